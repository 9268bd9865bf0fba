#include "algorithms/calibration/search_range.h"

#include <cmath>
#include <cstdio>

namespace remount {

std::string outside_range(const RigidTransform& ins_from_lidar, const SearchRange& range) {
  const SixParameters six = six_from_rigid(ins_from_lidar);
  std::string problems;
  const auto check = [&](const char* name, double value, double minimum, double maximum, double factor,
                         const char* unit) {
    if (value >= minimum && value <= maximum) return;
    char text[160];
    const bool below = value < minimum;
    const double limit = below ? minimum : maximum;
    // As many digits as tell the two apart: "5.00 m above 5.00 m" says nothing.
    int decimals = 2;
    for (double step = 0.01; decimals < 12 && std::abs(value - limit) * factor < step; step *= 0.1) ++decimals;
    std::snprintf(text, sizeof text, "%s%s %.*f %s %s %.*f %s", problems.empty() ? "" : ", ", name, decimals,
                  value * factor, unit, below ? "below" : "above", decimals, limit * factor, unit);
    problems += text;
  };
  const double to_deg = radians_to_degrees(1.0);
  // Beyond 180 deg an angle goes on at -180 deg: bounds that meet there leave no gap, though they were rounded.
  constexpr double kSeam_rad = 1e-5;
  const auto check_angle = [&](const char* name, double value, double minimum, double maximum) {
    const bool full_turn = maximum - minimum >= 2.0 * kPi - kSeam_rad;
    if (!full_turn) check(name, value, minimum, maximum, to_deg, "deg");
  };
  check("x", six.x_m, range.x_min_m, range.x_max_m, 1.0, "m");
  check("y", six.y_m, range.y_min_m, range.y_max_m, 1.0, "m");
  check("z", six.z_m, range.z_min_m, range.z_max_m, 1.0, "m");
  check_angle("yaw", six.yaw_rad, range.yaw_min_rad, range.yaw_max_rad);
  check_angle("pitch", six.pitch_rad, range.pitch_min_rad, range.pitch_max_rad);
  check_angle("roll", six.roll_rad, range.roll_min_rad, range.roll_max_rad);
  return problems;
}

}  // namespace remount
