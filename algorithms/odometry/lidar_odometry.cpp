#include "algorithms/odometry/lidar_odometry.h"

#include <cmath>

#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount {

struct LidarOdometry::Scan {
  const PointCloud& cloud;
  std::span<const float> times_s;
};

struct LidarOdometry::Attempt {
  std::unique_ptr<PreparedCloud> cloud;
  RegistrationResult result;
  RigidTransform odometry_from_lidar;
};

namespace {

// What the motion at a constant velocity makes in a time.
RigidTransform motion(const Vector6d& velocity, double time_s) {
  const Eigen::Vector3d turn = velocity.tail<3>() * time_s;
  return make_rigid(so3_exp(turn), so3_left_jacobian(turn) * velocity.head<3>() * time_s);
}

// Inverse of the information, with what neighbouring surfaces and voxels do not average (measured on simulated
// streets), and a bound where hardly anything is known.
Matrix6d covariance_of(const Matrix6d& information, const Eigen::Matrix3d& lidar_from_map) {
  constexpr double kScale = 3.0, kFloor_m = 1.5e-3, kFloor_rad = 1e-4, kLever_m = 10.0, kMost_m = 1.0;
  Matrix6d turned = Matrix6d::Zero(), units = Matrix6d::Identity();
  turned.topLeftCorner<3, 3>() = turned.bottomRightCorner<3, 3>() = lidar_from_map;
  units.bottomRightCorner<3, 3>() /= kLever_m;
  const Matrix6d scaled = units * turned * information * turned.transpose() * units;
  const auto eigen = symmetric_eigen(Matrix6d(0.5 * (scaled + scaled.transpose())));
  Vector6d variances;
  for (int i = 0; i < 6; ++i)
    variances[i] = 1.0 / std::max(eigen.eigenvalues()[i] / (kScale * kScale), 1.0 / (kMost_m * kMost_m));
  Matrix6d covariance =
      units * eigen.eigenvectors() * variances.asDiagonal() * eigen.eigenvectors().transpose() * units;
  covariance.diagonal().head<3>().array() += kFloor_m * kFloor_m;
  covariance.diagonal().tail<3>().array() += kFloor_rad * kFloor_rad;
  return covariance;
}

RegistrationOptions for_odometry(RegistrationOptions registration, double voxel_m) {
  registration.voxel_m = voxel_m;
  registration.search_when_doubtful = false;  // the prediction is near, and time is short
  return registration;
}

}  // namespace

LidarOdometry::LidarOdometry(LidarOdometryOptions options, RegistrationOptions registration)
    : options_(options),
      registration_(for_odometry(registration, options.voxel_m)),
      map_(registration_, static_cast<std::size_t>(options.map_keyframes)) {}

PreparedCloud LidarOdometry::prepared(const Scan& scan, const Vector6d& velocity, const Progress& progress) const {
  if (scan.times_s.empty()) return PreparedCloud(scan.cloud, registration_, {}, progress);
  const PointCloud compensated =
      deskew(scan.cloud, scan.times_s, [&](double time_s) { return motion(velocity, time_s); });
  return PreparedCloud(compensated, registration_, {}, progress);
}

Vector6d LidarOdometry::velocity_to(const RigidTransform& odometry_from_lidar, std::int64_t stamp_ns) const {
  const double step_s = static_cast<double>(stamp_ns - last_.stamp_ns) * 1e-9;
  const RigidTransform step = last_.odometry_from_lidar.inverse() * odometry_from_lidar;
  const Eigen::Vector3d turn = so3_log(step.linear());
  Vector6d velocity;
  velocity << so3_left_jacobian_inverse(turn) * step.translation() / step_s, turn / step_s;
  return velocity;
}

LidarOdometry::Attempt LidarOdometry::attempt(const Scan& scan, const RigidTransform& start, const Vector6d& velocity,
                                              const Progress& progress) const {
  Attempt out;
  out.cloud.reset(new PreparedCloud(prepared(scan, velocity, progress)));
  const RigidTransform& odometry_from_map = map_.odometry_from_map();
  out.result = align_scans(*out.cloud, map_.cloud(), odometry_from_map.inverse() * start, registration_, progress);
  out.odometry_from_lidar = odometry_from_map * out.result.target_from_source;
  // Rotations stay rotations over ten thousand products.
  out.odometry_from_lidar.linear() = nearest_rotation(out.odometry_from_lidar.linear());
  return out;
}

void LidarOdometry::start_map(const Scan& scan, const Vector6d& velocity, const Progress& progress) {
  map_.clear();
  map_.insert(prepared(scan, velocity, progress), last_.odometry_from_lidar, progress);
}

