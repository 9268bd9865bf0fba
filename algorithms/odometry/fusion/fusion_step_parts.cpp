#include "algorithms/odometry/fusion/fusion_step_parts.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/geodesy/earth_radius.h"
#include "algorithms/registration/undetermined.h"
#include "messages/pairs.h"

namespace remount::odometry {
namespace {

constexpr double kGravity_mps2 = 9.81;
constexpr std::size_t kLeastMatches = 40;

template <class Sample>
auto first_at(const std::vector<Sample>& samples, std::int64_t stamp_ns) {
  return std::lower_bound(samples.begin(), samples.end(), stamp_ns,
                          [](const Sample& sample, std::int64_t at) { return sample.stamp_ns < at; });
}

constexpr std::int64_t kLevelReach_ns = 250000000;

// Slope per second of a quantity over the samples' reach, by least squares: single samples of the wheels are too noisy
// for an acceleration. Nothing where the sensor does not say, or for less than half of the reach.
template <class Value, class Ask>
std::optional<Value> slope(Ask&& ask, std::int64_t stamp_ns) {
  constexpr std::int64_t kStep_ns = 10000000;
  std::vector<std::pair<double, Value>> asked;
  for (std::int64_t offset_ns = -kLevelReach_ns; offset_ns <= kLevelReach_ns; offset_ns += kStep_ns)
    if (const auto value = ask(stamp_ns + offset_ns)) asked.emplace_back(seconds(offset_ns), *value);
  if (asked.empty() || asked.back().first - asked.front().first < seconds(kLevelReach_ns)) return std::nullopt;
  double mean_s = 0.0, spread = 0.0;
  for (const auto& [time_s, value] : asked) mean_s += time_s / static_cast<double>(asked.size());
  Value sum = asked.front().second * 0.0;
  for (const auto& [time_s, value] : asked) {
    sum += (time_s - mean_s) * value;
    spread += (time_s - mean_s) * (time_s - mean_s);
  }
  return Value(sum / spread);
}

}  // namespace

RigidTransform moved_at(const Vector6d& velocity, double time_s) {
  const Eigen::Vector3d turn = velocity.tail<3>() * time_s;
  return make_rigid(so3_exp(turn), so3_left_jacobian(turn) * velocity.head<3>() * time_s);
}

Vector6d velocity_between(const RigidTransform& odometry_from_before, const RigidTransform& odometry_from_after,
                          double duration_s) {
  const RigidTransform moved = odometry_from_before.inverse() * odometry_from_after;
  const Eigen::Vector3d turn = so3_log(moved.linear());
  Vector6d velocity;
  velocity << so3_left_jacobian_inverse(turn) * moved.translation(), turn;
  return velocity / duration_s;
}

bool changed_too_much(const Vector6d& used, const Vector6d& found) {
  constexpr double kShift_mps = 0.2, kTurn_radps = 0.01;  // over half a sweep of 0.1 s, points 20 m away
  return (used - found).head<3>().norm() > kShift_mps || (used - found).tail<3>().norm() > kTurn_radps;
}

VehicleMotion::VehicleMotion(std::optional<DeadReckonedPath> path, const std::optional<Vector6d>& velocity)
    : path_(std::move(path)), velocity_(velocity.value_or(Vector6d::Zero())) {
  if (path_) stamp_from_start_ = path_->at(0.0).inverse();
}

RigidTransform VehicleMotion::at_stamp_from_at(double time_s) const {
  RigidTransform steady = moved_at(velocity_, time_s);
  if (!path_) return steady;
  const RigidTransform reckoned = stamp_from_start_ * path_->at(time_s);
  if (path_->has_rotation) steady.linear() = reckoned.linear();
  if (path_->has_speed) steady.translation() = reckoned.translation();
  return steady;
}

MotionSigma motion_sigma(const FusionOptions& options, const std::optional<DeadReckonedPath>& path, bool velocity_known,
                         double duration_s, double blind_s) {
  constexpr double kAcceleration_mps2 = 10.0, kTurning_radps2 = 5.0;
  constexpr double kFastest_mps = 30.0, kFastestTurn_radps = 1.0;  // where nothing is known of the velocity
  constexpr double kRocking_radps = 0.05;                          // roll and pitch that wheels do not see
  MotionSigma sigma;
  sigma.travel_m.setConstant(velocity_known ? kAcceleration_mps2 * (duration_s + blind_s) : kFastest_mps);
  sigma.turn_rad.setConstant(velocity_known ? kTurning_radps2 * (duration_s + blind_s) : kFastestTurn_radps);
  if (path && path->has_speed) {
    const double along = options.wheel_sigma * std::abs(path->mean_speed_mps) + options.wheel_sigma_mps;
    sigma.travel_m << along, options.sideslip_sigma_mps, options.sideslip_sigma_mps;
    if (path->has_rotation) sigma.turn_rad << kRocking_radps, kRocking_radps, 2.0 * along / options.track_width_m;
  }
  if (path && path->has_rotation && path->by_gyro)
    sigma.turn_rad.setConstant(degrees_to_radians(options.gyro_sigma_dps));
  sigma.travel_m *= duration_s;
  sigma.turn_rad *= duration_s;
  return sigma;
}

std::optional<GravityMeasurement> gravity_in_vehicle(const std::vector<motion::ImuSample>& imu,
                                                     const DeadReckoning& reckoning,
                                                     const RigidTransform& vehicle_from_imu,
                                                     const DeadReckoningState& drift,
                                                     const std::optional<Vector6d>& velocity, std::int64_t stamp_ns) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (auto sample = first_at(imu, stamp_ns - kLevelReach_ns);
       sample != imu.end() && sample->stamp_ns <= stamp_ns + kLevelReach_ns; ++sample, count += 1.0)
    sum += sample->specific_force_mps2;
  if (count < 1.0) return std::nullopt;
  constexpr double kAcceleration_mps2 = 3.0, kSpeed_mps = 20.0;  // of traffic, where nothing tells
  const auto rate_at = [&](std::int64_t at) -> std::optional<Eigen::Vector3d> {
    const auto turning = reckoning.turning(at, drift);
    return turning ? std::optional(turning->rate_radps) : std::nullopt;
  };
  const auto speed_at = [&](std::int64_t at) { return reckoning.speed_mps(at); };
  const auto rate = rate_at(stamp_ns);
  const auto speed = speed_at(stamp_ns);
  const auto change = slope<double>(speed_at, stamp_ns);
  const Vector6d steady = velocity.value_or(Vector6d::Zero());
  const Eigen::Vector3d turning = rate.value_or(Eigen::Vector3d(steady.tail<3>()));
  const Eigen::Vector3d forward =
      speed ? Eigen::Vector3d(*speed * drift.wheel_scale, 0.0, 0.0) : Eigen::Vector3d(steady.head<3>());
  const Eigen::Vector3d along(change.value_or(0.0) * drift.wheel_scale, 0.0, 0.0);
  const Eigen::Vector3d spin_up = slope<Eigen::Vector3d>(rate_at, stamp_ns).value_or(Eigen::Vector3d::Zero());
  const Eigen::Vector3d arm = vehicle_from_imu.translation();
  const Eigen::Vector3d own = along + turning.cross(forward) + spin_up.cross(arm) + turning.cross(turning.cross(arm));
  const Eigen::Vector3d up = vehicle_from_imu.linear() * (sum / count) - own;
  if (std::abs(up.norm() - kGravity_mps2) > 1.0) return std::nullopt;
  GravityMeasurement gravity{up, own.norm()};
  if (!change) gravity.forward_unknown_mps2 = kAcceleration_mps2;
  if (!rate && !velocity)
    gravity.sideways_unknown_mps2 = kAcceleration_mps2;
  else if (!speed && !velocity)
    gravity.sideways_unknown_mps2 = kSpeed_mps * std::abs(turning.z());
  return gravity;
}

