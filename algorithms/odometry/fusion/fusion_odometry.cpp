#include "algorithms/odometry/fusion/fusion_odometry.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "algorithms/odometry/fusion/fusion_step_parts.h"
#include "algorithms/registration/registration.h"
#include "messages/odometry.h"
#include "messages/stages.h"

namespace remount::odometry {
namespace {

constexpr int kMostIterations = 8;
constexpr int kMostFirstIterations = 20;    // where nothing predicts the motion
constexpr int kLostScans = 3;               // after which the map is given up
constexpr std::size_t kLeastFeatures = 40;  // fewer tell nothing and push nothing out of the map
constexpr double kSettled_m = 1e-3, kSettled_rad = 1e-4;

// How far neighbours are looked for, as a share of the setting, and what distances are taken for serious: where nothing
// predicts the motion, first the few surfaces across it must be heard over the many along it.
struct Search {
  double widen, expected_m;
  bool narrow;  // nothing more is to be expected of the next iteration than better numbers
};

Search search_at(int iteration, bool predicted) {
  constexpr double kSerious_m = 0.06;
  const double expected_m = predicted ? 0.2 * std::pow(0.5, iteration) : 2.0 * std::pow(0.75, iteration);
  const double widen = predicted ? 1.0 : std::max(1.0, 3.0 - 0.25 * iteration);
  return {widen, expected_m, widen <= 1.0 && expected_m <= kSerious_m};
}

}  // namespace

struct FusionOdometry::Step {
  std::int64_t from_ns = 0, stamp_ns = 0;
  double duration_s = 0.0;
  StepAnchor anchor;
  std::optional<DeadReckonedPath> path;  // over the step
  bool velocity_known = false;
  std::optional<LevelMeasurement> level;
  std::optional<HeightTerm> height;
  ScanFeatures features;  // in the vehicle frame
  FusionVector x = FusionVector::Zero();
  FusionInformation information = FusionInformation::Zero();

