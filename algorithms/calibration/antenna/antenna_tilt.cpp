#include "algorithms/calibration/antenna/antenna_tilt.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/core/median.h"
#include "algorithms/geometry/lasting_errors.h"
#include "algorithms/geometry/shortest_rotation.h"

namespace remount::calibration {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRateStep_radps = 1e-5;  // of the derivatives by the biases
constexpr double kCrossfall_rad = 0.01;   // 1-sigma

// Attitude and way since the start of a window.
struct Course {
  Matrix3d start_from_here = Matrix3d::Identity();
  Vector3d way_m = Vector3d::Zero();                              // with the pitch centre at the axle
  Vector3d lift_rad = Vector3d::Zero();                           // by each metre that it lies ahead
  Vector3d side_m = Vector3d::Zero(), rise_m = Vector3d::Zero();  // by each radian that the way points there
  void advance(const motion::MotionStep& step, const Matrix3d& vehicle_from_imu, const Vector3d& bias_radps) {
    const Vector3d turn = vehicle_from_imu * step.turn_in_imu_rad - step.duration_s * bias_radps;
    const Matrix3d travel_m = step.travel_m * start_from_here * so3_left_jacobian(turn);
    way_m += travel_m.col(0);
    side_m += travel_m.col(1);
    rise_m += travel_m.col(2);
    lift_rad += start_from_here.col(2) * turn.y();
    start_from_here = start_from_here * so3_exp(turn);
  }
};

// As sensed, and with each bias taken a step farther.
using Courses = std::array<Course, 3>;

struct PointOfDrive {
  std::size_t window = 0;
  Courses courses;
  double travel_m = 0.0, height_m = 0.0;
};

std::vector<PointOfDrive> places_of(const std::vector<DrivenPosition>& driven, const Matrix3d& vehicle_from_imu,
                                    const Progress& progress) {
  const std::array<Vector3d, 3> biases{Vector3d::Zero(), kRateStep_radps * Vector3d::UnitX(),
                                       kRateStep_radps * Vector3d::UnitY()};
  std::vector<PointOfDrive> places;
  Courses courses;
  double travel_m = 0.0;
  for (std::size_t i = 0; i < driven.size() && !progress.cancelled(); ++i) {
    if (driven[i].begins_window)
      courses = {}, travel_m = 0.0;
    else
      for (const motion::MotionStep& step : driven[i].steps) {
        for (std::size_t k = 0; k < courses.size(); ++k) courses[k].advance(step, vehicle_from_imu, biases[k]);
        travel_m += step.travel_m;
      }
    places.push_back({driven[i].window, courses, travel_m, driven[i].position.position_m.z()});
  }
  return places;
}

// Unknowns: height and the vertical's x and y at the start of each window; biases of the rates about x and y, pitch of
// the way, pitch centre, yaw of the way.
constexpr int kOwn = 3, kTiltCommon = 5;
using Own = Eigen::Matrix<double, kOwn, 1>;
using TiltCommon = Eigen::Matrix<double, kTiltCommon, 1>;
using OwnMatrix = Eigen::Matrix<double, kOwn, kOwn>;
using TiltCommonMatrix = Eigen::Matrix<double, kTiltCommon, kTiltCommon>;
using Link = Eigen::Matrix<double, kOwn, kTiltCommon>;

struct LeanRow {
  Own own;
  TiltCommon common;
  double rest_m;  // of the height, with all unknowns at zero
};

// Of the unknowns so far: heights are products of the two.
struct Guess {
  double centre_m = motion::kPitchCentre_m, way_side = 0.0;
  std::vector<Vector3d> up_at_start;
};

// The height of the antenna is the way's rise and that of the lever; one that stays the same is the window's own.
double height_of(const Course& course, const Vector3d& up_at_start, const Vector2d& lever_m, const Guess& guess) {
  return (course.way_m + guess.centre_m * course.lift_rad + guess.way_side * course.side_m).dot(up_at_start) +
         (course.start_from_here.transpose() * up_at_start).head<2>().dot(lever_m);
}

LeanRow row_of(const PointOfDrive& place, const Vector2d& lever_m, const Guess& guess) {
  const auto height_m = [&](std::size_t course, const Vector3d& up_at_start) {
    return height_of(place.courses[course], up_at_start, lever_m, guess);
  };
  const double flat_m = height_m(0, Vector3d::UnitZ());
  LeanRow row;
  row.own << 1.0, height_m(0, Vector3d::UnitX()), height_m(0, Vector3d::UnitY());
  row.common << (height_m(1, Vector3d::UnitZ()) - flat_m) / kRateStep_radps,
      (height_m(2, Vector3d::UnitZ()) - flat_m) / kRateStep_radps, place.travel_m,
      place.courses[0].lift_rad.dot(guess.up_at_start[place.window]),
      place.courses[0].side_m.dot(guess.up_at_start[place.window]);
  row.rest_m = place.height_m - flat_m;
  return row;
}

struct Solution {
  std::vector<Own> own;
  TiltCommon common = TiltCommon::Zero();
  std::vector<OwnMatrix> own_inverse;
  std::vector<Link> link;
  TiltCommonMatrix common_covariance = TiltCommonMatrix::Zero();  // for errors of unit size
};

// `unit_m`: 1-sigma of a height, against which what is expected beforehand is weighed.
Solution solve(const std::vector<PointOfDrive>& places, const std::vector<LeanRow>& rows,
               const std::vector<double>& weights, double unit_m, const Guess& guess) {
  constexpr double kTilt = 0.2, kBias_radps = 0.02, kWay_rad = 0.05;  // 1-sigma beforehand
  const std::size_t windows = places.back().window + 1;
  const auto expected = [unit_m](double sigma) { return std::pow(unit_m / sigma, 2); };
  std::vector<OwnMatrix> own(windows, Own(0.0, expected(kTilt), expected(kTilt)).asDiagonal());
  std::vector<Own> own_side(windows, Own::Zero());
  Solution out;
  out.link.assign(windows, Link::Zero());
  TiltCommon prior;
  prior << expected(kBias_radps), expected(kBias_radps), expected(kWay_rad), expected(motion::kPitchCentreSigma_m),
      expected(kWay_rad);
  TiltCommonMatrix common = prior.asDiagonal();
  TiltCommon side = TiltCommon::Zero();
  side[3] = prior[3] * (motion::kPitchCentre_m - guess.centre_m);
  side[4] = -prior[4] * guess.way_side;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t w = places[i].window;
    own[w] += weights[i] * rows[i].own * rows[i].own.transpose();
    out.link[w] += weights[i] * rows[i].own * rows[i].common.transpose();
    common += weights[i] * rows[i].common * rows[i].common.transpose();
    own_side[w] += weights[i] * rows[i].rest_m * rows[i].own;
    side += weights[i] * rows[i].rest_m * rows[i].common;
  }
  for (std::size_t w = 0; w < windows; ++w) {
    out.own_inverse.push_back(own[w].ldlt().solve(OwnMatrix::Identity()));
    common -= out.link[w].transpose() * out.own_inverse[w] * out.link[w];
    side -= out.link[w].transpose() * out.own_inverse[w] * own_side[w];
  }
  out.common_covariance = common.ldlt().solve(TiltCommonMatrix::Identity());
  out.common = out.common_covariance * side;
  for (std::size_t w = 0; w < windows; ++w)
    out.own.push_back(out.own_inverse[w] * (own_side[w] - out.link[w] * out.common));
  return out;
}

