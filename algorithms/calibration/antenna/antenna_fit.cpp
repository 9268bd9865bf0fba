#include "algorithms/calibration/antenna/antenna_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/calibration/antenna/antenna_points.h"
#include "algorithms/core/median.h"
#include "algorithms/geometry/lasting_errors.h"
#include "messages/calibration.h"
#include "messages/stages.h"

namespace remount::calibration {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Lever arm twice, bias, log of the wheel scale, height; place twice, heading.
constexpr int kCommon = 5, kOfWindow = 3;
// Of an antenna over the rear axle's ground, for all that is known beforehand.
constexpr double kUsualHeight_m = 1.5, kHeightSigma_m = 1.0;

struct FitState {
  Vector2d lever_m = Vector2d::Zero();
  double height_m = kUsualHeight_m;
  double bias_change_radps = 0.0, log_scale = 0.0;
  std::vector<WindowPlacement> windows;
};

using Row = Eigen::Matrix<double, 2, kCommon + kOfWindow>;  // of the common unknowns and of the point's window

Vector2d residual_of(const AntennaPoint& point, const FitState& state, Row& jacobian) {
  const WindowPlacement& window = state.windows[point.window];
  const double scale = std::exp(state.log_scale);
  const double turn_rad = point.turn_rad - state.bias_change_radps * point.time_s;
  const Vector2d way_m = scale * (point.way_m + state.bias_change_radps * point.way_by_bias);
  const Matrix2d world_from_window = rotation_in_plane(window.heading_rad),
                 window_from_vehicle = rotation_in_plane(turn_rad);
  const Vector2d antenna_m = point.level_from_vehicle * Vector3d(state.lever_m.x(), state.lever_m.y(), state.height_m);
  const Vector2d in_window = way_m + window_from_vehicle * antenna_m;
  Matrix2d quarter;
  quarter << 0.0, -1.0, 1.0, 0.0;
  const Eigen::Matrix<double, 2, 3> by_antenna = world_from_window * window_from_vehicle * point.level_from_vehicle;
  jacobian.leftCols<2>() = by_antenna.leftCols<2>();
  jacobian.col(2) =
      world_from_window * (scale * point.way_by_bias - point.time_s * quarter * window_from_vehicle * antenna_m);
  jacobian.col(3) = world_from_window * way_m;
  jacobian.col(4) = by_antenna.col(2);
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

double weight_of(const Vector2d& residual_m, double limit_m) {
  return std::min(1.0, limit_m / std::max(1e-300, residual_m.norm()));
}

// What the covariance for errors of unit size is to be multiplied by. Positions that are far off pull by no more than
// others: the variance is that of the pulls, over the square of how they change with the error.
// docs/maths/vehicle-frame.md (V15)
double variance_of_pulls(const std::vector<Vector2d>& residuals, double unknowns) {
  const double limit_m = clipped_beyond_m(residuals), count = static_cast<double>(residuals.size());
  double sum = 0.0, weights = 0.0, slopes = 0.0;
  for (const Vector2d& r : residuals) {
    const double weight = weight_of(r, limit_m);
    sum += weight * weight * r.squaredNorm();
    weights += weight / count;
    slopes += (weight < 1.0 ? 0.5 * weight : 1.0) / count;  // along the residual a pull that is clipped does not change
  }
  return sum / std::max(1.0, 2.0 * count - unknowns) * weights / (slopes * slopes);
}

using CommonMatrix = Eigen::Matrix<double, kCommon, kCommon>;
using CommonVector = Eigen::Matrix<double, kCommon, 1>;

// Normal equations of one window's own unknowns, and what links them to the common ones.
struct WindowNormal {
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, kCommon, kOfWindow> link = Eigen::Matrix<double, kCommon, kOfWindow>::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, kCommon, kOfWindow> common_by_own = Eigen::Matrix<double, kCommon, kOfWindow>::Zero();
};

// What the rounds of the fit carry along.
struct Running {
  FitState state;
  double bias_radps = 0.0;
  CommonMatrix covariance = CommonMatrix::Zero();  // for errors of unit size
  std::vector<Vector2d> residuals;
  Eigen::MatrixXd scores;  // one point a row
  std::vector<TiltErrors::Factors> lever_by_tilt;
};

CommonMatrix inverse_of(const CommonMatrix& matrix) {
  const CommonVector scale = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const CommonMatrix inverse =
      CommonMatrix(scale.asDiagonal() * matrix * scale.asDiagonal()).ldlt().solve(CommonMatrix::Identity());
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

// How each point moves the common unknowns, freed of the windows' own.
void score(const std::vector<AntennaPoint>& points, const std::vector<Row>& jacobians,
           const std::vector<WindowNormal>& windows, Running& running) {
  const double limit_m = clipped_beyond_m(running.residuals);
  running.scores.resize(static_cast<Eigen::Index>(points.size()), kCommon);
  running.lever_by_tilt.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& common_by_own = windows[points[i].window].common_by_own;
    const Eigen::Matrix<double, kCommon, 2> weighted =
        weight_of(running.residuals[i], limit_m) *
        (jacobians[i].leftCols<kCommon>() - jacobians[i].rightCols<kOfWindow>() * common_by_own.transpose())
            .transpose();
    running.scores.row(static_cast<Eigen::Index>(i)) = (weighted * running.residuals[i]).transpose();
    const Matrix2d lever_by_residual = (running.covariance * weighted).topRows<2>();
    const double heading_rad = running.state.windows[points[i].window].heading_rad;
    running.lever_by_tilt.push_back({-running.state.height_m * lever_by_residual * jacobians[i].leftCols<2>(),
                                     lever_by_residual * rotation_in_plane(heading_rad)});
  }
}

// One round of Gauss-Newton; the covariance is for independent errors of unit size. Each window is eliminated by
// itself: the time grows with the drive, not with the cube of it.
double improve(const std::vector<AntennaPoint>& points, Running& running) {
  FitState& state = running.state;
  std::vector<Vector2d>& residuals = running.residuals;
  CommonMatrix normal = CommonMatrix::Zero();
  CommonVector gradient = CommonVector::Zero();
  std::vector<WindowNormal> windows(state.windows.size());
  std::vector<Row> jacobians(points.size());
  residuals.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) residuals[i] = residual_of(points[i], state, jacobians[i]);
  const double median_m = median_norm(residuals), limit = clipped_beyond_m(residuals);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Row& jacobian = jacobians[i];
    const double weight = weight_of(residuals[i], limit);
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
    window.common_by_own = own.solve(window.link.transpose()).transpose();
  }
  running.covariance = inverse_of(normal);
  score(points, jacobians, windows, running);
  const CommonVector step = -running.covariance * gradient;
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
WholeDrive integrate_all(const std::vector<DrivenPosition>& driven, const Matrix3d& vehicle_from_imu, double bias_radps,
                         double scale, const Vector2d& lever_m, const Progress& progress) {
  constexpr double kStart_s = 20.0;
  std::vector<AntennaPoint> points = antenna_points(driven, vehicle_from_imu, {}, bias_radps, progress);
  WholeDrive drive;
  if (points.size() < 3 || progress.cancelled()) return drive;
  std::size_t start = 0, of_first = 0;
  for (AntennaPoint& point : points) {
    point.way_m = scale * point.way_m + rotation_in_plane(point.turn_rad) * lever_m;
    if (point.window > 0) continue;
    ++of_first;
    if (point.time_s < kStart_s) ++start;
  }
  if (of_first < 3) return drive;
  const WindowPlacement window = place_window(points, 0, std::clamp<std::size_t>(start, 3, of_first));
  if (of_first < points.size()) drive.first_gap_s = points[of_first - 1].time_s;
  for (std::size_t i = 0; i < of_first; ++i) {
    const StampedPosition& position = driven[i].position;
    const Vector2d place_m = window.place_m + rotation_in_plane(window.heading_rad) * points[i].way_m;
    drive.integrated.push_back({position.stamp_ns, {place_m.x(), place_m.y(), position.position_m.z()}});
    drive.end_error_m = (place_m - points[i].position_m).norm();
    drive.way_m = scale * points[i].travel_m;
  }
  return drive;
}

bool refuse(Status failure, Message why, AntennaFit& fit) {
  fit.found = false;
  fit.failure = failure;
  fit.why = std::move(why);
  return false;
}

// Rounds until the unknowns stand still. False, with the reason, where nothing can be found.
bool converge(const std::vector<DrivenPosition>& driven, const Matrix3d& vehicle_from_imu, const VehicleTilt& tilt,
              Progress& progress, Running& running, AntennaFit& fit) {
  constexpr int kRounds = 30;
  constexpr std::size_t kFewest = 30;
  for (int round = 0; round < kRounds; ++round) {
    progress.report(say::stage_integrating_wheels_and_yaw_rate, static_cast<std::size_t>(round), kRounds);
    const std::vector<AntennaPoint> points =
        antenna_points(driven, vehicle_from_imu, tilt, running.bias_radps, progress);
    if (progress.cancelled()) return refuse(Status::Cancelled, say::antenna_cancelled(), fit);
    fit.positions = points.size();
    if (points.size() < kFewest) return refuse(Status::TooLittleData, say::antenna_few_positions(points.size()), fit);
    if (running.state.windows.empty()) running.state.windows = place_windows(points);
    const double step = improve(points, running);
    running.bias_radps += running.state.bias_change_radps;
    running.state.bias_change_radps = 0.0;
    if (round > 2 && step < 1e-7) break;
  }
  return true;
}

// docs/maths/vehicle-frame.md (V15)
CommonMatrix covariance_of(const Running& running, double unknowns) {
  const double limit_m = clipped_beyond_m(running.residuals);
  constexpr int kFewestBlocks = 12;  // a window takes up what lasts longer
  std::vector<Vector2d> pulls;
  for (const Vector2d& r : running.residuals) pulls.push_back(weight_of(r, limit_m) * r);
  const CommonVector widening =
      lasting_widening(running.covariance, running.scores, kFewestBlocks).cwiseMax(std::sqrt(lasting(pulls)));
  return variance_of_pulls(running.residuals, unknowns) * widening.asDiagonal() * running.covariance *
         widening.asDiagonal();
}

void describe(const Running& running, const VehicleTilt& tilt, AntennaFit& fit) {
  double sum = 0.0;
  for (const Vector2d& r : running.residuals) sum += r.squaredNorm();
  const double count = static_cast<double>(running.residuals.size());
  const double unknowns = kCommon + kOfWindow * static_cast<double>(running.state.windows.size());
  const CommonMatrix covariance = covariance_of(running, unknowns);
  fit.found = true;
  if (!covariance.allFinite()) {
    refuse(Status::NotConverged, say::antenna_no_solution(), fit);
    return;
  }
  fit.antenna_in_vehicle_m = running.state.lever_m;
  fit.covariance_m2 = covariance.topLeftCorner<2, 2>();
  if (tilt.known) fit.covariance_m2 += tilt.errors.covariance_of_sum(running.lever_by_tilt);
  // A lean that is wrong alike all along the drive shifts the antenna by its height, and leaves no residual.
  const double height2_m2 = running.state.height_m * running.state.height_m + covariance(4, 4);
  fit.covariance_m2(1, 1) += height2_m2 * tilt.common_roll_variance_rad2;
  fit.yaw_rate_bias_radps = running.bias_radps;
  fit.yaw_rate_bias_sigma_radps = std::sqrt(covariance(2, 2));
  fit.wheel_scale = std::exp(running.state.log_scale);
  fit.wheel_scale_sigma = fit.wheel_scale * std::sqrt(covariance(3, 3));
  fit.rms_m = std::sqrt(sum / count);
  fit.windows = static_cast<int>(running.state.windows.size());
}

}  // namespace

