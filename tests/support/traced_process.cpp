#include "tests/support/traced_process.h"

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <map>

#include "tests/support/exit_code.h"
#include "tests/support/system_calls.h"

#if defined(__aarch64__)
#include <elf.h>
#include <linux/elf.h>
#include <linux/ptrace.h>
#endif

namespace remount::testing {
namespace {

/// A call that does nothing and that nobody else makes.
constexpr int kMark = -7700;

/// Registers of a process that stands at the beginning or end of a system call.
struct Registers {
#if defined(__x86_64__)
  static bool skip_call(pid_t process) { return poke(process, offsetof(user, regs.orig_rax), -1); }
  static bool set_result(pid_t process, long value) { return poke(process, offsetof(user, regs.rax), value); }
  static bool set_argument(pid_t process, int index, long value) {
    constexpr std::array<std::size_t, 6> kOffsets{offsetof(user, regs.rdi), offsetof(user, regs.rsi),
                                                  offsetof(user, regs.rdx), offsetof(user, regs.r10),
                                                  offsetof(user, regs.r8),  offsetof(user, regs.r9)};
    return poke(process, kOffsets.at(static_cast<std::size_t>(index)), value);
  }
  static constexpr bool kKnown = true;

 private:
  static bool poke(pid_t process, std::size_t offset, long value) {
    return ::ptrace(PTRACE_POKEUSER, process, offset, value) == 0;
  }
#elif defined(__aarch64__)
  static bool skip_call(pid_t process) {
    int none = -1;
    iovec room{&none, sizeof none};
    return ::ptrace(PTRACE_SETREGSET, process, NT_ARM_SYSTEM_CALL, &room) == 0;
  }
  static bool set_result(pid_t process, long value) { return set_argument(process, 0, value); }
  static bool set_argument(pid_t process, int index, long value) {
    user_regs_struct registers{};
    iovec room{&registers, sizeof registers};
    if (::ptrace(PTRACE_GETREGSET, process, NT_PRSTATUS, &room) != 0) return false;
    registers.regs[index] = static_cast<unsigned long long>(value);
    return ::ptrace(PTRACE_SETREGSET, process, NT_PRSTATUS, &room) == 0;
  }
  static constexpr bool kKnown = true;
#else
  static bool skip_call(pid_t) { return false; }
  static bool set_result(pid_t, long) { return false; }
  static bool set_argument(pid_t, int, long) { return false; }
  static constexpr bool kKnown = false;
#endif
};

std::string link_target(const std::string& link) {
  std::array<char, 4096> target{};
  const ssize_t size = ::readlink(link.c_str(), target.data(), target.size());
  return size < 0 ? std::string() : std::string(target.data(), static_cast<std::size_t>(size));
}

std::string descriptor_path(pid_t thread, std::uint64_t descriptor) {
  const int number = static_cast<int>(descriptor);
  const std::string process = "/proc/" + std::to_string(thread);
  if (number == AT_FDCWD) return link_target(process + "/cwd");
  return number < 0 ? std::string() : link_target(process + "/fd/" + std::to_string(number));
}

/// A text in the memory of another process, at most a path long.
std::string text_at(pid_t thread, std::uint64_t address) {
  std::string text;
  std::array<char, 256> piece{};
  while (address != 0 && text.size() < 8192) {
    const std::size_t count = piece.size() - address % piece.size();  // does not cross into a page that is not there
    iovec here{piece.data(), count}, there{reinterpret_cast<void*>(address), count};
    const ssize_t got = ::process_vm_readv(thread, &here, 1, &there, 1, 0);
    if (got <= 0) break;
    const std::size_t length = ::strnlen(piece.data(), static_cast<std::size_t>(got));
    text.append(piece.data(), length);
    if (length < static_cast<std::size_t>(got)) break;
    address += static_cast<std::uint64_t>(got);
  }
  return text;
}

using Arguments = std::array<std::uint64_t, 6>;

class Tracer {
 public:
  Tracer(std::filesystem::path folder, const Fault& fault, bool begun)
      : folder_(folder.string()), fault_(fault), begun_(begun) {}

  /// Follows the process and its threads until it ends.
  TracedRun follow(pid_t process);