// What is horizontal of the ways of a place, by each unknown. A yaw of the way turns the window as a whole, which its
// heading takes up.
void set_ways(const PointOfDrive& place, const Matrix3d& level_from_start, double way_side,
              TiltErrors::OfPoint& point) {
  const auto level_m = [&](const Vector3d& in_start_m) -> Vector2d {
    return (level_from_start * in_start_m).head<2>();
  };
  const Course& sensed = place.courses[0];
  const Vector3d way_m = level_from_start * (sensed.way_m + way_side * sensed.side_m);
  point.way_by_window.rightCols<2>() = -way_m.z() * Matrix2d::Identity();
  for (int k = 0; k < 2; ++k)
    point.way_by_drive.col(k) =
        level_m(place.courses[static_cast<std::size_t>(k + 1)].way_m - sensed.way_m) / kRateStep_radps;
  point.way_by_drive.col(2) = level_m(sensed.rise_m);
  point.way_by_drive.col(3) = level_m(sensed.lift_rad);
  point.way_by_drive.col(4) = level_m(sensed.side_m) - Vector2d(-way_m.y(), way_m.x());
}

// The verticals along the drive, and how they and the ways follow the unknowns.
std::vector<Vector2d> leans_of(const std::vector<PointOfDrive>& places, const Solution& solution, double way_side,
                               TiltErrors& errors) {
  std::vector<Vector2d> ups;
  for (const PointOfDrive& place : places) {
    const Own& own = solution.own[place.window];
    const Vector3d up_at_start = Vector3d(own[1], own[2], 1.0).normalized();
    const auto up_by = [&](std::size_t k) -> Vector2d {
      return (place.courses[k].start_from_here.transpose() * up_at_start).head<2>();
    };
    TiltErrors::OfPoint point;
    point.window = place.window;
    point.lean_by_window.rightCols<2>() = place.courses[0].start_from_here.transpose().topLeftCorner<2, 2>();
    point.lean_by_drive.col(0) = (up_by(1) - up_by(0)) / kRateStep_radps;
    point.lean_by_drive.col(1) = (up_by(2) - up_by(0)) / kRateStep_radps;
    point.lean_by_drive(0, 2) = 1.0;  // x of the vehicle is the way of its wheels
    point.lean_by_drive.col(4) << up_by(0).y(), -up_by(0).x();
    ups.push_back(up_by(0) + point.lean_by_drive.leftCols<3>() * solution.common.head<3>() +
                  way_side * point.lean_by_drive.col(4));
    set_ways(place, shortest_rotation(up_at_start, Vector3d::UnitZ()), way_side, point);
    errors.points.push_back(point);
  }
  return ups;
}

