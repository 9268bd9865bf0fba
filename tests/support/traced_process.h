// A process whose system calls fail where a test says so, or that is killed there.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace remount::testing {

/// What happens at the `call`-th system call (from 1) that concerns the folder; 0: nothing, they are only counted.
struct Fault {
  enum class Kind {
    Error,       ///< it is not executed and returns -1 with errno `error`; close(2) is executed, as Linux does
    Partly,      ///< it writes half of what it was given, if it writes
    KillBefore,  ///< SIGKILL before it takes effect
    KillAfter,   ///< SIGKILL right after it took effect
  };
  std::size_t call = 0;
  Kind kind = Kind::Error;
  int error = 0;
};

struct TracedRun {
  int exit_code = -1;              ///< 128 + signal where one ended it
  std::string said;                ///< what the body returned; empty where it was killed
  std::vector<std::string> calls;  ///< that concern the folder, with their paths, in order
  bool faulted = false;            ///< the call was reached
};

/// Why processes cannot be traced here; empty where they can.
std::string why_tracing_is_impossible();

/// Runs `body` in a child of its own (fork, no exec: it holds what this process holds) and returns what it returned,
/// with every call by which it touches `folder` or anything below it: by path, by descriptor, in any thread. Nothing is
/// counted before the body calls begin_faults().
TracedRun run_traced(const std::filesystem::path& folder, const std::function<std::string()>& body,
                     const Fault& fault = {});
void begin_faults();

/// The same for a program. It says what it writes to its standard error.
TracedRun run_program_traced(const std::filesystem::path& folder, const std::vector<std::string>& words,
                             const Fault& fault = {});

/// A child that runs `body` again and again and is killed after so many microseconds. Returns how often it had run.
int run_and_kill(const std::function<void(int)>& body, int after_us);
/// How long such a child must live to run `body` twice, at least `least_us`: whoever is killed at random within it is
/// killed before and after, on a slow machine as on a fast one. A second at most.
int life_of_two_runs_us(const std::function<void(int)>& body, int least_us);

}  // namespace remount::testing
