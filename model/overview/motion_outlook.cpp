#include "model/overview/motion_outlook.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/motion/pairing.h"
#include "messages/parameters.h"
#include "model/conventions/assumed_tilt.h"
#include "model/pipeline/drive_motion.h"

namespace remount::overview {
namespace {

/// Errors of a registration.
struct RegistrationErrors {
  double m, rad;
};
/// What registrations of outdoor scans reach, taken together with what pairs of shared scans have in common.
constexpr RegistrationErrors kUsual{0.02, 1e-3};
/// Of a dense LiDAR with little noise among walls, where the errors of the INS alone are left.
constexpr RegistrationErrors kBest{0.002, 1e-4};
/// Turns this small follow steering and braking too closely to show a lever arm, where the log states no errors.
constexpr double kUndeclaredAttitude_rad = 0.005;
/// How many times larger than supposed the errors of a drive are where they are, as a rule.
constexpr double kLarger = 1.25;

struct ExpectedNoise {
  double position2_m2, attitude2_rad2;  ///< of the difference of two INS poses
  double spurious2_rad2;                ///< what turns of the vehicle must exceed to count as turns
};

ExpectedNoise expected_noise(const calibration::SessionNoise& stated, const calibration::SolveOptions& options) {
  const bool declared = std::isfinite(stated.attitude_white_sigma_rad);
  const double attitude_rad =
      declared ? stated.attitude_white_sigma_rad : degrees_to_radians(options.ins_attitude_sigma_deg);
  const double position_m =
      std::isfinite(stated.position_white_sigma_m) ? stated.position_white_sigma_m : options.ins_position_sigma_m;
  const double attitude2 = 2.0 * attitude_rad * attitude_rad;
  return {2.0 * position_m * position_m, attitude2,
          declared ? attitude2 : std::max(attitude2, kUndeclaredAttitude_rad * kUndeclaredAttitude_rad)};
}

/// Information that one pair would carry, and the share of it that noise of the INS feigns.
void add_pair(const motion::Pair& pair, const RigidTransform& ins_from_lidar, const ExpectedNoise& noise,
              const RegistrationErrors& errors, calibration::SpuriousInformation& sum) {
  const RigidTransform q = calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, ins_from_lidar);
  const Matrix6d d_x = calibration::linearise_pair(pair.ins_b_from_ins_a, q, ins_from_lidar).d_x;
  const double translation = 1.0 / (noise.position2_m2 + errors.m * errors.m),
               rotation = 1.0 / (noise.attitude2_rad2 + errors.rad * errors.rad);
  Vector6d weights;
  weights << Eigen::Vector3d::Constant(translation), Eigen::Vector3d::Constant(rotation);
  sum.apparent += d_x.transpose() * weights.asDiagonal() * d_x;
  // The mean of [v]x' M [v]x over noise v of unit variance is 2 m I for M = m I.
  sum.spurious.diagonal().head<3>().array() += 2.0 * noise.spurious2_rad2 * translation;
  sum.spurious.diagonal().tail<3>().array() +=
      2.0 * (noise.spurious2_rad2 * rotation + noise.position2_m2 * translation);
}

/// What would be observed if all errors were `times` as large as they are supposed to be.
void judge_supposing(double times, calibration::SpuriousInformation information, double independent,
                     const calibration::MotionSummary& summary, double tilt_rad, double north_rad,
                     const calibration::SolveOptions& options, calibration::CalibrationResult& result) {
  // What noise feigns grows as its weight falls, and stays what it is.
  information.apparent /= times * times;
  const auto directions =
      calibration::observed_directions(independent * information.apparent, information, summary, options);
  Matrix6d covariance =
      (calibration::trusted_information(directions, options) + calibration::weak_prior(false)).inverse();
  if (summary.tilt_assumed) {
    covariance += calibration::assumed_tilt_covariance(result.mounting.ins_from_lidar(), tilt_rad);
    covariance += calibration::beyond_first_order(result.mounting.ins_from_lidar(), covariance, tilt_rad);
  }
  calibration::judge_parameters(covariance, summary, options, result);
  if (north_rad > 0.0)
    calibration::add_doubt(calibration::turned_by_north(result.mounting.ins_from_lidar(), north_rad),
                           say::unknown_north(), options, result);
}

}  // namespace

MotionOutlook motion_outlook(const drive::Session& session, const settings::Settings& settings,
                             const Progress& progress) {
  MotionOutlook outlook;
  if (session.ins.empty() && session.world_from_ins.empty()) return outlook;
  // Not owned: the session outlives this call.
  const pipeline::DriveMotion motion({std::shared_ptr<const drive::Session>(std::shared_ptr<void>(), &session)});
  constexpr motion::SessionIndex kOnly;
  const std::vector<motion::Keyframe> keyframes =
      motion::select_keyframes(kOnly, motion.lidar_stamps_ns(kOnly), motion.track(kOnly), 0.0, settings.keyframes);
  std::vector<RigidTransform> local_from_ins;
  for (const calibration::JointNode& node : motion.nodes(keyframes)) local_from_ins.push_back(node.local_from_ins);
  std::vector<motion::Pair> pairs = motion::propose_pairs(keyframes, local_from_ins, settings.pairing);
  pipeline::keep_independent_odometry(motion, keyframes, pairs);
  outlook.judged = !keyframes.empty();
  calibration::CalibrationResult result;
  result.mounting.reference_from_sensor = session.nominal_ins_from_lidar.value_or(RigidTransform::Identity());
  calibration::SpuriousInformation usual, best;
  const ExpectedNoise noise = expected_noise(motion.noise().front(), settings.solve);
  for (motion::Pair& pair : pairs) {
    if (progress.cancelled()) return {};
    pair.state = motion::PairState::Accepted;
    add_pair(pair, result.mounting.ins_from_lidar(), noise, kUsual, usual);
    add_pair(pair, result.mounting.ins_from_lidar(), noise, kBest, best);
  }
  // Pairs of the same keyframes repeat each other: no more independent motions than keyframes.
  const double independent =
      pairs.empty() ? 0.0 : std::min(1.0, static_cast<double>(keyframes.size()) / static_cast<double>(pairs.size()));
  const double tilt_rad = conventions::assumed_tilt_sigma_rad(session);
  calibration::MotionSummary summary = calibration::summarise_motion(pairs);
  summary.tilt_assumed = tilt_rad > 0.0;
  calibration::CalibrationResult by_larger = result, by_smaller = result;
  judge_supposing(1.0, usual, independent, summary, tilt_rad, session.ins_north_sigma_rad, settings.solve, result);
  judge_supposing(kLarger, usual, independent, summary, tilt_rad, session.ins_north_sigma_rad, settings.solve,
                  by_larger);
  judge_supposing(1.0, best, independent, summary, tilt_rad, session.ins_north_sigma_rad, settings.solve, by_smaller);
  outlook.determinable = result.observed();
  for (const calibration::Parameter parameter : calibration::kParameters)
    if (by_larger.known[parameter].observed != by_smaller.known[parameter].observed) outlook.open.insert(parameter);
  outlook.needs_nominal =
      !outlook.determinable.empty() && !session.nominal_ins_from_lidar && calibration::yaw_is_open(result);
  outlook.advice = result.advice;
  return outlook;
}

}  // namespace remount::overview