LevelMeasurement level_of(const GravityMeasurement& gravity, const RigidTransform& odometry_from_vehicle,
                          const FusionOptions& options) {
  LevelMeasurement level = level_from_gravity(up_at_start(gravity.up_mps2, odometry_from_vehicle));
  const double known_rad =
      degrees_to_radians(options.accelerometer_sigma_deg + options.accelerometer_discount_deg * gravity.taken_off_mps2);
  level.roll_sigma_rad = std::hypot(known_rad, std::atan(gravity.sideways_unknown_mps2 / kGravity_mps2));
  level.pitch_sigma_rad = std::hypot(known_rad, std::atan(gravity.forward_unknown_mps2 / kGravity_mps2));
  return level;
}

double window_overlap(double duration_s) { return std::max(1.0, 2.0 * seconds(kLevelReach_ns) / duration_s); }

double drop_of_level_m(const Eigen::Vector3d& place_in_odometry) {
  return place_in_odometry.head<2>().squaredNorm() / (2.0 * geodesy::kEarthRadius_m);
}

Eigen::Vector3d up_at_start(const Eigen::Vector3d& up_in_vehicle, const RigidTransform& odometry_from_vehicle) {
  const Eigen::Vector3d lean(odometry_from_vehicle.translation().x() / geodesy::kEarthRadius_m,
                             odometry_from_vehicle.translation().y() / geodesy::kEarthRadius_m, 0.0);
  return up_in_vehicle - up_in_vehicle.norm() * (odometry_from_vehicle.linear().transpose() * lean);
}

