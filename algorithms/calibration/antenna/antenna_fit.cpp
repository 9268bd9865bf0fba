#include "algorithms/calibration/antenna/antenna_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/calibration/antenna/antenna_tilt.h"
#include "algorithms/core/median.h"
#include "messages/calibration.h"
#include "messages/stages.h"

namespace remount {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Matrix2d turned(double angle_rad) { return Eigen::Rotation2Dd(angle_rad).toRotationMatrix(); }

// One position with the motion since the start of its window, and how that changes with the bias of the yaw rate.
struct Point {
  std::size_t window = 0;
  double time_s = 0.0, turn_rad = 0.0, travel_m = 0.0;  // since the start of the window
  Vector2d way_m = Vector2d::Zero(), way_by_bias = Vector2d::Zero();
  Vector2d position_m = Vector2d::Zero();
  Vector2d up_in_vehicle = Vector2d::Zero();  // how the vehicle leans: x and y of the vertical
};

// Since the start of a window, in its axes.
struct Motion {
  Matrix3d start_from_here = Matrix3d::Identity();
  Vector3d way_m = Vector3d::Zero();
  /// In the plane where the lean is not known.
  void advance(const std::vector<MotionStep>& steps, const Matrix3d& vehicle_from_imu, const VehicleTilt& tilt,
               double bias_radps) {
    const Vector3d biases_radps(tilt.rate_bias_radps.x(), tilt.rate_bias_radps.y(), bias_radps);
    for (const MotionStep& step : steps) {
      Vector3d turn = vehicle_from_imu * step.turn_in_imu_rad - step.duration_s * biases_radps;
      if (!tilt.known) turn.head<2>().setZero();
      way_m += start_from_here * so3_left_jacobian(turn).col(0) * step.travel_m;
      start_from_here = start_from_here * so3_exp(turn);
    }
  }
  Vector2d level_way_m(const Matrix3d& level_from_start) const { return (level_from_start * way_m).head<2>(); }
  double heading_rad(const Matrix3d& level_from_start) const {
    const Vector3d ahead = level_from_start * start_from_here.col(0);
    return std::atan2(ahead.y(), ahead.x());
  }
};

// Points of the drive under a bias; a new window after `window_s` and after each gap of the sensed. Cancelled: fewer.
std::vector<Point> points_of(const WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
                             const Matrix3d& vehicle_from_imu, const VehicleTilt& tilt, double window_s,
                             double bias_radps, double& distance_m, const Progress& progress) {
  constexpr double kStep_radps = 1e-5;
  std::vector<Point> points;
  Motion motion, up;
  double time_s = 0.0, travel_m = 0.0;
  distance_m = 0.0;
  for (std::size_t i = 0; i < positions.size() && !progress.cancelled(); ++i) {
    const auto steps = i > 0 ? sensed.steps(positions[i - 1].stamp_ns, positions[i].stamp_ns)
                             : std::optional<std::vector<MotionStep>>();
    if (steps) {
      motion.advance(*steps, vehicle_from_imu, tilt, bias_radps);
      up.advance(*steps, vehicle_from_imu, tilt, bias_radps + kStep_radps);
      for (const MotionStep& step : *steps) {
        time_s += step.duration_s;
        travel_m += std::abs(step.travel_m);
        distance_m += std::abs(step.travel_m);
      }
    }
    const bool covered = positions[i].stamp_ns >= sensed.begin_ns() && positions[i].stamp_ns <= sensed.end_ns();
    if (!covered) continue;
    const bool anew = !steps || points.empty() || time_s > window_s;  // as in vehicle_tilt
    if (anew) {
      motion = up = {};
      time_s = travel_m = 0.0;
    }
    Point point;
    point.window = points.empty() ? 0 : points.back().window + (anew ? 1 : 0);
    point.time_s = time_s;
    const Matrix3d level_from_start = tilt.known ? tilt.level_from_window_start[point.window] : Matrix3d::Identity();
    point.turn_rad = motion.heading_rad(level_from_start);
    point.travel_m = travel_m;
    point.way_m = motion.level_way_m(level_from_start);
    point.way_by_bias = (up.level_way_m(level_from_start) - point.way_m) / kStep_radps;
    if (tilt.known) point.up_in_vehicle = tilt.up_in_vehicle[points.size()];
    point.position_m = positions[i].position_m.head<2>();
    points.push_back(point);
  }
  return points;
}

struct Placement {
  Vector2d place_m = Vector2d::Zero();
  double heading_rad = 0.0;
};

// Where a window lies, by its ways alone.
Placement place(const std::vector<Point>& points, std::size_t first, std::size_t last) {
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
  return {positions - turned(heading_rad) * ways, heading_rad};
}

// Lever arm twice, bias, log of the wheel scale, height; place twice, heading.
constexpr int kCommon = 5, kOfWindow = 3;
// Of an antenna over the rear axle's ground, for all that is known beforehand.
constexpr double kUsualHeight_m = 1.5, kHeightSigma_m = 1.0;

struct FitState {
  Vector2d lever_m = Vector2d::Zero();
  double height_m = kUsualHeight_m;
  double bias_change_radps = 0.0, log_scale = 0.0;
  std::vector<Placement> windows;
};

using Row = Eigen::Matrix<double, 2, kCommon + kOfWindow>;  // of the common unknowns and of the point's window

Vector2d residual_of(const Point& point, const FitState& state, Row& jacobian) {
  const Placement& window = state.windows[point.window];
  const double scale = std::exp(state.log_scale);
  const double turn_rad = point.turn_rad - state.bias_change_radps * point.time_s;
  const Vector2d way_m = scale * (point.way_m + state.bias_change_radps * point.way_by_bias);
  const Matrix2d world_from_window = turned(window.heading_rad), window_from_vehicle = turned(turn_rad);
  // What is high leans away from where the vertical points.
  const Vector2d antenna_m = state.lever_m - state.height_m * point.up_in_vehicle;
  const Vector2d in_window = way_m + window_from_vehicle * antenna_m;
  Matrix2d quarter;
  quarter << 0.0, -1.0, 1.0, 0.0;
  jacobian.leftCols<2>() = world_from_window * window_from_vehicle;
  jacobian.col(2) =
      world_from_window * (scale * point.way_by_bias - point.time_s * quarter * window_from_vehicle * antenna_m);
  jacobian.col(3) = world_from_window * way_m;
  jacobian.col(4) = -world_from_window * window_from_vehicle * point.up_in_vehicle;
  jacobian.middleCols<2>(kCommon).setIdentity();
  jacobian.col(kCommon + 2) = quarter * world_from_window * in_window;
  return window.place_m + world_from_window * in_window - point.position_m;
}

// How many positions in a row have one error in common: one over the share that is independent.
double lasting(const std::vector<Vector2d>& residuals) {
  double power = 0.0, factor = 1.0;
  for (const Vector2d& r : residuals) power += r.squaredNorm();
  const std::size_t most = residuals.size() / 4;
  for (std::size_t lag = 1; lag < most && power > 0.0; ++lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < residuals.size(); ++i) sum += residuals[i].dot(residuals[i - lag]);
    const double correlation = sum / power;
    if (correlation < 0.05) break;
    factor += 2.0 * correlation;
  }
  return factor;
}

