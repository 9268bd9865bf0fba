#include "model/settings.h"

#include <cstdio>

#include "algorithms/geometry/rotation.h"
#include "algorithms/search/candidates.h"

namespace remount {

std::vector<std::string> Settings::check() const {
  std::vector<std::string> problems;
  visit_sections(*this, [&](std::string_view section, const auto& options) {
    for (const std::string& problem : option_problems(options))
      problems.push_back(std::string(section) + "." + problem);
  });
  const auto ordered = [&](const char* name, double minimum, double maximum, const char* unit) {
    if (minimum <= maximum) return;
    char text[120];
    std::snprintf(text, sizeof text, "range.%s: the minimum %.6g %s exceeds the maximum %.6g %s", name, minimum, unit,
                  maximum, unit);
    problems.emplace_back(text);
  };
  const auto ordered_angle = [&](const char* name, double minimum_rad, double maximum_rad) {
    ordered(name, radians_to_degrees(minimum_rad), radians_to_degrees(maximum_rad), "deg");
  };
  ordered("x", range.x_min_m, range.x_max_m, "m");
  ordered("y", range.y_min_m, range.y_max_m, "m");
  ordered("z", range.z_min_m, range.z_max_m, "m");
  ordered_angle("yaw", range.yaw_min_rad, range.yaw_max_rad);
  ordered_angle("pitch", range.pitch_min_rad, range.pitch_max_rad);
  ordered_angle("roll", range.roll_min_rad, range.roll_max_rad);
  return problems;
}

std::string nominal_problem(const std::optional<RigidTransform>& nominal_ins_from_lidar, const SearchRange& range) {
  const std::string outside = nominal_ins_from_lidar ? outside_range(*nominal_ins_from_lidar, range) : "";
  if (outside.empty()) return {};
  return "lies outside the search range: " + outside + ". Correct it, or widen the search range.";
}

}  // namespace remount
