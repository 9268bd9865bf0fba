// What several checks share.
#pragma once

#include <cstdint>

namespace remount::checks {

inline double seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
  return static_cast<double>(to_ns - from_ns) * 1e-9;
}

}  // namespace remount::checks
