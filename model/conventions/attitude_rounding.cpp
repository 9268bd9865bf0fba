#include "model/conventions/attitude_rounding.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount::conventions {
namespace {

constexpr double kLeastStep_rad = 5e-3 * kPi / 180.0;  ///< finer ones are less than any attitude is known to
constexpr double kSame_rad = 1e-7;                     ///< digits that are lost on the way
constexpr std::size_t kFewestChanges = 10;

using Angles = std::array<std::vector<double>, 3>;

Angles angles_of(const std::vector<motion::InsSample>& ins) {
  Angles angles;
  for (const motion::InsSample& sample : ins) {
    const YawPitchRoll of_sample = yaw_pitch_roll_from_rotation(sample.enu_from_ins.toRotationMatrix());
    angles[0].push_back(of_sample.yaw_rad);
    angles[1].push_back(of_sample.pitch_rad);
    angles[2].push_back(of_sample.roll_rad);
  }
  return angles;
}

/// The least change of which all are multiples; 0 where there is none.
double step_rad(const std::vector<double>& angles_rad) {
  std::vector<double> changes_rad;
  for (std::size_t i = 1; i < angles_rad.size(); ++i) {
    const double change = std::abs(wrap_angle_rad(angles_rad[i] - angles_rad[i - 1]));
    if (change > kSame_rad) changes_rad.push_back(change);
  }
  if (changes_rad.size() < kFewestChanges) return 0.0;
  const double step = *std::min_element(changes_rad.begin(), changes_rad.end());
  if (step < kLeastStep_rad) return 0.0;
  const bool all = std::all_of(changes_rad.begin(), changes_rad.end(), [&](double change) {
    return std::abs(change - step * std::round(change / step)) < 20.0 * kSame_rad;
  });
  return all ? step : 0.0;
}

/// Share of a rounding error that is the same throughout, for an angle that scatters by so much. Rounding of what
/// scatters by half a step averages out (Widrow and Kollar 2008, (4.10): the characteristic function of the angle).
double lasting_share(const std::vector<double>& angles_rad, double step) {
  double sum = 0.0, squares = 0.0;
  for (const double angle : angles_rad) {
    const double away = wrap_angle_rad(angle - angles_rad.front());
    sum += away, squares += away * away;
  }
  const auto count = static_cast<double>(angles_rad.size());
  const double scatter2 = std::max(0.0, squares / count - sum * sum / (count * count));
  return std::exp(-2.0 * kPi * kPi * scatter2 / (step * step));
}

}  // namespace

AttitudeRounding attitude_rounding(const std::vector<motion::InsSample>& ins) {
  AttitudeRounding out;
  if (ins.size() < kFewestChanges) return out;
  const Angles angles = angles_of(ins);
  for (const std::vector<double>& one : angles) out.step_rad = std::max(out.step_rad, step_rad(one));
  if (out.step_rad == 0.0) return out;
  out.sigma_rad = out.step_rad / std::sqrt(12.0);
  for (const std::vector<double>& one : angles)
    out.lasting_rad = std::max(out.lasting_rad, out.sigma_rad * lasting_share(one, out.step_rad));
  return out;
}

}  // namespace remount::conventions