double median_norm(const std::vector<Vector2d>& residuals) {
  std::vector<double> norms;
  for (const Vector2d& r : residuals) norms.push_back(r.norm());
  return median_of(std::move(norms));
}

// Beyond which a residual pulls as if it were no larger (Huber).
double clipped_beyond_m(const std::vector<Vector2d>& residuals) { return std::max(1e-9, 2.0 * median_norm(residuals)); }

// What the covariance for errors of unit size is to be multiplied by. Positions that are far off pull by no more than
// others: the variance is that of the pulls, over the square of how they change with the error.
// docs/maths/vehicle-frame.md (V15)
double variance_of_pulls(const std::vector<Vector2d>& residuals, double unknowns) {
  const double limit_m = clipped_beyond_m(residuals), count = static_cast<double>(residuals.size());
  std::vector<Vector2d> pulls;
  double sum = 0.0, weights = 0.0, slopes = 0.0;
  for (const Vector2d& r : residuals) {
    const double weight = std::min(1.0, limit_m / std::max(1e-300, r.norm()));
    pulls.push_back(weight * r);
    sum += pulls.back().squaredNorm();
    weights += weight / count;
    slopes += (weight < 1.0 ? 0.5 * weight : 1.0) / count;  // along the residual a pull that is clipped does not change
  }
  return lasting(pulls) * sum / std::max(1.0, 2.0 * count - unknowns) * weights / (slopes * slopes);
}

using CommonMatrix = Eigen::Matrix<double, kCommon, kCommon>;
using CommonVector = Eigen::Matrix<double, kCommon, 1>;

