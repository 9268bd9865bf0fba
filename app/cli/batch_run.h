// All jobs of a fleet, each in a process of its own.
#pragma once

#include "app/cli/console.h"
#include "model/fleet/fleet.h"

namespace remount::cli {

/// How the processes ended, taken together.
struct BatchEnd {
  std::size_t unreadable = 0;  ///< jobs that could not be run, or whose process died
  std::size_t no_result = 0;
  bool cancelled = false;
};

/// Runs every job that is not done, `at_once` at a time, each with `threads` threads, and prints a line as each ends. A
/// job that fails does not stop the others. Ctrl-C stops them all and waits for them; where this process is killed,
/// they are stopped too.
BatchEnd run_jobs(const fleet::Fleet& fleet, std::size_t at_once, int threads, Console& console);

}  // namespace remount::cli