std::optional<double> mean_height_m(const std::vector<motion::BarometerSample>& barometer, std::int64_t stamp_ns) {
  constexpr std::int64_t kReach_ns = 250000000;
  double sum = 0.0, count = 0.0;
  for (auto sample = first_at(barometer, stamp_ns - kReach_ns);
       sample != barometer.end() && sample->stamp_ns <= stamp_ns + kReach_ns; ++sample)
    if (std::isfinite(sample->height_m)) {
      sum += sample->height_m;
      count += 1.0;
    }
  if (count < 1.0) return std::nullopt;
  return sum / count;
}

double rms_distance_m(const FeatureMatches& matches) {
  double sum = 0.0;
  for (const auto* list : {&matches.lines, &matches.planes})
    for (const FeatureMatch& match : *list) sum += match.distance_m * match.distance_m;
  return std::sqrt(sum / static_cast<double>(matches.lines.size() + matches.planes.size()));
}

double median_distance_m(const FeatureMatches& matches) {
  std::vector<double> distances;
  for (const auto* list : {&matches.lines, &matches.planes})
    for (const FeatureMatch& match : *list) distances.push_back(match.distance_m);
  if (distances.empty()) return std::numeric_limits<double>::quiet_NaN();
  return median_of(std::move(distances));
}

HeardFeatures heard_features(const FeatureMatches& matches, const RigidTransform& odometry_from_vehicle,
                             double expected_m, const FusionOptions& options) {
  HeardFeatures result;
  const std::size_t count = matches.lines.size() + matches.planes.size();
  result.none = count < kLeastMatches;
  if (result.none) {
    result.undetermined = say::open_all();
    return result;
  }
  const double share = std::min(1.0, options.independent_features / static_cast<double>(count));
  // An edge lies where a ray happened to meet it. All features of an edge err alike, and along with the vehicle.
  constexpr double kFeaturesOfEdge = 10.0;
  // Cauchy's weight, wide while the scan is still far from the map.
  const double usual_m = std::max(expected_m, 2.0 * median_distance_m(matches));
  const auto weight_of = [usual_m](const FeatureMatch& match, double sigma_m) {
    const double ratio = match.distance_m / std::max(usual_m, 2.0 * sigma_m);
    return 1.0 / (1.0 + ratio * ratio);
  };
  // In vehicle axes, so that words name those.
  const Eigen::Matrix3d vehicle_from_odometry = odometry_from_vehicle.linear().transpose();
  std::vector<registration::SurfaceElement> elements;
  elements.reserve(count + matches.lines.size());
  for (const FeatureMatch& match : matches.lines) {
    const double weight = weight_of(match, options.line_sigma_m);
    result.line_weights.push_back(std::sqrt(weight * share / kFeaturesOfEdge) / options.line_sigma_m);
    const Eigen::Vector3d along = vehicle_from_odometry * match.direction;
    const Eigen::Vector3d across = along.unitOrthogonal();
    elements.push_back({across, match.point_in_vehicle, weight});
    elements.push_back({along.cross(across), match.point_in_vehicle, weight});
  }
  for (const FeatureMatch& match : matches.planes) {
    const double weight = weight_of(match, options.plane_sigma_m);
    result.plane_weights.push_back(std::sqrt(weight * share) / options.plane_sigma_m);
    elements.push_back({vehicle_from_odometry * match.direction, match.point_in_vehicle, weight});
  }
  const registration::UndeterminedDirections open = registration::undetermined_directions(elements);
  result.none = open.all();
  if (!open.empty()) result.undetermined = say::open_of_vehicle(open.directions());
  Vector6d scale;
  scale << 1.0, 1.0, 1.0, open.lever_m, open.lever_m, open.lever_m;
  Matrix6d axes = Matrix6d::Zero();
  axes.topLeftCorner<3, 3>() = axes.bottomRightCorner<3, 3>() = odometry_from_vehicle.linear();
  result.heard = axes * scale.cwiseInverse().asDiagonal() *
                 (Matrix6d::Identity() - open.basis * open.basis.transpose()) * scale.asDiagonal() * axes.transpose();
  return result;
}

Eigen::MatrixXd root_information(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd sigma = covariance.diagonal().cwiseMax(1e-24).cwiseSqrt();
  const Eigen::VectorXd inverse_sigma = sigma.cwiseInverse();
  Eigen::MatrixXd correlation = inverse_sigma.asDiagonal() * covariance * inverse_sigma.asDiagonal();
  correlation.diagonal().array() += 1e-9;  // rounding over a long drive must not make it indefinite
  const Eigen::MatrixXd lower = correlation.llt().matrixL();
  return lower.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd(inverse_sigma.asDiagonal()));
}

std::optional<FusionInformation> inverse_information(const FusionInformation& information) {
  const FusionVector scale = information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const FusionInformation scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::LLT<FusionInformation> factor(scaled);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const FusionInformation inverse = factor.solve(FusionInformation::Identity());
  return FusionInformation(scale.asDiagonal() * inverse * scale.asDiagonal());
}

}  // namespace remount::odometry
