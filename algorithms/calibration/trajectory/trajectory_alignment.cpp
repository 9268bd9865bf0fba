#include "algorithms/calibration/trajectory/trajectory_alignment.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/trajectory/trajectory_condense.h"
#include "algorithms/calibration/trajectory/trajectory_refusal.h"
#include "algorithms/calibration/trajectory/trajectory_start.h"
#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/calibration.h"
#include "messages/stages.h"

namespace remount::calibration {
namespace {

constexpr std::size_t kFewestEpochs = 8;
constexpr double kLeastTravel_m = 3.0;

double travelled_m(const TrajectorySession& session) {
  double sum = 0.0;
  for (std::size_t i = 1; i < session.epochs.size(); ++i)
    sum +=
        (session.epochs[i].odometry_from_lidar.translation() - session.epochs[i - 1].odometry_from_lidar.translation())
            .norm();
  return sum;
}

bool says_something(const TrajectorySession& session) {
  if (!session.past.empty()) return true;
  const auto seen = std::count_if(session.epochs.begin(), session.epochs.end(),
                                  [](const TrajectoryEpoch& epoch) { return epoch.ins || epoch.antenna; });
  return static_cast<std::size_t>(seen) >= kFewestEpochs && travelled_m(session) > kLeastTravel_m;
}

// Sessions that say nothing take part with no epoch, so that their indices stay.
TrajectoryProblem usable_part(const TrajectoryProblem& problem) {
  TrajectoryProblem out = problem;
  for (TrajectorySession& session : out.sessions)
    if (!says_something(session)) session.epochs.clear();
  return out;
}

void count_outliers(const TrajectoryProblem& problem, const TrajectoryOptions& options, TrajectoryOutcome& outcome) {
  const WeightedTerms weighted = weighted_terms(problem, options, outcome.solution.state, outcome.solution.noise);
  for (std::size_t s = 0; s < weighted.terms.size(); ++s)
    for (std::size_t k = 0; k < weighted.terms[s].size(); ++k) {
      // What is assumed was not measured.
      if (weighted.terms[s][k].is_step() || weighted.terms[s][k].kind == TermKind::InsTilt) continue;
      ++outcome.measurements;
      outcome.outliers += weighted.weights[s][k] < 0.5 ? 1U : 0U;
    }
}

// Trajectories of different drives settle somewhere too: with errors beyond belief, or most measurements without
// weight.
bool contradict(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                const TrajectorySolution& solution) {
  constexpr double kBeyondBelief = 10.0;  // times the errors that were stated or assumed
  const WeightedTerms weighted = weighted_terms(problem, options, solution.state, solution.noise);
  std::array<std::size_t, kTermKinds> all{}, without{};
  for (std::size_t s = 0; s < weighted.terms.size(); ++s)
    for (std::size_t k = 0; k < weighted.terms[s].size(); ++k) {
      const auto kind = index_of(weighted.terms[s][k].kind);
      ++all[kind];
      without[kind] += weighted.weights[s][k] < 0.5 ? 1U : 0U;
    }
  for (std::size_t kind = 0; kind < kTermKinds; ++kind)
    if (2 * without[kind] > all[kind] || solution.noise.factor[kind] > kBeyondBelief) return true;
  return false;
}

// What the drive does not show stays where it was.
void keep_what_is_open(const TrajectoryProblem& problem, const TrajectoryOptions& options, const TrajectoryPrior& prior,
                       TrajectoryOutcome& outcome) {
  outcome.solution.state = held_state(problem, options, outcome.solution, prior, outcome.answer.hold);
  set_values(outcome.solution.state, outcome.answer);
}

// Angles measured by hand are linear about where X starts: once more about where it came to lie. What the drive shows
// is then no longer expected at the start, or it would draw what is held with it.
void solve_about_x(const TrajectoryProblem& usable, const TrajectoryOptions& options, const SolveOptions& judged_by,
                   const Progress& progress, TrajectoryPrior& prior, TrajectorySolution& solution) {
  const RigidTransform x = solution.state.ins_from_lidar;
  const ParameterSet observed =
      describe_trajectory(usable, options, judged_by, solution, prior, false).result.observed();
  const ParameterSet shown = observed & ~usable.measured.parameters();
  prior = weak_trajectory_prior(usable, options, x);
  for (const Parameter axis : {Parameter::X, Parameter::Y, Parameter::Z})
    if (shown.contains(axis)) prior.ins_from_lidar.translation()[row_of(axis)] = x.translation()[row_of(axis)];
  TrajectoryApproach approach;
  approach.graduated = false;
  solution = solve_trajectory(usable, options, solution, prior, approach, progress);
}

TrajectorySnapshot snapshot_of(const CalibrationResult& result, double time_s) {
  TrajectorySnapshot out;
  out.time_s = time_s;
  out.known = is_solved(result.status);
  out.mounting = result.mounting;
  for (const Parameter parameter : kParameters) out.sigma[parameter] = result.estimate(parameter).sigma;
  return out;
}

// New poses follow the odometry from the last one that is solved.
void extend_state(const TrajectoryProblem& problem, TrajectoryState& state) {
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    const std::vector<TrajectoryEpoch>& epochs = problem.sessions[s].epochs;
    std::vector<RigidTransform>& poses = state.enu_from_lidar[s];
    for (std::size_t i = poses.size(); i < epochs.size(); ++i)
      poses.push_back(poses.back() * epochs[i - 1].odometry_from_lidar.inverse() * epochs[i].odometry_from_lidar);
  }
}

// What was linear about one X says little of another.
bool moved_far(const TrajectoryProblem& problem, const TrajectoryState& state) {
  constexpr double kFar_m = 1.0, kFar_rad = degrees_to_radians(1.0);
  return std::any_of(problem.sessions.begin(), problem.sessions.end(), [&](const TrajectorySession& session) {
    if (session.past.empty()) return false;
    const Vector6d moved = difference(session.past.linearised_ins_from_lidar, state.ins_from_lidar);
    return moved.head<3>().norm() > kFar_m || moved.tail<3>().norm() > kFar_rad;
  });
}

std::vector<bool> that_say_something(const TrajectoryProblem& problem) {
  std::vector<bool> takes_part;
  for (const TrajectorySession& session : problem.sessions) takes_part.push_back(says_something(session));
  return takes_part;
}

std::size_t epochs_in(const TrajectoryProblem& problem) {
  std::size_t sum = 0;
  for (const TrajectorySession& session : problem.sessions) sum += session.epochs.size();
  return sum;
}

double sufficient(Parameter parameter, const TrajectoryOptions& options) {
  return is_angle(parameter) ? degrees_to_radians(options.converged_rotation_deg) : options.converged_translation_m;
}

// Nothing where one of them does not observe the parameter.
std::optional<double> moved_by(Parameter parameter, const TrajectorySnapshot& from, const TrajectorySnapshot& to) {
  if (!from.sigma[parameter] || !to.sigma[parameter]) return std::nullopt;
  const double moved = parameters_of(to.mounting.reference_from_sensor)[parameter] -
                       parameters_of(from.mounting.reference_from_sensor)[parameter];
  return std::abs(is_angle(parameter) ? wrap_angle_rad(moved) : moved);
}

bool observe_the_same(const TrajectorySnapshot& a, const TrajectorySnapshot& b) {
  return std::all_of(kParameters.begin(), kParameters.end(), [&](Parameter parameter) {
    return a.sigma[parameter].has_value() == b.sigma[parameter].has_value();
  });
}

bool observes_enough(const TrajectorySnapshot& now, const TrajectoryOptions& options) {
  bool anything = false;
  for (const Parameter parameter : kParameters) {
    const std::optional<double>& sigma = now.sigma[parameter];
    if (sigma && !(*sigma < sufficient(parameter, options))) return false;
    anything = anything || sigma;
  }
  return anything;
}

}  // namespace

