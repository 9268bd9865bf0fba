#include "algorithms/calibration/trajectory/trajectory_solver.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithms/core/index.h"
#include "algorithms/core/median.h"

namespace remount::calibration {
namespace {

// The cost of a squared residual u: u itself within the threshold, beyond it bounded by twice the threshold. Its
// derivative is the weight, which good measurements have whole and which no measurement has less of than `least`.
// docs/maths/trajectory.md (T7)
struct Kernel {
  double limit2;
  double weight(double u, double least) const {
    return u <= limit2 ? 1.0 : std::max(least, (limit2 / u) * (limit2 / u));
  }
  double cost(double u, double least) const {
    if (u <= limit2) return u;
    const double bent = least > 0.0 ? std::min(u, limit2 / std::sqrt(least)) : u;
    return 2.0 * limit2 - limit2 * limit2 / bent + least * (u - bent);
  }
};

// A chain must hold together where a step is an outlier too.
double least_weight(const TrajectoryTerm& term) { return term.is_step() ? 1e-6 : 0.0; }

double squared(const TrajectoryTerm& term, const TrajectoryNoise& noise) {
  const double factor = noise.of(term.kind);
  return term.residual.squaredNorm() / (factor * factor);
}

double total_cost(const TrajectoryProblem& problem, const TrajectoryOptions& options, const TrajectoryState& state,
                  const TrajectoryNoise& noise, const TrajectoryPrior& prior, const OwnVector& own_prior,
                  double widened) {
  const Kernel kernel{options.outlier_threshold * options.outlier_threshold * widened};
  const SharedVector away = prior.distance(state);
  double cost = away.dot(prior.information * away);
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    for (const TrajectoryTerm& term : trajectory_terms(problem.sessions[s], s, state))
      cost += kernel.cost(squared(term, noise), least_weight(term));
    cost += state.own(s).dot(own_prior.cwiseProduct(state.own(s)));
    cost += problem.sessions[s].past.cost(border_point(state, s));
  }
  return cost;
}

TrajectoryState state_after(const TrajectoryState& state, const std::vector<ChainVector>& steps, double share) {
  TrajectoryState out = state;
  if (steps.empty()) return out;
  const BorderVector shared = share * steps.front().border;
  out.ins_from_lidar = perturb(state.ins_from_lidar, shared.head<6>());
  out.antenna_in_lidar += shared.segment<3>(kAntennaAt);
  for (std::size_t s = 0; s < steps.size(); ++s) {
    out.add_own(s, share * steps[s].border.tail<kOwnSize>());
    for (std::size_t i = 0; i < steps[s].poses.size(); ++i)
      out.enu_from_lidar[s][i] = moved_in_lidar(state.enu_from_lidar[s][i], share * steps[s].poses[i]);
  }
  return out;
}

struct StepSize {
  double shared = 0.0, poses = 0.0;
};
StepSize size_of(const std::vector<ChainVector>& steps) {
  StepSize size;
  for (const ChainVector& one : steps) {
    size.shared = std::max(size.shared, one.border.cwiseAbs().maxCoeff());
    for (const Vector6d& pose : one.poses) size.poses = std::max(size.poses, pose.cwiseAbs().maxCoeff());
  }
  return size;
}

// How the cost falls at a state: half its negative derivative by poses, borders and what all sessions share.
struct Descent {
  std::vector<ChainVector> sides;
  SharedVector shared = SharedVector::Zero();
  double along(const std::vector<ChainVector>& moves) const {
    double sum = shared.dot(moves.front().border.head<kSharedSize>());
    for (std::size_t s = 0; s < sides.size(); ++s) {
      sum += sides[s].border.dot(moves[s].border);
      for (std::size_t i = 0; i < sides[s].poses.size(); ++i) sum += sides[s].poses[i].dot(moves[s].poses[i]);
    }
    return sum;
  }
};

// A step, and by how much it lowers the cost if residuals are linear.
struct Step {
  std::vector<ChainVector> moves;
  double predicted_decrease = 0.0;
  Descent descent;
};

Step gauss_newton_step(const TrajectoryProblem& problem, const WeightedTerms& weighted, const TrajectoryNoise& noise,
                       const TrajectoryPrior& prior, const TrajectoryEquations& equations,
                       const TrajectoryState& state) {
  Step step;
  step.descent.sides = zero_sides(problem);
  std::vector<ChainVector>& sides = step.descent.sides;
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    for (std::size_t k = 0; k < weighted.terms[s].size(); ++k) {
      const TrajectoryTerm& term = weighted.terms[s][k];
      const double factor = noise.of(term.kind);
      TrajectoryChain::add_transposed(term, -weighted.weights[s][k] / (factor * factor) * term.residual, sides[s]);
    }
    sides[s].border.tail<kOwnSize>() -= equations.own_prior().cwiseProduct(state.own(s));
    sides[s].border -= problem.sessions[s].past.pull_at(border_point(state, s));
  }
  step.descent.shared = -prior.information * prior.distance(state);
  step.moves = equations.solve(sides, step.descent.shared);
  if (!step.moves.empty()) step.predicted_decrease = step.descent.along(step.moves);
  return step;
}

