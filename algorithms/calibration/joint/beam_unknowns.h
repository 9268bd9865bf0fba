// The errors of a LiDAR's beams as unknowns of the joint solution. docs/maths/beams.md (B5)
#pragma once

#include <vector>

#include "algorithms/cloud/beam_errors.h"
#include "algorithms/motion/pair.h"

namespace remount::calibration {

/// Those combinations of the errors that registrations show at all, each of unit variance before they tell: what is in
/// the scans = mean + basis * unknowns.
struct BeamUnknowns {
  Eigen::VectorXd mean;  ///< of cloud::BeamErrors
  Eigen::MatrixXd basis = Eigen::MatrixXd(0, 0);
  Eigen::Index of_single = 0;  ///< the last so many are of what single beams do
};

/// Of a pair, a column for each of so many errors; zeros for those that its file left out at the end.
Eigen::MatrixXd response_of(const motion::Pair& pair, Eigen::Index errors);

/// @param mended what was taken out of the scans before they were registered
/// @param usable indices of pairs; those with a weight count
/// @param beside information on the errors from elsewhere, for pairs across LiDARs show what those within one do not;
///        empty: there is none
BeamUnknowns choose_beam_unknowns(const cloud::BeamPrior& believed, const cloud::BeamErrors& mended,
                                  const std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                                  const Eigen::MatrixXd& beside = {});

/// The errors of the LiDAR after the drive; what it does not show stays as it was believed.
/// @param solution of the unknowns, and its covariance; empty: they were not solved for
cloud::BeamEstimate estimate_beams(const cloud::BeamPrior& believed, const cloud::BeamErrors& mended,
                                   const BeamUnknowns& unknowns, const Eigen::VectorXd& solution,
                                   const Eigen::MatrixXd& covariance);

}  // namespace remount::calibration