TrajectoryAligner::TrajectoryAligner(TrajectoryOptions options, SolveOptions judged_by,
                                     std::optional<RigidTransform> nominal_ins_from_lidar, bool estimate_clock)
    : options_(options), judged_by_(judged_by) {
  problem_.nominal_ins_from_lidar = nominal_ins_from_lidar;
  problem_.estimate_clock = estimate_clock;
  window_ = problem_;
}

std::size_t TrajectoryAligner::add_session(TrajectorySession session) {
  window_.sessions.push_back(session);
  problem_.sessions.push_back(std::move(session));
  return problem_.sessions.size() - 1;
}

void TrajectoryAligner::push(std::size_t session, TrajectoryEpoch epoch) {
  if (session >= problem_.sessions.size())
    throw Error(ErrorCode::Contract, "session " + std::to_string(session),
                Message::verbatim("was not added to the alignment"));
  std::vector<TrajectoryEpoch>& epochs = problem_.sessions[session].epochs;
  if (!epochs.empty() && !(epoch.time_s > epochs.back().time_s))
    throw Error(ErrorCode::Contract, "session " + std::to_string(session), say::trajectory_epochs_not_ascending());
  window_.sessions[session].epochs.push_back(epoch);
  epochs.push_back(std::move(epoch));
}

