// Maximum likelihood of trajectory alignment: robust weights, Gauss-Newton, and how large the errors turn out.
#pragma once

#include "algorithms/calibration/trajectory/trajectory_equations.h"
#include "algorithms/core/progress.h"

namespace remount::calibration {

struct TrajectorySolution {
  TrajectoryState state;
  TrajectoryNoise noise;
  bool converged = false;
  int iterations = 0;
};

/// How a solution is approached. A kernel that starts wide and narrows lets gross outliers go without being trapped by
/// them (graduated non-convexity: Yang et al. 2020); from a solution of almost the same data it stays narrow.
struct TrajectoryApproach {
  bool graduated = true;
  bool estimate_noise = true;
  int most_iterations = 60;
};

/// Minimises over all poses, X, the antenna, scales and clocks, from `start`.
TrajectorySolution solve_trajectory(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                    const TrajectorySolution& start, const TrajectoryPrior& prior,
                                    const TrajectoryApproach& approach, const Progress& progress);

/// The state nearest to a solution's that keeps to `hold` as well, information about the prior's centre: one step with
/// the weights as they are. What is held may contradict what noise seems to say, and no measurement is to lose its
/// weight by that.
TrajectoryState held_state(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                           const TrajectorySolution& solution, const TrajectoryPrior& prior, const SharedMatrix& hold);

/// Terms and robust weights at a state.
WeightedTerms weighted_terms(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                             const TrajectoryState& state, const TrajectoryNoise& noise, double widened = 1.0);

/// Random right-hand sides as measurement errors would make them, from a seed, and the steps they cause: samples of the
/// errors of every pose and of X.
struct ErrorSample {
  std::vector<std::vector<Eigen::Vector3d>> errors;  ///< of each term, +-1
  std::vector<ChainVector> steps;
};
ErrorSample sample_errors(const WeightedTerms& weighted, const TrajectoryNoise& noise,
                          const TrajectoryEquations& equations, const TrajectoryProblem& problem, std::uint64_t seed);

}  // namespace remount::calibration