// A direction that was gone along, for the one after it.
struct Gone {
  Step step;                       ///< that the equations gave there
  std::vector<ChainVector> moves;  ///< as it was gone, but for its length
};

// Where a drive hardly shows a direction (z on flat ground), residuals bend the cost as much as their derivatives say:
// steps by linear residuals go to and fro about the minimum, or reach it after hundreds. Conjugate directions (Polak
// and Ribiere 1969), with the equations in the place of a scale, learn the bend on the way.
std::vector<ChainVector> conjugate_moves(const Gone& before, const Step& step) {
  const double share =
      (step.predicted_decrease - before.step.descent.along(step.moves)) / before.step.predicted_decrease;
  std::vector<ChainVector> moves = step.moves;
  if (!(share > 0.0) || !std::isfinite(share)) return moves;
  for (std::size_t s = 0; s < moves.size(); ++s) {
    moves[s].border += share * before.moves[s].border;
    for (std::size_t i = 0; i < moves[s].poses.size(); ++i) moves[s].poses[i] += share * before.moves[s].poses[i];
  }
  return step.descent.along(moves) > 0.0 ? moves : step.moves;
}

enum class Improved { Moved, AtMinimum, Stuck };

// Cost falls by share * (2 - bend * share) * slope, slope being that along the step: how much it fell tells the bend.
double best_share(double share, double fell, double slope) {
  constexpr double kShortest = 0.1, kLongest = 20.0;
  const double bend = (2.0 - fell / (share * slope)) / share;
  return std::clamp(1.0 / std::max(bend, 1.0 / kLongest), kShortest * share, kLongest);
}

// Along `moves` as far as the cost falls, or falls most. Nothing where it does not.
template <class Cost>
std::optional<TrajectoryState> find_lower(const TrajectoryState& state, const std::vector<ChainVector>& moves,
                                          double before, double slope, const Cost& cost) {
  constexpr double kSame = 0.9;
  constexpr int kMostHalvings = 12;
  const double most = before * (1.0 + 1e-9);
  double share = 1.0;
  for (int halved = 0; halved < kMostHalvings; ++halved, share *= 0.5) {
    TrajectoryState next = state_after(state, moves, share);
    const double after = cost(next);
    if (!(after <= most)) continue;
    const double better = best_share(share, before - after, slope);
    if (better > kSame * share && share > kSame * better) return next;
    TrajectoryState other = state_after(state, moves, better);
    return cost(other) < after ? other : next;
  }
  return std::nullopt;
}

// One step, conjugate to the one before. `gone` is begun anew where another cost is to be lowered.
Improved improve(const TrajectoryProblem& problem, const TrajectoryOptions& options, const TrajectoryPrior& prior,
                 double widened, TrajectorySolution& solution, std::optional<Gone>& gone) {
  constexpr double kShared = 1e-7, kPoses = 1e-5, kNoDecrease = 1e-5, kNoShare = 1e-9;
  const WeightedTerms weighted = weighted_terms(problem, options, solution.state, solution.noise, widened);
  const TrajectoryEquations equations(problem, options, weighted, solution.noise, prior.information);
  if (!equations.solvable()) return Improved::Stuck;
  Step step = gauss_newton_step(problem, weighted, solution.noise, prior, equations, solution.state);
  const auto cost = [&](const TrajectoryState& state) {
    return total_cost(problem, options, state, solution.noise, prior, equations.own_prior(), widened);
  };
  const double before = cost(solution.state);
  const StepSize size = size_of(step.moves);
  if (!std::isfinite(size.shared + size.poses)) return Improved::Stuck;
  // Judged by the whole step: the part that is left after halving is small wherever the search fails.
  const bool at_minimum = size.shared < kShared && size.poses < kPoses;
  // Along what the drive hardly shows, steps stay long however little they change: three thousandths of a sigma, whose
  // square is this decrease.
  const bool nothing_left = step.predicted_decrease < std::max(kNoDecrease, kNoShare * before);
  if (at_minimum || nothing_left) {
    TrajectoryState last = state_after(solution.state, step.moves, 1.0);
    if (cost(last) <= before) solution.state = std::move(last);
    return Improved::AtMinimum;
  }
  std::vector<ChainVector> moves = gone ? conjugate_moves(*gone, step) : step.moves;
  std::optional<TrajectoryState> next = find_lower(solution.state, moves, before, step.descent.along(moves), cost);
  if (!next && gone) {
    moves = step.moves;
    next = find_lower(solution.state, moves, before, step.predicted_decrease, cost);
  }
  if (!next) return Improved::Stuck;
  solution.state = *std::move(next);
  gone = Gone{std::move(step), std::move(moves)};
  return Improved::Moved;
}

