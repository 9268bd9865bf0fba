#include "algorithms/odometry/lidar/lidar_odometry.h"

#include <array>
#include <cmath>

#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "algorithms/core/symmetric_eigen.h"
#include "messages/odometry.h"

namespace remount::odometry {

struct LidarOdometry::Scan {
  const cloud::PointCloud& cloud;
  std::span<const float> times_s;
};

struct LidarOdometry::Attempt {
  std::unique_ptr<registration::PreparedCloud> cloud;
  registration::RegistrationResult result;
  RigidTransform odometry_from_lidar = RigidTransform::Identity();
  bool aligned() const { return cloud && result.quality.failure.empty(); }
};

// The newest scan, with a pose that is good enough to tell how the one before it moved.
struct LidarOdometry::Waiting {
  cloud::PointCloud cloud;
  std::vector<float> times_s;
  OdometryPose pose;
  Attempt found;  ///< nothing for the first scan
};

namespace {

// Inverse of the information, with what neighbouring surfaces and voxels do not average (measured on simulated
// streets), and a bound where hardly anything is known. docs/maths/odometry.md (D4)
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

registration::RegistrationOptions for_odometry(registration::RegistrationOptions registration, double voxel_m) {
  registration.voxel_m = voxel_m;
  // A velocity may be a mere guess: at the start, after scans that failed, or because it came from an alignment that
  // let rings of the ground slide over each other. That fits well wherever it ends, and the velocity that it tells
  // leads the next scan astray. Facades then miss each other, as they never do where a scan near the map is in place.
  registration.near_is_a_sign = false;
  // Rings of a sparse sensor on open ground lie between those of the map: less in common than two scans of a street
  // have is no sign of another place, where the prediction is near.
  registration.min_overlap *= 0.5;
  registration.max_iterations *= 3;  // a prediction in the place of a pose costs more than the few scans that need them
  return registration;
}

// What was aligned already is near, and time is short.
registration::RegistrationOptions for_refinement(registration::RegistrationOptions registration) {
  registration.search_when_doubtful = false;
  return registration;
}

TimedMotion seen_from(const OdometryPose& here, const OdometryPose& other) {
  return {seconds(other.stamp_ns - here.stamp_ns), here.odometry_from_lidar.inverse() * other.odometry_from_lidar};
}

}  // namespace

LidarOdometry::LidarOdometry(LidarOdometryOptions options, registration::RegistrationOptions registration)
    : options_(options),
      registration_(for_odometry(registration, options.voxel_m)),
      map_(registration_, static_cast<std::size_t>(options.map_keyframes)) {}

LidarOdometry::~LidarOdometry() = default;

std::unique_ptr<registration::PreparedCloud> LidarOdometry::prepare(const Scan& scan, const SweepMotion& motion,
                                                                    const Progress& progress) const {
  const std::vector<bool> all;
  if (scan.times_s.empty())
    return std::make_unique<registration::PreparedCloud>(scan.cloud, registration_, all, progress);
  const cloud::PointCloud compensated =
      cloud::deskew(scan.cloud, scan.times_s, [&motion](double time_s) { return motion.at(time_s); });
  return std::make_unique<registration::PreparedCloud>(compensated, registration_, all, progress);
}

LidarOdometry::Attempt LidarOdometry::attempt(const Scan& scan, const RigidTransform& start, const SweepMotion& motion,
                                              const registration::RegistrationOptions& registration,
                                              const Progress& progress) const {
  Attempt out;
  out.cloud = prepare(scan, motion, progress);
  const RigidTransform& odometry_from_map = map_.odometry_from_map();
  out.result =
      registration::align_scans(*out.cloud, map_.cloud(), odometry_from_map.inverse() * start, registration, progress);
  out.odometry_from_lidar = odometry_from_map * out.result.target_from_source;
  // Rotations stay rotations over ten thousand products.
  out.odometry_from_lidar.linear() = nearest_rotation(out.odometry_from_lidar.linear());
  return out;
}

void LidarOdometry::start_map(const Scan& scan, const RigidTransform& odometry_from_lidar, const SweepMotion& motion,
                              const Progress& progress) {
  map_.clear();
  map_.insert(*prepare(scan, motion, progress), odometry_from_lidar, progress);
}

bool LidarOdometry::joins_map(const RigidTransform& odometry_from_lidar) const {
  const RigidTransform away = map_.odometry_from_map().inverse() * odometry_from_lidar;
  return away.translation().norm() > options_.keyframe_distance_m ||
         so3_log(away.linear()).norm() > degrees_to_radians(options_.keyframe_angle_deg);
}

// Only the second scan tells by which motion the first one, the map so far, is torn: both are compensated again.
void LidarOdometry::mend_first_map(const Scan& second, OdometryPose pose, Attempt& found, const Progress& progress) {
  constexpr int kRepeats = 3;
  const Scan first{waiting_->cloud, waiting_->times_s};
  const RigidTransform& odometry_from_first = waiting_->pose.odometry_from_lidar;
  SweepMotion before;
  for (int repeat = 0; repeat < kRepeats && found.aligned(); ++repeat) {
    pose.odometry_from_lidar = found.odometry_from_lidar;
    const SweepMotion motion = SweepMotion::through(std::array{seen_from(waiting_->pose, pose)});
    start_map(first, odometry_from_first, motion, progress);
    Attempt again = attempt(second, found.odometry_from_lidar, motion, for_refinement(registration_), progress);
    if (!again.aligned()) {
      // Times that make it worse: what fitted before is kept, with the map that it fitted.
      start_map(first, odometry_from_first, before, progress);
      return;
    }
    before = motion;
    found = std::move(again);
  }
}

// What a scan is first compensated with is the motion before it. Its own brings it near enough to tell how the scan
// before it moved.
void LidarOdometry::compensate_again(const Scan& scan, OdometryPose pose, const OdometryPose& before, Attempt& found,
                                     const Progress& progress) const {
  if (!found.aligned()) return;
  pose.odometry_from_lidar = found.odometry_from_lidar;
  Attempt again = attempt(scan, found.odometry_from_lidar, SweepMotion::through(std::array{seen_from(pose, before)}),
                          for_refinement(registration_), progress);
  if (again.aligned()) found = std::move(again);
}

// Through the scans on both sides where they are known, else through the two before.
SweepMotion LidarOdometry::motion_around(const OdometryPose& pose, const OdometryPose* after) const {
  std::vector<TimedMotion> others;
  if (after && after->aligned) others.push_back(seen_from(pose, *after));
  for (auto before = final_.rbegin(); before != final_.rend() && others.size() < 2; ++before)
    if (before->aligned) others.push_back(seen_from(pose, *before));
  return SweepMotion::through(others);
}

// The map goes on with a scan whose pose is final.
OdometryPose LidarOdometry::accept(const Scan& scan, const Attempt& best, const SweepMotion& motion, OdometryPose pose,
                                   const Progress& progress) {
  constexpr int kMostFailures = 3;
  const motion::RegistrationQuality& quality = best.result.quality;
  pose.rmse_m = quality.rmse_m;
  pose.overlap = quality.overlap;
  pose.problem = quality.failure;
  pose.aligned = best.aligned();
  pose.undetermined = pose.aligned ? quality.undetermined : Message();
  const Eigen::Matrix3d lidar_from_map = best.result.target_from_source.linear().transpose();
  if (pose.aligned) pose.odometry_from_lidar = best.odometry_from_lidar;
  pose.covariance = covariance_of(pose.aligned ? quality.information : Matrix6d(Matrix6d::Zero()), lidar_from_map);
  failures_ = pose.aligned ? 0 : failures_ + 1;
  const bool lost = failures_ >= kMostFailures && !progress.cancelled();
  maps_ += lost ? 1 : 0;
  pose.map = maps_;
  if (progress.cancelled()) return pose;
  if (lost) {
    start_map(scan, pose.odometry_from_lidar, motion, progress);  // the old surroundings are lost: go on from here
    failures_ = 0;
  } else if (pose.aligned && joins_map(pose.odometry_from_lidar)) {
    map_.insert(*best.cloud, pose.odometry_from_lidar, progress);
  }
  return pose;
}

// The scan that waits, with the motion on both its sides.
OdometryPose LidarOdometry::settle(const OdometryPose* after, const Progress& progress) {
  const std::unique_ptr<Waiting> waiting = std::move(waiting_);
  if (final_.empty()) return keep(waiting->pose);
  const Scan scan{waiting->cloud, waiting->times_s};
  const SweepMotion motion = motion_around(waiting->pose, after);
  Attempt best = attempt(scan, waiting->pose.odometry_from_lidar, motion, for_refinement(registration_), progress);
  if (!best.aligned()) best = std::move(waiting->found);
  return keep(accept(scan, best, motion, waiting->pose, progress));
}

OdometryPose LidarOdometry::keep(OdometryPose pose) {
  if (final_.size() == 2) final_.erase(final_.begin());
  final_.push_back(pose);
  return pose;
}

std::vector<OdometryPose> LidarOdometry::start(const Scan& scan, std::int64_t stamp_ns, const Progress& progress) {
  OdometryPose pose;
  pose.stamp_ns = stamp_ns;
  start_map(scan, pose.odometry_from_lidar, {}, progress);
  if (scan.times_s.empty()) return {keep(pose)};
  waiting_.reset(new Waiting{scan.cloud, {scan.times_s.begin(), scan.times_s.end()}, pose, {}});
  return {};
}

std::vector<OdometryPose> LidarOdometry::push(const cloud::PointCloud& cloud_in_lidar, std::span<const float> times_s,
                                              std::int64_t stamp_ns, const Progress& progress,
                                              const std::optional<RigidTransform>& predicted_step) {
  const Scan scan{cloud_in_lidar, times_s};
  if (map_.empty()) return start(scan, stamp_ns, progress);
  const OdometryPose before = waiting_ ? waiting_->pose : final_.back();
  if (stamp_ns <= before.stamp_ns) throw Error(ErrorCode::Contract, "LiDAR odometry", say::odometry_stamps_descend());
  const double step_s = seconds(stamp_ns - before.stamp_ns);
  OdometryPose pose;
  pose.stamp_ns = stamp_ns;
  if (predicted_step) velocity_ = SweepMotion::through(std::array{TimedMotion{step_s, *predicted_step}}).velocity;
  const SweepMotion expected{velocity_, Vector6d::Zero()};
  pose.odometry_from_lidar = before.odometry_from_lidar * expected.at(step_s);
  Attempt found = attempt(scan, pose.odometry_from_lidar, expected, registration_, progress);
  if (final_.empty() && !times_s.empty())
    mend_first_map(scan, pose, found, progress);
  else if (!times_s.empty())
    compensate_again(scan, pose, before, found, progress);
  pose.aligned = found.aligned();
  if (pose.aligned) pose.odometry_from_lidar = found.odometry_from_lidar;
  std::vector<OdometryPose> final_now;
  if (waiting_) final_now.push_back(settle(&pose, progress));
  if (pose.aligned) velocity_ = SweepMotion::through(std::array{seen_from(pose, final_.back())}).velocity;
  if (times_s.empty())
    final_now.push_back(keep(accept(scan, found, expected, pose, progress)));
  else
    waiting_.reset(new Waiting{cloud_in_lidar, {times_s.begin(), times_s.end()}, pose, std::move(found)});
  return final_now;
}

std::vector<OdometryPose> LidarOdometry::finish(const Progress& progress) {
  if (!waiting_) return {};
  return {settle(nullptr, progress)};
}

}  // namespace remount::odometry