TiltErrors errors_of(const Solution& solution, double variance_m2) {
  TiltErrors errors;
  for (std::size_t w = 0; w < solution.own.size(); ++w)
    errors.windows.push_back({variance_m2 * solution.own_inverse[w], -solution.own_inverse[w] * solution.link[w]});
  errors.drive_covariance = variance_m2 * solution.common_covariance;
  return errors;
}

// Factors of the mean lean. A window of a few places, as at the end of a drive, is placed anew and tells of no lever
// arm.
std::vector<TiltErrors::Factors> factors_of_mean(const std::vector<PointOfDrive>& places) {
  constexpr std::size_t kFewest = 10;
  std::vector<std::size_t> sizes(places.back().window + 1, 0);
  for (const PointOfDrive& place : places) ++sizes[place.window];
  std::size_t count = 0;
  for (const std::size_t size : sizes) count += size < kFewest ? 0 : size;
  std::vector<TiltErrors::Factors> factors(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    if (sizes[places[i].window] >= kFewest) factors[i].by_lean = Matrix2d::Identity() / static_cast<double>(count);
  return factors;
}

// The lean is that of the axes of the rates, whose roll in the vehicle heights do not show: the mean lean is that of
// the road or that of the axes, each as far as it is expected. Hilly roads may lean on the mean by what they lean at
// all. docs/maths/vehicle-frame.md (V17)
void allow_for_imu_roll(double imu_roll_sigma_rad, VehicleTilt& tilt) {
  const double count = static_cast<double>(tilt.up_in_vehicle.size());
  Vector2d mean = Vector2d::Zero(), squares = Vector2d::Zero();
  for (const Vector2d& up : tilt.up_in_vehicle) mean += up / count;
  for (const Vector2d& up : tilt.up_in_vehicle) squares += (up - mean).cwiseAbs2() / count;
  const double of_road = kCrossfall_rad * kCrossfall_rad + squares.maxCoeff(),
               of_axes = imu_roll_sigma_rad * imu_roll_sigma_rad, share_of_axes = of_axes / (of_road + of_axes);
  for (Vector2d& up : tilt.up_in_vehicle) up.y() -= share_of_axes * mean.y();
  tilt.common_roll_variance_rad2 = share_of_axes * of_road;
}

double median_size(const std::vector<double>& residuals) {
  std::vector<double> sizes;
  for (const double residual : residuals) sizes.push_back(std::abs(residual));
  return median_of(std::move(sizes));
}

// What heights say, and with which errors.
struct TiltFit {
  Solution solution;
  Guess guess;
  double variance_m2 = std::numeric_limits<double>::infinity();  // of a height; infinite: fewer heights than it takes
};

// Rounds of least squares whose weights keep what is far off from pulling (Huber).
TiltFit fit_heights(const std::vector<PointOfDrive>& places, const Vector2d& lever_m) {
  TiltFit fit;
  fit.guess.up_at_start.assign(places.back().window + 1, Vector3d::UnitZ());
  std::vector<double> weights(places.size(), 1.0), residuals(places.size(), 0.0);
  std::vector<LeanRow> rows(places.size());
  constexpr int kRounds = 10;
  double unit_m = 0.05;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < places.size(); ++i) rows[i] = row_of(places[i], lever_m, fit.guess);
    fit.solution = solve(places, rows, weights, unit_m, fit.guess);
    const Solution& solution = fit.solution;
    for (std::size_t w = 0; w < solution.own.size(); ++w)
      fit.guess.up_at_start[w].head<2>() = solution.own[w].tail<2>();
    fit.guess.centre_m += solution.common[3];
    fit.guess.way_side += solution.common[4];
    for (std::size_t i = 0; i < places.size(); ++i)
      residuals[i] =
          rows[i].rest_m - rows[i].own.dot(solution.own[places[i].window]) - rows[i].common.dot(solution.common);
    unit_m = std::max(1e-4, 1.4826 * median_size(residuals));
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] = std::min(1.0, 2.0 * unit_m / std::max(1e-300, std::abs(residuals[i])));
  }
  const double unknowns = kTiltCommon + kOwn * static_cast<double>(fit.solution.own.size());
  const auto count = static_cast<double>(places.size());
  if (count < 2.0 * unknowns) return fit;
  double squares = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i) squares += weights[i] * residuals[i] * residuals[i];
  fit.variance_m2 = squares / (count - unknowns) * lasting_factor(residuals, unknowns);
  return fit;
}

}  // namespace

