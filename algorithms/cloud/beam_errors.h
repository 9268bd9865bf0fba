// What a LiDAR's own errors do to its points. docs/maths/beams.md (B1) to (B3)
#pragma once

#include <Eigen/Core>

#include "algorithms/cloud/point_cloud.h"

namespace remount::cloud {

/// Elevations over the LiDAR's x-y plane at which its errors are unknowns: every 0.8 degrees, as far as the rings of
/// spinning LiDARs lie apart, to 24 degrees up and down, and at three more beyond. In between errors are linear in the
/// slope z / distance from the z axis, and constant beyond the last.
inline constexpr Eigen::Index kBeamNodes = 67;
double beam_node_rad(Eigen::Index node);
inline constexpr Eigen::Index kBeamErrors = 2 * kBeamNodes + 1;

/// To be *added* to what the LiDAR measured: of the elevation at each node (rad, up), of the range at each node (m),
/// and of the range over itself.
using BeamErrors = Eigen::Matrix<double, kBeamErrors, 1>;
/// What is believed of them before a drive tells. Nothing: the LiDAR has none.
struct BeamPrior {
  Eigen::MatrixXd common;  ///< what all beams do together, a column of 1 sigma each
  Eigen::MatrixXd own;     ///< covariance of what each does beside that

  bool empty() const { return common.size() == 0; }
};

inline constexpr Eigen::Index elevation_at(Eigen::Index node) { return node; }
inline constexpr Eigen::Index range_at(Eigen::Index node) { return kBeamNodes + node; }
inline constexpr Eigen::Index kRangeScale = 2 * kBeamNodes;

/// Between which two nodes a point of the LiDAR lies, and the share of the upper one.
struct BeamPlace {
  Eigen::Index lower = 0;  ///< the upper is the next one
  double share = 0.0;
};
BeamPlace place_of_beam(const Eigen::Vector3d& point_in_lidar);

/// How a point moves (m) with the elevation (per rad) and with the range (per m) of its beam.
struct BeamMotion {
  Eigen::Vector3d elevation, range;
};
BeamMotion moved_by_beam(const Eigen::Vector3d& point_in_lidar);

/// The points as they would be without these errors, each as it was measured: before motion is compensated.
void mend_beams(const BeamErrors& errors, PointCloud& cloud);

struct BeamMean {
  double error = 0.0, sigma = 0.0;
  bool told = false;  ///< false: no beam is known better than it was believed before
};

/// The errors of a LiDAR after a drive; zero without a sigma where they were not unknowns.
struct BeamEstimate {
  BeamErrors errors = BeamErrors::Zero(), sigmas = BeamErrors::Zero();
  BeamMean elevation, range;  ///< rad, m; of the beams that the drive tells, each by its information

  bool empty() const { return sigmas.isZero(0.0); }
  /// Whether any stands so far out of what was taken out of the scans already that they are worth another pass.
  bool stands_out_of(const BeamErrors& mended) const;
};

}  // namespace remount::cloud
