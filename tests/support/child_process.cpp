#include "tests/support/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <thread>

#include "tests/support/exit_code.h"

namespace remount::testing {
namespace {

std::vector<std::string> environment_with(const ChildProcess::Variables& added) {
  std::vector<std::string> entries;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    if (!added.count(std::string(text.substr(0, text.find('='))))) entries.emplace_back(text);
  }
  for (const auto& [name, value] : added) entries.push_back(name + "=" + value);
  return entries;
}

/// As exec wants them; valid as long as `words` is.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

}  // namespace

ChildProcess::ChildProcess(const std::string& program, const std::vector<std::string>& arguments,
                           const Variables& added) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environment_with(added);

  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  const int error = ::posix_spawnp(&process_, program.c_str(), &actions, nullptr, pointers(words).data(),
                                   pointers(environment).data());
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  output_ = ends[0];
  if (error != 0) {
    ::close(output_);
    throw std::system_error(error, std::generic_category(), program);
  }
}

ChildProcess::~ChildProcess() {
  if (!exit_code_ && process_ > 0) {
    kill();
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  ::close(output_);
}

bool ChildProcess::says(const std::string& words, int patience_ms) {
  const auto until = Clock::now() + std::chrono::milliseconds(patience_ms);
  while (said_.find(words) == std::string::npos)
    if (!read_more(until)) return false;
  return true;
}

std::optional<int> ChildProcess::ended(int patience_ms) {
  const auto until = Clock::now() + std::chrono::milliseconds(patience_ms);
  while (read_more(until)) {
  }
  int status = 0;
  while (!exit_code_) {
    const pid_t ended = ::waitpid(process_, &status, WNOHANG);
    if (ended < 0 && errno != EINTR) {
      const int error = errno;
      process_ = -1;  // somebody else took its end; the number may be another's by now
      throw std::system_error(error, std::generic_category(), "waitpid");
    }
    if (ended == process_)
      exit_code_ = exit_code_of(status);
    else if (Clock::now() > until)
      return std::nullopt;
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return exit_code_;
}

void ChildProcess::kill() {
  if (!exit_code_ && process_ > 0) ::kill(process_, SIGKILL);
}

bool ChildProcess::read_more(Clock::time_point until) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
  if (left.count() <= 0) return false;
  pollfd waiting{output_, POLLIN, 0};
  const int ready = ::poll(&waiting, 1, static_cast<int>(left.count()));
  if (ready < 0 && errno == EINTR) return true;
  if (ready <= 0) return false;
  std::array<char, 4096> piece{};
  const ssize_t size = ::read(output_, piece.data(), piece.size());
  if (size < 0) return errno == EINTR;
  said_.append(piece.data(), static_cast<std::size_t>(size));
  return size > 0;
}

}  // namespace remount::testing