Matrix2d TiltErrors::covariance_of_sum(const std::vector<Factors>& factors) const {
  std::vector<ByWindow> of_windows(windows.size(), ByWindow::Zero());
  ByDrive of_drive = ByDrive::Zero();
  for (std::size_t i = 0; i < factors.size(); ++i) {
    of_windows[points[i].window] +=
        factors[i].by_lean * points[i].lean_by_window + factors[i].by_way * points[i].way_by_window;
    of_drive += factors[i].by_lean * points[i].lean_by_drive + factors[i].by_way * points[i].way_by_drive;
  }
  Matrix2d sum = Matrix2d::Zero();
  for (std::size_t w = 0; w < windows.size(); ++w) {
    sum += of_windows[w] * windows[w].spread * of_windows[w].transpose();
    of_drive += of_windows[w] * windows[w].follows;
  }
  return sum + of_drive * drive_covariance * of_drive.transpose();
}

VehicleTilt vehicle_tilt(const std::vector<DrivenPosition>& driven, bool one_axis, const Matrix3d& vehicle_from_imu,
                         double imu_roll_sigma_rad, const Vector2d& lever_m, const Progress& progress) {
  VehicleTilt tilt;
  const std::vector<PointOfDrive> places = places_of(driven, vehicle_from_imu, progress);
  tilt.up_in_vehicle.assign(places.size(), Vector2d::Zero());
  tilt.common_roll_variance_rad2 = kCrossfall_rad * kCrossfall_rad;
  if (places.empty() || one_axis || progress.cancelled()) return tilt;
  const TiltFit fit = fit_heights(places, lever_m);
  if (!std::isfinite(fit.variance_m2)) return tilt;
  const Solution& solution = fit.solution;
  TiltErrors errors = errors_of(solution, fit.variance_m2);
  std::vector<Vector2d> ups = leans_of(places, solution, fit.guess.way_side, errors);
  // Heights that say less of the lean than what roads are like are left alone.
  if (!(errors.covariance_of_sum(factors_of_mean(places))(1, 1) < kCrossfall_rad * kCrossfall_rad)) return tilt;
  tilt.known = true;
  tilt.up_in_vehicle = std::move(ups);
  tilt.errors = std::move(errors);
  for (const Own& own : solution.own)
    tilt.level_from_window_start.push_back(shortest_rotation(Vector3d(own[1], own[2], 1.0), Vector3d::UnitZ()));
  tilt.way = {1.0, fit.guess.way_side, solution.common[2]};
  tilt.pitch_centre_m = fit.guess.centre_m;
  tilt.rate_bias_radps = solution.common.head<2>();
  allow_for_imu_roll(imu_roll_sigma_rad, tilt);
  return tilt;
}

}  // namespace remount::calibration
