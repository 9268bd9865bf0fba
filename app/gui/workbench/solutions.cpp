#include "app/gui/workbench/solutions.h"

#include <optional>

#include "model/pipeline/first_answer.h"
#include "model/results/result_words.h"

namespace remount::gui {

/// A solution from the pairs that are there, and what it is compared with.
struct SolveTask {
  pipeline::PipelineInput input, input_before;
  OutputPtr output, before;  ///< before: the last whole solution, or null
  /// A solution from the pairs cannot be compared with one whose clouds were aligned together: what that last step
  /// changed would pass for the effect of a decision. Then what was before is solved from its pairs as well.
  bool unlike = false;
};

namespace {

struct Answer {
  std::shared_ptr<pipeline::PipelineOutput> now;
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
  auto like = std::make_shared<pipeline::PipelineOutput>(*task.before);
  if (!engine.solve_at_once(task.input_before, *like, progress)) return {};
  auto answer = std::make_shared<pipeline::PipelineOutput>(*task.output);
  if (!engine.solve_at_once(task.input, *answer, progress)) return {};
  const RigidTransform& moved = answer->result.mounting.ins_from_lidar();
  pipeline::answer_with(
      moved_alike(task.before->result.mounting.ins_from_lidar(), like->result.mounting.ins_from_lidar(), moved),
      *answer);
  return Answer{answer, task.before};
}

/// Nothing where cancelled.
std::optional<Answer> answer_in_full(const SolveTask& task, const Engine& engine, Progress& progress) {
  Answer answer{std::make_shared<pipeline::PipelineOutput>(*task.output), task.before};
  if (!engine.solve_again(task.input, *answer.now, progress)) return {};
  if (!task.unlike) return answer;
  auto like = std::make_shared<pipeline::PipelineOutput>(*task.before);
  if (!engine.solve_again(task.input_before, *like, progress)) return {};
  answer.before = like;
  return answer;
}

}  // namespace

settings::Settings solved_again_with(const settings::Settings& of_pairs, const settings::Settings& now) {
  settings::Settings settings = of_pairs;
  settings.range = now.range;
  settings.solve = now.solve;
  settings.solve.joint_clouds = of_pairs.solve.joint_clouds;
  return settings;
}

Solutions::Solutions(const Desk& desk, Setup& setup, Outcome& outcome, Decisions& decisions, MapChecks& map_checks)
    : WorkbenchPart(desk), setup_(setup), outcome_(outcome), decisions_(decisions), map_checks_(map_checks) {
  connect(&decisions_, &Decisions::applied, this, &Solutions::answer_decisions);
  connect(&setup_, &Setup::settings_applied, this, &Solutions::answer_settings);
}

pipeline::PipelineInput Solutions::input_of_next() const {
  pipeline::PipelineInput input = outcome_.input();
  input.settings = solved_again_with(outcome_.input().settings, setup_.settings());
  return input;
}

void Solutions::answer_decisions(const QString& step, bool counts) {
  if (counts) {
    if (!return_to_run(step)) start(step, FirstAnswer::Moved);
  } else {
    outcome_.count_as_solved();
    map_checks_.begin_soon();
  }
}

void Solutions::answer_settings(const QString& step) {
  if (!outcome_.output()) return;
  // An option that only a whole calibration obeys needs no new solution; one under way may hold an earlier edit.
  const bool solvable =
      desk_.activity.solving() ||
      !project::changes_since(project::basis_of(outcome_.input()), project::basis_of(input_of_next())).empty();
  if (solvable && setup_.settings().check().empty() && !return_to_run(step)) start(step, FirstAnswer::Ranking);
  emit state_changed();
}

void Solutions::name_step(const QString& step) {
  if (!desk_.activity.solving() || solving_for_.isEmpty())
    solving_for_ = step;
  else if (!solving_for_.endsWith(step))  // turning one knob is one edit
    solving_for_ += QStringLiteral("; ") + step;
}

void Solutions::start(const QString& step, FirstAnswer first) {
  // What no pairs stand behind cannot be solved again from them.
  if (!outcome_.output() || outcome_.output()->pairs.empty() || desk_.activity.calibrating()) return;
  name_step(step);
  refining_ = false;
  desk_.activity.cancel(Activity::Kind::Solving);
  map_checks_.stop();
  const OutputPtr solved = outcome_.solved();
  desk_.activity.start(
      Activity::Kind::Solving,
      [this, first, turn = desk_.activity.next_turn(Activity::Kind::Solving), engine = desk_.engine,
       task = SolveTask{input_of_next(), outcome_.input(), outcome_.output(), solved,
                        solved && results::is_aligned_together(solved->result)}](Progress& progress) {
        return work(task, engine, first, turn, progress);
      },
      desk_.notices.report_failure());
}

JobRunner::Deliver Solutions::work(const SolveTask& task, const Engine& engine, FirstAnswer first, int turn,
                                   Progress& progress) {
  if (first == FirstAnswer::Moved)
    if (const auto answer = answer_at_once(task, engine, progress))
      desk_.jobs.post(if_last(turn, [this, answer = *answer] { take_first_answer(answer.now, answer.before); }));
  if (first == FirstAnswer::Ranking && calibration::is_usable(task.output->result)) {
    auto ranked = std::make_shared<pipeline::PipelineOutput>(*task.output);
    pipeline::rank_again(task.input, *ranked);
    desk_.jobs.post(if_last(turn, [this, ranked] { take_ranking(ranked); }));
  }
  const auto answer = answer_in_full(task, engine, progress);
  if (!answer) return [] {};
  return if_last(turn, [this, answer = *answer, settings = task.input.settings] {
    take_solution(answer.now, answer.before, settings);
  });
}

JobRunner::Deliver Solutions::if_last(int turn, const std::function<void()>& take) const {
  return [this, turn, take] {
    if (desk_.activity.is_last(Activity::Kind::Solving, turn)) take();
  };
}

bool Solutions::return_to_run(const QString& step) {
  const std::optional<WholeRun>& run = outcome_.whole_run();
  if (!run || run->decisions != decisions_.made() || desk_.activity.calibrating()) return false;
  if (!project::changes_since(project::basis_of(run->input), project::basis_of(input_of_next())).empty()) return false;
  desk_.activity.drop(Activity::Kind::Solving);
  desk_.activity.cancel(Activity::Kind::CheckingMap);
  refining_ = false;
  solving_for_ = step;
  // What aligning the clouds changed is not the effect of this step.
  const OutputPtr before = results::is_aligned_together(run->output->result) ? nullptr : outcome_.solved();
  take_solution(run->output, before, run->input.settings);
  emit state_changed();
  return true;
}

void Solutions::resume() {
  if (outcome_.output() && incomplete()) solve(solving_for_);
  map_checks_.begin_soon();
}

void Solutions::take_ranking(OutputPtr answer) {
  outcome_.take_ranking(std::move(answer));
  outcome_.announce();
}

void Solutions::take_solution(OutputPtr solved, OutputPtr before, const settings::Settings& settings) {
  outcome_.take_solution(std::move(solved), std::move(before), settings, solving_for_);
  map_checks_.begin_soon();
  outcome_.announce();
  emit edited();
}

void Solutions::take_first_answer(OutputPtr answer, OutputPtr before) {
  outcome_.take_first_answer(std::move(answer), std::move(before), solving_for_);
  refining_ = true;
  outcome_.announce();
  emit state_changed();
}

}  // namespace remount::gui
