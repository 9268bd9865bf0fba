#include "app/gui/workbench/calibrations.h"

#include <algorithm>

#include "app/gui/workbench/edit_commands.h"
#include "model/pipeline/keep_finished.h"
#include "model/project/project.h"
#include "widgets/forms/option_changes.h"
#include "widgets/text/model_text.h"
#include "widgets/text/pair_counts.h"

namespace remount::gui {

pipeline::PipelineInput Calibrations::input_of_next() const {
  pipeline::PipelineInput input;
  input.sessions = parts_.sessions.all();
  input.settings = parts_.setup.settings();
  const std::optional<RigidTransform>& nominal = parts_.setup.nominal_ins_from_lidar();
  input.nominal_ins_from_lidar = nominal;
  // What a session declares is of the LiDAR in the INS frame: a method with another does without.
  const auto declares_it = [&](const auto& session) {
    return session->nominal_ins_from_lidar && nominal->isApprox(*session->nominal_ins_from_lidar);
  };
  if (nominal && !results::starts_from_ins(*input.settings.run.method) &&
      std::any_of(input.sessions.begin(), input.sessions.end(), declares_it))
    input.nominal_ins_from_lidar.reset();
  return input;
}

QStringList Calibrations::changes_since_output() const {
  QStringList changes;
  if (!parts_.outcome.output()) return changes;
  project::CalibrationBasis shown =
      project::basis_of(desk_.activity.solving() ? parts_.solutions.input_of_next() : parts_.outcome.input());
  changes << widgets::setting_changes(shown.settings, parts_.setup.settings());
  shown.settings = parts_.setup.settings();
  for (const Message& change : project::changes_since(shown, project::basis_of(input_of_next())))
    changes << widgets::model_text(change);
  if (parts_.outcome.data_changed()) changes << tr("other files in the sessions");
  if (parts_.solutions.incomplete()) changes << tr("decisions about pairs that the solution does not answer in full");
  return changes;
}

bool Calibrations::is_of_output(const drive::Session& session) const {
  const std::vector<SessionPtr>& of = parts_.outcome.input().sessions;
  return parts_.outcome.output() &&
         std::any_of(of.begin(), of.end(), [&](const auto& one) { return one.get() == &session; });
}

bool Calibrations::may_calibrate() {
  if (desk_.activity.opening() || desk_.activity.calibrating()) return false;
  if (parts_.sessions.empty()) {
    desk_.notices.say(drive::Severity::Warning, {},
                      tr("There is nothing to calibrate yet: open a recorded session first."));
    return false;
  }
  const pipeline::PipelineInput input = input_of_next();
  Message nominal = settings::nominal_problem(input.nominal_ins_from_lidar, input.settings.range);
  if (input.nominal_ins_from_lidar && nominal.empty())
    nominal = results::frame_problem(input.nominal_frames, *input.settings.run.method, input.sessions);
  if (!nominal.empty()) {
    desk_.notices.say(drive::Severity::Problem, tr("Nominal mounting"), widgets::model_text(nominal));
    return false;
  }
  const std::vector<Message> problems = input.settings.check();
  if (!problems.empty()) {
    QStringList lines;
    for (const Message& problem : problems) lines << widgets::model_text(problem);
    desk_.notices.say(drive::Severity::Problem, tr("Options"), lines.join('\n'));
    return false;
  }
  return true;
}

void Calibrations::calibrate() {
  if (!may_calibrate()) return;
  parts_.map_checks.stop();
  for (const auto kind : {Activity::Kind::Solving, Activity::Kind::CheckingMap}) desk_.activity.drop(kind);
  pipeline::PipelineInput input = input_of_next();
  input.verdicts = parts_.decisions.verdicts();
  desk_.notices.say(drive::Severity::Note, {}, tr("Calibration started"));
  desk_.activity.start(
      Activity::Kind::Calibrating,
      [this, input, turn = desk_.activity.next_turn(Activity::Kind::Calibrating), engine = desk_.engine,
       decisions = parts_.decisions.made()](Progress& progress) {
        return work(input, turn, engine, decisions, progress);
      },
      [this](const JobFailure& failure) {
        desk_.notices.say(drive::Severity::Problem, failure.where, failure.what);
        parts_.solutions.resume();
      });
}

JobRunner::Deliver Calibrations::work(const pipeline::PipelineInput& input, int turn, const Engine& engine,
                                      const KeptVerdicts& decisions, Progress& progress) {
  pipeline::PipelineInput telling = input;
  telling.tell_so_far = [this, turn](const Message& x) {
    desk_.jobs.post([this, turn, x] {
      if (!desk_.activity.is_last(Activity::Kind::Calibrating, turn)) return;
      desk_.activity.take_so_far(x);
      desk_.notices.log(drive::Severity::Note, {}, widgets::model_text(x));
    });
  };
  const auto output = std::make_shared<pipeline::PipelineOutput>(run_without_map_check(engine, telling, progress));
  if (output->result.status == calibration::Status::Cancelled)
    return [this, input, output] { take_cancelled_run(input, output); };
  return [this, input, output, decisions] { take_whole_run(input, output, decisions); };
}

void Calibrations::take_whole_run(const pipeline::PipelineInput& input,
                                  const std::shared_ptr<pipeline::PipelineOutput>& output,
                                  const KeptVerdicts& decisions) {
  if (input.sessions != parts_.sessions.all()) return drop_run();
  const bool redecided = parts_.decisions.made() != decisions;  // they may have been undone while it ran
  if (redecided) parts_.decisions.impose_on(*output);
  take_run(input, output);
  if (!redecided || output->pairs.empty()) return;
  parts_.outcome.count_as_unsolved();  // whole, but for the decisions
  parts_.solutions.solve(tr("decisions during the calibration"));
}

void Calibrations::take_cancelled_run(const pipeline::PipelineInput& input,
                                      const std::shared_ptr<pipeline::PipelineOutput>& output) {
  if (input.sessions != parts_.sessions.all()) return drop_run();
  if (parts_.outcome.output()) {  // a complete result is not given up for part of another
    desk_.notices.say(
        drive::Severity::Warning, tr("Cancelled"),
        tr("The result that was there before is kept. %1 of %2 pairs were aligned anew by then; they are left "
           "out.")
            .arg(widgets::count_pairs(*output).aligned)
            .arg(output->pairs.size()));
    return parts_.solutions.resume();
  }
  const std::size_t finished = pipeline::keep_finished(input, *output);
  if (finished == 0) {
    desk_.notices.say(drive::Severity::Note, {}, tr("Cancelled before there was anything that could be kept."));
    return parts_.solutions.resume();
  }
  parts_.decisions.impose_on(*output);
  take_run(input, output);
  parts_.outcome.count_as_unsolved();
  parts_.solutions.solve(tr("cancelled calibration"));
  desk_.notices.say(
      drive::Severity::Warning, tr("Cancelled"),
      tr("%1 of %2 pairs were aligned by then; they are kept, and solved.").arg(finished).arg(output->pairs.size()));
}

void Calibrations::take_run(const pipeline::PipelineInput& input, OutputPtr output) {
  Outcome& outcome = parts_.outcome;
  const CalibratedPtr before = outcome.output() || desk_.history.can_undo() ? calibrated() : nullptr;
  const std::optional<motion::PairIndex> selected =
      same_pair(outcome.input(), outcome.output().get(), parts_.selection.pair(), input, *output);
  outcome.take_run(input, std::move(output), parts_.decisions.made());
  const OutputPtr now = outcome.output();
  for (const drive::Finding& finding : now->findings)
    desk_.notices.log(finding.severity, widgets::model_text(finding.where.words()),
                      widgets::model_text(finding.explanation));
  desk_.notices.say(drive::Severity::Note, tr("Result"), widgets::model_text(now->result.message));
  keep_what_was(before);
  outcome.announce();
  parts_.selection.select_anew(selected);
  parts_.map_checks.begin_soon();
  parts_.input_files.hash();
  emit edited();
}

void Calibrations::keep_what_was(const CalibratedPtr& before) {
  if (!before) return desk_.history.clear();  // or redo would put an older calibration in the place of this one
  const OutputPtr now = parts_.outcome.output();
  desk_.history.push(new CalibrationCommand(*this, now->method, before));
  const OutputPtr& was = before->result.output;
  if (was && !was->pairs.empty() && now->pairs.empty())
    desk_.notices.say(drive::Severity::Note, {},
                      tr("This method has no pairs. Those of the calibration before come back by undo (Ctrl+Z), and "
                         "decisions on them hold for the next calibration from pairs."));
}

void Calibrations::drop_run() {
  desk_.notices.say(drive::Severity::Note, {},
                    tr("The calibration was of other sessions or topics than there are now: it is left out. Calibrate "
                       "(F5) for these."));
  parts_.solutions.resume();
}

CalibratedPtr Calibrations::calibrated() const {
  return std::make_shared<const Calibrated>(
      Calibrated{parts_.outcome.now(), parts_.decisions.made(), parts_.selection.pair()});
}

void Calibrations::apply(const CalibratedPtr& calibrated, const QString& step) {
  forget();
  put_back(*calibrated);
  desk_.notices.say(drive::Severity::Note, {}, step);
  announce(calibrated);
}

void Calibrations::stop_for_other_sessions() {
  desk_.activity.cancel(Activity::Kind::Calibrating);  // what it is about is no longer there
  forget();
}

void Calibrations::forget() {
  desk_.activity.drop(Activity::Kind::Solving);
  parts_.input_files.stop();
  parts_.outcome.forget();
  parts_.map_checks.begin_soon();
  parts_.selection.select(std::nullopt);
}

void Calibrations::put_back(const Calibrated& calibrated) {
  parts_.outcome.put(calibrated.result);
  parts_.decisions.put(calibrated.decisions);
}

void Calibrations::announce(const CalibratedPtr& calibrated) {
  parts_.map_checks.begin_soon();
  parts_.outcome.announce();
  emit state_changed();
  if (parts_.outcome.output() && calibrated) {
    parts_.selection.select(calibrated->selected);
    if (parts_.outcome.input_files().empty()) parts_.input_files.hash();
    if (!parts_.outcome.whole()) parts_.solutions.solve(tr("decisions before"));
  }
  emit edited();
}

}  // namespace remount::gui