bool LidarOdometry::joins_map(const RigidTransform& odometry_from_lidar) const {
  const RigidTransform away = map_.odometry_from_map().inverse() * odometry_from_lidar;
  return away.translation().norm() > options_.keyframe_distance_m ||
         so3_log(away.linear()).norm() > degrees_to_radians(options_.keyframe_angle_deg);
}

void LidarOdometry::start(const Scan& scan, std::int64_t stamp_ns, const Progress& progress) {
  last_ = {};
  last_.stamp_ns = stamp_ns;
  first_cloud_ = scan.cloud;
  first_times_s_.assign(scan.times_s.begin(), scan.times_s.end());
  start_map(scan, velocity_, progress);
}

LidarOdometry::Attempt LidarOdometry::best_attempt(const Scan& scan, const RigidTransform& predicted,
                                                   std::int64_t stamp_ns, const Progress& progress) {
  constexpr double kNewVelocity_mps = 0.15, kNewRate_radps = 0.015;
  Attempt best = attempt(scan, predicted, velocity_, progress);
  // Scans that were compensated by a velocity that is not theirs are compensated again; so is the first one, which had
  // none.
  const Scan first{first_cloud_, first_times_s_};
  const bool first_step = scans_ == 2 && !first_times_s_.empty();
  for (int repeat = 0; repeat < (first_step ? 3 : 1) && best.result.quality.failure.empty(); ++repeat) {
    const Vector6d found = velocity_to(best.odometry_from_lidar, stamp_ns);
    const Vector6d change = found - velocity_;
    const bool other = change.head<3>().norm() > kNewVelocity_mps || change.tail<3>().norm() > kNewRate_radps;
    if (scan.times_s.empty() || (!other && !first_step)) break;
    if (first_step) start_map(first, found, progress);
    Attempt again = attempt(scan, best.odometry_from_lidar, found, progress);
    if (!again.result.quality.failure.empty()) {
      // Times that make it worse: what fitted before is kept, with the map that it fitted.
      if (first_step) start_map(first, velocity_, progress);
      break;
    }
    velocity_ = found;
    best = std::move(again);
  }
  if (scans_ == 2) first_cloud_ = {};
  return best;
}

OdometryPose LidarOdometry::accept(const Scan& scan, const Attempt& best, OdometryPose pose, const Progress& progress) {
  constexpr int kMostFailures = 3;
  const RegistrationQuality& quality = best.result.quality;
  pose.rmse_m = quality.rmse_m;
  pose.overlap = quality.overlap;
  pose.problem = quality.failure;
  pose.aligned = quality.failure.empty();
  pose.undetermined = pose.aligned ? quality.undetermined : std::string();
  const Eigen::Matrix3d lidar_from_map = best.result.target_from_source.linear().transpose();
  if (pose.aligned) pose.odometry_from_lidar = best.odometry_from_lidar;
  pose.covariance = covariance_of(pose.aligned ? quality.information : Matrix6d(Matrix6d::Zero()), lidar_from_map);
  failures_ = pose.aligned ? 0 : failures_ + 1;
  if (pose.aligned) velocity_ = velocity_to(pose.odometry_from_lidar, pose.stamp_ns);
  const bool lost = failures_ >= kMostFailures && !progress.cancelled();
  pose.map += lost ? 1 : 0;
  last_ = pose;
  if (progress.cancelled()) return pose;
  if (lost) {
    start_map(scan, velocity_, progress);  // the old surroundings are lost: go on from here
    failures_ = 0;
  } else if (pose.aligned && joins_map(pose.odometry_from_lidar)) {
    map_.insert(*best.cloud, pose.odometry_from_lidar, progress);
  }
  return pose;
}

OdometryPose LidarOdometry::push(const PointCloud& cloud_in_lidar, std::span<const float> times_s,
                                 std::int64_t stamp_ns, const Progress& progress,
                                 const std::optional<RigidTransform>& predicted_step) {
  const Scan scan{cloud_in_lidar, times_s};
  if (scans_++ == 0) {
    start(scan, stamp_ns, progress);
    return last_;
  }
  if (stamp_ns <= last_.stamp_ns) throw Error(ErrorCode::Contract, "LiDAR odometry", "the stamps of scans must ascend");
  const double step_s = static_cast<double>(stamp_ns - last_.stamp_ns) * 1e-9;
  OdometryPose pose;
  pose.stamp_ns = stamp_ns;
  pose.map = last_.map;
  pose.odometry_from_lidar = last_.odometry_from_lidar * predicted_step.value_or(motion(velocity_, step_s));
  if (predicted_step) velocity_ = velocity_to(pose.odometry_from_lidar, stamp_ns);
  const Attempt best = best_attempt(scan, pose.odometry_from_lidar, stamp_ns, progress);
  return accept(scan, best, std::move(pose), progress);
}

}  // namespace remount
