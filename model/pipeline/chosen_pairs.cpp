#include "model/pipeline/chosen_pairs.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/noise_prior.h"
#include "algorithms/calibration/pairwise/pair_choice.h"
#include "algorithms/motion/pairing.h"
#include "messages/pipeline.h"
#include "messages/places.h"
#include "model/pipeline/offset_search.h"
#include "model/pipeline/solve_stage.h"
#include "model/results/deciding_notes.h"

namespace remount::pipeline {
namespace {

constexpr std::size_t kFew = 400;          // all of so many are registered
constexpr std::size_t kFirst = 80;         // to begin with
constexpr std::size_t kLeastMore = 40;     // at a time
constexpr std::size_t kMostTimes = 8;      // as many, by one forecast: noise is known as well as pairs tell it
constexpr std::size_t kWholeSession = 50;  // a session with fewer is not thinned: it has to speak for itself
constexpr double kWider = 1.08;            // a sigma that is left, over what it would be with all pairs
constexpr double kDoubted = 1.2;           // a sigma over what pairs and their common errors make of it
constexpr int kMostDoublings = 2;          // of the pairs, where something is in doubt

// The solver's input for keyframes of which the output holds only those that are taken.
calibration::PairwiseInput input_of_all(const PipelineInput& input, const DriveMotion& motion,
                                        const PipelineOutput& output, const std::vector<motion::Keyframe>& keyframes) {
  PipelineOutput all;
  static_cast<RunRecord&>(all) = output;
  static_cast<CalibrationOutcome&>(all) = output;
  all.up_in_lidar = output.up_in_lidar;
  all.session_frames = output.session_frames;
  all.ground = output.ground;
  all.keyframes = keyframes;
  return solver_input(input, motion, all);
}

SolvedByPairs solved_by(std::size_t pairs, const calibration::CalibrationResult& result) {
  SolvedByPairs solved{pairs};
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const double sigma = result.estimate(parameter).sigma.value_or(std::numeric_limits<double>::quiet_NaN());
    solved.variances[calibration::row_of(parameter)] = sigma * sigma;
  }
  return solved;
}

// What more pairs would make of a solution, but for errors of beams. docs/maths/pairwise.md (P25)
class Forecast {
 public:
  /// @param pairs all; those that are taken registered
  Forecast(const calibration::PairwiseInput& solver, const std::vector<motion::Pair>& pairs,
           const std::vector<bool>& taken, const calibration::PairwiseDetails& details,
           const calibration::CalibrationResult& result, const Progress& progress)
      : solver_(solver),
        pairs_(pairs),
        taken_(taken),
        details_(details),
        result_(result),
        progress_(progress),
        x_(details.joint.ins_from_lidar),
        of_pairs_(calibration::parameter_covariance(x_, details.pairs_covariance).diagonal()),
        common_(calibration::parameter_covariance(x_, details.common_covariance).diagonal()) {
    double accepted = 0.0, registered = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      accepted += taken[i] && pairs[i].state == motion::PairState::Accepted;
      registered += taken[i];
    }
    accepted_share_ = accepted / std::max(1.0, registered);
    now_ = variances_with(taken);
    all_ = variances_with(std::vector<bool>(pairs.size(), true));
  }

  /// Whether something widens a sigma beside what pairs and their common errors make of it.
  bool in_doubt() const {
    return std::ranges::any_of(calibration::kParameters, [this](calibration::Parameter parameter) {
      const int i = calibration::row_of(parameter);
      const std::optional<double> sigma = result_.estimate(parameter).sigma;
      return sigma && *sigma * *sigma > kDoubted * kDoubted * (of_pairs_[i] + common_[i]);
    });
  }

  ToldByTaken told_by(const std::vector<bool>& chosen) const {
    const Vector6d variances = variances_with(chosen),
                   limits = calibration::observation_limits(solver_.options).cwiseAbs2();
    ToldByTaken least;
    for (const calibration::Parameter parameter : calibration::kParameters) {
      const int i = calibration::row_of(parameter);
      const bool observed = result_.estimate(parameter).observed;
      if (!observed && all_[i] > limits[i]) continue;  // not even all pairs would show it
      const double stays = observed ? common_[i] : 0.0, own = observed ? of_pairs_[i] / now_[i] : 1.0;
      const double wider = std::sqrt((stays + own * variances[i]) / (stays + own * all_[i]));
      if (wider > least.wider) least = {parameter, std::min(1.0, all_[i] / variances[i]), wider};
    }
    return least;
  }