 private:
  struct Thread {
    bool inside = false, faulted = false;
    std::uint64_t number = 0;
    long result = 0;
    bool replace_result = false;
  };

  void stop(pid_t thread);
  void enter(pid_t thread, Thread& state, std::uint64_t number, const Arguments& arguments);
  void leave(pid_t thread, Thread& state);
  void apply(pid_t thread, Thread& state, const SystemCall& call, const Arguments& arguments);
  std::string concerned_path(pid_t thread, const SystemCall& call, const Arguments& arguments) const;
  bool is_below(const std::string& path) const { return path == folder_ || path.rfind(folder_ + "/", 0) == 0; }

  std::string folder_;
  Fault fault_;
  bool begun_;
  pid_t process_ = 0;
  std::map<pid_t, Thread> threads_;
  TracedRun run_;
};

std::string Tracer::concerned_path(pid_t thread, const SystemCall& call, const Arguments& arguments) const {
  const auto argument = [&](int index) { return arguments.at(static_cast<std::size_t>(index)); };
  if (call.descriptor >= 0) {
    const std::string path = descriptor_path(thread, argument(call.descriptor));
    return is_below(path) ? path : std::string();
  }
  for (const auto& [folder, path] : {std::pair{call.folder, call.path}, {call.other_folder, call.other_path}}) {
    if (path < 0) continue;
    const std::string name = text_at(thread, argument(path));
    std::filesystem::path whole = name;
    if (!whole.is_absolute())
      whole = std::filesystem::path(
                  descriptor_path(thread, folder < 0 ? static_cast<std::uint64_t>(AT_FDCWD) : argument(folder))) /
              name;
    if (is_below(whole.string())) return whole.string();
  }
  return {};
}

void Tracer::apply(pid_t thread, Thread& state, const SystemCall& call, const Arguments& arguments) {
  run_.faulted = true;
  switch (fault_.kind) {
    case Fault::Kind::KillBefore:
      ::kill(process_, SIGKILL);
      break;
    case Fault::Kind::KillAfter:
      state.faulted = true;
      break;
    case Fault::Kind::Partly:
      if (call.size >= 0)
        Registers::set_argument(thread, call.size,
                                static_cast<long>((arguments.at(static_cast<std::size_t>(call.size)) + 1) / 2));
      break;
    case Fault::Kind::Error:
      if (call.number != SYS_close) Registers::skip_call(thread);
      state.result = -fault_.error;
      state.replace_result = true;
      break;
  }
}

void Tracer::enter(pid_t thread, Thread& state, std::uint64_t number, const Arguments& arguments) {
  state = {true, false, number, 0, false};
  if (number == SYS_close && static_cast<int>(arguments[0]) == kMark) begun_ = true;
  const SystemCall* call = begun_ ? find_system_call(number) : nullptr;
  if (call == nullptr) return;
  const std::string path = concerned_path(thread, *call, arguments);
  if (path.empty()) return;
  run_.calls.push_back(std::string(call->name) + " " + path);
  if (run_.calls.size() == fault_.call) apply(thread, state, *call, arguments);
}

void Tracer::leave(pid_t thread, Thread& state) {
  state.inside = false;
  if (state.replace_result) Registers::set_result(thread, state.result);
  if (state.faulted) ::kill(process_, SIGKILL);
}

void Tracer::stop(pid_t thread) {
  __ptrace_syscall_info info{};
  if (::ptrace(static_cast<__ptrace_request>(PTRACE_GET_SYSCALL_INFO), thread, sizeof info, &info) <= 0) return;
  Thread& state = threads_[thread];
  if (info.op == PTRACE_SYSCALL_INFO_ENTRY) {
    Arguments arguments{};
    std::copy(std::begin(info.entry.args), std::end(info.entry.args), arguments.begin());
    enter(thread, state, info.entry.nr, arguments);
  } else if (info.op == PTRACE_SYSCALL_INFO_EXIT && state.inside) {
    leave(thread, state);
  }
}

TracedRun Tracer::follow(pid_t process) {
  process_ = process;
  int status = 0;
  ::waitpid(process, &status, 0);  // it stops itself
  ::ptrace(PTRACE_SETOPTIONS, process, 0,
           PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACECLONE | PTRACE_O_TRACEEXEC | PTRACE_O_EXITKILL);
  ::ptrace(PTRACE_SYSCALL, process, 0, 0);
  for (;;) {
    const pid_t thread = ::waitpid(-1, &status, __WALL);
    if (thread < 0 && errno == EINTR) continue;
    if (thread < 0) break;
    if (WIFEXITED(status) || WIFSIGNALED(status)) {
      if (thread != process) continue;
      run_.exit_code = exit_code_of(status);
      break;
    }
    int signal = WSTOPSIG(status);
    if (signal == (SIGTRAP | 0x80)) stop(thread);
    // Stops of the tracing itself are none of the program's signals; a new thread begins with SIGSTOP.
    if (signal == (SIGTRAP | 0x80) || signal == SIGTRAP || signal == SIGSTOP) signal = 0;
    ::ptrace(PTRACE_SYSCALL, thread, 0, signal);
  }
  return std::move(run_);
}

void write_all(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count <= 0) return;
    done += static_cast<std::size_t>(count);
  }
}

