#include "model/results/nominal_check.h"

#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "messages/places.h"

namespace remount::results {
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

void report_nominal(const std::optional<RigidTransform>& nominal_ins_from_lidar,
                    const calibration::CalibrationResult& result, std::vector<drive::Finding>& findings) {
  std::erase_if(findings, [](const drive::Finding& finding) { return finding.code == kNominalFar; });
  if (!nominal_ins_from_lidar || !calibration::is_usable(result)) return;
  const RigidTransform &nominal = *nominal_ins_from_lidar, &x = result.mounting.reference_from_sensor;
  if (!far_apart(nominal, x)) return;
  const Angle turn{rotation_angle_between_rad(nominal, x)};
  const Length distance{distance_m(nominal, x)};
  findings.push_back(
      {drive::Severity::Warning, kNominalFar, say::place_nominal_mounting(),
       far_apart(nominal.inverse(), x) ? say::nominal_far(turn, distance) : say::nominal_inverse(turn, distance)});
}

}  // namespace remount::results
