#include "model/results/disagreement.h"

#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "messages/places.h"

namespace remount::results {

void report_disagreement(const calibration::CalibrationResult& result, std::vector<drive::Finding>& findings) {
  constexpr const char* kMotionsDiffer = "motions-differ";
  constexpr double kMoreThanSurveyed_rad = degrees_to_radians(1.0);
  std::erase_if(findings, [](const drive::Finding& finding) { return finding.code == kMotionsDiffer; });
  if (!calibration::is_usable(result) || !(result.rotation_rms_rad > kMoreThanSurveyed_rad)) return;
  findings.push_back({drive::Severity::Warning, kMotionsDiffer, say::place_calibration(),
                      say::motions_differ(Angle{result.rotation_rms_rad}, Angle{kMoreThanSurveyed_rad})});
}

}  // namespace remount::results
