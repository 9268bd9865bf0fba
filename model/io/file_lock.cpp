#include "model/io/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "algorithms/core/error.h"
#include "model/io/input_file.h"

namespace remount {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw Error(ErrorCode::Io, path.string(), std::string("cannot be locked: ") + std::strerror(errno));
}

/// As far as it goes: the name is for people, the lock holds without it.
void write_holder(const FileDescriptor& file, const std::string& holder) {
  const std::string line = holder + "\n";
  if (::ftruncate(file.get(), 0) != 0) return;
  [[maybe_unused]] const ssize_t written = ::pwrite(file.get(), line.data(), line.size(), 0);
}

}  // namespace

std::optional<FileLock> FileLock::take(const std::filesystem::path& path, const std::string& holder) {
  FileDescriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666));
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) fail(path);
  if (!S_ISREG(status.st_mode)) throw Error(ErrorCode::Io, path.string(), "cannot be locked, it is no regular file");
  int answer = 0;
  while ((answer = ::flock(file.get(), LOCK_EX | LOCK_NB)) != 0 && errno == EINTR) continue;
  if (answer != 0 && errno == EWOULDBLOCK) return std::nullopt;
  if (answer != 0) fail(path);
  write_holder(file, holder);
  if (::fstat(file.get(), &status) != 0) fail(path);
  return FileLock(std::move(file), std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec);
}

std::string lock_holder(const std::filesystem::path& path) {
  try {
    const std::string text = read_file_head(path, 200);
    return text.substr(0, text.find('\n'));
  } catch (const Error&) {
    return {};
  }
}

std::string this_process() {
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '?';
  return "process " + std::to_string(::getpid()) + " on " + host.data();
}

}  // namespace remount