  bool predicted() const { return velocity_known || (path && path->has_speed); }
};

FusionOdometry::FusionOdometry(const FusionMounting& mounting, SensorStreams streams, const FusionOptions& options,
                               int threads)
    : mounting_(mounting),
      options_(options),
      imu_(streams.imu),
      barometer_(std::move(streams.barometer)),
      reckoning_(std::move(streams.imu), std::move(streams.wheels), mounting.vehicle_from_imu, options.track_width_m),
      threads_(threads),
      errors_(options) {
  if (Message all = in_one(option_problems(options)); !all.empty())
    throw Error(ErrorCode::Contract, "multi-sensor odometry", std::move(all));
  std::erase_if(imu_, [](const motion::ImuSample& sample) { return !sample.specific_force_mps2.allFinite(); });
}

FusedScan FusionOdometry::add(const OdometryScan& scan) {
  if (last_ && scan.stamp_ns <= last_->stamp_ns)
    throw Error(ErrorCode::Contract, "multi-sensor odometry", say::odometry_scan_not_later());
  if (!last_) {
    FusedScan result;
    start(scan, result);
    last_ = result;
    return result;
  }
  return follow(scan);
}

void FusionOdometry::start(const OdometryScan& scan, FusedScan& result) {
  result.stamp_ns = scan.stamp_ns;
  result.usable = true;
  const auto level = options_.accelerometer ? level_at(scan.stamp_ns, result.odometry_from_vehicle) : std::nullopt;
  if (level)
    result.odometry_from_vehicle.linear() = rotation_from_yaw_pitch_roll({0.0, level->pitch_rad, level->roll_rad});
  result.levelled = level.has_value();
  errors_.start(level, options_.barometer && !barometer_.empty());
  result.covariance = errors_.covariance().topLeftCorner<6, 6>();
  start_height(result);
  ScanFeatures features = features_of(scan, std::nullopt);
  result.line_features = static_cast<int>(features.lines.size());
  result.plane_features = static_cast<int>(features.planes.size());
  map_.add(std::move(features), result.odometry_from_vehicle, options_);
  map_.rebuild(options_);
  if (!options_.ackermann || !reckoning_.has_wheels()) first_scan_ = scan;
}

FusionOdometry::Step FusionOdometry::predict(std::int64_t stamp_ns, const std::optional<Vector6d>& velocity) const {
  Step step;
  step.from_ns = last_->stamp_ns;
  step.stamp_ns = stamp_ns;
  step.duration_s = seconds(stamp_ns - step.from_ns);
  step.velocity_known = velocity.has_value();
  step.anchor.before = last_->odometry_from_vehicle;
  if (options_.ackermann) step.path = reckoning_.path(step.from_ns, stamp_ns, step.from_ns, drift_);
  RigidTransform before_from_after = velocity ? moved_at(*velocity, step.duration_s) : RigidTransform::Identity();
  if (step.path) {
    const RigidTransform& end = step.path->start_from_vehicle.back();
    if (step.path->has_rotation) before_from_after.linear() = end.linear();
    if (step.path->has_speed) before_from_after.translation() = end.translation();
  }
  step.anchor.predicted = step.anchor.before * before_from_after;
  const double overlap = std::sqrt(window_overlap(step.duration_s));
  if (options_.accelerometer) step.level = level_at(stamp_ns, step.anchor.predicted);
  if (step.level) {
    step.level->roll_sigma_rad *= overlap, step.level->pitch_sigma_rad *= overlap;
    step.level->roll_rad += steady_rad_[0], step.level->pitch_rad += steady_rad_[1];
  }
  if (const auto height_m = height_offset_m_ ? height_at(stamp_ns) : std::nullopt)
    step.height.emplace(step.anchor,
                        *height_m - *height_offset_m_ - drop_of_level_m(step.anchor.predicted.translation()),
                        overlap * options_.barometer_sigma_m);
  return step;
}

ScanFeatures FusionOdometry::features_of(const OdometryScan& scan, const std::optional<Vector6d>& velocity) const {
  const cloud::PointCloud* cloud = &scan.cloud_in_lidar;
  cloud::PointCloud compensated;
  if (options_.deskew && scan.time_from_stamp_s.size() == cloud->size() && !cloud->points.empty()) {
    const auto [first, last] = std::minmax_element(scan.time_from_stamp_s.begin(), scan.time_from_stamp_s.end());
    const auto at_ns = [&](float time_s) { return scan.stamp_ns + std::llround(static_cast<double>(time_s) * 1e9); };
    std::optional<DeadReckonedPath> path;
    if (options_.ackermann)
      path = reckoning_.path(at_ns(std::min(*first, 0.0f)), at_ns(std::max(*last, 0.0f)), scan.stamp_ns, drift_);
    if (path || velocity) {
      const VehicleMotion motion(path, velocity);
      const RigidTransform lidar_from_vehicle = mounting_.vehicle_from_lidar.inverse();
      compensated = cloud::deskew(*cloud, scan.time_from_stamp_s, [&](double time_s) {
        return RigidTransform(lidar_from_vehicle * motion.at_stamp_from_at(time_s) * mounting_.vehicle_from_lidar);
      });
      cloud = &compensated;
    }
  }
  ScanFeatures features = extract_features(*cloud, options_);
  const Eigen::Isometry3f vehicle_from_lidar = mounting_.vehicle_from_lidar.cast<float>();
  for (Eigen::Vector3f& point : features.lines) point = vehicle_from_lidar * point;
  for (Eigen::Vector3f& point : features.planes) point = vehicle_from_lidar * point;
  return features;
}

std::optional<Vector6d> FusionOdometry::first_velocity(const OdometryScan& scan) const {
  if (!first_scan_ || (!options_.lines && !options_.planes)) return std::nullopt;
  registration::RegistrationOptions options;
  options.min_range_m = options_.min_range_m;
  options.max_range_m = options_.max_range_m;
  const registration::PreparedCloud first(first_scan_->cloud_in_lidar, options), now(scan.cloud_in_lidar, options);
  const registration::RegistrationResult aligned =
      registration::align_scans(now, first, RigidTransform::Identity(), options, {});
  if (!aligned.quality.converged) return std::nullopt;
  const RigidTransform before_from_after =
      mounting_.vehicle_from_lidar * aligned.target_from_source * mounting_.vehicle_from_lidar.inverse();
  return velocity_between(RigidTransform::Identity(), before_from_after, seconds(scan.stamp_ns - last_->stamp_ns));
}

FusedScan FusionOdometry::follow(const OdometryScan& scan) {
  FusedScan result;
  result.stamp_ns = scan.stamp_ns;
  const std::optional<Vector6d> assumed = velocity_ ? velocity_ : first_velocity(scan);
  Step step = predict(scan.stamp_ns, assumed);
  step.features = features_of(scan, assumed);
  match_and_solve(step, result);
  const bool blind_deskew = options_.deskew && !scan.time_from_stamp_s.empty() && !(step.path && step.path->has_speed);
  const Vector6d velocity = velocity_between(step.anchor.before, moved_pose(step.anchor, step.x), step.duration_s);
  if (blind_deskew && (first_scan_ || !assumed || changed_too_much(*assumed, velocity))) {
    // Motion within the scan was compensated by a velocity that turned out wrong; within the first one, not at all.
    if (first_scan_) {
      map_ = FeatureMap();
      map_.add(features_of(*first_scan_, velocity), last_->odometry_from_vehicle, options_);
      map_.rebuild(options_);
    }
    step = predict(scan.stamp_ns, velocity);
    step.features = features_of(scan, velocity);
    match_and_solve(step, result);
  }
  first_scan_.reset();
  accept(step, result);
  if (lost_scans_ >= kLostScans) {
    restart_map(scan);
    last_->map_restarted = result.map_restarted = true;
  }
  return result;
}

void FusionOdometry::match_and_solve(Step& step, FusedScan& result) const {
  const int most = step.predicted() ? kMostIterations : kMostFirstIterations;
  result.line_features = static_cast<int>(step.features.lines.size());
  result.plane_features = static_cast<int>(step.features.planes.size());
  result.usable = false;  // what an earlier pass said of another prediction counts no more
  for (int iteration = 0; iteration < most; ++iteration) {
    std::vector<WeighedTerm> terms;
    add_prior(step, terms);
    add_absolute(step, terms, result);
    const bool features = add_features(step, iteration, terms, result);
    add_motion(step, result.untold, terms);
    const JointStep joint = solve_joint_step(terms, step.x);
    if (!joint.usable) return;
    const Vector6d change = joint.x.segment<6>(kMotion) - step.x.segment<6>(kMotion);
    step.x = joint.x;
    step.information = joint.information;
    result.usable = features || result.dead_reckoned;
    const bool settled = change.head<3>().norm() < kSettled_m && change.tail<3>().norm() < kSettled_rad;
    if (!features || (settled && search_at(iteration, step.predicted()).narrow)) break;
  }
}

void FusionOdometry::add_prior(const Step& step, std::vector<WeighedTerm>& terms) const {
  terms.push_back(
      {std::make_unique<LinearFusionTerm>(errors_.prior_root(step.duration_s), FusionVector::Zero().eval()), false});
  const auto standing =
      options_.ackermann ? reckoning_.standstill_rate_radps(step.from_ns, step.stamp_ns) : std::nullopt;
  if (!standing) return;
  FusionJacobian rates = FusionJacobian::Zero(3, kFusionUnknowns);
  rates.block<3, 3>(0, kDrift).diagonal().setConstant(1.0 / degrees_to_radians(options_.gyro_sigma_dps));
  FusionVector expected = FusionVector::Zero();
  expected.segment<3>(kDrift) = *standing - drift_.gyro_bias_radps;
  terms.push_back({std::make_unique<LinearFusionTerm>(std::move(rates), expected), false});
}

MotionSigma FusionOdometry::sigma_of(const Step& step) const {
  return motion_sigma(options_, step.path, step.velocity_known, step.duration_s, blind_s_);
}

void FusionOdometry::add_motion(const Step& step, const Matrix6d& untold, std::vector<WeighedTerm>& terms) const {
  const RigidTransform predicted = step.anchor.before.inverse() * step.anchor.predicted;
  const MotionSigma sigma = sigma_of(step);
  const bool turned = step.path && step.path->has_rotation, travelled = step.path && step.path->has_speed;
  const auto add = [&](std::unique_ptr<FusionTerm> term, bool robust) {
    if (mounting_.to_be_judged) {
      // A hundredth of their voice, a ten thousandth of their weight, keeps a step from running away.
      constexpr double kKept = 0.01;
      term = std::make_unique<FilteredTerm>(std::move(term), kKept * Matrix6d::Identity() + (1.0 - kKept) * untold);
    }
    terms.push_back({std::move(term), robust});
  };
  add(std::make_unique<TurnTerm>(step.anchor, predicted.linear(), step.duration_s, sigma.turn_rad,
                                 turned && step.path->by_gyro),
      false);
  add(std::make_unique<TravelTerm>(step.anchor, predicted.translation(), sigma.travel_m, travelled), travelled);
}

void FusionOdometry::add_absolute(const Step& step, std::vector<WeighedTerm>& terms, FusedScan& result) const {
  result.dead_reckoned = step.path && step.path->has_speed && step.path->has_rotation;
  result.levelled = step.level.has_value();
  if (step.level) terms.push_back({std::make_unique<LevelTerm>(step.anchor, *step.level), false});
  result.height_measured = step.height.has_value();
  if (step.height) terms.push_back({std::make_unique<HeightTerm>(*step.height), false});
}

bool FusionOdometry::add_features(const Step& step, int iteration, std::vector<WeighedTerm>& terms,
                                  FusedScan& result) const {
  result.untold = Matrix6d::Identity();
  if (!options_.lines && !options_.planes) return false;
  const RigidTransform at = pose_in_map(step.anchor, step.x);
  const Search search = search_at(iteration, step.predicted());
  FeatureMatches matches = map_.match(step.features, at, search.widen * options_.match_distance_m, options_, threads_);
  result.line_matches = static_cast<int>(matches.lines.size());
  result.plane_matches = static_cast<int>(matches.planes.size());
  result.residual_m = rms_distance_m(matches);
  HeardFeatures heard = heard_features(matches, at, search.expected_m, options_);
  result.undetermined = heard.undetermined;
  if (heard.none) return false;
  result.untold -= heard.heard;
  if (!matches.lines.empty())
    terms.push_back({std::make_unique<FeatureTerm>(FeatureTerm::Kind::Lines, step.anchor, std::move(matches.lines),
                                                   std::move(heard.line_weights), heard.heard),
                     false});
  if (!matches.planes.empty())
    terms.push_back({std::make_unique<FeatureTerm>(FeatureTerm::Kind::Planes, step.anchor, std::move(matches.planes),
                                                   std::move(heard.plane_weights), heard.heard),
                     false});
  return true;
}

std::optional<LevelMeasurement> FusionOdometry::level_at(std::int64_t stamp_ns,
                                                         const RigidTransform& odometry_from_vehicle) const {
  const auto gravity = gravity_in_vehicle(imu_, reckoning_, mounting_.vehicle_from_imu, drift_, velocity_, stamp_ns);
  if (!gravity) return std::nullopt;
  return level_of(*gravity, odometry_from_vehicle, options_);
}

std::optional<double> FusionOdometry::height_at(std::int64_t stamp_ns) const {
  return mean_height_m(barometer_, stamp_ns);
}

void FusionOdometry::start_height(FusedScan& result) {
  const auto height_m = options_.barometer && !height_offset_m_ ? height_at(result.stamp_ns) : std::nullopt;
  if (!height_m) return;
  const Eigen::Vector3d place = result.odometry_from_vehicle.translation();
  height_offset_m_ = *height_m - place.z() - drop_of_level_m(place);
  errors_.height_starts();
  result.height_measured = true;
}

void FusionOdometry::restart_map(const OdometryScan& scan) {
  map_ = FeatureMap();
  map_.add(features_of(scan, std::nullopt), last_->odometry_from_vehicle, options_);
  map_.rebuild(options_);
  errors_.new_map();
  velocity_.reset();  // it was carried on unchecked
  if (!options_.ackermann || !reckoning_.has_wheels()) first_scan_ = scan;
  lost_scans_ = 0;
  blind_s_ = 0.0;
}

bool FusionOdometry::enters_map(const ScanFeatures& features, const RigidTransform& odometry_from_vehicle) const {
  if (features.lines.size() + features.planes.size() < kLeastFeatures) return false;
  if (map_.empty()) return true;
  const RigidTransform moved = map_.newest().inverse() * odometry_from_vehicle;
  return moved.translation().norm() >= options_.map_step_m ||
         so3_log(moved.linear()).norm() >= degrees_to_radians(options_.map_step_deg);
}

void FusionOdometry::propagate(const Step& step, FusedScan& result) {
  errors_.mark(0, step.anchor.before);
  errors_.step(step.anchor, step.x, step.duration_s, inverse_information(step.information), step.height,
               step_covariance_of(sigma_of(step), step.anchor));
  result.covariance = errors_.covariance().topLeftCorner<6, 6>();
  result.step_covariance = errors_.covariance_since(0, result.odometry_from_vehicle);
}

void FusionOdometry::accept(Step& step, FusedScan& result) {
  result.odometry_from_vehicle = fused_pose(step.anchor, step.x);
  result.before_from_vehicle = step.anchor.before.inverse() * moved_pose(step.anchor, step.x);
  velocity_ = velocity_between(step.anchor.before, moved_pose(step.anchor, step.x), step.duration_s);
  result.speed_mps = velocity_->head<3>().norm();
  propagate(step, result);
  if (step.path && step.path->has_speed) {
    const Eigen::Vector3d travel = (step.anchor.before.inverse() * step.anchor.predicted).translation();
    result.wheel_disagreement = disagreement(TravelTerm(step.anchor, travel, sigma_of(step).travel_m, true), step.x);
  }
  drift_.gyro_bias_radps += step.x.segment<3>(kDrift);
  drift_.wheel_scale *= 1.0 + step.x[kDrift + 3];
  steady_rad_ += step.x.segment<2>(kSteady);
  blind_s_ = result.undetermined.empty() || result.dead_reckoned ? 0.0 : blind_s_ + step.duration_s;
  map_.move(result.odometry_from_vehicle * pose_in_map(step.anchor, step.x).inverse());
  if (!result.usable && (options_.lines || options_.planes) &&
      step.features.lines.size() + step.features.planes.size() >= kLeastFeatures)
    ++lost_scans_;
  else if (result.usable)
    lost_scans_ = 0;
  start_height(result);
  if (result.usable && enters_map(step.features, result.odometry_from_vehicle)) {
    map_.add(std::move(step.features), result.odometry_from_vehicle, options_);
    errors_.entered_map(map_.frames());
  }
  map_.rebuild(options_);
  last_ = result;
}

FusionOdometryResult solve_fusion_odometry(std::size_t scan_count, const std::function<OdometryScan(std::size_t)>& load,
                                           const FusionMounting& mounting, const SensorStreams& streams,
                                           const FusionOptions& options, int threads, Progress& progress) {
  FusionOdometry odometry(mounting, streams, options, threads);
  FusionOdometryResult result;
  result.scans.reserve(scan_count);
  for (std::size_t i = 0; i < scan_count && !result.cancelled; ++i) {
    result.cancelled = progress.cancelled();
    if (result.cancelled) break;
    progress.report(say::stage_odometry, i, scan_count);
    result.scans.push_back(odometry.add(load(i)));
  }
  result.drift = odometry.drift();
  result.drift_sigma = odometry.drift_sigma();
  return result;
}

}  // namespace remount::odometry
