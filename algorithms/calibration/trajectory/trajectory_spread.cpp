#include "algorithms/calibration/trajectory/trajectory_spread.h"

#include <Eigen/LU>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::calibration {
namespace {

// The gradients of the cost by the shared unknowns, poses and own unknowns following: one for each term.
// docs/maths/trajectory.md (T13)
template <class Use>
void for_each_pull(const TrajectoryProblem& problem, const TrajectorySolution& solution, const WeightedTerms& weighted,
                   const TrajectoryEquations& equations, Use&& use) {
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    const TrajectoryEquations::Sensitivity follow = equations.sensitivity(s);
    for (std::size_t k = 0; k < weighted.terms[s].size(); ++k) {
      const TrajectoryTerm& term = weighted.terms[s][k];
      Eigen::Matrix<double, 3, kSharedSize> by_shared = term.by_border.leftCols<kSharedSize>();
      by_shared += term.by_pose * follow.poses[term.epoch] + term.by_border.rightCols<kOwnSize>() * follow.own;
      if (term.is_step()) by_shared += term.by_before * follow.poses[term.epoch - 1];
      const double factor = solution.noise.of(term.kind);
      use(s, problem.sessions[s].epochs[term.epoch].time_s,
          SharedVector(weighted.weights[s][k] / (factor * factor) * by_shared.transpose() * term.residual));
    }
  }
}

SharedMatrix positive_part(const SharedMatrix& matrix) {
  const auto eigen = symmetric_eigen(Eigen::MatrixXd(0.5 * (matrix + matrix.transpose())));
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

BlockPulls block_pulls(const TrajectoryProblem& problem, const TrajectorySolution& solution,
                       const WeightedTerms& weighted, const TrajectoryEquations& equations, double block_s) {
  BlockPulls blocks;
  for_each_pull(problem, solution, weighted, equations,
                [&](std::size_t session, double time_s, const SharedVector& pull) {
                  const auto [at, first] = blocks.try_emplace({session, block_of(time_s, block_s)}, pull);
                  if (!first) at->second += pull;
                });
  return blocks;
}

SharedMatrix spurious_trajectory_information(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                             const TrajectorySolution& solution, const WeightedTerms& weighted,
                                             const TrajectoryEquations& equations,
                                             const SharedMatrix& prior_information) {
  constexpr std::uint64_t kSamples = 2, kFirstSeed = 100;
  SharedMatrix sum = SharedMatrix::Zero();
  for (std::uint64_t sample = 0; sample < kSamples; ++sample) {
    const ErrorSample errors = sample_errors(weighted, solution.noise, equations, problem, kFirstSeed + sample);
    TrajectoryState shaken = solution.state;
    for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
      std::vector<RigidTransform>& poses = shaken.enu_from_lidar[s];
      for (std::size_t i = 0; i < poses.size(); ++i) poses[i].linear() *= so3_exp(errors.steps[s].poses[i].tail<3>());
      for (std::size_t k = 0; k < weighted.terms[s].size(); ++k)
        if (weighted.terms[s][k].kind == TermKind::InsAttitude)
          poses[weighted.terms[s][k].epoch].linear() *=
              so3_exp(problem.sessions[s].doubtful_attitude_rad * errors.errors[s][k]);
    }
    WeightedTerms again;
    again.weights = weighted.weights;
    for (std::size_t s = 0; s < problem.sessions.size(); ++s)
      again.terms.push_back(trajectory_terms(problem.sessions[s], s, shaken));
    const TrajectoryEquations apart(problem, options, again, solution.noise, prior_information);
    if (apart.solvable()) sum += (apart.information() - equations.information()) / static_cast<double>(kSamples);
  }
  for (const TrajectorySession& session : problem.sessions) sum += session.past.spurious;
  return positive_part(sum);
}

SharedMatrix scatter_of_blocks(const TrajectoryProblem& problem, const TrajectorySolution& solution,
                               const WeightedTerms& weighted, const TrajectoryEquations& equations,
                               const SharedMatrix& prior_information, double block_s) {
  const BlockPulls blocks = block_pulls(problem, solution, weighted, equations, block_s);
  SharedMatrix scatter = SharedMatrix::Zero();
  double count = 0.0;
  for (const auto& [block, pull] : blocks) scatter += pull * pull.transpose(), count += 1.0;
  for (const TrajectorySession& session : problem.sessions)
    scatter += session.past.scatter, count += session.past.blocks;
  if (count < 2.0) return SharedMatrix::Zero();
  const SharedMatrix covariance = (equations.information() + prior_information).inverse();
  return count / (count - 1.0) * covariance * scatter * covariance;
}

std::vector<SessionAnswer> trajectory_session_answers(const TrajectoryProblem& problem,
                                                      const TrajectorySolution& solution, const WeightedTerms& weighted,
                                                      const TrajectoryEquations& equations,
                                                      const SharedMatrix& prior_information) {
  std::vector<SessionAnswer> answers;
  if (problem.sessions.size() < 2) return answers;
  std::vector<SharedVector> pulls(problem.sessions.size(), SharedVector::Zero());
  for_each_pull(problem, solution, weighted, equations,
                [&](std::size_t session, double, const SharedVector& pull) { pulls[session] += pull; });
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    const Matrix6d information = information_of_x(equations.information(s), prior_information);
    const SharedMatrix kept = equations.information(s) + 1e-3 * prior_information;
    const SharedVector away = -kept.ldlt().solve(pulls[s]);
    const Matrix6d with_unseen = inverse_by_lu(Matrix6d::Identity() + information * problem.sessions[s].unseen);
    Matrix6d left = with_unseen * information;
    left = (0.5 * (left + left.transpose())).eval();
    answers.push_back({left, away.head<6>()});
  }
  return answers;
}

Matrix6d information_of_x(const SharedMatrix& information, const SharedMatrix& prior_information) {
  const Eigen::Matrix3d antenna = information.bottomRightCorner<3, 3>() + prior_information.bottomRightCorner<3, 3>();
  const Eigen::Matrix<double, 6, 3> link = information.topRightCorner<6, 3>();
  return information.topLeftCorner<6, 6>() - link * antenna.inverse() * link.transpose();
}

Eigen::Matrix3d information_of_antenna(const SharedMatrix& information, const SharedMatrix& prior_information) {
  const Matrix6d x = information.topLeftCorner<6, 6>() + prior_information.topLeftCorner<6, 6>();
  const Eigen::Matrix<double, 6, 3> link = information.topRightCorner<6, 3>();
  return information.bottomRightCorner<3, 3>() - link.transpose() * inverse_by_lu(x) * link;
}

}  // namespace remount::calibration