 private:
  Vector6d variances_with(const std::vector<bool>& chosen) const {
    std::vector<double> weights(pairs_.size(), 0.0);
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (taken_[i])
        weights[i] = pairs_[i].state == motion::PairState::Accepted ? pairs_[i].weight : 0.0;
      else if (chosen[i])
        weights[i] = accepted_share_;
    const Matrix6d information =
        calibration::expected_information(solver_, pairs_, weights, details_.noise, x_, progress_);
    const Matrix6d whole = information + calibration::weak_prior(solver_.nominal_ins_from_lidar.has_value()) +
                           solver_.measured.information(x_);
    return calibration::parameter_covariance(x_, whole.ldlt().solve(Matrix6d::Identity())).diagonal();
  }

  const calibration::PairwiseInput& solver_;
  const std::vector<motion::Pair>& pairs_;
  const std::vector<bool>& taken_;
  const calibration::PairwiseDetails& details_;
  const calibration::CalibrationResult& result_;
  const Progress& progress_;
  RigidTransform x_ = RigidTransform::Identity();
  Vector6d of_pairs_, common_, now_, all_;
  double accepted_share_ = 1.0;
};

}  // namespace

ToldByTaken told_by_trend(const SolvedByPairs& before, const SolvedByPairs& now, std::size_t count, std::size_t all) {
  const auto per_pair = [](std::size_t pairs) { return 1.0 / static_cast<double>(pairs); };
  ToldByTaken least;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const int i = calibration::row_of(parameter);
    const double falls = before.variances[i] - now.variances[i];
    if (!(falls > 0.0)) continue;  // or it is not observed
    const double slope = falls / (per_pair(before.pairs) - per_pair(now.pairs));
    const auto variance_with = [&](std::size_t pairs) {
      return now.variances[i] - slope * (per_pair(now.pairs) - per_pair(pairs));
    };
    // Noise of the two sigmas may lead below what so many pairs would tell if all of it averaged out.
    const double floor = now.variances[i] * static_cast<double>(now.pairs) * per_pair(all);
    const double with_all = std::max(floor, variance_with(all)), with_these = std::max(with_all, variance_with(count));
    const double wider = std::sqrt(with_these / with_all);
    if (wider > least.wider) least = {parameter, with_all / with_these, wider};
  }
  return least;
}

ChosenPairs::ChosenPairs(const PipelineInput& input, const DriveMotion& motion, PipelineOutput& output)
    : taken_(output.pairs.size(), true), taken_count_(output.pairs.size()) {
  if (input.settings.pairing.choice == motion::PairChoice::All || output.pairs.size() <= kFew) return;
  keyframes_ = std::move(output.keyframes);
  pairs_ = std::move(output.pairs);
  std::map<motion::SessionIndex, std::size_t> of_session;
  for (const motion::Pair& pair : pairs_) ++of_session[keyframes_[pair.keyframe_a].session];
  const auto is_decided = [&](const motion::Keyframe& a, const motion::Keyframe& b) {
    return std::ranges::any_of(input.verdicts, [&](const PairVerdict& verdict) {
      return verdict.session == a.session && verdict.stamp_a_ns == a.stamp_ns && verdict.stamp_b_ns == b.stamp_ns;
    });
  };
  for (motion::PairIndex i; i < pairs_.size(); ++i) {
    const motion::Keyframe &a = keyframes_[pairs_[i].keyframe_a], &b = keyframes_[pairs_[i].keyframe_b];
    taken_[i] = of_session[a.session] <= kWholeSession || !motion.session(a.session).scans || is_decided(a, b);
  }
  const calibration::PairwiseInput solver = input_of_all(input, motion, output, keyframes_);
  calibration::expect_registrations(output.initial_ins_from_lidar, pairs_);
  calibration::PairChooser chooser(solver, pairs_, calibration::noise_prior(solver).expected,
                                   output.initial_ins_from_lidar, taken_);
  chooser.take(kFirst);
  taken_ = chooser.taken();
  std::vector<KeyframeObjects> none;
  hand_over(output, none);
}

// What became of those that are taken.
void ChosenPairs::store(const PipelineOutput& output) {
  auto next = output.pairs.begin();
  for (motion::PairIndex i; i < pairs_.size(); ++i) {
    if (!taken_[i]) continue;
    const motion::KeyframeIndex a = pairs_[i].keyframe_a, b = pairs_[i].keyframe_b;
    pairs_[i] = *next++;
    pairs_[i].keyframe_a = a;
    pairs_[i].keyframe_b = b;
  }
}

