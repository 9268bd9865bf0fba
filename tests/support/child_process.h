// A program in a process of its own, whose output is read here.
#pragma once

#include <sys/types.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace remount::testing {

/// Killed, if it still runs, when this goes. Not QProcess: that lets the child run in this process's memory until it
/// has become the program, and the thread sanitizer, which takes it for one of this process's threads, ends the test.
class ChildProcess {
 public:
  using Variables = std::map<std::string, std::string>;

  /// `program` is looked for in PATH unless it is a path. `added` joins or replaces variables of this environment.
  /// @throws std::system_error where it cannot be started.
  ChildProcess(const std::string& program, const std::vector<std::string>& arguments, const Variables& added = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Whether it writes `words` before it ends and before `patience_ms` are over.
  bool says(const std::string& words, int patience_ms);
  /// Its exit code, 128 + signal where one ended it; nothing where `patience_ms` are over before.
  std::optional<int> ended(int patience_ms);
  void kill();
  /// What it has written so far, as far as it was waited for: standard output and standard error in one.
  const std::string& said() const { return said_; }

 private:
  /// False where it has closed its output or `until_ms` has passed.
  bool read_more(double until_ms);

  pid_t process_ = -1;
  int output_ = -1;
  std::string said_;
  std::optional<int> exit_code_;
};

}  // namespace remount::testing
