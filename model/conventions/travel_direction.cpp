#include "model/conventions/travel_direction.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "model/conventions/travel_steps.h"

namespace remount::conventions {
namespace {

constexpr std::size_t kFewestSteps = 20;  // half a second each

/// Of one stretch, from the axis along which most of the way leads.
struct Slip {
  double sideways = 0.0;   ///< tangent of the angle from the axis
  double curvature = 0.0;  ///< of the path along the axis, 1/m: negative in reverse as the lever arm has it
};

/// Angles of the stretches about z of the INS; nothing where z is not upright.
std::optional<std::vector<double>> travel_angles_rad(const std::vector<TravelStep>& steps) {
  constexpr double kUpright = 0.9;
  std::vector<double> angles_rad;
  Eigen::Vector3d up_in_ins = Eigen::Vector3d::Zero();
  for (const TravelStep& step : steps) {
    const Eigen::Vector3d ahead = step.world_from_ins.transpose() * step.direction;
    angles_rad.push_back(std::atan2(ahead.y(), ahead.x()));
    up_in_ins += step.world_from_ins.row(2).transpose() / static_cast<double>(steps.size());
  }
  if (std::abs(up_in_ins.z()) < kUpright) return std::nullopt;
  return angles_rad;
}

/// The axis that most of the way keeps to, and its end to which more of the way leads. Nothing where there is none.
std::optional<double> main_direction_rad(const std::vector<TravelStep>& steps, const std::vector<double>& angles_rad) {
  constexpr double kKeepsTo = 0.9;  // mean of the doubled angles' cosine: within some 12 degrees
  std::complex<double> doubled = 0.0, single = 0.0;
  double way = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    doubled += std::polar(steps[i].speed_mps, 2.0 * angles_rad[i]);
    single += std::polar(steps[i].speed_mps, angles_rad[i]);
    way += steps[i].speed_mps;
  }
  if (std::abs(doubled) < kKeepsTo * way) return std::nullopt;
  const double axis_rad = 0.5 * std::arg(doubled);
  return std::cos(std::arg(single) - axis_rad) < 0.0 ? wrap_angle_rad(axis_rad + kPi) : axis_rad;
}

std::vector<Slip> slips(const std::vector<TravelStep>& steps, const std::vector<double>& angles_rad, double main_rad) {
  constexpr double kLargest_rad = 0.5;
  std::vector<Slip> out;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    double from_axis_rad = wrap_angle_rad(angles_rad[i] - main_rad);
    const bool reversed = std::abs(from_axis_rad) > 0.5 * kPi;
    if (reversed) from_axis_rad = wrap_angle_rad(from_axis_rad - kPi);
    if (std::abs(from_axis_rad) > kLargest_rad) continue;
    out.push_back({std::tan(from_axis_rad), steps[i].turn_rate_radps / (reversed ? -1.0 : 1.0) / steps[i].speed_mps});
  }
  return out;
}

/// sideways = offset + lever * curvature, robustly (Tukey).
struct SlipFit {
  double offset = 0.0, sigma = 0.0;
};
std::optional<SlipFit> fit_slips(const std::vector<Slip>& slips) {
  constexpr int kRounds = 12;
  constexpr double kTukey = 4.685, kSigmaOfMedian = 1.4826, kFinest = 1e-5;
  constexpr double kLever_m = 3.0;  // a weak prior: where all of the drive is one bend, its middle counts
  if (slips.size() < kFewestSteps) return std::nullopt;
  Eigen::Vector2d model = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> residuals;
    for (const Slip& slip : slips) residuals.push_back(std::abs(slip.sideways - model[0] - model[1] * slip.curvature));
    const double scale = std::max(kFinest, kSigmaOfMedian * median_of(residuals));
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d side = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < slips.size(); ++i) {
      const double ratio = residuals[i] / (kTukey * scale);
      if (ratio >= 1.0) continue;
      const double weight = std::pow(1.0 - ratio * ratio, 2) / (scale * scale);
      const Eigen::Vector2d row(1.0, slips[i].curvature);
      normal += weight * row * row.transpose();
      side += weight * row * slips[i].sideways;
    }
    normal(1, 1) += 1.0 / (kLever_m * kLever_m);
    covariance = normal.inverse();
    model = covariance * side;
  }
  return std::isfinite(model[0]) ? std::optional<SlipFit>({model[0], std::sqrt(covariance(0, 0))}) : std::nullopt;
}

}  // namespace

std::optional<TravelDirection> travel_direction(const MetricPoses& world_from_ins) {
  constexpr double kRoad_rad = 0.1 * kPi / 180.0;
  constexpr double kNoReverse_mps = 6.0;
  constexpr double kTogether = 2.0;  // neighbouring stretches err alike: the root of four
  const std::vector<TravelStep> steps = travel_steps(world_from_ins);
  if (steps.size() < kFewestSteps) return std::nullopt;
  const auto angles_rad = travel_angles_rad(steps);
  const auto main_rad = angles_rad ? main_direction_rad(steps, *angles_rad) : std::nullopt;
  const auto fit = main_rad ? fit_slips(slips(steps, *angles_rad, *main_rad)) : std::nullopt;
  if (!fit) return std::nullopt;
  double fastest_mps = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (std::cos((*angles_rad)[i] - *main_rad) > 0.0) fastest_mps = std::max(fastest_mps, steps[i].speed_mps);
  return TravelDirection{wrap_angle_rad(*main_rad + std::atan(fit->offset)),
                         std::hypot(kTogether * fit->sigma, kRoad_rad), fastest_mps > kNoReverse_mps};
}

}  // namespace remount::conventions
