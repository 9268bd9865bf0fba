#include "model/nominal_check.h"

#include <cstdio>
#include <string>

#include "algorithms/geometry/rotation.h"

namespace remount {
namespace {

constexpr const char* kNominalFar = "nominal-far";
constexpr double kFar_m = 1.0, kFar_rad = degrees_to_radians(20.0);

double distance_m(const RigidTransform& a, const RigidTransform& b) {
  return (a.translation() - b.translation()).norm();
}

bool far_apart(const RigidTransform& a, const RigidTransform& b) {
  return distance_m(a, b) > kFar_m || rotation_angle_between_rad(a, b) > kFar_rad;
}

}  // namespace

void report_nominal(const std::optional<RigidTransform>& nominal_ins_from_lidar, const CalibrationResult& result,
                    std::vector<Finding>& findings) {
  std::erase_if(findings, [](const Finding& finding) { return finding.code == kNominalFar; });
  if (!nominal_ins_from_lidar || !is_usable(result)) return;
  const RigidTransform &nominal = *nominal_ins_from_lidar, &x = result.ins_from_lidar;
  if (!far_apart(nominal, x)) return;
  char text[400];
  std::snprintf(text, sizeof text, "The result lies %.1f deg and %.2f m from the nominal mounting. %s",
                radians_to_degrees(rotation_angle_between_rad(nominal, x)), distance_m(nominal, x),
                far_apart(nominal.inverse(), x)
                    ? "The LiDAR sits otherwise than assumed, or the nominal has other axes or signs."
                    : "The inverse of the nominal is near: was lidar_from_ins given for ins_from_lidar?");
  findings.push_back({Severity::Warning, kNominalFar, "nominal mounting", text});
}

}  // namespace remount