double TrajectoryAligner::data_s() const {
  double sum = 0.0;
  for (const TrajectorySession& session : problem_.sessions)
    if (!session.epochs.empty()) sum += session.epochs.back().time_s - session.epochs.front().time_s;
  return sum;
}

std::size_t TrajectoryAligner::epochs() const { return epochs_in(problem_); }

std::size_t TrajectoryAligner::open_epochs() const { return epochs_in(window_); }

bool TrajectoryAligner::enough() const {
  return std::any_of(window_.sessions.begin(), window_.sessions.end(), says_something);
}

bool TrajectoryAligner::due(double after_s) const { return data_s() - updated_s_ >= after_s - 1e-6; }

bool TrajectoryAligner::has_stayed(const TrajectorySnapshot& now) const {
  constexpr double kWatched_s = 10.0;
  if (!observes_enough(now, options_)) return false;
  for (auto before = history_.rbegin(); before != history_.rend(); ++before) {
    if (!before->known || !observe_the_same(*before, now)) return false;
    for (const Parameter parameter : kParameters)
      if (moved_by(parameter, *before, now).value_or(0.0) > sufficient(parameter, options_)) return false;
    if (now.time_s - before->time_s >= kWatched_s) return true;
  }
  return false;
}

bool TrajectoryAligner::starts_anew(const Running& running) const {
  constexpr double kAnew = 1.5;
  if (that_say_something(window_) != running.takes_part) return true;
  if (static_cast<double>(epochs()) <= kAnew * static_cast<double>(running.at_start)) return false;
  const bool condensed = std::any_of(window_.sessions.begin(), window_.sessions.end(),
                                     [](const TrajectorySession& session) { return !session.past.empty(); });
  return !condensed || running.doubtful;
}

bool TrajectoryAligner::solve_on(const TrajectoryProblem& usable, bool anew, Running& running,
                                 const Progress& progress) const {
  constexpr double kNoise = 1.15;
  const std::size_t count = epochs();
  TrajectoryApproach approach;
  if (anew) {
    running.solution = start_trajectory(usable, options_, progress);
    running.prior = weak_trajectory_prior(usable, options_, running.solution.state.ins_from_lidar);
    running.takes_part = that_say_something(usable);
    running.at_start = running.at_noise = count;
    ++running.cold_starts;
  } else {
    extend_state(usable, running.solution.state);
    approach.graduated = false;
    approach.estimate_noise = static_cast<double>(count) > kNoise * static_cast<double>(running.at_noise);
    if (approach.estimate_noise) running.at_noise = count;
    approach.most_iterations = 4;
  }
  running.solution = solve_trajectory(usable, options_, running.solution, running.prior, approach, progress);
  const bool answered = !contradict(usable, options_, running.solution);
  running.doubtful = !answered || moved_far(usable, running.solution.state);
  return answered;
}

void TrajectoryAligner::shorten(TrajectoryProblem& usable, TrajectoryProblem& window, Running& running) const {
  constexpr std::size_t kMostOpen = 600, kKept = 300;
  const double block_s = std::max(1e-3, judged_by_.bootstrap_block_s);
  // From then on blocks have their full length: what is condensed stays in blocks as they will be.
  if (epochs_in(usable) <= kMostOpen || data_s() < kBootstrapBlocks * block_s) return;
  for (std::size_t s = 0; s < usable.sessions.size(); ++s) {
    const std::size_t count = condense(s, kKept, options_, running.prior, block_s, usable, running.solution);
    std::vector<TrajectoryEpoch>& epochs = window.sessions[s].epochs;
    epochs.erase(epochs.begin(), epochs.begin() + static_cast<std::ptrdiff_t>(count));
    window.sessions[s].past = usable.sessions[s].past;
  }
}

