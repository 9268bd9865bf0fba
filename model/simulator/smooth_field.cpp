#include "model/simulator/smooth_field.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "model/simulator/random_stream.h"

namespace remount::simulator {

SmoothField::SmoothField(int seed, std::uint64_t stream, double sigma) {
  if (sigma == 0.0) return;
  constexpr int kWaves = 64;
  constexpr double kAlike = 0.21;
  amplitude_ = sigma * std::sqrt(2.0 / kWaves);
  RandomStream random(static_cast<std::uint64_t>(seed), stream);
  for (int wave = 0; wave < kWaves; ++wave) {
    const Eigen::Vector3d along = random.normal3() / kAlike;
    waves_.push_back({along, random.uniform(0.0, 2.0 * kPi)});
  }
}

double SmoothField::at(const Eigen::Vector3d& direction) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) sum += std::cos(wave.along.dot(direction) + wave.phase_rad);
  return amplitude_ * sum;
}

PointingField::PointingField(int seed, std::uint64_t stream, double sigma_rad)
    : aside_rad_(seed, stream, sigma_rad), up_rad_(seed, stream + 1, sigma_rad) {}

void PointingField::take_out_turn(const std::vector<Eigen::Vector3d>& directions) {
  if (zero()) return;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d side = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& direction : directions) {
    const Eigen::Matrix3d turned = -skew(direction);  // by a turn about each axis
    normal += turned.transpose() * turned;
    side += turned.transpose() * aside(direction);
  }
  turn_rad_ += normal.ldlt().solve(side);
}

Eigen::Vector3d PointingField::aside(const Eigen::Vector3d& direction) const {
  if (zero()) return Eigen::Vector3d::Zero();
  const double flat = std::max(1e-9, direction.head<2>().norm());
  const Eigen::Vector3d left(-direction.y() / flat, direction.x() / flat, 0.0), up = direction.cross(left);
  return aside_rad_.at(direction) * left + up_rad_.at(direction) * up - turn_rad_.cross(direction);
}

}  // namespace remount::simulator