AntennaFit fit_antenna(const motion::WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
                       const Eigen::Matrix3d& vehicle_from_imu, double imu_roll_sigma_rad, double window_s,
                       Progress& progress) {
  AntennaFit fit;
  Running running;
  const std::vector<DrivenPosition> driven = driven_positions(sensed, positions, window_s, progress);
  for (const DrivenPosition& one : driven)
    for (const motion::MotionStep& step : one.steps) fit.distance_m += std::abs(step.travel_m);
  // The lever arm is part of the heights, and the lean of the lever arm: twice is enough.
  VehicleTilt tilt;
  for (int round = 0; round < 2; ++round) {
    tilt = vehicle_tilt(driven, sensed.rates_about_one_axis(), vehicle_from_imu, imu_roll_sigma_rad,
                        running.state.lever_m, progress);
    if (!converge(driven, vehicle_from_imu, tilt, progress, running, fit)) return fit;
  }
  describe(running, tilt, fit);
  if (!fit.found) return fit;
  const std::vector<DrivenPosition> whole =
      driven_positions(sensed, positions, std::numeric_limits<double>::infinity(), progress);
  WholeDrive drive = integrate_all(whole, vehicle_from_imu, fit.yaw_rate_bias_radps, fit.wheel_scale,
                                   fit.antenna_in_vehicle_m, progress);
  fit.integrated = std::move(drive.integrated);
  fit.end_error_m = drive.end_error_m;
  fit.integrated_m = drive.way_m;
  fit.first_gap_s = drive.first_gap_s;
  WholeDrive raw = integrate_all(whole, vehicle_from_imu, 0.0, 1.0, Vector2d::Zero(), progress);
  fit.integrated_raw = std::move(raw.integrated);
  fit.end_error_raw_m = raw.end_error_m;
  if (progress.cancelled()) refuse(Status::Cancelled, say::antenna_cancelled(), fit);
  return fit;
}

}  // namespace remount::calibration