// Median of the sum of so many squares of unit variance.
double median_square(double components) { return components > 2.5 ? 2.366 : components > 1.5 ? 1.386 : 0.455; }

// Medians of squared residuals, over what they are where errors are as stated.
TrajectoryNoise at_least_as_stated(const TrajectoryProblem& problem, const TrajectoryState& state) {
  constexpr double kMost = 30.0;
  std::array<std::vector<double>, kTermKinds> squares;
  for (std::size_t s = 0; s < problem.sessions.size(); ++s)
    for (const TrajectoryTerm& term : trajectory_terms(problem.sessions[s], s, state))
      if (term.kind != TermKind::InsTilt)
        squares[index_of(term.kind)].push_back(term.residual.squaredNorm() / median_square(term.used.sum()));
  TrajectoryNoise noise;
  for (std::size_t kind = 0; kind < kTermKinds; ++kind) {
    auto& values = squares[kind];
    if (values.empty()) continue;
    noise.factor[kind] = std::clamp(std::sqrt(median_of(std::move(values))), 1.0, kMost);
  }
  return noise;
}

// Errors that somebody states may turn out larger; what seems smaller is correlated from sample to sample.
double least_factor(const TrajectoryProblem& problem, TermKind kind) {
  constexpr double kAssumed = 0.05;
  if (kind == TermKind::Antenna) return 1.0;
  if (kind != TermKind::InsPosition && kind != TermKind::InsAttitude) return kAssumed;
  const auto states = [](const TrajectorySession& session) {
    return !session.epochs.empty() && session.ins_noise_stated;
  };
  return std::any_of(problem.sessions.begin(), problem.sessions.end(), states) ? 1.0 : kAssumed;
}

// Variance components (Foerstner 1979): squared residuals of each kind over their redundancy, which samples of errors
// tell without any inverse. What is stated counts like a few measurements. docs/maths/trajectory.md (T10)
double update_noise(const TrajectoryProblem& problem, const TrajectoryOptions& options, const TrajectoryPrior& prior,
                    TrajectorySolution& solution) {
  constexpr double kBelieved = 12.0;
  constexpr int kSamples = 2;
  const WeightedTerms weighted = weighted_terms(problem, options, solution.state, solution.noise);
  const TrajectoryEquations equations(problem, options, weighted, solution.noise, prior.information);
  if (!equations.solvable()) return 0.0;
  std::array<double, kTermKinds> squares{}, redundancy{};
  for (int sample = 0; sample < kSamples; ++sample) {
    const ErrorSample errors =
        sample_errors(weighted, solution.noise, equations, problem, static_cast<std::uint64_t>(sample));
    for (std::size_t s = 0; s < weighted.terms.size(); ++s)
      for (std::size_t k = 0; k < weighted.terms[s].size(); ++k) {
        const TrajectoryTerm& term = weighted.terms[s][k];
        if (weighted.weights[s][k] < 0.5) continue;
        const auto kind = index_of(term.kind);
        const double root = std::sqrt(weighted.weights[s][k]) / solution.noise.of(term.kind);
        const Eigen::Vector3d left = errors.errors[s][k] - root * TrajectoryChain::apply(term, errors.steps[s]);
        redundancy[kind] += term.used.cwiseProduct(left).squaredNorm() / kSamples;
        if (sample == 0) squares[kind] += weighted.weights[s][k] * term.residual.squaredNorm();
      }
  }
  double change = 0.0;
  for (std::size_t kind = 0; kind < kTermKinds; ++kind) {
    if (static_cast<TermKind>(kind) == TermKind::InsTilt) continue;
    const double before = solution.noise.factor[kind];
    const double variance = (squares[kind] + kBelieved) / (redundancy[kind] + kBelieved);
    solution.noise.factor[kind] =
        std::clamp(std::sqrt(variance), least_factor(problem, static_cast<TermKind>(kind)), kMostNoiseFactor);
    change = std::max(change, std::abs(std::log(solution.noise.factor[kind] / before)));
  }
  return change;
}

