// Positions between samples.
#pragma once

#include <Eigen/Core>
#include <array>

namespace remount::motion {

/// The samples about a time: the second and the third enclose it, the others are their neighbours.
struct CubicNeighbours {
  std::array<double, 4> times_s{};  ///< ascending
  std::array<Eigen::Vector3d, 4> values;
  bool has_first = true, has_last = true;
};

/// The polynomial through all that there are: a cubic, at the end of the data a parabola, else a straight line. A curve
/// is not cut short, and what is missed is of the fourth order all the way (a Hermite cubic with slopes by differences
/// is so only halfway).
Eigen::Vector3d cubic_between(const CubicNeighbours& samples, double time_s);

}  // namespace remount::motion
