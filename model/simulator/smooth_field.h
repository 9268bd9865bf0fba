// A random function of the direction that changes slowly: what mirrors and prisms do to where a beam looks.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"

namespace remount::simulator {

/// Values at two directions are alike as exp(-d^2 / (2 l^2)) says, d the distance of the unit vectors and l 0.21 (12
/// degrees); everywhere of mean 0 and of one sigma over the seeds. From random waves (Rahimi and Recht 2007).
class SmoothField {
 public:
  /// Zero everywhere.
  SmoothField() = default;
  SmoothField(int seed, std::uint64_t stream, double sigma);

  /// @param direction of unit length
  double at(const Eigen::Vector3d& direction) const;
  bool zero() const { return waves_.empty(); }

 private:
  struct Wave {
    Eigen::Vector3d along;
    double phase_rad = 0.0;
  };
  double amplitude_ = 0.0;
  std::vector<Wave> waves_;
};

/// Where beams look beside where they are believed to look, over where that is.
class PointingField {
 public:
  /// Straight.
  PointingField() = default;
  PointingField(int seed, std::uint64_t stream, double sigma_rad);

  /// Takes out what turns all of these directions together: the axes of a LiDAR are those of its points.
  void take_out_turn(const std::vector<Eigen::Vector3d>& directions);

  /// Of a beam that is believed to look along this: the way to where it looks, m at 1 m, across it.
  Eigen::Vector3d aside(const Eigen::Vector3d& direction) const;
  bool zero() const { return aside_rad_.zero() && up_rad_.zero(); }

 private:
  SmoothField aside_rad_, up_rad_;
  Eigen::Vector3d turn_rad_ = Eigen::Vector3d::Zero();
};

}  // namespace remount::simulator
