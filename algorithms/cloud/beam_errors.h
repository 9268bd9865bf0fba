// What a LiDAR's own errors do to its points. docs/maths/beams.md (B1) to (B3)
#pragma once

#include <Eigen/Core>

#include "algorithms/cloud/beam_nodes.h"
#include "algorithms/cloud/point_cloud.h"

namespace remount::cloud {

/// To be *added* to what the LiDAR measured, where `nodes` says.
struct BeamErrors {
  BeamNodes nodes;
  Eigen::VectorXd values;  ///< nodes.errors() of them

  BeamErrors() = default;  ///< none
  /// Zero at all of them.
  explicit BeamErrors(const BeamNodes& at) : nodes(at), values(Eigen::VectorXd::Zero(at.errors())) {}
  BeamErrors(BeamNodes at, Eigen::VectorXd errors) : nodes(std::move(at)), values(std::move(errors)) {}

  bool none() const { return values.isZero(0.0); }
  /// The values, or as many zeros where there are none.
  Eigen::VectorXd at(const BeamNodes& asked) const {
    return values.size() == asked.errors() ? values : Eigen::VectorXd::Zero(asked.errors()).eval();
  }
};

/// What is believed of them before a drive tells. Nothing: the LiDAR has none.
struct BeamPrior {
  BeamNodes nodes;
  Eigen::VectorXd mean;           ///< not zero where an earlier drive told them
  Eigen::VectorXd untold_sigmas;  ///< before any drive: by these a beam is told or not
  Eigen::MatrixXd common;         ///< what all beams do together, a column of 1 sigma each
  Eigen::MatrixXd own;            ///< covariance of what each does beside that

  bool empty() const { return common.size() == 0; }
};

/// How a point moves (m) with the elevation (per rad), the range (per m) and the azimuth (per rad across) of its beam.
struct BeamMotion {
  Eigen::Vector3d elevation, range, azimuth;
};
BeamMotion moved_by_beam(const Eigen::Vector3d& point_in_lidar);

/// The points as they would be without these errors, each as it was measured: before motion is compensated.
void mend_beams(const BeamErrors& errors, PointCloud& cloud);

struct BeamMean {
  double error = 0.0, sigma = 0.0;
  bool told = false;  ///< false: no beam is known better than it was believed before
};

/// The errors of a LiDAR after a drive.
struct BeamEstimate {
  BeamNodes nodes;  ///< none: they were no unknowns
  Eigen::VectorXd errors, sigmas;
  BeamMean elevation, range;  ///< rad, m; of the beams that the drive tells, each by its information

  bool empty() const { return nodes.empty(); }
  BeamErrors beam_errors() const { return {nodes, errors}; }
  double range_scale() const { return errors[nodes.range_scale()]; }
  double range_scale_sigma() const { return sigmas[nodes.range_scale()]; }
  /// Whether any stands so far out of what was taken out of the scans already that they are worth another pass.
  bool stands_out_of(const BeamErrors& mended) const;
};

}  // namespace remount::cloud
