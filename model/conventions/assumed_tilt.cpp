#include "model/conventions/assumed_tilt.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount::conventions {

void assume_roll(Eigen::Vector3d& sigma_rad) {
  sigma_rad.x() = kAssumedTilt_rad;
  for (double& sigma : sigma_rad.tail<2>())
    if (std::isnan(sigma)) sigma = kAntennaHeading_rad;
}

double assumed_tilt_sigma_rad(const std::vector<motion::InsSample>& ins) {
  // What measures a roll knows it far better than this, and never finds it level throughout: not even to what
  // interpolation makes of two levels with another pitch. Two antennas measure pitch, and leave roll open.
  constexpr double kLeastGuess_rad = kPi / 180.0, kLevel = 2e-3;
  double largest = 0.0;
  for (const motion::InsSample& sample : ins) {
    const double sigma = std::max(sample.sigma.attitude_rad.x(), sample.sigma.attitude_rad.y());
    const double roll = (sample.enu_from_ins * Eigen::Vector3d::UnitY()).z();
    if (!(sigma >= kLeastGuess_rad) || std::abs(roll) > kLevel) return 0.0;
    largest = std::max(largest, sigma);
  }
  return largest;
}

double assumed_tilt_sigma_rad(const drive::Session& session) {
  return session.ins.empty() ? session.ins_tilt_sigma_rad : assumed_tilt_sigma_rad(session.ins);
}

}  // namespace remount::conventions
