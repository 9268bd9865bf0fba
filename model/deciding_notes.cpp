#include "model/deciding_notes.h"

#include <algorithm>
#include <array>

namespace remount {

bool is_deciding(const Finding& finding) {
  constexpr std::array<std::string_view, 22> kCodes{
      // of methods: what was taken for what, what stands in for what is missing, and where scans do not tell the motion
      kRecording, kOdometryByWheels, kCloserKeyframes, "odometry-without", "odometry-deskew-off",
      "odometry-undetermined", "deskew-on", "deskew-off", "imu-from-ins", "trajectory-outliers",
      // of readers: which of several streams was taken, and what was assumed of it
      "topic-chosen", "ins-file-chosen", "scans-preferred", "lidar-poses-preferred", "stamps-by-number", "utm-poses",
      "one-speed", "truth-as-gnss", "gnss-sigma-assumed", "gnss-covariance-unknown", "host-clock", "clock-aligned"};
  return finding.severity == Severity::Note && std::find(kCodes.begin(), kCodes.end(), finding.code) != kCodes.end();
}

}  // namespace remount
