#include "model/settings.h"

namespace remount {

std::vector<std::string> Settings::check() const {
  std::vector<std::string> problems;
  visit_sections(*this, [&](std::string_view section, const auto& options) {
    for (const std::string& problem : option_problems(options))
      problems.push_back(std::string(section) + "." + problem);
  });
  const auto ordered = [&](std::string_view name, double minimum, double maximum) {
    if (minimum > maximum) problems.push_back("range." + std::string(name) + ": the minimum exceeds the maximum");
  };
  ordered("x", range.x_min_m, range.x_max_m);
  ordered("y", range.y_min_m, range.y_max_m);
  ordered("z", range.z_min_m, range.z_max_m);
  ordered("yaw", range.yaw_min_rad, range.yaw_max_rad);
  ordered("pitch", range.pitch_min_rad, range.pitch_max_rad);
  ordered("roll", range.roll_min_rad, range.roll_max_rad);
  return problems;
}

}  // namespace remount
