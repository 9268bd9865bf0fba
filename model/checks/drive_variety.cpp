// Whether the drive moves in the ways that a calibration needs.
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "model/checks/builtin.h"
#include "model/conventions/assumed_tilt.h"

namespace remount::checks {
namespace {

constexpr double kLittleTurning_rad = degrees_to_radians(20.0);
constexpr double kLittleTilt_rad = degrees_to_radians(1.0);

struct Variety {
  double turned_rad = 0.0;      ///< sum of the turns about any axis
  double tilt_range_rad = 0.0;  ///< of the direction of the INS's z axis: what makes height observable
};

/// A pose at most every 0.2 s: noise of the single sample must not pass for motion.
std::vector<motion::StampedPose> thin(const std::vector<motion::StampedPose>& poses) {
  std::vector<motion::StampedPose> kept;
  for (const motion::StampedPose& pose : poses)
    if (kept.empty() || pose.stamp_ns - kept.back().stamp_ns >= 200'000'000) kept.push_back(pose);
  if (!poses.empty() && kept.back().stamp_ns != poses.back().stamp_ns) kept.push_back(poses.back());
  return kept;
}

Variety variety_of(const std::vector<motion::StampedPose>& world_from_ins) {
  Variety variety;
  Eigen::Vector3d lowest = Eigen::Vector3d::Constant(1.0), highest = Eigen::Vector3d::Constant(-1.0);
  const std::vector<motion::StampedPose> poses = thin(world_from_ins);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d up = poses[i].pose.linear().col(2);
    lowest = lowest.cwiseMin(up);
    highest = highest.cwiseMax(up);
    if (i == 0) continue;
    const Eigen::Vector3d turn = so3_log(poses[i].pose.linear() * poses[i - 1].pose.linear().transpose());
    variety.turned_rad += turn.norm();
  }
  if (!poses.empty()) variety.tilt_range_rad = std::asin(std::min(1.0, (highest - lowest).maxCoeff()));
  return variety;
}

/// The poses while the LiDAR is recorded.
std::vector<motion::StampedPose> during_lidar(const CheckedSession& checked) {
  const drive::Session& session = checked.session;
  std::int64_t from_ns = 0, to_ns = -1;
  if (session.scans && session.scans->size() > 0) {
    from_ns = session.scans->stamp_ns(0);
    to_ns = session.scans->stamp_ns(session.scans->size() - 1);
  } else if (!session.odometry_from_lidar.empty()) {
    from_ns = session.odometry_from_lidar.front().stamp_ns;
    to_ns = session.odometry_from_lidar.back().stamp_ns;
  }
  std::vector<motion::StampedPose> kept;
  for (const motion::StampedPose& pose : checked.poses)
    if (pose.stamp_ns >= from_ns && pose.stamp_ns <= to_ns) kept.push_back(pose);
  return kept;
}

void look_at_variety(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  const std::vector<motion::StampedPose> shared = during_lidar(checked);
  if (shared.size() < 2) return;
  const Variety variety = variety_of(shared);
  if (variety.turned_rad < kLittleTurning_rad)
    findings.push_back({drive::Severity::Warning, "little-turning", checked.session.name,
                        say::little_turning(Angle{variety.turned_rad})});
  // No ramp tilts an INS that is taken to be level.
  else if (variety.tilt_range_rad < kLittleTilt_rad && !(conventions::assumed_tilt_sigma_rad(checked.session) > 0.0))
    findings.push_back({drive::Severity::Note, "flat-driving", checked.session.name,
                        say::little_tilting(Angle{variety.tilt_range_rad})});
}

}  // namespace

DataCheck drive_variety_check() {
  return {.kinds = {{"little-turning", say::little_turning_meaning, say::little_turning_remedy},
                    {"flat-driving", say::flat_driving_meaning, say::flat_driving_remedy}},
          .look = look_at_variety,
          .of_the_drive = true};
}

}  // namespace remount::checks
