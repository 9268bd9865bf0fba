#include "algorithms/calibration/vehicle_frame/vehicle_frame.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/vehicle_frame/vehicle_frame_refusal.h"
#include "algorithms/calibration/vehicle_frame/vehicle_frame_start.h"
#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "algorithms/motion/motion_track.h"
#include "messages/calibration.h"
#include "messages/parameters.h"
#include "messages/quantities.h"
#include "messages/stages.h"

namespace remount::calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kFewestIntervals = 8;
constexpr double kTyre = 0.015;  // share by which the wheels' way may be wrong where nobody asks for their scale
constexpr double kGyroScaleSigma = 0.02;       // share by which the rates of an IMU may be wrong,
constexpr double kGyroScaleApartSigma = 0.01;  // and those about one axis more than about the others
// The vehicle's x is where its rear axle rolls, and how straight that is: what alignment racks repeat to.
constexpr double kRollingSigma_deg = 0.02;

void require_valid(const VehicleFrameOptions& options) {
  std::vector<Message> problems = option_problems(options);
  if (options.scale == ScaleMode::Estimated && options.estimate_wheel_scale)
    problems.push_back(say::vehicle_frame_two_scales());
  if (!problems.empty()) throw Error(ErrorCode::Contract, "vehicle-frame options", in_one(std::move(problems)));
}

// Stretches of one drive between poses of the sensor, cut by way or by turn.
void append_intervals(const VehicleDrive& drive, const VehicleFrameOptions& options,
                      std::vector<VehicleInterval>& out) {
  constexpr double kLongest_s = 20.0;  // at walking pace 5 m take so long; a vehicle that stands is cut off
  const motion::MotionTrack reference(drive.reference_from_vehicle);
  VehicleInterval open;
  double way_m = 0.0;
  const auto restart = [&](std::int64_t stamp_ns) {
    open = {};
    open.begin_ns = stamp_ns;
    way_m = 0.0;
  };
  const std::vector<motion::StampedPose>& poses = drive.world_from_sensor;
  std::size_t begin = 0;
  if (!poses.empty()) restart(poses.front().stamp_ns);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto steps = drive.sensed.steps(poses[i - 1].stamp_ns, poses[i].stamp_ns);
    if (!steps) {
      restart(poses[i].stamp_ns);
      begin = i;
      continue;
    }
    open.steps.insert(open.steps.end(), steps->begin(), steps->end());
    for (const motion::MotionStep& step : *steps) way_m += std::abs(step.travel_m);
    const RigidTransform motion = poses[begin].pose.inverse() * poses[i].pose;
    const double turn_rad = so3_log(motion.linear()).norm();
    const bool far = way_m >= options.interval_m || turn_rad >= degrees_to_radians(options.interval_turn_deg);
    const bool stands = seconds(poses[i].stamp_ns - open.begin_ns) > kLongest_s;
    if (!far && !stands) continue;
    if (far) {
      open.end_ns = poses[i].stamp_ns;
      open.sensor_begin_from_sensor_end = motion;
      const auto from = reference.at(open.begin_ns), to = reference.at(open.end_ns);
      if (from && to) open.reference_begin_from_end = from->linear().transpose() * to->linear();
      out.push_back(open);
    }
    restart(poses[i].stamp_ns);
    begin = i;
  }
}

// One scale for all axes where some axis tells it, and of those that tell it, all but one apart from it. The turns of
// an INS are differences of its attitudes: they have no scale.
void free_gyro_scale(const VehicleFrameStreams& streams, const VehicleFrameStart& start, VehicleFrameProblem& problem) {
  const auto& tells = start.tells_gyro_scale;
  const bool told = !streams.rates_by_reference && tells.any();
  problem.free[19] = told;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    problem.free[20 + axis] = told && tells[axis] && axis != start.main_axis_of_imu;
}

