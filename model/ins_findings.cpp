#include "model/ins_findings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/geometry/rotation.h"
#include "model/session_frames.h"

namespace remount {

namespace {

constexpr double kShortestGap_s = 0.1;
constexpr double kFrozen_s = 1.0;
constexpr double kLittleTurning_deg = 20.0;
constexpr double kLittleTilt_deg = 1.0;
constexpr double kFastestVehicle_mps = 100.0;

struct Motion {
  double turned_deg = 0.0;      ///< sum of the turns about any axis
  double tilt_range_deg = 0.0;  ///< of the direction of the INS's z axis: what makes height observable
  double speed_max_mps = 0.0;
};

double seconds(std::int64_t duration_ns) { return static_cast<double>(duration_ns) * 1e-9; }

std::string number(double value, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// A pose at most every 0.2 s: noise of the single sample must not pass for motion.
std::vector<StampedPose> thinned(const std::vector<StampedPose>& poses) {
  std::vector<StampedPose> kept;
  for (const StampedPose& pose : poses)
    if (kept.empty() || pose.stamp_ns - kept.back().stamp_ns >= 200'000'000) kept.push_back(pose);
  if (!poses.empty() && kept.back().stamp_ns != poses.back().stamp_ns) kept.push_back(poses.back());
  return kept;
}

Motion measure_motion(const std::vector<StampedPose>& world_from_ins) {
  Motion motion;
  Eigen::Vector3d lowest = Eigen::Vector3d::Constant(1.0), highest = Eigen::Vector3d::Constant(-1.0);
  const std::vector<StampedPose> poses = thinned(world_from_ins);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d up = poses[i].pose.linear().col(2);
    lowest = lowest.cwiseMin(up);
    highest = highest.cwiseMax(up);
    if (i == 0) continue;
    const double step_m = (poses[i].pose.translation() - poses[i - 1].pose.translation()).norm();
    const Eigen::Vector3d turn = so3_log(poses[i].pose.linear() * poses[i - 1].pose.linear().transpose());
    motion.turned_deg += radians_to_degrees(turn.norm());
    motion.speed_max_mps = std::max(motion.speed_max_mps, step_m / seconds(poses[i].stamp_ns - poses[i - 1].stamp_ns));
  }
  if (!poses.empty())
    motion.tilt_range_deg = radians_to_degrees(std::asin(std::min(1.0, (highest - lowest).maxCoeff())));
  return motion;
}

double longest_frozen_s(const std::vector<StampedPose>& poses) {
  double longest = 0.0;
  std::size_t since = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!(poses[i].pose.matrix() == poses[since].pose.matrix())) since = i;
    longest = std::max(longest, seconds(poses[i].stamp_ns - poses[since].stamp_ns));
  }
  return longest;
}

void report_status(const std::vector<InsSample>& ins, std::vector<Finding>& findings) {
  std::size_t degraded = 0, invalid = 0;
  for (const InsSample& sample : ins) {
    degraded += sample.quality == InsQuality::Degraded;
    invalid += sample.quality == InsQuality::Invalid;
  }
  if (degraded + invalid == 0) return;
  findings.push_back({invalid > 0 ? Severity::Warning : Severity::Note, "ins-status", "INS",
                      std::to_string(degraded) + " of " + std::to_string(ins.size()) + " samples are degraded and " +
                          std::to_string(invalid) + " invalid by the INS's own status."});
}

void report_gaps(const std::vector<StampedPose>& poses, std::vector<Finding>& findings) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < poses.size(); ++i) steps.push_back(seconds(poses[i].stamp_ns - poses[i - 1].stamp_ns));
  if (steps.empty()) return;
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double longest_allowed = std::max(3.0 * *middle, kShortestGap_s);
  const auto gaps = std::count_if(steps.begin(), steps.end(), [&](double step) { return step > longest_allowed; });
  if (gaps == 0) return;
  findings.push_back({Severity::Warning, "ins-gaps", "INS",
                      std::to_string(gaps) + " gaps, the longest " +
                          number(*std::max_element(steps.begin(), steps.end()), 3) +
                          " s; nothing is interpolated across them."});
}

/// The poses while the LiDAR is recorded.
std::vector<StampedPose> during_lidar(const Session& session, const std::vector<StampedPose>& poses) {
  std::int64_t from_ns = 0, to_ns = -1;
  if (session.scans && session.scans->size() > 0) {
    from_ns = session.scans->stamp_ns(0);
    to_ns = session.scans->stamp_ns(session.scans->size() - 1);
  } else if (!session.odometry_from_lidar.empty()) {
    from_ns = session.odometry_from_lidar.front().stamp_ns;
    to_ns = session.odometry_from_lidar.back().stamp_ns;
  }
  std::vector<StampedPose> kept;
  for (const StampedPose& pose : poses)
    if (pose.stamp_ns >= from_ns && pose.stamp_ns <= to_ns) kept.push_back(pose);
  return kept;
}

void report_motion(const Motion& motion, const std::string& name, std::vector<Finding>& findings) {
  if (motion.speed_max_mps > kFastestVehicle_mps)
    findings.push_back({Severity::Warning, "ins-jump", "INS",
                        "The INS moves at up to " + number(motion.speed_max_mps, 0) +
                            " m/s: its position jumps, or its stamps are wrong."});
  if (motion.turned_deg < kLittleTurning_deg)
    findings.push_back({Severity::Warning, "little-turning", name,
                        "The vehicle turns by " + number(motion.turned_deg, 1) +
                            " degrees in all: the position of the LiDAR will not be observable from this drive alone. "
                            "Drive a figure of eight."});
  else if (motion.tilt_range_deg < kLittleTilt_deg)
    findings.push_back({Severity::Note, "flat-driving", name,
                        "The vehicle tilts by " + number(motion.tilt_range_deg, 2) +
                            " degrees only: the height of the LiDAR will hardly be observable. Drive over a ramp."});
}

}  // namespace

std::vector<Finding> ins_findings(const Session& session) {
  std::vector<Finding> findings;
  const std::vector<StampedPose> poses = metric_poses(session);
  report_status(session.ins, findings);
  report_gaps(poses, findings);
  const double frozen_s = longest_frozen_s(poses);
  if (frozen_s > kFrozen_s)
    findings.push_back({Severity::Warning, "ins-frozen", "INS",
                        "The INS repeats one solution for " + number(frozen_s, 1) +
                            " s; was it still aligning, or did the log stall?"});
  const std::vector<StampedPose> shared = during_lidar(session, poses);
  if (shared.size() >= 2) report_motion(measure_motion(shared), session.name, findings);
  return findings;
}

}  // namespace remount
