#include "model/assumed_tilt.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount {

double assumed_tilt_sigma_rad(const std::vector<InsSample>& ins) {
  // What measures a tilt knows it far better than this, and never finds it level throughout to all digits.
  constexpr double kLeastGuess_rad = kPi / 180.0, kLevel = 1e-9;
  double largest = 0.0;
  for (const InsSample& sample : ins) {
    const double sigma = std::max(sample.sigma.attitude_rad.x(), sample.sigma.attitude_rad.y());
    const Eigen::Vector3d up = sample.enu_from_ins * Eigen::Vector3d::UnitZ();
    if (!(sigma >= kLeastGuess_rad) || up.head<2>().norm() > kLevel) return 0.0;
    largest = std::max(largest, sigma);
  }
  return largest;
}

}  // namespace remount
