#include "algorithms/calibration/antenna/antenna_tilt.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/core/index.h"
#include "algorithms/core/median.h"
#include "algorithms/geometry/lasting_errors.h"
#include "algorithms/geometry/shortest_rotation.h"

namespace remount {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRateStep_radps = 1e-5;  // of the derivatives by the biases
constexpr double kCrossfall_rad = 0.01;   // 1-sigma

// Attitude and way since the start of a window.
struct Course {
  Matrix3d start_from_here = Matrix3d::Identity();
  Vector3d way_m = Vector3d::Zero();
  void advance(const MotionStep& step, const Matrix3d& vehicle_from_imu, const Vector3d& bias_radps) {
    const Vector3d turn = vehicle_from_imu * step.turn_in_imu_rad - step.duration_s * bias_radps;
    way_m += start_from_here * so3_left_jacobian(turn).col(0) * step.travel_m;
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

std::vector<PointOfDrive> places_of(const WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
                                    const Matrix3d& vehicle_from_imu, double window_s, const Progress& progress) {
  const std::array<Vector3d, 3> biases{Vector3d::Zero(), kRateStep_radps * Vector3d::UnitX(),
                                       kRateStep_radps * Vector3d::UnitY()};
  std::vector<PointOfDrive> places;
  Courses courses;
  double time_s = 0.0, travel_m = 0.0;
  for (std::size_t i = 0; i < positions.size() && !progress.cancelled(); ++i) {
    const auto steps = i > 0 ? sensed.steps(positions[i - 1].stamp_ns, positions[i].stamp_ns)
                             : std::optional<std::vector<MotionStep>>();
    if (steps)
      for (const MotionStep& step : *steps) {
        for (std::size_t k = 0; k < courses.size(); ++k) courses[k].advance(step, vehicle_from_imu, biases[k]);
        time_s += step.duration_s;
        travel_m += step.travel_m;
      }
    if (positions[i].stamp_ns < sensed.begin_ns() || positions[i].stamp_ns > sensed.end_ns()) continue;
    const bool anew = !steps || places.empty() || time_s > window_s;
    if (anew) courses = {}, time_s = travel_m = 0.0;
    const std::size_t before = places.empty() ? 0 : places.back().window;
    places.push_back({before + (anew && !places.empty() ? 1 : 0), courses, travel_m, positions[i].position_m.z()});
  }
  return places;
}

// Unknowns: height and the vertical's x and y at the start of each window; biases of the rates about x and y, pitch of
// the way.
constexpr int kOwn = 3, kTiltCommon = 3;
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

// The height of the antenna is the way's rise and that of the lever; one that stays the same is the window's own.
double height_of(const Course& course, const Vector3d& up_at_start, const Vector2d& lever_m) {
  return course.way_m.dot(up_at_start) + (course.start_from_here.transpose() * up_at_start).head<2>().dot(lever_m);
}

LeanRow row_of(const PointOfDrive& place, const Vector2d& lever_m) {
  const Course& sensed = place.courses[0];
  LeanRow row;
  row.own << 1.0, height_of(sensed, Vector3d::UnitX(), lever_m), height_of(sensed, Vector3d::UnitY(), lever_m);
  const double flat_m = height_of(sensed, Vector3d::UnitZ(), lever_m);
  for (int k = 0; k < 2; ++k)
    row.common[k] = (height_of(place.courses[index_at(k + 1)], Vector3d::UnitZ(), lever_m) - flat_m) / kRateStep_radps;
  row.common[2] = place.travel_m;
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
               const std::vector<double>& weights, double unit_m) {
  constexpr double kTilt = 0.2, kBias_radps = 0.02, kWay_rad = 0.05;  // 1-sigma beforehand
  const std::size_t windows = places.back().window + 1;
  const auto expected = [unit_m](double sigma) { return std::pow(unit_m / sigma, 2); };
  std::vector<OwnMatrix> own(windows, Own(0.0, expected(kTilt), expected(kTilt)).asDiagonal());
  std::vector<Own> own_side(windows, Own::Zero());
  Solution out;
  out.link.assign(windows, Link::Zero());
  TiltCommonMatrix common = TiltCommon(expected(kBias_radps), expected(kBias_radps), expected(kWay_rad)).asDiagonal();
  TiltCommon side = TiltCommon::Zero();
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

// The vertical at a place and how it follows the unknowns.
struct Lean {
  Vector2d up;
  Eigen::Matrix<double, 2, kOwn> by_own = Eigen::Matrix<double, 2, kOwn>::Zero();
  Eigen::Matrix<double, 2, kTiltCommon> by_common = Eigen::Matrix<double, 2, kTiltCommon>::Zero();
};

Lean lean_of(const PointOfDrive& place, const Solution& solution) {
  const Own& own = solution.own[place.window];
  const Vector3d up_at_start(own[1], own[2], 1.0);
  const auto up_by = [&](std::size_t k) -> Vector2d {
    return (place.courses[k].start_from_here.transpose() * up_at_start).head<2>();
  };
  Lean lean;
  lean.up = up_by(0);
  lean.by_own.rightCols<2>() = place.courses[0].start_from_here.transpose().topLeftCorner<2, 2>();
  for (int k = 0; k < 2; ++k)
    lean.by_common.col(k) = (up_by(static_cast<std::size_t>(k + 1)) - lean.up) / kRateStep_radps;
  lean.by_common(0, 2) = 1.0;  // x of the vehicle is the way of its wheels
  lean.up += lean.by_common * solution.common;
  return lean;
}

// Of the mean lean. A window of a few places, as at the end of a drive, is placed anew and tells of no lever arm.
Eigen::Matrix2d common_covariance_of(const std::vector<Lean>& leans, const std::vector<PointOfDrive>& places,
                                     const Solution& solution, double variance_m2) {
  constexpr double kFewest = 10.0;
  const std::size_t windows = solution.own.size();
  std::vector<double> sizes(windows, 0.0);
  for (const PointOfDrive& place : places) sizes[place.window] += 1.0;
  double count = 0.0;
  for (const double size : sizes) count += size < kFewest ? 0.0 : size;
  std::vector<Eigen::Matrix<double, 2, kOwn>> by_own(windows, Eigen::Matrix<double, 2, kOwn>::Zero());
  Eigen::Matrix<double, 2, kTiltCommon> by_common = Eigen::Matrix<double, 2, kTiltCommon>::Zero();
  for (std::size_t i = 0; i < leans.size(); ++i) {
    if (sizes[places[i].window] < kFewest) continue;
    by_own[places[i].window] += leans[i].by_own / count;
    by_common += leans[i].by_common / count;
  }
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t w = 0; w < windows; ++w) {
    sum += by_own[w] * solution.own_inverse[w] * by_own[w].transpose();
    by_common -= by_own[w] * solution.own_inverse[w] * solution.link[w];
  }
  return variance_m2 * (sum + by_common * solution.common_covariance * by_common.transpose());
}

double median_size(const std::vector<double>& residuals) {
  std::vector<double> sizes;
  for (const double residual : residuals) sizes.push_back(std::abs(residual));
  return median_of(std::move(sizes));
}

}  // namespace

VehicleTilt vehicle_tilt(const WheelImuSignals& sensed, const std::vector<StampedPosition>& positions,
                         const Matrix3d& vehicle_from_imu, double window_s, const Vector2d& lever_m,
                         const Progress& progress) {
  VehicleTilt tilt;
  const std::vector<PointOfDrive> places = places_of(sensed, positions, vehicle_from_imu, window_s, progress);
  tilt.up_in_vehicle.assign(places.size(), Vector2d::Zero());
  tilt.common_covariance = Vector2d(0.0, kCrossfall_rad * kCrossfall_rad).asDiagonal();
  if (places.empty() || sensed.rates_about_one_axis() || progress.cancelled()) return tilt;
  std::vector<LeanRow> rows;
  for (const PointOfDrive& place : places) rows.push_back(row_of(place, lever_m));
  std::vector<double> weights(places.size(), 1.0), residuals(places.size(), 0.0);
  constexpr int kRounds = 10;
  double unit_m = 0.05;
  Solution solution;
  for (int round = 0; round < kRounds; ++round) {
    solution = solve(places, rows, weights, unit_m);
    for (std::size_t i = 0; i < places.size(); ++i)
      residuals[i] =
          rows[i].rest_m - rows[i].own.dot(solution.own[places[i].window]) - rows[i].common.dot(solution.common);
    unit_m = std::max(1e-4, 1.4826 * median_size(residuals));
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] = std::min(1.0, 2.0 * unit_m / std::max(1e-300, std::abs(residuals[i])));
  }
  const double unknowns = kTiltCommon + kOwn * static_cast<double>(solution.own.size());
  const auto count = static_cast<double>(places.size());
  if (count < 2.0 * unknowns) return tilt;
  double squares = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i) squares += weights[i] * residuals[i] * residuals[i];
  std::vector<Lean> leans;
  for (const PointOfDrive& place : places) leans.push_back(lean_of(place, solution));
  const Eigen::Matrix2d covariance =
      common_covariance_of(leans, places, solution, squares / (count - unknowns) * lasting_factor(residuals, unknowns));
  // Heights that say less of the lean than what roads are like are left alone.
  if (!(covariance(1, 1) < kCrossfall_rad * kCrossfall_rad)) return tilt;
  tilt.known = true;
  for (std::size_t i = 0; i < leans.size(); ++i) tilt.up_in_vehicle[i] = leans[i].up;
  for (const Own& own : solution.own)
    tilt.level_from_window_start.push_back(shortest_rotation(Vector3d(own[1], own[2], 1.0), Vector3d::UnitZ()));
  tilt.rate_bias_radps = solution.common.head<2>();
  tilt.common_covariance = covariance;
  return tilt;
}

}  // namespace remount
