#include "model/settings/settings.h"

#include <utility>

#include "algorithms/core/error.h"
#include "messages/projects.h"

namespace remount::settings {

std::vector<Message> Settings::check() const {
  std::vector<Message> problems;
  visit_sections(*this, [&](std::string_view section, const auto& options) {
    for (const auto& problem : option_problems(options))
      problems.push_back(say::settings_of_section(std::string(section), problem));
  });
  const auto ordered = [&](const char* parameter, double minimum_m, double maximum_m) {
    if (!(minimum_m <= maximum_m))
      problems.push_back(say::settings_range_of_lengths(parameter, Length{minimum_m}, Length{maximum_m}));
  };
  const auto ordered_angle = [&](const char* parameter, double minimum_rad, double maximum_rad) {
    if (!(minimum_rad <= maximum_rad))
      problems.push_back(say::settings_range_of_angles(parameter, Angle{minimum_rad}, Angle{maximum_rad}));
  };
  ordered("x", range.x_min_m, range.x_max_m);
  ordered("y", range.y_min_m, range.y_max_m);
  ordered("z", range.z_min_m, range.z_max_m);
  ordered_angle("yaw", range.yaw_min_rad, range.yaw_max_rad);
  ordered_angle("pitch", range.pitch_min_rad, range.pitch_max_rad);
  ordered_angle("roll", range.roll_min_rad, range.roll_max_rad);
  const auto not_above = [&](const char* lower, double low, const char* upper, double high) {
    if (!(low <= high)) problems.push_back(say::settings_not_above(lower, low, upper, high));
  };
  not_above("keyframes.minimum", keyframes.minimum, "keyframes.maximum", keyframes.maximum);
  if (pairing.limit != motion::PairLimit::Time)
    not_above("pairing.min_distance_m", pairing.min_distance_m, "pairing.max_distance_m", pairing.max_distance_m);
  not_above("objects.min_points", objects.min_points, "objects.max_points", objects.max_points);
  not_above("registration.min_range_m", registration.min_range_m, "registration.max_range_m", registration.max_range_m);
  not_above("registration.min_range_m", registration.min_range_m, "objects.max_range_m", objects.max_range_m);
  if (vehicle_frame.scale == calibration::ScaleMode::Estimated && vehicle_frame.estimate_wheel_scale)
    problems.push_back(say::settings_two_scales());
  return problems;
}

void require_valid(const Settings& settings) {
  const std::vector<Message> problems = settings.check();
  if (!problems.empty()) throw Error(ErrorCode::Contract, "settings", in_one(problems));
}

Message nominal_problem(const std::optional<RigidTransform>& nominal_ins_from_lidar,
                        const calibration::SearchRange& range) {
  if (!nominal_ins_from_lidar) return {};
  const auto outside = calibration::outside_range(*nominal_ins_from_lidar, range);
  return outside.empty() ? Message() : say::nominal_outside_range(outside);
}

}  // namespace remount::settings