TrajectorySnapshot TrajectoryAligner::update(const Progress& progress) {
  TrajectorySnapshot now;
  now.time_s = data_s();
  if (enough()) {
    Running next = running_;
    const bool anew = starts_anew(next);
    TrajectoryProblem window = anew ? problem_ : window_;
    TrajectoryProblem usable = usable_part(window);
    const bool answered = solve_on(usable, anew, next, progress);
    if (answered)
      now = snapshot_of(describe_trajectory(usable, options_, judged_by_, next.solution, next.prior, false).result,
                        now.time_s);
    now.converged = now.known && has_stayed(now);
    if (answered && !progress.cancelled()) shorten(usable, window, next);
    if (progress.cancelled()) return {};
    window_ = std::move(window);
    running_ = std::move(next);
  }
  if (progress.cancelled()) return {};
  updated_s_ = now.time_s;
  history_.push_back(now);
  return now;
}

TrajectoryOutcome solve_alignment(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                  const SolveOptions& judged_by, const Progress& progress) {
  TrajectoryOutcome outcome;
  if (std::none_of(problem.sessions.begin(), problem.sessions.end(), says_something)) {
    outcome.answer = without_numbers(Status::TooLittleData, say::trajectory_too_little(kFewestEpochs));
    return outcome;
  }
  const TrajectoryProblem usable = usable_part(problem);
  outcome.solution = start_trajectory(usable, options, progress);
  TrajectoryPrior prior = weak_trajectory_prior(usable, options, outcome.solution.state.ins_from_lidar);
  outcome.solution = solve_trajectory(usable, options, outcome.solution, prior, {}, progress);
  if (!usable.measured.rows(outcome.solution.state.ins_from_lidar).empty() && has_ins(usable))
    solve_about_x(usable, options, judged_by, progress, prior, outcome.solution);
  outcome.answer = describe_trajectory(usable, options, judged_by, outcome.solution, prior, true);
  if (progress.cancelled()) {
    outcome.answer = without_numbers(Status::Cancelled, say::calibration_cancelled());
    return outcome;
  }
  const bool aligned = outcome.solution.converged && !contradict(usable, options, outcome.solution);
  if (auto refusal = refusal_of(usable, options, outcome.solution.state, aligned)) {
    outcome.answer = *std::move(refusal);
    return outcome;
  }
  count_outliers(usable, options, outcome);
  if (!outcome.answer.hold.isZero(0.0)) keep_what_is_open(usable, options, prior, outcome);
  return outcome;
}

double converged_after_s(const std::vector<TrajectorySnapshot>& history) {
  double since_s = std::numeric_limits<double>::quiet_NaN();
  for (auto one = history.rbegin(); one != history.rend() && one->converged; ++one) since_s = one->time_s;
  return since_s;
}

TrajectoryOutcome TrajectoryAligner::finish(const Progress& progress) const {
  TrajectoryOutcome outcome = solve_alignment(problem_, options_, judged_by_, progress);
  outcome.converged_after_s = calibration::converged_after_s(history_);
  return outcome;
}

TrajectoryOutcome align_trajectories(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                     const SolveOptions& judged_by, std::size_t most_snapshots,
                                     std::vector<TrajectorySnapshot>& history, Progress& progress) {
  TrajectoryAligner aligner(options, judged_by, problem.nominal_ins_from_lidar, problem.estimate_clock);
  aligner.set_measured(problem.measured);
  aligner.set_up_in_lidar(problem.up_in_lidar);
  std::size_t total = 0, done = 0;
  for (const TrajectorySession& session : problem.sessions) total += session.epochs.size();
  const std::size_t step = most_snapshots > 0 ? std::max<std::size_t>(1, total / most_snapshots) : 0;
  std::size_t last = 0;
  for (const TrajectorySession& session : problem.sessions) {
    TrajectorySession empty = session;
    empty.epochs.clear();
    const std::size_t index = aligner.add_session(std::move(empty));
    for (const TrajectoryEpoch& epoch : session.epochs) {
      aligner.push(index, epoch);
      ++done;
      if (step == 0 || progress.cancelled() || done - last < step || !aligner.due()) continue;
      last = done;
      progress.report(say::stage_aligning_trajectories, done, total);
      aligner.update(progress);
    }
  }
  history = aligner.history();
  progress.report(say::stage_aligning_trajectories, total, total);
  return aligner.finish(progress);
}

}  // namespace remount::calibration