VehicleFrameProblem problem_of(const std::vector<VehicleInterval>& intervals, const VehicleFrameStreams& streams,
                               const VehicleFrameStart& start,
                               const std::optional<RigidTransform>& nominal_vehicle_from_sensor,
                               const VehicleFrameOptions& options) {
  VehicleFrameProblem problem;
  problem.intervals = &intervals;
  // A reference attitude knows better which way is up in the vehicle than turns that are level on the whole.
  const bool level = options.level_turns && !streams.one_axis && !streams.reference;
  problem.used = {true, true, streams.wheels_differ, streams.reference, level};
  problem.free.setConstant(true);
  problem.free[6] = options.scale == ScaleMode::Estimated;
  // Tyres differ from what the vehicle takes them for by a per cent or two: a sensor in metres says by how much.
  problem.free[7] = options.scale == ScaleMode::Known;
  problem.free[14] = streams.wheels_differ;
  free_gyro_scale(streams, start, problem);
  problem.free[23] = streams.wheels_differ;
  if (streams.one_axis)
    for (const int held : {8, 9, 11, 12, 13, 18}) problem.free[held] = false;
  if (!streams.reference)
    for (const int held : {15, 16, 17}) problem.free[held] = false;
  problem.prior = start.state;
  if (nominal_vehicle_from_sensor) problem.prior.vehicle_from_sensor = *nominal_vehicle_from_sensor;
  problem.prior.gyro_bias_radps.setZero();
  problem.prior.pitch_centre_m = motion::kPitchCentre_m;
  // An IMU whose mounting nobody stated is held where the start found it, by next to nothing.
  if (options.imu_mounting_sigma_deg < 90.0) problem.prior.vehicle_from_imu = stated_imu_mounting(options);
  const bool nominal = nominal_vehicle_from_sensor.has_value();
  const double bias_radps = std::max(1e-9, degrees_to_radians(options.gyro_bias_sigma_dps));
  problem.prior_sigma << Vector3d::Constant(nominal ? 2.0 : 5.0), Vector3d::Constant(nominal ? 0.2 : 1.0), 3.0,
      options.estimate_wheel_scale ? 0.1 : kTyre, Vector3d::Constant(bias_radps),
      Vector3d::Constant(degrees_to_radians(options.imu_mounting_sigma_deg)), 1.0,
      Vector3d::Constant(degrees_to_radians(options.ins_alignment_sigma_deg)), motion::kPitchCentreSigma_m,
      kGyroScaleSigma, Vector3d::Constant(kGyroScaleApartSigma), kTyre;
  return problem;
}

MotionSummary motion_of(const std::vector<VehicleInterval>& intervals, const VehicleFrameState& state) {
  std::vector<motion::Pair> pairs;
  for (const VehicleInterval& interval : intervals) {
    motion::Pair pair;
    pair.state = motion::PairState::Accepted;
    pair.ins_b_from_ins_a =
        motion::preintegrate(interval.steps, state.gyro_bias_radps, state.log_gyro_scales().array().exp())
            .start_from_end(state.vehicle_from_imu);
    pairs.push_back(pair);
  }
  return summarise_motion(pairs);
}

// A drive tells how its rear axle rolled on the whole. That an axle rolls a little to the side, over crests that are
// banked or by its tyres, turns the vehicle's frame with everything in it. docs/maths/vehicle-frame.md (V16)
Matrix6d doubt_about_rolling(const RigidTransform& vehicle_from_sensor) {
  Vector6d slope;
  slope << Vector3d::UnitZ().cross(vehicle_from_sensor.translation()), Vector3d::UnitZ();
  return std::pow(degrees_to_radians(kRollingSigma_deg), 2) * slope * slope.transpose();
}

// Fills sigma, what is observed and the words from the solution.
void judge(const std::vector<VehicleInterval>& intervals, const VehicleFrameProblem& problem,
           const VehicleFrameSolution& solution, const SolveOptions& solve, CalibrationResult& result) {
  const Vector6d prior_information = problem.prior_sigma.head<6>().cwiseAbs2().cwiseInverse();
  Matrix6d information = inverse_by_lu(solution.covariance.topLeftCorner<6, 6>());
  information.diagonal() -= prior_information;
  const MotionSummary motion = motion_of(intervals, solution.state);
  result.mounting.reference_from_sensor = solution.state.vehicle_from_sensor;
  result.directions = observed_directions(information, solution.excitation, motion, solve);
  const Matrix6d widened = solution.covariance.topLeftCorner<6, 6>();
  judge_parameters(stated_covariance(widened, prior_information, result.directions, solve) +
                       doubt_about_rolling(result.mounting.reference_from_sensor),
                   motion, solve, result);
}

// What is not observed stays at the nominal, or at zero, and the rest is solved again with it.
VehicleFrameSolution solve_holding_unobserved(VehicleFrameProblem problem, const VehicleFrameSolution& solution,
                                              const CalibrationResult& judged, bool nominal_known,
                                              const Progress& progress) {
  const RigidTransform nominal = problem.prior.vehicle_from_sensor;
  VehicleFrameState start = solution.state;
  bool held = false;
  for (const Parameter axis : {Parameter::X, Parameter::Y, Parameter::Z}) {
    if (judged.known[axis].observed) continue;
    const int i = row_of(axis);
    held = true;
    problem.free[i] = false;
    start.vehicle_from_sensor.translation()[i] = nominal_known ? nominal.translation()[i] : 0.0;
  }
  if (!held) return solution;
  return solve_problem(problem, start, progress);
}

