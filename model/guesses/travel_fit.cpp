#include "model/guesses/travel_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>

#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "model/conventions/travel_steps.h"

namespace remount::guesses {
namespace {

using conventions::TravelStep;

constexpr double kSigmaOfMedian = 1.4826;

/// Mean angle of the doubled ones: forwards and in reverse are one.
double axis_rad(const std::vector<double>& angles_rad) {
  std::complex<double> doubled = 0.0, single = 0.0;
  for (const double angle_rad : angles_rad)
    doubled += std::polar(1.0, 2.0 * angle_rad), single += std::polar(1.0, angle_rad);
  const double axis = 0.5 * std::arg(doubled);
  return std::cos(std::arg(single) - axis) < 0.0 ? wrap_angle_rad(axis + kPi) : axis;
}

double off_axis_rad(double angle_rad, double axis_rad) { return 0.5 * wrap_angle_rad(2.0 * (angle_rad - axis_rad)); }

/// The angles seen from their axis, robustly, without what a lever arm from the axle that does not slip adds in turns:
/// off = constant + lever * curvature. Leaves `offset_rad` and `residual_rad`.
void fit_angles(const std::vector<TravelStep>& steps, const std::vector<double>& angles_rad, TravelFit& fit) {
  constexpr int kRounds = 8;
  constexpr double kFinest_rad = 1e-5, kLever_m = 3.0;
  const double axis = axis_rad(angles_rad);
  std::vector<double> off, curvature, weight(angles_rad.size(), 1.0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool reversed = std::cos(angles_rad[i] - axis) < 0.0;
    off.push_back(off_axis_rad(angles_rad[i], axis));
    curvature.push_back((reversed ? -1.0 : 1.0) * steps[i].turn_rate_radps / steps[i].speed_mps);
  }
  double constant = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d side = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < off.size(); ++i) {
      const Eigen::Vector2d row(1.0, curvature[i]);
      normal += weight[i] * row * row.transpose();
      side += weight[i] * row * off[i];
    }
    normal(1, 1) += 0.01 / (kLever_m * kLever_m);  // in straight travel the lever arm shows in nothing
    const Eigen::Vector2d model = normal.ldlt().solve(side);
    std::vector<double> sizes;
    for (std::size_t i = 0; i < off.size(); ++i) sizes.push_back(std::abs(off[i] - model[0] - model[1] * curvature[i]));
    fit.residual_rad = std::max(kFinest_rad, kSigmaOfMedian * median_of(sizes));
    for (std::size_t i = 0; i < off.size(); ++i)
      weight[i] = 1.0 / (1.0 + std::pow(sizes[i] / (2.0 * fit.residual_rad), 2));
    constant = model[0];
  }
  fit.offset_rad = wrap_angle_rad(axis + constant);
}

/// Between the 5th and 95th percentile of the directions, seen from their mean.
double range_of(const std::vector<double>& courses_rad) {
  const double middle = axis_rad(courses_rad);
  std::vector<double> off;
  for (const double course_rad : courses_rad) off.push_back(off_axis_rad(course_rad, middle));
  std::ranges::sort(off);
  return off[off.size() * 19 / 20] - off[off.size() / 20];
}

double mean_square(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  const double count = static_cast<double>(values.size());
  for (const double value : values) sum += value, squares += value * value;
  return std::max(0.0, squares / count - sum * sum / (count * count));
}

void judge_slope(const std::vector<TravelStep>& steps, TravelFit& fit) {
  constexpr double kLeastSlope_rad = 0.7 * kPi / 180.0, kFollows = 0.35;
  const Eigen::Vector3d ahead(std::cos(fit.offset_rad), std::sin(fit.offset_rad), 0.0);
  std::vector<double> slopes, with, against;
  for (const TravelStep& step : steps) {
    const Eigen::Vector3d nose = step.world_from_ins * ahead;
    const double level = step.direction.head<2>().norm();
    if (level < 0.5) continue;
    const double along = nose.head<2>().dot(step.direction.head<2>()) > 0.0 ? 1.0 : -1.0;  // in reverse the nose lowers
    const double slope_rad = std::atan2(step.direction.z(), level),
                 nose_rad = along * std::asin(std::clamp(nose.z(), -1.0, 1.0));
    slopes.push_back(slope_rad);
    with.push_back(slope_rad - nose_rad);
    against.push_back(slope_rad + nose_rad);
  }
  if (slopes.size() < kFewestTravelSteps) return;
  const double all = mean_square(slopes);
  fit.slope_sigma_rad = std::sqrt(all);
  if (fit.slope_sigma_rad < kLeastSlope_rad) return;
  const bool agrees = mean_square(with) < kFollows * all, opposite = mean_square(against) < kFollows * all;
  fit.slope = agrees ? SlopeFit::Agrees : opposite ? SlopeFit::Opposite : SlopeFit::Unrelated;
}

}  // namespace

TravelFit travel_fit(const std::vector<motion::StampedPose>& world_from_ins) {
  TravelFit fit;
  const std::vector<TravelStep> steps = conventions::travel_steps(world_from_ins);
  fit.steps = steps.size();
  if (steps.size() < kFewestTravelSteps) return fit;
  std::vector<double> angles_rad, courses_rad;
  for (const TravelStep& step : steps) {
    const Eigen::Vector3d ahead = step.world_from_ins.transpose() * step.direction;
    angles_rad.push_back(std::atan2(ahead.y(), ahead.x()));
    courses_rad.push_back(std::atan2(step.direction.y(), step.direction.x()));
    fit.upright += step.world_from_ins(2, 2) / static_cast<double>(steps.size());
  }
  fit_angles(steps, angles_rad, fit);
  fit.turned_rad = range_of(courses_rad);
  judge_slope(steps, fit);
  return fit;
}

}  // namespace remount::guesses