/// A file without a name: unlike a pipe it takes any amount without a reader.
class Notes {
 public:
  Notes() : file_(std::tmpfile()) {}
  ~Notes() {
    if (file_ != nullptr) std::fclose(file_);
  }
  Notes(const Notes&) = delete;
  Notes& operator=(const Notes&) = delete;
  int descriptor() const { return ::fileno(file_); }
  std::string text() const {
    std::string all(static_cast<std::size_t>(::lseek(descriptor(), 0, SEEK_END)), '\0');
    const ssize_t got = ::pread(descriptor(), all.data(), all.size(), 0);
    all.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
    return all;
  }

 private:
  std::FILE* file_;
};

TracedRun trace_child(const std::filesystem::path& folder, const Fault& fault, bool begun,
                      const std::function<int(int)>& body) {
  const Notes notes;
  const pid_t child = ::fork();
  if (child == 0) {
    ::ptrace(PTRACE_TRACEME, 0, 0, 0);
    ::raise(SIGSTOP);
    ::_exit(body(notes.descriptor()));
  }
  TracedRun run = Tracer(std::filesystem::canonical(folder), fault, begun).follow(child);
  run.said = notes.text();
  return run;
}

}  // namespace

std::string why_tracing_is_impossible() {
  if (!Registers::kKnown) return "system calls are traced on x86-64 and aarch64 only";
  const pid_t child = ::fork();
  if (child == 0) {
    if (::ptrace(PTRACE_TRACEME, 0, 0, 0) != 0) ::_exit(errno);
    ::raise(SIGSTOP);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status)) return std::string("processes cannot be traced here: ") + std::strerror(WEXITSTATUS(status));
  ::kill(child, SIGKILL);
  ::waitpid(child, &status, 0);
  return {};
}

void begin_faults() { ::close(kMark); }

TracedRun run_traced(const std::filesystem::path& folder, const std::function<std::string()>& body,
                     const Fault& fault) {
  return trace_child(folder, fault, false, [&](int notes) {
    const std::string said = body();
    write_all(notes, said);
    return said.empty() ? 0 : 1;
  });
}

TracedRun run_program_traced(const std::filesystem::path& folder, const std::vector<std::string>& words,
                             const Fault& fault) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  return trace_child(folder, fault, true, [&](int notes) {
    ::dup2(notes, STDERR_FILENO);
    ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
    const char* options = ::getenv("ASAN_OPTIONS");
    // Looking for leaks is tracing, too, and two cannot.
    ::setenv("ASAN_OPTIONS", (std::string(options ? options : "") + ":detect_leaks=0").c_str(), 1);
    ::execv(arguments[0], arguments.data());
    return 98;
  });
}

int run_and_kill(const std::function<void(int)>& body, int after_us) {
  const Notes notes;
  const pid_t child = ::fork();
  if (child == 0)
    for (int i = 0;; ++i) {
      body(i);
      write_all(notes.descriptor(), ".");
    }
  ::usleep(static_cast<useconds_t>(after_us));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  return static_cast<int>(notes.text().size());
}

int life_of_two_runs_us(const std::function<void(int)>& body, int least_us) {
  int life_us = least_us;
  while (life_us < 1'000'000 && run_and_kill(body, life_us) < 2) life_us *= 2;
  return life_us;
}

}  // namespace remount::testing