// Normal equations of one window's own unknowns, and what links them to the common ones.
struct WindowNormal {
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, kCommon, kOfWindow> link = Eigen::Matrix<double, kCommon, kOfWindow>::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

CommonMatrix inverse_of(const CommonMatrix& matrix) {
  const CommonVector scale = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const CommonMatrix inverse =
      CommonMatrix(scale.asDiagonal() * matrix * scale.asDiagonal()).ldlt().solve(CommonMatrix::Identity());
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

// One round of Gauss-Newton; the covariance is for independent errors of unit size. Each window is eliminated by
// itself: the time grows with the drive, not with the cube of it.
double improve(const std::vector<Point>& points, FitState& state, CommonMatrix& covariance,
               std::vector<Vector2d>& residuals) {
  CommonMatrix normal = CommonMatrix::Zero();
  CommonVector gradient = CommonVector::Zero();
  std::vector<WindowNormal> windows(state.windows.size());
  Row jacobian = Row::Zero();
  residuals.clear();
  for (const Point& point : points) residuals.push_back(residual_of(point, state, jacobian));
  const double median_m = median_norm(residuals), limit = clipped_beyond_m(residuals);
  for (std::size_t i = 0; i < points.size(); ++i) {
    residual_of(points[i], state, jacobian);
    const double weight = std::min(1.0, limit / std::max(1e-300, residuals[i].norm()));
    const auto common = jacobian.leftCols<kCommon>();
    const auto own = jacobian.rightCols<kOfWindow>();
    WindowNormal& window = windows[points[i].window];
    normal += weight * common.transpose() * common;
    gradient += weight * common.transpose() * residuals[i];
    window.own += weight * own.transpose() * own;
    window.link += weight * common.transpose() * own;
    window.gradient += weight * own.transpose() * residuals[i];
  }
  // A lever arm of more than 5 m is no car's: without turns it stays near the axle.
  normal(0, 0) += 1e-4;
  normal(1, 1) += 1e-4;
  const double height_weight = 0.5 * median_m * median_m / (kHeightSigma_m * kHeightSigma_m) + 1e-12;
  normal(4, 4) += height_weight;
  gradient[4] += height_weight * (state.height_m - kUsualHeight_m);
  for (WindowNormal& window : windows) {
    // The last window may hold a single position: its heading is then anything, and stays as it is.
    window.own(2, 2) += 1e-6;
    const Eigen::LDLT<Eigen::Matrix3d> own(window.own);
    normal -= window.link * own.solve(window.link.transpose());
    gradient -= window.link * own.solve(window.gradient);
  }
  covariance = inverse_of(normal);
  const CommonVector step = -covariance * gradient;
  state.lever_m += step.head<2>();
  state.bias_change_radps += step[2];
  state.log_scale += step[3];
  state.height_m += step[4];
  for (std::size_t w = 0; w < windows.size(); ++w) {
    const Eigen::Vector3d change =
        -windows[w].own.ldlt().solve(windows[w].gradient + windows[w].link.transpose() * step);
    state.windows[w].place_m += change.head<2>();
    state.windows[w].heading_rad += change[2];
  }
  return step.norm();
}

struct WholeDrive {
  std::vector<StampedPosition> integrated;
  double end_error_m = 0.0, way_m = 0.0;
  std::optional<double> first_gap_s;
};

// The drive from its start, whose heading comes from its first `kStart_s`, up to the first gap of the signals.
WholeDrive integrate_all(const WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
                         const Matrix3d& vehicle_from_imu, double bias_radps, double scale, const Vector2d& lever_m,
                         const Progress& progress) {
  constexpr double kStart_s = 20.0;
  double distance_m = 0.0;
  std::vector<Point> points =
      points_of(sensed, positions, vehicle_from_imu, {}, 1e12, bias_radps, distance_m, progress);
  WholeDrive drive;
  if (points.size() < 3 || progress.cancelled()) return drive;
  std::size_t start = 0, of_first = 0;
  for (Point& point : points) {
    point.way_m = scale * point.way_m + turned(point.turn_rad) * lever_m;
    if (point.window > 0) continue;
    ++of_first;
    if (point.time_s < kStart_s) ++start;
  }
  if (of_first < 3) return drive;
  const Placement window = place(points, 0, std::clamp<std::size_t>(start, 3, of_first));
  std::size_t at = 0;
  for (const StampedPosition& position : positions) {
    if (position.stamp_ns < sensed.begin_ns() || position.stamp_ns > sensed.end_ns()) continue;
    const Point& point = points[at++];
    if (point.window > 0) {
      drive.first_gap_s = points[of_first - 1].time_s;
      break;
    }
    const Vector2d place_m = window.place_m + turned(window.heading_rad) * point.way_m;
    drive.integrated.push_back({position.stamp_ns, {place_m.x(), place_m.y(), position.position_m.z()}});
    drive.end_error_m = (place_m - point.position_m).norm();
    drive.way_m = scale * point.travel_m;
  }
  return drive;
}

// What the rounds of the fit carry along.
struct Running {
  FitState state;
  double bias_radps = 0.0;
  CommonMatrix covariance = CommonMatrix::Zero();  // for errors of unit size
  std::vector<Vector2d> residuals;
};

std::vector<Placement> placed(const std::vector<Point>& points) {
  std::vector<Placement> windows;
  for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
    while (last < points.size() && points[last].window == points[first].window) ++last;
    windows.push_back(place(points, first, last));
  }
  return windows;
}

bool refuse(Status failure, Message why, AntennaFit& fit) {
  fit.found = false;
  fit.failure = failure;
  fit.why = std::move(why);
  return false;
}

// Rounds until the unknowns stand still. False, with the reason, where nothing can be found.
bool converge(const WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
              const Matrix3d& vehicle_from_imu, double window_s, const VehicleTilt& tilt, Progress& progress,
              Running& running, AntennaFit& fit) {
  constexpr int kRounds = 30;
  constexpr std::size_t kFewest = 30;
  for (int round = 0; round < kRounds; ++round) {
    progress.report(say::stage_integrating_wheels_and_yaw_rate, static_cast<std::size_t>(round), kRounds);
    const std::vector<Point> points =
        points_of(sensed, positions, vehicle_from_imu, tilt, window_s, running.bias_radps, fit.distance_m, progress);
    if (progress.cancelled()) return refuse(Status::Cancelled, say::antenna_cancelled(), fit);
    fit.positions = points.size();
    if (points.size() < kFewest) return refuse(Status::TooLittleData, say::antenna_few_positions(points.size()), fit);
    if (running.state.windows.empty()) running.state.windows = placed(points);
    const double step = improve(points, running.state, running.covariance, running.residuals);
    running.bias_radps += running.state.bias_change_radps;
    running.state.bias_change_radps = 0.0;
    if (round > 2 && step < 1e-7) break;
  }
  return true;
}

void describe(const Running& running, const VehicleTilt& tilt, AntennaFit& fit) {
  double sum = 0.0;
  for (const Vector2d& r : running.residuals) sum += r.squaredNorm();
  const double count = static_cast<double>(running.residuals.size());
  const double unknowns = kCommon + kOfWindow * static_cast<double>(running.state.windows.size());
  const CommonMatrix covariance = variance_of_pulls(running.residuals, unknowns) * running.covariance;
  fit.found = true;
  if (!covariance.allFinite()) refuse(Status::NotConverged, say::antenna_no_solution(), fit);
  fit.antenna_in_vehicle_m = running.state.lever_m;
  // A lean that is wrong alike all along the drive shifts the antenna by its height, and leaves no residual.
  const double height2_m2 = running.state.height_m * running.state.height_m + covariance(4, 4);
  fit.covariance_m2 = covariance.topLeftCorner<2, 2>() + height2_m2 * tilt.common_covariance;
  fit.yaw_rate_bias_radps = running.bias_radps;
  fit.yaw_rate_bias_sigma_radps = std::sqrt(covariance(2, 2));
  fit.wheel_scale = std::exp(running.state.log_scale);
  fit.wheel_scale_sigma = fit.wheel_scale * std::sqrt(covariance(3, 3));
  fit.rms_m = std::sqrt(sum / count);
  fit.windows = static_cast<int>(running.state.windows.size());
}

}  // namespace

