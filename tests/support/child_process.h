// A program in a process of its own, whose output is read here.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace remount::testing {

/// Killed, if it still runs, when this goes. Not QProcess: the thread sanitizer takes its clone() for a fork, whose
/// child has memory of its own, and ends the test. That of posix_spawn lies within the C library, out of its sight.
class ChildProcess {
 public:
  using Variables = std::map<std::string, std::string>;

  /// `program` is looked for in PATH unless it is a path. `added` joins or replaces variables of this environment.
  /// @throws std::system_error where it cannot be started.
  ChildProcess(const std::string& program, const std::vector<std::string>& arguments, const Variables& added = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Whether it has written `words` since it was started, before it closes its output or `patience_ms` are over.
  bool says(const std::string& words, int patience_ms);
  /// Its exit code, 128 + signal where one ended it; nothing where it still runs after `patience_ms`. All that it says
  /// is read first: programs that it leaves behind with its output are waited for, too.
  std::optional<int> ended(int patience_ms);
  void kill();
  /// What it has written so far, as far as it was waited for: standard output and standard error in one.
  const std::string& said() const { return said_; }

 private:
  using Clock = std::chrono::steady_clock;

  /// False where it has closed its output or `until` has passed.
  bool read_more(Clock::time_point until);

  pid_t process_ = -1;
  int output_ = -1;
  std::string said_;
  std::optional<int> exit_code_;
};

}  // namespace remount::testing
