#include "algorithms/motion/cubic_between.h"

namespace remount::motion {

Eigen::Vector3d cubic_between(const CubicNeighbours& samples, double time_s) {
  const std::size_t first = samples.has_first ? 0 : 1, end = samples.has_last ? 4 : 3;
  // Steps from one of the samples keep the digits of coordinates that are large.
  const Eigen::Vector3d origin = samples.values[1];
  Eigen::Vector3d value = origin;
  for (std::size_t i = first; i < end; ++i) {
    double weight = 1.0;
    for (std::size_t j = first; j < end; ++j)
      if (j != i) weight *= (time_s - samples.times_s[j]) / (samples.times_s[i] - samples.times_s[j]);
    value += weight * (samples.values[i] - origin);
  }
  return value;
}

}  // namespace remount::motion
