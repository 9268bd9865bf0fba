#pragma once
#include <cstdint>

namespace remount {

/// Seconds that so many nanoseconds are. Stamps are nanoseconds since 1970, which a double does not hold to the
/// microsecond: subtract stamps before converting what is between them.
constexpr double seconds(std::int64_t duration_ns) { return static_cast<double>(duration_ns) * 1e-9; }

}  // namespace remount
