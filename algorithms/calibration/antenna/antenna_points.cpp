#include "algorithms/calibration/antenna/antenna_points.h"

#include <algorithm>
#include <cmath>

namespace remount::calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Since the start of a window, in its axes.
struct Motion {
  Matrix3d start_from_here = Matrix3d::Identity();
  Vector3d way_m = Vector3d::Zero();
  /// In the plane where the lean is not known.
  void advance(const std::vector<motion::MotionStep>& steps, const Matrix3d& vehicle_from_imu, const VehicleTilt& tilt,
               double bias_radps) {
    const Vector3d biases_radps(tilt.rate_bias_radps.x(), tilt.rate_bias_radps.y(), bias_radps);
    for (const motion::MotionStep& step : steps) {
      Vector3d turn = vehicle_from_imu * step.turn_in_imu_rad - step.duration_s * biases_radps;
      if (!tilt.known) turn.head<2>().setZero();
      way_m += start_from_here * (so3_left_jacobian(turn) * step.travel_m * tilt.way +
                                  tilt.pitch_centre_m * turn.y() * Vector3d::UnitZ());
      start_from_here = start_from_here * so3_exp(turn);
    }
  }
  Vector2d level_way_m(const Matrix3d& level_from_start) const { return (level_from_start * way_m).head<2>(); }
  double heading_rad(const Matrix3d& level_from_start, const Vector3d& way) const {
    const Vector3d ahead = level_from_start * start_from_here * way;
    return std::atan2(ahead.y(), ahead.x());
  }
};

Eigen::Matrix<double, 2, 3> level_from_vehicle(const Vector2d& up_in_vehicle) {
  const Vector3d up(up_in_vehicle.x(), up_in_vehicle.y(), std::sqrt(1.0 - std::min(0.99, up_in_vehicle.squaredNorm())));
  const Vector3d ahead = (Vector3d::UnitX() - up.x() * up).normalized();
  Eigen::Matrix<double, 2, 3> level;
  level << ahead.transpose(), up.cross(ahead).transpose();
  return level;
}

}  // namespace

Eigen::Matrix2d rotation_in_plane(double angle_rad) { return Eigen::Rotation2Dd(angle_rad).toRotationMatrix(); }

std::vector<AntennaPoint> antenna_points(const std::vector<DrivenPosition>& driven, const Matrix3d& vehicle_from_imu,
                                         const VehicleTilt& tilt, double bias_radps, const Progress& progress) {
  constexpr double kStep_radps = 1e-5;
  std::vector<AntennaPoint> points;
  Motion motion, up;
  double travel_m = 0.0;
  for (std::size_t i = 0; i < driven.size() && !progress.cancelled(); ++i) {
    const DrivenPosition& here = driven[i];
    if (here.begins_window) {
      motion = up = {};
      travel_m = 0.0;
    } else {
      motion.advance(here.steps, vehicle_from_imu, tilt, bias_radps);
      up.advance(here.steps, vehicle_from_imu, tilt, bias_radps + kStep_radps);
      for (const motion::MotionStep& step : here.steps) travel_m += std::abs(step.travel_m);
    }
    AntennaPoint point;
    point.window = here.window;
    point.time_s = here.time_s;
    const Matrix3d level_from_start = tilt.known ? tilt.level_from_window_start.at(here.window) : Matrix3d::Identity();
    point.turn_rad = motion.heading_rad(level_from_start, tilt.way);
    point.travel_m = travel_m;
    point.way_m = motion.level_way_m(level_from_start);
    point.way_by_bias = (up.level_way_m(level_from_start) - point.way_m) / kStep_radps;
    if (tilt.known) point.level_from_vehicle = level_from_vehicle(tilt.up_in_vehicle.at(i));
    point.position_m = here.position.position_m.head<2>();
    points.push_back(point);
  }
  return points;
}

WindowPlacement place_window(const std::vector<AntennaPoint>& points, std::size_t first, std::size_t last) {
  Vector2d ways = Vector2d::Zero(), positions = Vector2d::Zero();
  for (std::size_t i = first; i < last; ++i) ways += points[i].way_m, positions += points[i].position_m;
  ways /= static_cast<double>(last - first);
  positions /= static_cast<double>(last - first);
  double across = 0.0, along = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    const Vector2d from = points[i].way_m - ways, to = points[i].position_m - positions;
    across += from.x() * to.y() - from.y() * to.x();
    along += from.dot(to);
  }
  const double heading_rad = std::atan2(across, along);
  return {positions - rotation_in_plane(heading_rad) * ways, heading_rad};
}

std::vector<WindowPlacement> place_windows(const std::vector<AntennaPoint>& points) {
  std::vector<WindowPlacement> windows;
  for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
    while (last < points.size() && points[last].window == points[first].window) ++last;
    windows.push_back(place_window(points, first, last));
  }
  return windows;
}

}  // namespace remount::calibration
