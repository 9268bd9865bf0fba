#include "app/gui/workbench/workbench.h"

#include <algorithm>
#include <utility>

#include "algorithms/core/error.h"
#include "app/gui/jobs/error_words.h"
#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/wording.h"
#include "model/pipeline/keep_finished.h"
#include "widgets/forms/option_changes.h"
#include "widgets/text/model_text.h"
#include "widgets/text/option_access.h"
#include "widgets/text/pair_counts.h"

namespace remount {

Workbench::Workbench(Engine engine, QObject* parent)
    : Workbench(std::move(engine), std::make_unique<LockKeeper>(), parent) {}

Workbench::Workbench(Engine engine, std::unique_ptr<LockKeeper> locks, QObject* parent)
    : QObject(parent), engine_(std::move(engine)), locks_(std::move(locks)) {
  qRegisterMetaType<CloudsPtr>();
  constexpr int kMostSteps = 1000;  // those that hold calibrations and closed sessions cost memory
  undo_.setUndoLimit(kMostSteps);
  connect(&jobs_, &JobRunner::progressed, this,
          [this](int job, const Message& stage, qulonglong done, qulonglong total) {
            if (job == run_job_ && stage != stage_) {
              stage_ = stage;
              emit state_changed();
            }
            if (job == run_job_ || job == open_job_) emit job_progressed(stage, done, total);
          });
  connect(this, &Workbench::sessions_changed, this, &Workbench::look_over_sessions);
  connect(&jobs_, &JobRunner::finished, this, &Workbench::state_changed);
  connect(&jobs_, &JobRunner::finished, this, [this](int job) {
    if (job == open_job_ && !opening() && !waiting_.empty()) open_all(std::exchange(waiting_, {}));
  });
  connect(&map_pause_, &QTimer::timeout, this, &Workbench::check_map_again);
  map_pause_.setSingleShot(true);
  connect(&beats_, &QTimer::timeout, this, &Workbench::show_life);
  beats_.start(HolderLock::kBeat_ms);
}

QStringList Workbench::session_names() const { return names_of(sessions_); }

PipelineInput Workbench::input_of_next_run() const {
  PipelineInput input;
  input.sessions = sessions_;
  input.settings = settings_;
  input.nominal_ins_from_lidar = nominal_ins_from_lidar_;
  // What a session declares is of the LiDAR in the INS frame: a method with another does without.
  const auto declares_it = [&](const auto& session) {
    return session->nominal_ins_from_lidar && nominal_ins_from_lidar_->isApprox(*session->nominal_ins_from_lidar);
  };
  if (nominal_ins_from_lidar_ && !starts_from_ins(settings_.run.method) &&
      std::any_of(sessions_.begin(), sessions_.end(), declares_it))
    input.nominal_ins_from_lidar.reset();
  return input;
}

QStringList Workbench::changes_since_output() const {
  QStringList changes;
  if (!output_) return changes;
  CalibrationBasis shown = basis_of(solving() ? input_of_next_solve() : run_input_);
  changes << setting_changes(shown.settings, settings_);
  shown.settings = settings_;
  for (const Message& change : changes_since(shown, basis_of(input_of_next_run()))) changes << model_text(change);
  if (data_changed_) changes << tr("other files in the sessions");
  if (incomplete()) changes << tr("decisions about pairs that the solution does not answer in full");
  return changes;
}

JobRunner::Failed Workbench::report_failure() {
  return [this](const JobFailure& failure) { emit message(Severity::Problem, failure.where, failure.what); };
}

bool Workbench::may_calibrate() {
  if (opening() || calibrating()) return false;
  if (sessions_.empty()) {
    emit message(Severity::Warning, {}, tr("There is nothing to calibrate yet: open a recorded session first."));
    return false;
  }
  const PipelineInput input = input_of_next_run();
  Message nominal = nominal_problem(input.nominal_ins_from_lidar, settings_.range);
  if (input.nominal_ins_from_lidar && nominal.empty())
    nominal = frame_problem(input.nominal_frames, settings_.run.method, sessions_);
  if (!nominal.empty()) {
    emit message(Severity::Problem, tr("Nominal mounting"), model_text(nominal));
    return false;
  }
  const std::vector<Message> problems = settings_.check();
  if (!problems.empty()) {
    QStringList lines;
    for (const Message& problem : problems) lines << model_text(problem);
    emit message(Severity::Problem, tr("Options"), lines.join('\n'));
    return false;
  }
  return true;
}

void Workbench::calibrate() {
  if (!may_calibrate()) return;
  for (const int job : {solve_job_, map_job_}) jobs_.cancel(job);
  solve_job_ = map_job_ = 0;
  map_pause_.stop();
  PipelineInput input = input_of_next_run();
  input.verdicts = verdicts();
  stage_ = {};
  emit message(Severity::Note, {}, tr("Calibration started"));
  run_job_ = jobs_.start(
      [this, input, engine = engine_, decisions = decisions_](Progress& progress) -> JobRunner::Deliver {
        const auto output = std::make_shared<PipelineOutput>(run_without_map_check(engine, input, progress));
        if (output->result.status == Status::Cancelled)
          return [this, input, output] { take_cancelled_run(input, output); };
        return [this, input, output, decisions] {
          if (input.sessions != sessions_) return drop_run();
          const bool redecided = catch_up(decisions, *output);
          take_run(input, output);
          if (!redecided || output->pairs.empty()) return;
          output_solved_ = nullptr;  // whole, but for the decisions
          whole_run_.reset();
          start_solve(tr("decisions during the calibration"), FirstAnswer::None);
        };
      },
      [this](const JobFailure& failure) {
        emit message(Severity::Problem, failure.where, failure.what);
        resume_solving();
      });
  emit state_changed();
}

void Workbench::take_cancelled_run(const PipelineInput& input, const std::shared_ptr<PipelineOutput>& output) {
  if (input.sessions != sessions_) return drop_run();
  if (output_) {  // a complete result is not given up for part of another
    emit message(Severity::Warning, tr("Cancelled"),
                 tr("The result that was there before is kept. %1 of %2 pairs were aligned anew by then; they are left "
                    "out.")
                     .arg(count_pairs(*output).aligned)
                     .arg(output->pairs.size()));
    return resume_solving();
  }
  const std::size_t finished = keep_finished(input, *output);
  if (finished == 0) {
    emit message(Severity::Note, {}, tr("Cancelled before there was anything that could be kept."));
    return resume_solving();
  }
  withdraw_verdicts(*output);
  apply_verdicts(verdicts(), *output);
  take_run(input, output);
  whole_run_.reset();
  output_solved_ = nullptr;
  start_solve(tr("cancelled calibration"), FirstAnswer::None);
  emit message(
      Severity::Warning, tr("Cancelled"),
      tr("%1 of %2 pairs were aligned by then; they are kept, and solved.").arg(finished).arg(output->pairs.size()));
}

void Workbench::take_run(const PipelineInput& input, OutputPtr output) {
  const CalibratedPtr before = output_ || undo_.canUndo() ? calibrated() : nullptr;
  const int selected = same_pair(run_input_, output_.get(), selected_, input, *output);
  run_input_ = input;
  output_before_ = output_solved_;
  moved_by_.clear();
  output_ = output_solved_ = std::move(output);
  whole_run_ = WholeRun{input, output_, decisions_};
  data_changed_ = confirmed_ = false;
  exported_ = Exported::No;
  ++solution_;
  for (const Finding& finding : output_->findings)
    emit logged(finding.severity, model_text(finding.where.words()), model_text(finding.explanation));
  emit message(Severity::Note, tr("Result"), model_text(output_->result.message));
  keep_what_was(before);
  emit output_changed();
  selected_ = -1;
  select_pair(selected);
  check_map_soon();
  hash_input_files();
  mark_edited();
}

void Workbench::hash_input_files() {
  jobs_.cancel(hash_job_);
  input_files_.clear();
  auto job = std::make_shared<int>(0);
  hash_job_ = jobs_.start(
      [this, job, sessions = run_input_.sessions](Progress& progress) -> JobRunner::Deliver {
        std::vector<InputFile> files = hash_inputs(sessions, 1, progress);
        const bool whole = !progress.cancelled();
        return [this, job, whole, files = std::move(files)] {
          if (!whole || *job != hash_job_) return;
          input_files_ = files;
          mark_edited();
        };
      },
      report_failure());
  *job = hash_job_;
}

void Workbench::cancel() {
  waiting_.clear();
  for (int job : {open_job_, run_job_, solve_job_}) jobs_.cancel(job);
}

void Workbench::select_pair(int pair) {
  if (!output_ || pair < 0 || static_cast<std::size_t>(pair) >= output_->pairs.size()) pair = -1;
  if (pair == selected_ && pair >= 0) return;
  selected_ = pair;
  emit selection_changed(pair);
  load_clouds();
}

void Workbench::load_clouds() {
  jobs_.cancel(cloud_job_);
  cloud_job_ = 0;
  if (selected_ < 0) return;
  const int pair = selected_;
  emit clouds_loading(pair);
  // run_input_, not the present settings: the clouds are to look as they were when they were aligned.
  auto job = std::make_shared<int>(0);
  cloud_job_ = jobs_.start(
      [this, job, pair, input = run_input_, output = output_,
       load = engine_.load_pair_clouds](Progress&) -> JobRunner::Deliver {
        auto clouds = std::make_shared<const PairClouds>(load(input, *output, pair));
        return [this, job, pair, clouds] {
          if (*job == cloud_job_) emit clouds_loaded(pair, clouds);
        };
      },
      [this, job, pair](const JobFailure& failure) {
        if (*job == cloud_job_) emit clouds_failed(pair, in_words(failure));
      });
  *job = cloud_job_;
}

void Workbench::edit_option(const QString& section, const QString& name, const QVariant& value) {
  Settings changed = settings_;
  if (!set_option(changed, section, name, value)) return;
  undo_.push(new SettingsCommand(*this, tr("change %1").arg(option_label(changed, section, name)), section + '.' + name,
                                 changed));
}

void Workbench::reset_range() {
  Settings changed = settings_;
  changed.range = SearchRange{};
  undo_.push(new SettingsCommand(*this, tr("reset the search range"), {}, changed));
}

void Workbench::reset_settings() {
  undo_.push(new SettingsCommand(*this, tr("restore default options"), {}, Settings{}));
}

void Workbench::apply_settings(const Settings& settings, const QString& step) {
  settings_ = settings;
  emit settings_changed();
  mark_edited();
  if (!output_) return;
  // An option that only a whole calibration obeys needs no new solution; one under way may hold an earlier edit.
  const bool solvable = solving() || !changes_since(basis_of(run_input_), basis_of(input_of_next_solve())).empty();
  if (solvable && settings_.check().empty() && !return_to_run(step)) start_solve(step, FirstAnswer::Ranking);
  emit state_changed();
}

void Workbench::edit_nominal(const std::optional<RigidTransform>& ins_from_lidar) {
  undo_.push(new NominalCommand(*this, tr("change the nominal mounting"), ins_from_lidar));
}

void Workbench::use_result_as_nominal() {
  if (!output_ || !is_usable(output_->result)) return;
  if (const Message problem = not_in_ins_frame(output_->result.mounting.frames()); !problem.empty())
    emit message(Severity::Problem, tr("Nominal mounting"), model_text(problem));
  else
    edit_nominal(output_->result.mounting.ins_from_lidar());
}

void Workbench::apply_nominal(const std::optional<RigidTransform>& ins_from_lidar) {
  nominal_ins_from_lidar_ = ins_from_lidar;
  emit nominal_changed();
  emit state_changed();
  mark_edited();
}

void Workbench::confirm(bool good) {
  if (confirmed_ == good) return;
  confirmed_ = good;
  emit logged(Severity::Note, {}, good ? tr("result confirmed") : tr("confirmation of the result taken back"));
  emit state_changed();
  mark_edited();
}

void Workbench::mark_exported(Exported how) {
  const bool written = how == Exported::Written && exported_ != how;
  exported_ = std::max(exported_, how);
  emit state_changed();
  if (written) mark_edited();
}

}  // namespace remount