AntennaFit fit_antenna(const WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
                       const Eigen::Matrix3d& vehicle_from_imu, double window_s, Progress& progress) {
  AntennaFit fit;
  Running running;
  // The lever arm is part of the heights, and the lean of the lever arm: twice is enough.
  VehicleTilt tilt;
  for (int round = 0; round < 2; ++round) {
    tilt = vehicle_tilt(sensed, positions, vehicle_from_imu, window_s, running.state.lever_m, progress);
    if (!converge(sensed, positions, vehicle_from_imu, window_s, tilt, progress, running, fit)) return fit;
  }
  describe(running, tilt, fit);
  WholeDrive drive = integrate_all(sensed, positions, vehicle_from_imu, fit.yaw_rate_bias_radps, fit.wheel_scale,
                                   fit.antenna_in_vehicle_m, progress);
  fit.integrated = std::move(drive.integrated);
  fit.end_error_m = drive.end_error_m;
  fit.integrated_m = drive.way_m;
  fit.first_gap_s = drive.first_gap_s;
  WholeDrive raw = integrate_all(sensed, positions, vehicle_from_imu, 0.0, 1.0, Vector2d::Zero(), progress);
  fit.integrated_raw = std::move(raw.integrated);
  fit.end_error_raw_m = raw.end_error_m;
  if (progress.cancelled()) refuse(Status::Cancelled, say::antenna_cancelled(), fit);
  return fit;
}

}  // namespace remount