NamedQuantity quantity(std::string id, Message name, double value, double variance, const char* unit, double limit) {
  NamedQuantity out{std::move(id), std::move(name), value, std::sqrt(std::max(0.0, variance)), unit, true};
  out.observed = out.sigma < limit;
  if (!out.observed) out.sigma = std::numeric_limits<double>::quiet_NaN();
  return out;
}

void name_gyro_scales(const VehicleFrameProblem& problem, const StateMatrix& covariance, VehicleFrameResult& result) {
  if (!problem.free[19]) return;
  const double limit = 0.5 * problem.prior_sigma[19];
  if (!problem.free[20] && !problem.free[21] && !problem.free[22]) {
    const double scale = result.gyro_scale[0];
    result.quantities.push_back(
        quantity(kGyroScale, say::quantity_gyro_scale(), scale, scale * scale * covariance(19, 19), "", limit));
    return;
  }
  constexpr Message (*kNames[])() = {say::quantity_gyro_scale_x, say::quantity_gyro_scale_y,
                                     say::quantity_gyro_scale_z};
  for (int k = 0; k < 3; ++k) {
    const double scale = result.gyro_scale[k],
                 spread = covariance(19, 19) + 2.0 * covariance(19, 20 + k) + covariance(20 + k, 20 + k);
    result.quantities.push_back(
        quantity(gyro_scale_of_axis("xyz"[k]), kNames[k](), scale, scale * scale * spread, "", limit));
  }
}

void name_quantities(const VehicleFrameProblem& problem, const VehicleFrameSolution& solution,
                     const SolveOptions& solve, VehicleFrameResult& result) {
  const StateMatrix& covariance = solution.covariance;
  if (problem.free[6])
    result.quantities.push_back(quantity("scale", say::quantity_scale(), result.scale,
                                         std::pow(result.scale, 2) * covariance(6, 6), "", 0.05 * result.scale));
  if (problem.free[7])
    result.quantities.push_back(quantity("wheel scale", say::quantity_wheel_scale(), result.wheel_scale,
                                         std::pow(result.wheel_scale, 2) * covariance(7, 7), "",
                                         0.5 * problem.prior_sigma[7]));
  if (problem.free[11]) {
    const YawPitchRoll angles = yaw_pitch_roll_from_rotation(result.vehicle_from_imu);
    const Matrix3d jacobian = yaw_pitch_roll_jacobian(angles);
    const Matrix3d spread = jacobian * covariance.block<3, 3>(11, 11) * jacobian.transpose();
    const double limit = degrees_to_radians(solve.max_rotation_sigma_deg);
    result.quantities.push_back(
        quantity("imu yaw", say::quantity_imu_yaw(), angles.yaw_rad, spread(0, 0), "rad", limit));
    result.quantities.push_back(
        quantity("imu pitch", say::quantity_imu_pitch(), angles.pitch_rad, spread(1, 1), "rad", limit));
    result.quantities.push_back(
        quantity("imu roll", say::quantity_imu_roll(), angles.roll_rad, spread(2, 2), "rad", limit));
  }
  constexpr Message (*kBias[])() = {say::quantity_gyro_bias_x, say::quantity_gyro_bias_y, say::quantity_gyro_bias_z};
  for (int k = 0; k < 3; ++k)
    if (problem.free[8 + k])
      result.quantities.push_back(quantity(std::string("gyro bias ") + "xyz"[k], kBias[k](), result.gyro_bias_radps[k],
                                           covariance(8 + k, 8 + k), "rad/s", 0.5 * problem.prior_sigma[8 + k]));
  name_gyro_scales(problem, covariance, result);
  if (problem.free[23])
    result.quantities.push_back(quantity(kRightOverLeft, say::quantity_right_wheel_scale_over_left(),
                                         result.right_over_left, 4.0 * covariance(23, 23), "",
                                         problem.prior_sigma[23]));
  if (problem.free[14])
    result.quantities.push_back(
        quantity("track width", say::quantity_track_width(), solution.state.track_m, covariance(14, 14), "m", 0.3));
  if (problem.free[18])
    result.quantities.push_back(
        quantity("pitch centre ahead of the rear axle", say::quantity_pitch_centre_ahead_of_the_rear_axle(),
                 solution.state.pitch_centre_m, covariance(18, 18), "m", 0.5 * problem.prior_sigma[18]));
  if (!result.imu_to_reference) return;
  for (std::size_t k = 0; k < 4; ++k)
    result.quantities.push_back({"rotation equation singular value " + std::to_string(k + 1),
                                 say::quantity_rotation_equation_singular_value(k + 1),
                                 result.imu_to_reference->singular_values[k], std::numeric_limits<double>::quiet_NaN(),
                                 "", true});
}

