#include "model/settings.h"

#include <cstdio>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"

namespace remount {

std::vector<std::string> Settings::check() const {
  std::vector<std::string> problems;
  visit_sections(*this, [&](std::string_view section, const auto& options) {
    for (const Message& problem : option_problems(options))
      problems.push_back(std::string(section) + "." + english(problem));
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
  const auto not_above = [&](const char* low_name, double low, const char* high_name, double high) {
    if (low <= high) return;
    char text[160];
    std::snprintf(text, sizeof text, "%s = %.6g exceeds %s = %.6g", low_name, low, high_name, high);
    problems.emplace_back(text);
  };
  not_above("keyframes.minimum", keyframes.minimum, "keyframes.maximum", keyframes.maximum);
  if (pairing.limit != PairLimit::Time)
    not_above("pairing.min_distance_m", pairing.min_distance_m, "pairing.max_distance_m", pairing.max_distance_m);
  not_above("objects.min_points", objects.min_points, "objects.max_points", objects.max_points);
  not_above("registration.min_range_m", registration.min_range_m, "registration.max_range_m", registration.max_range_m);
  not_above("registration.min_range_m", registration.min_range_m, "objects.max_range_m", objects.max_range_m);
  if (vehicle_frame.scale == ScaleMode::Estimated && vehicle_frame.estimate_wheel_scale)
    problems.push_back("vehicle_frame.scale and vehicle_frame.estimate_wheel_scale: one of the two must be known");
  return problems;
}

void require_valid(const Settings& settings) {
  std::string all;
  for (const std::string& problem : settings.check()) all += (all.empty() ? "" : "; ") + problem;
  if (!all.empty()) throw Error(ErrorCode::Contract, "settings", all);
}

std::string nominal_problem(const std::optional<RigidTransform>& nominal_ins_from_lidar, const SearchRange& range) {
  const std::string outside = nominal_ins_from_lidar ? english(outside_range(*nominal_ins_from_lidar, range)) : "";
  if (outside.empty()) return {};
  return "lies outside the search range: " + outside + ". Correct it, or widen the search range.";
}

}  // namespace remount
