// The normal equations of all sessions together.
#pragma once

#include "algorithms/calibration/trajectory/trajectory_chain.h"
#include "algorithms/core/index.h"

namespace remount::calibration {

/// Factors by which the errors of each kind of term turn out larger than stated, or smaller where they are assumed.
inline constexpr double kMostNoiseFactor = 100.0;
struct TrajectoryNoise {
  std::array<double, kTermKinds> factor{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  double of(TermKind kind) const { return factor[index_of(kind)]; }
};

/// Terms of each session with their robust weights, 0..1.
struct WeightedTerms {
  std::vector<std::vector<TrajectoryTerm>> terms;
  std::vector<std::vector<double>> weights;
};

/// What is expected of the shared unknowns: X under `perturb` and the antenna, as seen from `centre`.
struct TrajectoryPrior {
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  Eigen::Vector3d antenna_in_lidar = Eigen::Vector3d::Zero();
  SharedMatrix information = SharedMatrix::Zero();

  SharedVector distance(const TrajectoryState& state) const {
    SharedVector out;
    out << difference(ins_from_lidar, state.ins_from_lidar), state.antenna_in_lidar - antenna_in_lidar;
    return out;
  }
};

/// Right-hand sides of the equations of all sessions, zero for each epoch. The caller sets what it solves for.
std::vector<ChainVector> zero_sides(const TrajectoryProblem& problem);

class TrajectoryEquations {
 public:
  TrajectoryEquations(const TrajectoryProblem& problem, const TrajectoryOptions& options, const WeightedTerms& weighted,
                      const TrajectoryNoise& noise, const SharedMatrix& prior_information);

  bool solvable() const { return solvable_; }
  /// What session s says of the shared unknowns, its own unknowns and its poses eliminated.
  const SharedMatrix& information(std::size_t session) const { return information_[session]; }
  /// Of all sessions together, without the prior.
  SharedMatrix information() const;
  /// Steps of every session for right-hand sides, which are used up; `shared` joins their borders.
  std::vector<ChainVector> solve(std::vector<ChainVector> sides, const SharedVector& shared) const;
  /// How each pose, and each session's own unknowns, follow the shared ones.
  struct Sensitivity {
    std::vector<Eigen::Matrix<double, 6, kSharedSize>> poses;
    Eigen::Matrix<double, kOwnSize, kSharedSize> own;
  };
  Sensitivity sensitivity(std::size_t session) const;
  /// Information of the prior on a session's own unknowns, in the order of BorderPoint::own.
  const OwnVector& own_prior() const { return own_prior_; }

 private:
  using OwnMatrix = Eigen::Matrix<double, kOwnSize, kOwnSize>;
  using OwnLink = Eigen::Matrix<double, kOwnSize, kSharedSize>;
  std::vector<TrajectoryChain> chains_;
  std::vector<SharedMatrix> information_;
  std::vector<OwnMatrix> own_inverse_;
  std::vector<OwnLink> own_link_;
  Eigen::LLT<SharedMatrix> shared_;
  OwnVector own_prior_ = OwnVector::Zero();
  bool solvable_ = true;
};

}  // namespace remount::calibration