// How wide the kernel must be for most residuals of the start to count.
double starting_width(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                      const TrajectorySolution& start) {
  constexpr double kMost = 1e8, kShare = 0.9;
  std::vector<double> squares;
  for (std::size_t s = 0; s < problem.sessions.size(); ++s)
    for (const TrajectoryTerm& term : trajectory_terms(problem.sessions[s], s, start.state))
      squares.push_back(squared(term, start.noise));
  if (squares.empty()) return 1.0;
  const auto at = squares.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(squares.size() - 1));
  std::nth_element(squares.begin(), at, squares.end());
  return std::clamp(*at / (options.outlier_threshold * options.outlier_threshold), 1.0, kMost);
}

bool converge(const TrajectoryProblem& problem, const TrajectoryOptions& options, const TrajectoryPrior& prior,
              double widened, int most, const Progress& progress, TrajectorySolution& solution) {
  std::optional<Gone> gone;
  for (int i = 0; i < most && !progress.cancelled(); ++i) {
    const Improved now = improve(problem, options, prior, widened, solution, gone);
    ++solution.iterations;
    if (now != Improved::Moved) return now == Improved::AtMinimum;
  }
  return false;
}

}  // namespace

TrajectoryState held_state(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                           const TrajectorySolution& solution, const TrajectoryPrior& prior, const SharedMatrix& hold) {
  const WeightedTerms weighted = weighted_terms(problem, options, solution.state, solution.noise);
  const TrajectoryEquations equations(problem, options, weighted, solution.noise, prior.information + hold);
  if (!equations.solvable()) return solution.state;
  return state_after(solution.state, equations.solve(zero_sides(problem), -hold * prior.distance(solution.state)), 1.0);
}

WeightedTerms weighted_terms(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                             const TrajectoryState& state, const TrajectoryNoise& noise, double widened) {
  const Kernel kernel{options.outlier_threshold * options.outlier_threshold * widened};
  WeightedTerms out;
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    out.terms.push_back(trajectory_terms(problem.sessions[s], s, state));
    std::vector<double>& weights = out.weights.emplace_back();
    for (const TrajectoryTerm& term : out.terms.back()) {
      weights.push_back(kernel.weight(squared(term, noise), least_weight(term)));
    }
  }
  return out;
}

ErrorSample sample_errors(const WeightedTerms& weighted, const TrajectoryNoise& noise,
                          const TrajectoryEquations& equations, const TrajectoryProblem& problem, std::uint64_t seed) {
  // SplitMix64 (Steele, Lea, Flood 2014): the same on every platform.
  std::uint64_t stream = (seed + 1) * 0x9e3779b97f4a7c15ULL;
  const auto sign = [&stream] {
    std::uint64_t z = (stream += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return ((z ^ (z >> 31)) & 1U) != 0 ? 1.0 : -1.0;
  };
  ErrorSample out;
  std::vector<ChainVector> sides = zero_sides(problem);
  for (std::size_t s = 0; s < weighted.terms.size(); ++s) {
    out.errors.emplace_back();
    for (std::size_t k = 0; k < weighted.terms[s].size(); ++k) {
      const double x = sign(), y = sign(), z = sign();
      out.errors[s].emplace_back(x, y, z);
      const double root = std::sqrt(weighted.weights[s][k]) / noise.of(weighted.terms[s][k].kind);
      TrajectoryChain::add_transposed(weighted.terms[s][k], root * out.errors[s][k], sides[s]);
    }
  }
  out.steps = equations.solve(std::move(sides), SharedVector::Zero());
  return out;
}

TrajectorySolution solve_trajectory(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                    const TrajectorySolution& start, const TrajectoryPrior& prior,
                                    const TrajectoryApproach& approach, const Progress& progress) {
  TrajectorySolution solution = start;
  solution.converged = false;
  solution.iterations = 0;
  const int most = approach.most_iterations;
  if (approach.graduated) {
    constexpr int kEach = 2;
    solution.noise = TrajectoryNoise{};
    for (double width = starting_width(problem, options, solution); width > 1.0 && !progress.cancelled();
         width *= 0.25) {
      converge(problem, options, prior, width, kEach, progress, solution);
      solution.noise = at_least_as_stated(problem, solution.state);
    }
  }
  solution.converged = converge(problem, options, prior, 1.0, most, progress, solution);
  constexpr int kRounds = 12;
  constexpr double kSettled = 0.02;
  for (int round = 0; approach.estimate_noise && round < kRounds && !progress.cancelled(); ++round) {
    const double change = update_noise(problem, options, prior, solution);
    solution.converged = converge(problem, options, prior, 1.0, most, progress, solution);
    if (change < kSettled) break;
  }
  return solution;
}

}  // namespace remount::calibration