void conclude(const VehicleFrameSolution& solution, VehicleFrameResult& result) {
  CalibrationResult& calibration = result.calibration;
  if (!solution.converged) {
    calibration.conclude(Status::NotConverged, say::vehicle_frame_not_converged());
    claim_nothing(say::unknown_not_converged(), calibration);
    return;
  }
  state_vehicle_frame(result.intervals, calibration);
}

VehicleFrameResult too_few(std::size_t intervals) {
  VehicleFrameResult result;
  result.calibration.mounting.reference = BodyFrame::Vehicle;
  result.calibration.conclude(Status::TooLittleData, say::vehicle_frame_too_few(intervals, kFewestIntervals));
  result.calibration.advice.push_back(say::vehicle_frame_check_streams());
  return result;
}

}  // namespace

void state_vehicle_frame(int intervals, CalibrationResult& calibration) {
  const bool all = calibration.observed().is_all();
  calibration.conclude(all ? Status::Ok : Status::Degenerate,
                       (all ? say::vehicle_frame_all : say::vehicle_frame_some)(intervals));
}

std::vector<VehicleInterval> vehicle_intervals(const std::vector<VehicleDrive>& drives,
                                               const VehicleFrameOptions& options) {
  std::vector<VehicleInterval> intervals;
  for (const VehicleDrive& drive : drives) append_intervals(drive, options, intervals);
  return intervals;
}

VehicleFrameResult solve_vehicle_frame(const std::vector<VehicleDrive>& drives,
                                       const std::optional<RigidTransform>& nominal_vehicle_from_sensor,
                                       const VehicleFrameOptions& options, const SolveOptions& solve,
                                       Progress& progress) {
  require_valid(options);
  progress.report(say::stage_integrating_wheels_and_imu, 0, 0);
  const std::vector<VehicleInterval> intervals = vehicle_intervals(drives, options);
  if (static_cast<int>(intervals.size()) < kFewestIntervals) return too_few(intervals.size());
  const VehicleFrameStreams streams = streams_of(drives, intervals);
  const VehicleFrameStart start = start_of(intervals, streams, nominal_vehicle_from_sensor, options);
  const VehicleFrameProblem problem = problem_of(intervals, streams, start, nominal_vehicle_from_sensor, options);

  VehicleFrameResult result;
  result.imu_to_reference = start.imu_to_reference;
  result.imu_to_sensor = start.imu_to_sensor;
  result.planar = start.planar;
  result.intervals = static_cast<int>(intervals.size());
  CalibrationResult& calibration = result.calibration;
  calibration.mounting.reference = BodyFrame::Vehicle;
  if (refused_for_units(start, options, calibration)) return result;
  progress.report(say::stage_solving_vehicle_frame, 0, 0);
  const VehicleFrameSolution first = solve_problem(problem, start.state, progress);
  if (first.converged) judge(intervals, problem, first, solve, calibration);
  const VehicleFrameSolution solution =
      first.converged
          ? solve_holding_unobserved(problem, first, calibration, nominal_vehicle_from_sensor.has_value(), progress)
          : first;
  if (first.cancelled || progress.cancelled()) {
    calibration.conclude(Status::Cancelled, say::calibration_cancelled());
    claim_nothing(say::unknown_cancelled(), calibration);
    return result;
  }
  calibration.mounting.reference_from_sensor =
      with_kept(solution.state.vehicle_from_sensor, problem.prior.vehicle_from_sensor,
                ~calibration.observed() & kAttitudeParameters);
  calibration.rotation_rms_rad = std::sqrt(3.0) * solution.sigma[kTurn];
  calibration.translation_rms_m = std::sqrt(3.0) * solution.sigma[kWay];
  calibration.pairs_proposed = result.intervals;
  calibration.pairs_rejected = solution.outliers;
  calibration.pairs_accepted = result.intervals - solution.outliers;
  result.vehicle_from_imu = solution.state.vehicle_from_imu;
  result.gyro_bias_radps = solution.state.gyro_bias_radps;
  result.gyro_scale = solution.state.log_gyro_scales().array().exp();
  result.right_over_left = (1.0 + solution.state.wheel_asymmetry) / (1.0 - solution.state.wheel_asymmetry);
  result.scale = std::exp(solution.state.log_scale);
  result.wheel_scale = std::exp(solution.state.log_wheel_scale);
  conclude(solution, result);
  name_quantities(problem, first, solve, result);
  return result;
}

}  // namespace remount::calibration
