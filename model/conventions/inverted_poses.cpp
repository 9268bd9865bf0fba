#include "model/conventions/inverted_poses.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "model/conventions/travel_steps.h"

namespace remount::conventions {
namespace {

constexpr std::size_t kFewestStepsOfTravel = 10;

/// Share of the travel that leads beside one axis of the body: 0 where all of it keeps to one.
double beside_one_axis(const std::vector<TravelStep>& steps) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const TravelStep& step : steps) {
    const Eigen::Vector3d direction = step.world_from_ins.transpose() * step.direction;
    scatter += direction * direction.transpose();
  }
  return 1.0 - symmetric_eigen(scatter).eigenvalues()[2] / scatter.trace();
}

std::vector<motion::StampedPose> inverses_of(const std::vector<motion::StampedPose>& poses) {
  std::vector<motion::StampedPose> inverted = poses;
  for (motion::StampedPose& pose : inverted) pose.pose = pose.pose.inverse();
  return inverted;
}

/// The same of the point of the body that keeps best to one axis: what is mounted far ahead of the axle goes sideways
/// in turns, and steady circles look alike either way.
double beside_one_axis_at_best(const std::vector<motion::StampedPose>& poses) {
  constexpr int kDirections = 8;
  double least = 1.0;
  for (const double lever_m : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0})
    for (int k = 0; k < kDirections; ++k) {
      const double angle_rad = 2.0 * kPi * k / kDirections;
      const Eigen::Vector3d lever(lever_m * std::cos(angle_rad), lever_m * std::sin(angle_rad), 0.0);
      std::vector<motion::StampedPose> moved = poses;
      for (motion::StampedPose& pose : moved) pose.pose.translation() += pose.pose.linear() * lever;
      const std::vector<TravelStep> steps = travel_steps(moved);
      if (steps.size() >= kFewestStepsOfTravel) least = std::min(least, beside_one_axis(steps));
    }
  return least;
}

bool are_inverted(const std::vector<motion::StampedPose>& poses) {
  constexpr double kFollows = 0.025, kFarLess = 0.1, kLeastBeside = 0.05;
  const std::vector<TravelStep> as_given = travel_steps(poses);
  const double beside = as_given.size() < kFewestStepsOfTravel ? 1.0 : beside_one_axis(as_given);
  if (beside < kLeastBeside) return false;
  const std::vector<TravelStep> inverted = travel_steps(inverses_of(poses));
  if (inverted.size() < kFewestStepsOfTravel) return false;
  const double left = beside_one_axis(inverted);
  return left < kFollows && left < kFarLess * beside && beside_one_axis_at_best(poses) > kLeastBeside;
}

}  // namespace

std::vector<drive::Finding> inverted_pose_findings(const drive::Session& session) {
  std::vector<drive::Finding> findings;
  const bool ins = session.ins.empty() && are_inverted(session.world_from_ins);
  const bool lidar = are_inverted(session.odometry_from_lidar);
  if (ins) findings.push_back({drive::Severity::Problem, kPosesInverted, session.name, say::ins_poses_inverted()});
  if (lidar) findings.push_back({drive::Severity::Problem, kPosesInverted, session.name, say::lidar_poses_inverted()});
  return findings;
}

}  // namespace remount::conventions
