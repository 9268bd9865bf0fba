// The user's decisions about pairs, and the new solutions they lead to.
#include <algorithm>
#include <optional>

#include "algorithms/motion/pair.h"
#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/wording.h"
#include "app/gui/workbench/workbench.h"
#include "messages/decisions.h"
#include "model/pipeline/first_answer.h"
#include "model/results/result_words.h"
#include "widgets/text/model_text.h"
#include "widgets/text/pair_reasons.h"

namespace remount {
namespace {

void set_decision(Pair& pair, const PairDecision& decision) {
  pair.state = decision.state;
  pair.decided_by = decision.decided_by;
  pair.reason = decision.reason;
}

PairDecision user_decision(int pair, PairState state, Message reason) {
  if (reason.empty()) reason = state == PairState::Accepted ? say::accepted_by_the_user() : say::rejected_by_the_user();
  return {pair, state, DecidedBy::User, std::move(reason)};
}

/// "reject pair 12: moving objects".
QString step_name(const std::vector<PairDecision>& decisions, PairState state, const Message& reason) {
  const int count = static_cast<int>(decisions.size()), pair = decisions.front().pair;
  const QString step =
      state == PairState::Accepted
          ? (count == 1 ? Workbench::tr("accept pair %1").arg(pair) : Workbench::tr("accept %1 pairs").arg(count))
          : (count == 1 ? Workbench::tr("reject pair %1").arg(pair) : Workbench::tr("reject %1 pairs").arg(count));
  return reason.empty() ? step : step + QStringLiteral(": ") + reason_words(reason);
}

/// What a new solution from the pairs that are there takes over: the search range, and the solution's options but for
/// those that only a whole calibration obeys.
Settings solved_again_with(const Settings& of_pairs, const Settings& now) {
  Settings settings = of_pairs;
  settings.range = now.range;
  settings.solve = now.solve;
  settings.solve.joint_clouds = of_pairs.solve.joint_clouds;
  return settings;
}

/// A solution from the pairs that are there, and what it is compared with.
struct SolveTask {
  PipelineInput input, input_before;
  OutputPtr output, before;  ///< before: the last whole solution, or null
  /// A solution from the pairs cannot be compared with one whose clouds were aligned together: what that last step
  /// changed would pass for the effect of a decision. Then what was before is solved from its pairs as well.
  bool unlike = false;
};

struct Answer {
  std::shared_ptr<PipelineOutput> now;
  OutputPtr before;
};

/// `x`, moved as far as `to` is from `from`, each parameter by itself: one that is held stays as it is.
RigidTransform moved_alike(const RigidTransform& x, const RigidTransform& from, const RigidTransform& to) {
  const SixParameters was = six_from_rigid(from), is = six_from_rigid(to);
  SixParameters six = six_from_rigid(x);
  six.x_m += is.x_m - was.x_m;
  six.y_m += is.y_m - was.y_m;
  six.z_m += is.z_m - was.z_m;
  six.yaw_rad += is.yaw_rad - was.yaw_rad;
  six.pitch_rad += is.pitch_rad - was.pitch_rad;
  six.roll_rad += is.roll_rad - was.roll_rad;
  return rigid_from_six(six);
}

/// X, residuals and counts; nothing where they cannot be had at once. What is solved at once differs a little from the
/// whole solution: what was before is solved so as well, and X moves by the difference of the two.
std::optional<Answer> answer_at_once(const SolveTask& task, const Engine& engine, Progress& progress) {
  if (!task.before || !engine.solve_at_once) return {};
  auto like = std::make_shared<PipelineOutput>(*task.before);
  if (!engine.solve_at_once(task.input_before, *like, progress)) return {};
  auto answer = std::make_shared<PipelineOutput>(*task.output);
  if (!engine.solve_at_once(task.input, *answer, progress)) return {};
  const RigidTransform& moved = answer->result.mounting.ins_from_lidar();
  answer_with(moved_alike(task.before->result.mounting.ins_from_lidar(), like->result.mounting.ins_from_lidar(), moved),
              *answer);
  return Answer{answer, task.before};
}

/// Nothing where cancelled.
std::optional<Answer> answer_in_full(const SolveTask& task, const Engine& engine, Progress& progress) {
  Answer answer{std::make_shared<PipelineOutput>(*task.output), task.before};
  if (!engine.solve_again(task.input, *answer.now, progress)) return {};
  if (!task.unlike) return answer;
  auto like = std::make_shared<PipelineOutput>(*task.before);
  if (!engine.solve_again(task.input_before, *like, progress)) return {};
  answer.before = like;
  return answer;
}

}  // namespace

PipelineInput Workbench::input_of_next_solve() const {
  PipelineInput input = run_input_;
  input.settings = solved_again_with(run_input_.settings, settings_);
  return input;
}

Workbench::DecisionKey Workbench::key_of(const PipelineInput& input, const PipelineOutput& output, const Pair& pair) {
  const Keyframe& a = output.keyframes.at(static_cast<std::size_t>(pair.keyframe_a));
  const Keyframe& b = output.keyframes.at(static_cast<std::size_t>(pair.keyframe_b));
  return {input.sessions.at(static_cast<std::size_t>(a.session))->path.string(), a.stamp_ns, b.stamp_ns};
}

int Workbench::same_pair(const PipelineInput& input_before, const PipelineOutput* before, int selected,
                         const PipelineInput& input, const PipelineOutput& output) {
  const int first = output.pairs.empty() ? -1 : 0;
  if (!before || selected < 0 || selected >= std::ssize(before->pairs)) return first;
  const DecisionKey wanted = key_of(input_before, *before, before->pairs[static_cast<std::size_t>(selected)]);
  const auto found = std::find_if(output.pairs.begin(), output.pairs.end(),
                                  [&](const Pair& pair) { return key_of(input, output, pair) == wanted; });
  return found == output.pairs.end() ? first : static_cast<int>(found - output.pairs.begin());
}

bool Workbench::catch_up(const Decisions& carried, PipelineOutput& output) const {
  if (decisions_ == carried) return false;
  withdraw_verdicts(output);
  apply_verdicts(verdicts(), output);
  return true;
}

void Workbench::decide(const std::vector<int>& pairs, PairState state, const Message& reason, const QString& step) {
  if (!output_ || calibrating()) return;
  std::vector<PairDecision> before, after;
  QStringList refused;
  for (int index : pairs) {
    if (index < 0 || index >= std::ssize(output_->pairs)) continue;  // of a chart that shows the pairs before still
    const Pair& pair = output_->pairs[static_cast<std::size_t>(index)];
    const PairDecision decision = user_decision(index, state, reason);
    if (pair.state == state && pair.decided_by == DecidedBy::User && (reason.empty() || pair.reason == decision.reason))
      continue;
    if (const Message why = unusable_reason(pair); state == PairState::Accepted && !why.empty()) {
      refused << tr("pair %1: %2").arg(index).arg(model_text(why));
      continue;
    }
    before.push_back({index, pair.state, pair.decided_by, pair.reason});
    after.push_back(decision);
  }
  if (!refused.isEmpty())
    emit message(Severity::Warning, tr("Cannot be accepted, for no solution can use it"),
                 in_short(refused, QStringLiteral("\n")));
  if (after.empty()) return;
  const QString text = step.isEmpty() ? step_name(after, state, reason) : step;
  undo_.push(new DecisionCommand(*this, text, std::move(before), std::move(after)));
}

void Workbench::apply_decisions(const std::vector<PairDecision>& decisions, const QString& step) {
  if (!output_) return;
  auto changed = std::make_shared<PipelineOutput>(*output_);
  bool counts = solving() || incomplete();  // a solution under way holds the reasons of before
  for (const PairDecision& decision : decisions) {
    Pair& pair = changed->pairs.at(static_cast<std::size_t>(decision.pair));
    counts |= pair.state != decision.state || pair.decided_by != decision.decided_by;
    set_decision(pair, decision);
    const DecisionKey key = key_of(run_input_, *changed, pair);
    if (decision.decided_by == DecidedBy::User)
      decisions_[key] = {decision.state, decision.reason};
    else
      decisions_.erase(key);
  }
  output_ = std::move(changed);
  emit logged(Severity::Note, {}, step);
  if (counts) {
    if (!return_to_run(step)) start_solve(step, FirstAnswer::Moved);
  } else {
    output_solved_ = output_;  // the reasons are other words for the same
    check_map_soon();
  }
  emit output_changed();
  mark_edited();
}

void Workbench::start_solve(const QString& step, FirstAnswer first) {
  // What no pairs stand behind cannot be solved again from them.
  if (!output_ || output_->pairs.empty() || calibrating()) return;
  if (!solving() || solving_for_.isEmpty())
    solving_for_ = step;
  else if (!solving_for_.endsWith(step))  // turning one knob is one edit
    solving_for_ += QStringLiteral("; ") + step;
  refining_ = false;
  for (const int job : {solve_job_, map_job_}) jobs_.cancel(job);
  map_pause_.stop();
  auto job = std::make_shared<int>(0);
  // What an earlier solution delivers after a later one was begun is dropped.
  const auto if_last = [this, job](auto take) {
    return [this, job, take] {
      if (*job == solve_job_) take();
    };
  };
  solve_job_ = jobs_.start(
      [this, if_last, first, engine = engine_,
       task = SolveTask{input_of_next_solve(), run_input_, output_, output_solved_,
                        output_solved_ && is_aligned_together(output_solved_->result)}](
          Progress& progress) -> JobRunner::Deliver {
        if (first == FirstAnswer::Moved)
          if (const auto answer = answer_at_once(task, engine, progress))
            jobs_.post(if_last([this, answer = *answer] { take_first_answer(answer.now, answer.before); }));
        if (first == FirstAnswer::Ranking && is_usable(task.output->result)) {
          auto ranked = std::make_shared<PipelineOutput>(*task.output);
          rank_again(task.input, *ranked);
          jobs_.post(if_last([this, ranked] { take_ranking(ranked); }));
        }
        const auto answer = answer_in_full(task, engine, progress);
        if (!answer) return [] {};
        return if_last([this, answer = *answer, settings = task.input.settings] {
          take_solution(answer.now, answer.before, settings);
        });
      },
      report_failure());
  *job = solve_job_;
  emit state_changed();
}

bool Workbench::return_to_run(const QString& step) {
  if (!whole_run_ || whole_run_->decisions != decisions_ || calibrating()) return false;
  if (!changes_since(basis_of(whole_run_->input), basis_of(input_of_next_solve())).empty()) return false;
  for (const int job : {solve_job_, map_job_}) jobs_.cancel(job);
  solve_job_ = 0;
  refining_ = false;
  solving_for_ = step;
  // What aligning the clouds changed is not the effect of this step.
  const OutputPtr before = is_aligned_together(whole_run_->output->result) ? nullptr : output_solved_;
  take_solution(whole_run_->output, before, whole_run_->input.settings);
  emit state_changed();
  return true;
}

void Workbench::use_clock_offset(bool with_it) {
  // What was left out by choice comes back where it is clear; what was not clear is to be applied all the same.
  const bool left_out = settings_.solve.apply_time_offset == ClockOffsetUse::No;
  const ClockOffsetUse use = !with_it ? ClockOffsetUse::No : left_out ? ClockOffsetUse::Auto : ClockOffsetUse::Yes;
  edit_option(QStringLiteral("solve"), QStringLiteral("apply_time_offset"), static_cast<int>(use));
}

void Workbench::resume_solving() {
  if (output_ && incomplete()) start_solve(solving_for_, FirstAnswer::None);
  check_map_soon();
}

void Workbench::take_ranking(OutputPtr answer) {
  output_ = std::move(answer);
  ++solution_;
  emit output_changed();
}

void Workbench::take_solution(OutputPtr solved, OutputPtr before, const Settings& settings) {
  output_before_ = std::move(before);
  moved_by_ = solving_for_;
  output_ = output_solved_ = std::move(solved);
  run_input_.settings = settings;
  exported_ = Exported::No;
  confirmed_ = false;
  ++solution_;
  check_map_soon();
  emit output_changed();
  mark_edited();
}

void Workbench::take_first_answer(OutputPtr answer, OutputPtr before) {
  output_ = std::move(answer);
  output_before_ = std::move(before);
  moved_by_ = solving_for_;
  exported_ = Exported::No;
  confirmed_ = false;
  ++solution_;
  refining_ = true;
  emit output_changed();
  emit state_changed();
}

}  // namespace remount
