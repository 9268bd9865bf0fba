// How well positions and attitudes of an INS go together that come in messages of their own.
#pragma once

#include <cstddef>

namespace remount::formats {

/// 1-sigma of how much older positions may be than attitudes: of one moment where messages carry the same stamps, as
/// one device gives them; otherwise by what receivers and drivers are late.
inline double position_lag_sigma_s(std::size_t samples, std::size_t with_own_attitude) {
  constexpr double kApart_s = 0.03;
  return 2 * with_own_attitude >= samples ? 0.0 : kApart_s;
}

}  // namespace remount::formats
