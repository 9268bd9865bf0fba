#include "model/attitude_check.h"

#include <Eigen/Eigenvalues>
#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>

#include "model/result_file.h"

namespace remount {
namespace {

constexpr const char* kHeadingAgainstTravel = "heading-against-travel";

/// Directions of travel seen from the INS, unit vectors, one for each few metres.
std::vector<Eigen::Vector3d> travel_in_ins(const std::vector<StampedPose>& world_from_ins) {
  constexpr double kStep_m = 2.0;          // so far that noise of positions does not turn the direction
  constexpr double kJump_m = 5 * kStep_m;  // a gap or a jump
  std::vector<Eigen::Vector3d> directions;
  for (std::size_t from = 0, i = 1; i < world_from_ins.size(); ++i) {
    const Eigen::Vector3d step = world_from_ins[i].pose.translation() - world_from_ins[from].pose.translation();
    if (step.norm() < kStep_m) continue;
    const RigidTransform& middle = world_from_ins[(from + i) / 2].pose;
    if (step.norm() < kJump_m) directions.push_back(middle.linear().transpose() * step.normalized());
    from = i;
  }
  return directions;
}

/// 1 where all directions lie on one axis, forwards or backwards; 0 where they spread over a whole plane.
double concentration(const std::vector<Eigen::Vector3d>& directions) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& direction : directions) scatter += direction * direction.transpose();
  const double share = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues()[2] / scatter.trace();
  return 2.0 * share - 1.0;
}

}  // namespace

std::vector<StampedPose> metric_poses(const Session& session) {
  if (session.ins.empty()) return session.world_from_ins;
  const InsSample& first = session.ins.front();
  const GeographicLib::LocalCartesian local(radians_to_degrees(first.latitude_rad),
                                            radians_to_degrees(first.longitude_rad), first.height_m);
  std::vector<StampedPose> poses;
  for (const InsSample& sample : session.ins) {
    Eigen::Vector3d position;
    local.Forward(radians_to_degrees(sample.latitude_rad), radians_to_degrees(sample.longitude_rad), sample.height_m,
                  position.x(), position.y(), position.z());
    poses.push_back({sample.stamp_ns, make_rigid(sample.enu_from_ins.toRotationMatrix(), position)});
  }
  return poses;
}

std::vector<Finding> attitude_findings(const Session& session) {
  constexpr std::size_t kFewSteps = 10;
  constexpr double kSpread = 0.6;  // a turn of 90 degrees that goes the wrong way spreads to 0
  std::vector<Finding> findings;
  const std::vector<StampedPose> poses = metric_poses(session);
  const std::vector<Eigen::Vector3d> travel = travel_in_ins(poses);
  if (travel.size() < kFewSteps) return findings;
  if (concentration(travel) < kSpread)
    findings.push_back({Severity::Problem, kHeadingAgainstTravel, session.name,
                        "The heading of the INS does not follow the direction of travel: rotations and positions are "
                        "not of one frame, and no mounting can be right. Check the convention of the attitude (heading "
                        "or yaw, ENU or NED, the order of the quaternion), and which column is yaw."});
  double up = 0.0;
  for (const StampedPose& pose : poses) up += pose.pose.linear()(2, 2) / static_cast<double>(poses.size());
  if (!session.ins.empty() && up < -0.5)
    findings.push_back({Severity::Problem, "attitude-upside-down", session.name,
                        "The z axis of the INS points down, where its axes are declared with z up: check the "
                        "convention of the attitude (ENU or NED, the order of the quaternion, roll by 180 degrees)."});
  return findings;
}

void blame_attitude(const std::vector<Finding>& findings, CalibrationResult& result) {
  constexpr double kFits_m = 0.2;
  const bool found = std::any_of(findings.begin(), findings.end(),
                                 [](const Finding& finding) { return finding.code == kHeadingAgainstTravel; });
  if (!found || result.status == Status::Cancelled) return;
  if (is_usable(result)) {
    if (result.translation_rms_m < kFits_m) return;
    result.status = Status::Inconsistent;
    result.message = "The INS contradicts itself: its heading does not follow the direction of its travel.";
  }
  result.advice = {
      "Before anything else check the convention of the INS attitude (heading or yaw, ENU or NED, the order "
      "of the quaternion): its heading does not follow the direction of travel."};
}

}  // namespace remount
