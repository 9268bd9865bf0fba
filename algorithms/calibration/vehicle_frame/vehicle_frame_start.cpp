#include "algorithms/calibration/vehicle_frame/vehicle_frame_start.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "algorithms/core/median.h"
#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/geometry/shortest_rotation.h"

namespace remount::calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTurnNoise_rad = 1e-4;        // what an interval's turn is known to at best
constexpr double kTrustedMounting_deg = 10.0;  // stated better than this the IMU's mounting is a start

// The attitude nearest to `a_from_b` that takes one direction to another.
Matrix3d turned_onto(const Matrix3d& a_from_b, const Vector3d& direction_in_b, const Vector3d& direction_in_a) {
  return shortest_rotation(Vector3d(a_from_b * direction_in_b), direction_in_a) * a_from_b;
}

struct IntervalTurns {
  std::vector<motion::WheelPreintegration> imu;
  Vector3d main_axis_in_imu = Vector3d::UnitZ();
};

IntervalTurns turns_of(const std::vector<VehicleInterval>& intervals) {
  IntervalTurns turns;
  Matrix3d scatter = Matrix3d::Zero();
  for (const VehicleInterval& interval : intervals) {
    turns.imu.push_back(motion::preintegrate(interval.steps, Vector3d::Zero()));
    const Vector3d& turn = turns.imu.back().turn_in_imu_rad;
    scatter += turn * turn.transpose();
  }
  turns.main_axis_in_imu = symmetric_eigen(scatter).eigenvectors().col(2);
  return turns;
}

// Turn of the vehicle as its wheels know it: about z, by the difference of their ways over the track width that fits.
std::vector<TurnPair> turns_by_wheels(const IntervalTurns& turns, double& track_m, Vector3d& axis_in_imu) {
  double across = 0.0, along = 0.0;
  for (const motion::WheelPreintegration& imu : turns.imu) {
    const double turn_rad = axis_in_imu.dot(imu.turn_in_imu_rad);
    across += imu.wheel_difference_m * turn_rad;
    along += turn_rad * turn_rad;
  }
  if (across < 0.0) axis_in_imu = -axis_in_imu;  // the IMU hangs upside down
  track_m = along > 0.0 ? std::max(0.3, std::abs(across) / along) : 1.6;
  std::vector<TurnPair> pairs;
  for (const motion::WheelPreintegration& imu : turns.imu)
    pairs.push_back({so3_exp(imu.wheel_difference_m / track_m * Vector3d::UnitZ()), imu.imu_start_from_imu_end});
  return pairs;
}

void start_imu(const std::vector<VehicleInterval>& intervals, const VehicleFrameStreams& streams,
               const IntervalTurns& turns, const VehicleFrameOptions& options, VehicleFrameStart& start) {
  VehicleFrameState& state = start.state;
  state.vehicle_from_imu = stated_imu_mounting(options);
  if (streams.one_axis) return;
  Vector3d axis_in_imu = turns.main_axis_in_imu;
  if (state.vehicle_from_imu.row(2).dot(axis_in_imu) < 0.0) axis_in_imu = -axis_in_imu;
  std::vector<TurnPair> pairs;
  if (streams.reference) {
    for (std::size_t i = 0; i < intervals.size(); ++i)
      if (intervals[i].reference_begin_from_end)
        pairs.push_back({*intervals[i].reference_begin_from_end, turns.imu[i].imu_start_from_imu_end});
  } else if (streams.wheels_differ) {
    pairs = turns_by_wheels(turns, state.track_m, axis_in_imu);
  }
  if (!pairs.empty()) start.imu_to_reference = solve_rotation_equation(pairs, kTurnNoise_rad);
  const bool solved = start.imu_to_reference && start.imu_to_reference->solved;
  if (solved && start.imu_to_reference->rotation_about_main_axis_observed && streams.reference)
    state.vehicle_from_imu = start.imu_to_reference->a_from_b;
  else if (solved && streams.reference)
    state.vehicle_from_imu = turned_onto(
        state.vehicle_from_imu, start.imu_to_reference->a_from_b.transpose() * start.imu_to_reference->main_axis_in_a,
        start.imu_to_reference->main_axis_in_a);
  else if (options.imu_mounting_sigma_deg > kTrustedMounting_deg)
    state.vehicle_from_imu = turned_onto(state.vehicle_from_imu, axis_in_imu, Vector3d::UnitZ());
}

