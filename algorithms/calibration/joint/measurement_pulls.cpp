#include "algorithms/calibration/joint/measurement_pulls.h"

#include <Eigen/Cholesky>

#include "algorithms/calibration/linear_solutions.h"

namespace remount::calibration {

MeasurementPulls::MeasurementPulls(const JointProblem& problem, const NoiseModel& noise, const JointSolution& solution,
                                   const Progress& progress)
    : problem_(problem),
      noise_(noise),
      layout_(layout_of(problem, noise)),
      state_(start_state(problem, layout_, {solution.ins_from_lidar})) {
  constexpr int kIterations = 8;
  // To where it can be, see settles_where_observed.
  solve_by_gauss_newton(problem_, noise_, layout_, kIterations, progress, state_, step_);
  step_.valid = step_.valid && !progress.cancelled();
  if (!step_.valid) return;
  terms_ = linearise(problem_, state_, layout_);
  equations_ = build(problem_, terms_, noise_, state_, layout_);
  eliminate(equations_, step_);
}

std::vector<MeasurementPull> MeasurementPulls::of_mounting() const { return of_unknowns({0, 1, 2, 3, 4, 5}, {}); }

std::vector<MeasurementPull> MeasurementPulls::of_times(motion::SessionIndex session) const {
  std::vector<Eigen::Index> unknowns;
  if (layout_.clock) unknowns.push_back(layout_.clock_at(session));
  if (layout_.lag) unknowns.push_back(layout_.lag_at(session));
  return of_unknowns(unknowns, session);
}

std::vector<MeasurementPull> MeasurementPulls::of_unknowns(const std::vector<Eigen::Index>& shared,
                                                           std::optional<motion::SessionIndex> only) const {
  if (!step_.valid) return {};
  const auto counts = [&](motion::KeyframeIndex node) { return !only || problem_.nodes[node].session == *only; };
  // How the unknowns move with the gradient of a shared unknown (columns) and of one of a keyframe's (rows).
  Eigen::MatrixXd chosen = Eigen::MatrixXd::Zero(layout_.size(), signed_of(shared.size()));
  for (std::size_t i = 0; i < shared.size(); ++i) chosen(shared[i], signed_of(i)) = 1.0;
  const Eigen::MatrixXd of_shared = symmetric_solution(step_.reduced, chosen).transpose() * step_.counted;
  const Eigen::MatrixXd of_keyframes = -step_.factors.solve(equations_.coupling * of_shared.transpose());
  const auto moved_by = [&](Eigen::Index at, const auto& gradient) -> Eigen::VectorXd {
    return -of_keyframes.middleRows(at, gradient.size()).transpose() * gradient;
  };
  std::vector<MeasurementPull> pulls;
  for (const LinearTerm& term : terms_) {
    if (!counts(term.term->node_a)) continue;
    const Vector6d weighted = term_information(term, noise_) * term.residual;
    Eigen::VectorXd moved = -of_shared * (term.shared.transpose() * weighted);
    for (const NodePart* part : {&term.a, &term.b})
      moved += moved_by(part->at, Eigen::VectorXd(part->jacobian.transpose() * weighted));
    pulls.push_back({std::move(moved), term.term->node_a});
  }
  for (motion::KeyframeIndex k; k < problem_.nodes.size(); ++k) {
    if (!counts(k)) continue;
    const Matrix6d covariance = node_covariance(problem_, noise_, k);
    const Vector6d white = symmetric_solution(covariance, white_error(problem_, state_, layout_, k));
    Eigen::VectorXd moved = moved_by(layout_.node_at(k), white);
    if (layout_.drift)
      moved -= moved_by(layout_.drift_at(k), Vector6d(drift_in_body(problem_.nodes[k]).transpose() * white));
    if (layout_.drift && !is_first_of_session(problem_, k)) {
      const Vector6d change = state_.drifts[k] - state_.drifts[k - 1];
      const Vector6d weighted = drift_step_information(problem_, noise_, k).cwiseProduct(change);
      moved +=
          moved_by(layout_.drift_at(k), weighted) - moved_by(layout_.drift_at(motion::KeyframeIndex(k - 1)), weighted);
    }
    pulls.push_back({std::move(moved), k});
  }
  return pulls;
}

}  // namespace remount::calibration
