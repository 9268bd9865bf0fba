#include "algorithms/calibration/pairwise/session_agreement.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/robust_start.h"
#include "algorithms/calibration/pairwise/uncertainty.h"
#include "algorithms/core/symmetric_eigen.h"

namespace remount::calibration {
namespace {

// Columns d such that d' e has unit variance for an error e of X: the directions whose sigma is below half the limit of
// what counts as observed.
Eigen::MatrixXd well_determined_directions(const Matrix6d& information, const SolveOptions& options) {
  constexpr double kLeast = 4.0;
  const Vector6d limits = observation_limits(options);
  const Matrix6d scaled = limits.asDiagonal() * information * limits.asDiagonal();
  const auto eigen = symmetric_eigen(Matrix6d(0.5 * (scaled + scaled.transpose())));
  const auto count = (eigen.eigenvalues().array() >= kLeast).count();
  Eigen::MatrixXd columns = limits.cwiseInverse().asDiagonal() * eigen.eigenvectors().rightCols(count);
  for (Eigen::Index i = 0; i < count; ++i) columns.col(i) *= std::sqrt(eigen.eigenvalues()[6 - count + i]);
  return columns;
}

// What is left of information where a drive moves X on its own; also where the information is singular.
Matrix6d with_limits(const Matrix6d& information, bool narrow_field) {
  const Matrix6d limited = Matrix6d::Identity() + information * registration_limits(narrow_field);
  const Matrix6d left = limited.partialPivLu().solve(information);
  return 0.5 * (left + left.transpose());
}

struct Common {
  Matrix6d information = Matrix6d::Zero();
  Vector6d from_common = Vector6d::Zero();
};

Common combine(const std::vector<SessionAnswer>& answers, std::optional<motion::SessionIndex> without) {
  Common common;
  Vector6d side = Vector6d::Zero();
  for (motion::SessionIndex s; s < answers.size(); ++s) {
    if (s == without) continue;
    common.information += answers[s].information;
    side += answers[s].information * answers[s].from_common;
  }
  // What no session determines stays where it is.
  common.from_common = symmetric_solution(common.information + weak_prior(true), side);
  return common;
}

}  // namespace

std::vector<SessionAnswer> session_answers(const JointProblem& problem, const PairwiseDetails& details,
                                           const Progress& progress) {
  constexpr int kIterations = 8;
  const RigidTransform& x = details.joint.ins_from_lidar;
  const std::size_t sessions = problem.session_attitude_bias_sigma_rad.size();
  std::vector<SessionAnswer> answers;
  for (motion::SessionIndex s; sessions > 1 && s < sessions && !progress.cancelled(); ++s) {
    JointProblem alone = problem;
    std::erase_if(alone.terms, [&](const JointTerm& term) { return problem.nodes[term.node_a].session != s; });
    alone.lidar().prior_ins_from_lidar = x;
    alone.lidar().measured = {};  // what all sessions are given is no agreement
    const JointSolution own = solve_joint(alone, details.noise, x, kIterations, progress);
    // A session that cannot be solved on its own says nothing.
    answers.push_back(own.converged ? SessionAnswer{with_limits(own.information, problem.lidar().narrow_field),
                                                    difference(x, own.ins_from_lidar)}
                                    : SessionAnswer{});
  }
  return answers;
}

SessionScatter session_scatter(const std::vector<SessionAnswer>& answers, const SolveOptions& options,
                               std::optional<motion::SessionIndex> without) {
  const Common common = combine(answers, without);
  double chi2 = 0.0;
  auto freedom = -static_cast<int>(well_determined_directions(common.information, options).cols());
  for (motion::SessionIndex s; s < answers.size(); ++s) {
    if (s == without) continue;
    const Eigen::MatrixXd directions = well_determined_directions(answers[s].information, options);
    chi2 += (directions.transpose() * (answers[s].from_common - common.from_common)).squaredNorm();
    freedom += static_cast<int>(directions.cols());
  }
  if (freedom <= 0 || !std::isfinite(chi2)) return {};
  return {std::sqrt(chi2 / freedom), freedom};
}

double widening(const SessionScatter& scatter, double log_spread) {
  if (!(scatter.ratio > 1.0)) return 1.0;
  // A variance estimated from n squares has a relative error of sqrt(2 / n), its root half of that.
  // docs/maths/covariance.md (C14)
  const double believed = 0.5 / (log_spread * log_spread), freedom = scatter.freedom;
  return std::sqrt((freedom * scatter.ratio * scatter.ratio + believed) / (freedom + believed));
}

std::optional<OutlierSession> outlier_session(const std::vector<SessionAnswer>& answers, const SolveOptions& options) {
  constexpr std::size_t kFewest = 3;
  constexpr double kContradict = 4.0, kAgree = 1.5;
  if (answers.size() < kFewest) return std::nullopt;
  const double all = session_scatter(answers, options).ratio;
  if (!(all > kContradict)) return std::nullopt;
  std::optional<OutlierSession> found;
  for (motion::SessionIndex s; s < answers.size(); ++s) {
    if (!(session_scatter(answers, options, s).ratio < kAgree)) continue;
    if (found) return std::nullopt;
    found = OutlierSession{s, all, combine(answers, s).from_common};
  }
  return found;
}

SessionVerdicts judge_sessions(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                               const std::vector<motion::PairIndex>& usable, const NoiseModel& expected,
                               const Progress& progress) {
  constexpr std::size_t kFewest = 5;
  constexpr double kHardlyAny = 0.1;
  // Against the expected noise: pairs of one mounting fit each other about as well as the noise says.
  constexpr double kCoherentScale = 5.0;
  std::vector<std::vector<motion::PairIndex>> of_session(input.sessions.size());
  std::vector<std::size_t> accepted(input.sessions.size(), 0);
  for (const motion::PairIndex i : usable) {
    const motion::Pair& pair = pairs[i];
    const motion::SessionIndex session = input.nodes[pair.keyframe_a].session;
    of_session[session].push_back(i);
    accepted[session] += pair.state == motion::PairState::Accepted ? 1 : 0;
  }
  const PairTilts tilts_rad = assumed_tilts_rad(input, pairs);
  SessionVerdicts out;
  for (motion::SessionIndex s; s < of_session.size() && of_session.size() > 1; ++s) {
    const std::size_t count = of_session[s].size();
    const bool hardly_any = static_cast<double>(accepted[s]) <= kHardlyAny * static_cast<double>(count);
    if (!hardly_any && accepted[s] >= kFewest) ++out.kept;
    if (!hardly_any || count < kFewest) continue;
    const RobustStart own =
        robust_start(pairs, of_session[s], expected, std::nullopt, {}, Eigen::Vector3d::Zero(), progress, tilts_rad);
    out.rejected.push_back({s, own.noise_scale < kCoherentScale});
  }
  return out;
}

}  // namespace remount::calibration