// The track width that fits, for a start also where the wheels were not asked for turns.
void start_track(const IntervalTurns& turns, VehicleFrameState& state) {
  double across = 0.0, along = 0.0;
  for (const motion::WheelPreintegration& imu : turns.imu) {
    const double turn_rad = state.vehicle_from_imu.row(2).dot(imu.turn_in_imu_rad);
    across += imu.wheel_difference_m * turn_rad;
    along += turn_rad * turn_rad;
  }
  if (along > 0.0) state.track_m = std::clamp(across / along, 0.5, 4.0);
}

// By how they vary: a bias turns as well. Plain sums of rates: in a wrong unit they go around more than once.
double turns_per_turn(const std::vector<VehicleInterval>& intervals, const IntervalTurns& turns) {
  constexpr double kLeast_rad = 0.02;  // of an interval, in rms
  Vector3d of_imu = Vector3d::Zero(), of_sensor = Vector3d::Zero();
  double time_s = 0.0;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    of_imu += turns.imu[i].turn_in_imu_rad;
    of_sensor += so3_log(intervals[i].sensor_begin_from_sensor_end.linear());
    time_s += turns.imu[i].duration_s;
  }
  double imu_rad2 = 0.0, sensor_rad2 = 0.0;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const double share = turns.imu[i].duration_s / time_s;
    imu_rad2 += (turns.imu[i].turn_in_imu_rad - share * of_imu).squaredNorm();
    sensor_rad2 += (so3_log(intervals[i].sensor_begin_from_sensor_end.linear()) - share * of_sensor).squaredNorm();
  }
  if (sensor_rad2 < kLeast_rad * kLeast_rad * static_cast<double>(intervals.size())) return 1.0;
  return std::sqrt(imu_rad2 / sensor_rad2);
}

// Turns about each axis of the IMU, what a mounting that is off makes of those about the others taken out, against what
// the sensor's turns leave unexplained of them. Noise of the rates makes their scale look small by its square over that
// of the turns: only where this is next to nothing is a scale worth asking for.
void judge_gyro_scale(const std::vector<VehicleInterval>& intervals, const IntervalTurns& turns,
                      VehicleFrameStart& start) {
  constexpr double kLeastRatio = 20.0;
  const auto count = static_cast<Eigen::Index>(intervals.size());
  Eigen::MatrixXd of_imu(count, 4), of_sensor(count, 4);  // about x, y, z, and time for the bias
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    of_imu.row(i) << turns.imu[at].turn_in_imu_rad.transpose(), turns.imu[at].duration_s;
    of_sensor.row(i) << so3_log(intervals[at].sensor_begin_from_sensor_end.linear()).transpose(), of_imu(i, 3);
  }
  const auto left_of = [](const Eigen::VectorXd& turn, const Eigen::MatrixXd& by) {
    return Eigen::VectorXd(turn - by * by.completeOrthogonalDecomposition().solve(turn));
  };
  // A scan that was aligned wrongly is no noise of the rest; a single turn is a turn.
  const auto noise_of = [](const Eigen::VectorXd& left) {
    std::vector<double> sizes;
    for (const double each : left) sizes.push_back(std::abs(each));
    return 1.4826 * median_of(sizes);
  };
  Eigen::Index main = 0;
  of_imu.leftCols<3>().colwise().squaredNorm().maxCoeff(&main);
  start.main_axis_of_imu = main;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::MatrixXd others = of_imu.rightCols<1>();
    if (axis != main) others = of_imu(Eigen::all, std::vector<Eigen::Index>{main, 3});
    const double turns_rad = left_of(of_imu.col(axis), others).norm() / std::sqrt(static_cast<double>(count));
    start.tells_gyro_scale[axis] = turns_rad > kLeastRatio * noise_of(left_of(of_imu.col(axis), of_sensor));
  }
}

Matrix3d pitch_and_roll_of(const Matrix3d& rotation) {
  YawPitchRoll angles = yaw_pitch_roll_from_rotation(rotation);
  angles.yaw_rad = 0.0;
  return rotation_from_yaw_pitch_roll(angles);
}

}  // namespace