void ChosenPairs::hand_over(PipelineOutput& output, std::vector<KeyframeObjects>& objects) {
  output.pairs.clear();
  for (motion::PairIndex i; i < pairs_.size(); ++i)
    if (taken_[i]) output.pairs.push_back(pairs_[i]);
  taken_count_ = output.pairs.size();
  std::vector<motion::KeyframeIndex> kept = motion::keyframes_of(output.pairs, keyframes_.size());
  motion::renumber_keyframes(kept, output.pairs);
  output.keyframes.clear();
  std::vector<KeyframeObjects> moved(kept.size());
  for (std::size_t k = 0, before = 0; k < kept.size(); ++k) {
    output.keyframes.push_back(keyframes_[kept[k]]);
    if (before < kept_.size() && kept_[before] == kept[k] && before < objects.size())
      moved[k] = std::move(objects[before++]);
  }
  objects = std::move(moved);
  kept_ = std::move(kept);
}

void ChosenPairs::take_for_sigma(const calibration::PairwiseInput& solver, const calibration::PairwiseDetails& details,
                                 const calibration::CalibrationResult& result, calibration::PairChooser& chooser,
                                 const Progress& progress) {
  const Forecast forecast(solver, pairs_, taken_, details, result, progress);
  // What a few pairs make likely, and more may refute: a lag of the clocks above all.
  if (forecast.in_doubt() && doublings_ < kMostDoublings) {
    ++doublings_;
    chooser.take(taken_count_);
  }
  const std::size_t most = std::min(pairs_.size(), kMostTimes * taken_count_);
  told_ = forecast.told_by(chooser.taken());
  while (told_.wider > kWider && chooser.taken_count() < most && !progress.cancelled()) {
    chooser.take(std::max(kLeastMore, chooser.taken_count() / 4));
    told_ = forecast.told_by(chooser.taken());
  }
}

void ChosenPairs::take_by_trend(const calibration::CalibrationResult& result, calibration::PairChooser& chooser) {
  const SolvedByPairs now = solved_by(taken_count_, result);
  const std::optional<SolvedByPairs> before = std::exchange(solved_before_, now);
  if (!before || before->pairs == now.pairs) {
    chooser.take(taken_count_);  // two solutions make a trend
    return;
  }
  const auto told = [&] { return told_by_trend(*before, now, chooser.taken_count(), pairs_.size()); };
  while (told().wider > kWider && chooser.taken_count() < pairs_.size())
    chooser.take(std::max(kLeastMore, taken_count_ / 8));
  if (told().wider > told_.wider) told_ = told();
}

std::vector<motion::PairIndex> ChosenPairs::take_more(const PipelineInput& input, const DriveMotion& motion,
                                                      const calibration::PairwiseDetails& details,
                                                      PipelineOutput& output, std::vector<KeyframeObjects>& objects,
                                                      const Progress& progress) {
  if (!any_left()) return {};
  store(output);
  const calibration::PairwiseInput solver = input_of_all(input, motion, output, keyframes_);
  const RigidTransform& x = details.joint.ins_from_lidar;
  if (is_moved(motion)) set_ins_motion(solver.nodes, pairs_);
  calibration::expect_registrations(x, pairs_);
  calibration::PairChooser chooser(solver, pairs_, details.noise, x, taken_);
  if (calibration::is_solved(output.result.status)) {
    take_for_sigma(solver, details, output.result, chooser, progress);
    if (!solver.beams.empty()) take_by_trend(output.result, chooser);
  } else {
    chooser.take((kMostTimes - 1) * taken_count_);
  }
  const std::vector<bool>& chosen = chooser.taken();
  std::vector<motion::PairIndex> fresh;
  motion::PairIndex place;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (chosen[i] && !taken_[i]) fresh.push_back(place);
    if (chosen[i]) ++place;
  }
  if (fresh.empty() || progress.cancelled()) return {};
  taken_ = chosen;
  hand_over(output, objects);
  return fresh;
}

Message ChosenPairs::so_far(const calibration::CalibrationResult& result) const {
  std::vector<Message> values;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const calibration::Estimate estimate = result.estimate(parameter);
    if (!estimate.sigma) continue;
    const Message word = calibration::parameter_word(parameter);
    values.push_back(calibration::is_angle(parameter)
                         ? say::pipeline_angle_so_far(word, Angle{estimate.value}, Angle{*estimate.sigma})
                         : say::pipeline_length_so_far(word, Length{estimate.value}, Length{*estimate.sigma}));
  }
  return say::pipeline_so_far(taken_count_, pairs_.size(), std::move(values));
}

void ChosenPairs::report(std::vector<drive::Finding>& findings) const {
  if (!any_left()) return;
  findings.push_back(
      {drive::Severity::Note, results::kPairsChosen, say::place_calibration(),
       say::pipeline_pairs_chosen(taken_count_, pairs_.size(), Share{told_.share},
                                  calibration::parameter_word(told_.parameter), Share{1.0 - 1.0 / told_.wider})});
}

}  // namespace remount::pipeline
