#include "algorithms/cloud/beam_options.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"

namespace remount::cloud {
namespace {

// Of single beams as makers and those who measured them say; what all of them share is more, for it is where the
// optics as a whole look (an HDL-64's was found 0.2 degrees off).
BeamOptions numbers_of(const BeamOptions& options, LidarKind kind) {
  if (kind == LidarKind::Own) return options;
  BeamOptions numbers;
  numbers.beam_range_m = kind == LidarKind::Spinning ? 0.015 : 0.02;
  return numbers;
}

// Rings err each for itself; what a mirror or a prism does changes smoothly with the elevation.
bool by_ring(LidarKind kind) { return kind != LidarKind::SolidState; }
bool smooth(LidarKind kind) { return kind == LidarKind::SolidState || kind == LidarKind::Unknown; }

Eigen::Vector3d direction_of(const BeamNodes& nodes, Eigen::Index node) {
  return direction_at(nodes.by_azimuth() ? nodes.azimuth_rad(node) : 0.0, nodes.elevation_rad(node));
}

// How alike two nodes err that are so far apart, rad. Over a field that is looked at by one mirror some of it is alike
// far across.
double likeness(LidarKind kind, bool by_azimuth, double apart_rad) {
  const auto within = [&](double size_rad) { return std::exp(-0.5 * apart_rad * apart_rad / (size_rad * size_rad)); };
  constexpr double kAlike_rad = 0.14, kFar_rad = 0.42;
  double alike = apart_rad == 0.0 && by_ring(kind) ? 1.0 : 0.0;
  if (smooth(kind)) alike += by_azimuth ? 0.5 * (within(kAlike_rad) + within(kFar_rad)) : within(kAlike_rad);
  return alike;
}

// Each node for itself or like its neighbours.
void believe_own(LidarKind kind, double sigma, Eigen::Index first, BeamPrior& prior) {
  const BeamNodes& nodes = prior.nodes;
  for (Eigen::Index i = 0; i < nodes.count(); ++i)
    for (Eigen::Index j = 0; j < nodes.count(); ++j) {
      const double chord = (direction_of(nodes, i) - direction_of(nodes, j)).norm();
      prior.own(first + i, first + j) =
          sigma * sigma * likeness(kind, nodes.by_azimuth(), 2.0 * std::asin(std::min(1.0, 0.5 * chord)));
    }
}

// What turns all points of a field alike is where the LiDAR's axes are, and part of X: no error of its beams.
void leave_turns_out(BeamPrior& prior) {
  const BeamNodes& nodes = prior.nodes;
  Eigen::MatrixXd turns = Eigen::MatrixXd::Zero(nodes.errors(), 3);
  for (Eigen::Index node = 0; node < nodes.count(); ++node) {
    const Eigen::Vector3d direction = direction_of(nodes, node);
    const BeamMotion moved = moved_by_beam(direction);
    const Eigen::Matrix3d turned = -skew(direction);  // by a turn about each axis
    turns.row(nodes.elevation_at(node)) = moved.elevation.transpose() * turned;
    turns.row(nodes.azimuth_at(node)) = moved.azimuth.transpose() * turned;
  }
  const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(nodes.errors(), nodes.errors()) -
                               turns * (turns.transpose() * turns).ldlt().solve(turns.transpose());
  prior.common = left * prior.common;
  prior.own = left * prior.own * left.transpose();
}

BeamPrior nothing_believed(const BeamNodes& nodes) {
  const Eigen::Index errors = nodes.errors();
  return {nodes, Eigen::VectorXd::Zero(errors), Eigen::VectorXd::Zero(errors), Eigen::MatrixXd::Zero(errors, 3),
          Eigen::MatrixXd::Zero(errors, errors)};
}

Eigen::VectorXd sigmas_of(const BeamPrior& believed) {
  return (believed.common.rowwise().squaredNorm() + believed.own.diagonal()).cwiseMax(0.0).cwiseSqrt();
}

// What all nodes share, and what is left of each sigma. Where none was told, and over a field, nearly all of it is
// shared, as it was before.
void believe_known(const BeamEstimate& known, const BeamMean& mean, const BeamPrior& untold, Eigen::Index first,
                   Eigen::Index column, BeamPrior& believed) {
  const bool as_mean = mean.told && !known.nodes.by_azimuth();
  for (Eigen::Index i = first; i < first + known.nodes.count(); ++i) {
    const double before = untold.untold_sigmas[i], sigma = known.sigmas[i];
    const double shared = before > 0.0 ? untold.common(i, column) / before : 0.0;
    const double common = as_mean ? std::min(mean.sigma, sigma) : shared * sigma;
    believed.common(i, column) = common;
    believed.own(i, i) = sigma * sigma - common * common;
  }
}

}  // namespace

BeamPrior believed_of_beams(const BeamOptions& options, LidarKind declared, const BeamNodes& nodes) {
  const LidarKind kind = options.lidar == LidarKind::Auto ? declared : options.lidar;
  if (kind == LidarKind::Perfect || nodes.empty()) return {};
  const BeamOptions numbers = numbers_of(options, kind);
  BeamPrior believed = nothing_believed(nodes);
  const Eigen::Index count = nodes.count();
  const double beam_rad = degrees_to_radians(numbers.beam_elevation_deg);
  believed.common.col(0)
      .segment(nodes.elevation_at(0), count)
      .setConstant(degrees_to_radians(numbers.common_elevation_deg));
  believed.common.col(1).segment(nodes.range_at(0), count).setConstant(numbers.common_range_m);
  believed.common(nodes.range_scale(), 2) = numbers.range_scale;
  believe_own(kind, beam_rad, nodes.elevation_at(0), believed);
  believe_own(kind, numbers.beam_range_m, nodes.range_at(0), believed);
  if (nodes.by_azimuth()) {
    believe_own(kind, beam_rad, nodes.azimuth_at(0), believed);
    leave_turns_out(believed);
  }
  believed.untold_sigmas = sigmas_of(believed);
  return believed;
}

BeamPrior believed_of_known(const BeamEstimate& known) {
  const BeamNodes& nodes = known.nodes;
  const BeamPrior untold = believed_of_beams({}, LidarKind::Unknown, nodes);
  BeamPrior believed = nothing_believed(nodes);
  believed.mean = known.errors;
  believed.untold_sigmas = untold.untold_sigmas;
  believe_known(known, known.elevation, untold, nodes.elevation_at(0), 0, believed);
  believe_known(known, known.range, untold, nodes.range_at(0), 1, believed);
  believed.common(nodes.range_scale(), 2) = known.range_scale_sigma();
  if (!nodes.by_azimuth()) return believed;
  believe_known(known, known.elevation, untold, nodes.azimuth_at(0), 0, believed);
  leave_turns_out(believed);
  return believed;
}

}  // namespace remount::cloud