Matrix3d stated_imu_mounting(const VehicleFrameOptions& options) {
  return rotation_from_yaw_pitch_roll({degrees_to_radians(options.imu_yaw_deg),
                                       degrees_to_radians(options.imu_pitch_deg),
                                       degrees_to_radians(options.imu_roll_deg)});
}

VehicleFrameStreams streams_of(const std::vector<VehicleDrive>& drives, const std::vector<VehicleInterval>& intervals) {
  VehicleFrameStreams streams;
  streams.wheels_differ =
      std::all_of(drives.begin(), drives.end(), [](const VehicleDrive& drive) { return drive.sensed.wheels_differ(); });
  streams.one_axis = std::all_of(drives.begin(), drives.end(),
                                 [](const VehicleDrive& drive) { return drive.sensed.rates_about_one_axis(); });
  streams.rates_by_reference =
      std::all_of(drives.begin(), drives.end(), [](const VehicleDrive& drive) { return drive.rates_by_reference; });
  streams.reference = std::any_of(intervals.begin(), intervals.end(), [](const VehicleInterval& interval) {
    return interval.reference_begin_from_end.has_value();
  });
  return streams;
}

VehicleFrameStart start_of(const std::vector<VehicleInterval>& intervals, const VehicleFrameStreams& streams,
                           const std::optional<RigidTransform>& nominal_vehicle_from_sensor,
                           const VehicleFrameOptions& options) {
  VehicleFrameStart start;
  VehicleFrameState& state = start.state;
  const IntervalTurns turns = turns_of(intervals);
  start_imu(intervals, streams, turns, options, start);
  start_track(turns, state);
  start.turns_per_turn = turns_per_turn(intervals, turns);
  judge_gyro_scale(intervals, turns, start);
  std::vector<TurnPair> sensor_imu, vehicle_sensor;
  std::vector<RigidTransform> motions;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const Matrix3d& q = intervals[i].sensor_begin_from_sensor_end.linear();
    motions.push_back(turns.imu[i].start_from_end(state.vehicle_from_imu));
    sensor_imu.push_back({q, turns.imu[i].imu_start_from_imu_end});
    vehicle_sensor.push_back({motions.back().linear(), q});
  }
  start.imu_to_sensor = solve_rotation_equation(sensor_imu, kTurnNoise_rad);
  const RotationEquationResult levelling = solve_rotation_equation(vehicle_sensor, kTurnNoise_rad);
  // Without turns nothing levels the sensor: it stays as the nominal has it.
  const Matrix3d nominal =
      nominal_vehicle_from_sensor ? nominal_vehicle_from_sensor->linear() : Matrix3d(Matrix3d::Identity());
  const Matrix3d level_from_sensor = pitch_and_roll_of(levelling.solved ? levelling.a_from_b : nominal);
  std::vector<PlanarMotion> planar;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const Vector3d way = level_from_sensor * intervals[i].sensor_begin_from_sensor_end.translation();
    planar.push_back(
        {yaw_pitch_roll_from_rotation(motions[i].linear()).yaw_rad, motions[i].translation().head<2>(), way.head<2>()});
  }
  start.planar = solve_planar_mounting(planar, options.scale == ScaleMode::Known);
  const PlanarMounting of_any_scale = solve_planar_mounting(planar, false);
  if (of_any_scale.solved && of_any_scale.scale > 0.0) start.metres_per_unit = of_any_scale.scale;
  const double height_m = nominal_vehicle_from_sensor ? nominal_vehicle_from_sensor->translation().z() : 0.0;
  Vector3d lever_m(start.planar.x_m, start.planar.y_m, height_m);
  if (!start.planar.position_observed && nominal_vehicle_from_sensor)
    lever_m = nominal_vehicle_from_sensor->translation();
  state.vehicle_from_sensor =
      make_rigid(so3_exp(start.planar.yaw_rad * Vector3d::UnitZ()) * level_from_sensor, lever_m);
  state.log_scale = std::log(std::max(start.planar.scale, 1e-12));
  const bool imu_known =
      options.imu_mounting_sigma_deg <= kTrustedMounting_deg ||
      (streams.reference && start.imu_to_reference && start.imu_to_reference->rotation_about_main_axis_observed);
  if (!imu_known && start.imu_to_sensor.rotation_about_main_axis_observed)
    state.vehicle_from_imu = state.vehicle_from_sensor.linear() * start.imu_to_sensor.a_from_b;
  return start;
}

}  // namespace remount::calibration
