// The most memory that the process has held: ctest runs each test in one of its own.
#pragma once

#include <sys/resource.h>

namespace remount::testing {

/// MB
inline double peak_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace remount::testing
