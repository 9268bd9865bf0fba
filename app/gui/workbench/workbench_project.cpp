// Projects: everything at once, from and to a file.
#include <algorithm>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "app/gui/workbench/wording.h"
#include "app/gui/workbench/workbench.h"
#include "model/project/project.h"
#include "model/results/result_words.h"
#include "widgets/text/model_text.h"

namespace remount {

/// Everything that a worker found out about a project's file.
struct OpenedProject {
  Project project;  // its sessions as they were found, its output apart
  std::vector<std::shared_ptr<const Session>> sessions;
  std::vector<JobFailure> failures;
  QStringList missing;
  OutputPtr output;
  HolderLock::Attempt lock;
};

namespace {

using LockPtr = std::shared_ptr<const HolderLock>;

/// What is held already is not taken again: a lock does not know that it is asked by its own holder.
HolderLock::Attempt take_lock(const QString& project, const LockPtr& present, bool by_force, LockKeeper& locks) {
  const std::filesystem::path path = lock_path_of(project.toStdString());
  HolderLock::Attempt attempt;
  if (!present || present->path() != path) {
    locks.await(path);
    attempt = HolderLock::take(path, by_force);
    attempt.lock = locks.kept(std::move(attempt.lock));
    return attempt;
  }
  attempt.holder = present->beat();
  if (!attempt.holder) attempt.lock = present;
  return attempt;
}

QString own_path_of(const ProjectToOpen& request) { return request.recovered ? request.belongs_to : request.path; }

/// The lock that goes with what is asked for.
HolderLock::Attempt lock_for(const ProjectToOpen& request, const LockPtr& present, LockKeeper& locks) {
  using Access = ProjectToOpen::Access;
  const QString path = own_path_of(request);
  if (path.isEmpty() || request.access == Access::ReadOnly || request.access == Access::Copy) return {};
  return take_lock(path, present, request.access == Access::TakeOver, locks);
}

/// For saving; null where the file system knows no locks. Throws Error where another window has the project.
LockPtr lock_to_save(const QString& path, const LockPtr& present, LockKeeper& locks) {
  HolderLock::Attempt attempt = take_lock(path, present, false, locks);
  if (attempt.holder)
    throw Error(ErrorCode::Contract, path.toStdString(),
                Workbench::tr("is open in another window: %1.\nSave under another name, or close it there first.")
                    .arg(holder_text(*attempt.holder))
                    .toStdString());
  return attempt.lock;
}

/// Verdicts name sessions by number: of those that are left.
void leave_verdicts_of_missing(const std::vector<std::shared_ptr<const Session>>& sessions, Project& project) {
  std::vector<int> numbers;
  int number = 0;
  for (const auto& session : sessions) numbers.push_back(session ? number++ : -1);
  const auto number_of = [&](const PairVerdict& verdict) {
    const auto session = static_cast<std::size_t>(verdict.session);
    return session < numbers.size() ? numbers[session] : -1;
  };
  std::erase_if(project.verdicts, [&](const PairVerdict& verdict) { return number_of(verdict) < 0; });
  for (PairVerdict& verdict : project.verdicts) verdict.session = number_of(verdict);
}

void open_sessions(const ProjectToOpen& request, OpenedProject& opened, const Engine& engine, Progress& progress) {
  std::vector<std::filesystem::path>& paths = opened.project.sessions;
  std::vector<std::filesystem::path> found = paths;
  for (auto& path : found)
    if (const auto moved = request.moved.find(path.string()); moved != request.moved.end()) path = moved->second;
  std::vector<std::shared_ptr<const Session>> sessions(paths.size());
  std::vector<std::optional<Error>> errors(paths.size());
  parallel_for(paths.size(), 0, [&](std::size_t i) {
    if (progress.cancelled()) return;
    try {
      sessions[i] = std::make_shared<const Session>(engine.open(found[i], opened.project.topics_of(i), progress));
    } catch (const Error& error) {
      errors[i] = error;
    }
  });
  std::error_code none;
  for (std::size_t i = 0; i < paths.size() && !progress.cancelled(); ++i) {
    if (sessions[i]) {
      opened.sessions.push_back(sessions[i]);
      paths[i] = found[i];
    } else if (errors[i]) {
      const Error& error = *errors[i];
      if (!std::filesystem::exists(found[i], none) && !request.without_missing)
        opened.missing << QString::fromStdString(paths[i].string());
      else
        opened.failures.push_back(
            {QString::fromStdString(error.where().empty() ? found[i].string() : error.where()),
             Workbench::tr(
                 "%1\nThe project is opened without this session and without its pairs. Its file is left as it "
                 "is: saving asks for another name.")
                 .arg(model_text(error.what_happened()))});
    }
  }
  leave_verdicts_of_missing(sessions, opened.project);
}

}  // namespace

void write_snapshot(ProjectSnapshot snapshot, const QString& path) {
  if (snapshot.output) snapshot.project.output = *snapshot.output;
  save_project(snapshot.project, path.toStdString());
}

ProjectSnapshot Workbench::snapshot() const {
  ProjectSnapshot snapshot;
  for (const auto& session : sessions_) {
    snapshot.project.sessions.push_back(session->path);
    snapshot.project.topics.push_back(session->topic_choice);
  }
  snapshot.project.verdicts = verdicts();
  snapshot.project.settings = settings_;
  snapshot.project.nominal_ins_from_lidar = nominal_ins_from_lidar_;
  if (output_) snapshot.project.basis = basis_of(run_input_);
  snapshot.project.inputs = input_files_;
  snapshot.output = output_;
  snapshot.project.solution_pending = output_ != output_solved_;
  snapshot.project.confirmed = confirmed_;
  snapshot.project.exported = exported_ == Exported::Written;
  snapshot.revision = revision_;
  return snapshot;
}

void Workbench::set_project(const QString& path, int saved_revision) {
  project_path_ = path;
  saved_revision_ = saved_revision;
  emit project_changed();
}

void Workbench::mark_edited() {
  ++revision_;
  emit project_changed();
}

void Workbench::save_project(const QString& path, std::function<void()> saved) {
  saves_.push_back({path, snapshot(), std::move(saved), project_});
  if (saves_.size() == 1) start_save(nullptr);
}

void Workbench::start_save(const LockPtr& of_last) {
  jobs_.start(
      [this, save = saves_.front(), of_last = of_last, of_project = lock_](Progress&) mutable -> JobRunner::Deliver {
        // Where links lead only the disk knows, which may take its time.
        const bool same = of_last && of_last->path() == lock_path_of(save.path.toStdString());
        const LockPtr lock = lock_to_save(save.path, same ? of_last : of_project, *locks_);
        of_last.reset();  // another save may be waiting for it
        write_snapshot(save.snapshot, save.path);
        return [this, save, lock] {
          if (save.project == project_) hold(lock, false);
          end_save(lock);
          emit message(Severity::Note, save.path, tr("project saved"));
          emit project_saved(save.path);
          if (save.project != project_) return;
          recovered_ = false;
          set_project(save.path, save.snapshot.revision);
          if (save.saved) save.saved();
        };
      },
      [this](const JobFailure& failure) {
        end_save(nullptr);
        emit message(Severity::Problem, failure.where, failure.what);
      });
}

void Workbench::hold(LockPtr lock, bool read_only) {
  lock_ = std::move(lock);
  read_only_ = read_only;
}

void Workbench::show_life() {
  if (!lock_) return;
  jobs_.start(
      [this, lock = lock_](Progress&) -> JobRunner::Deliver {
        const std::optional<LockHolder> other = lock->beat();
        if (!other) return {};
        return [this, lock, other] {
          if (lock != lock_) return;
          hold(nullptr, true);
          emit project_changed();
          emit project_lost(project_path_, *other);
        };
      },
      [](const JobFailure&) {});
}

void Workbench::end_save(const LockPtr& lock) {
  saves_.pop_front();
  if (!saves_.empty()) start_save(lock);
}

void Workbench::open_project(const ProjectToOpen& request) {
  if (opening() || calibrating()) {
    emit message(Severity::Warning, {},
                 tr("Wait until the present work is done, or cancel it, before opening a project."));
    return;
  }
  open_job_ = jobs_.start(
      [this, request, engine = engine_, present = lock_](Progress& progress) -> JobRunner::Deliver {
        auto opened = std::make_shared<OpenedProject>();
        opened->lock = lock_for(request, present, *locks_);
        if (const auto& attempt = opened->lock; attempt.holder)
          return [this, request, attempt] { emit project_held(request, *attempt.holder, attempt.on_another_computer); };
        opened->project = load_project(request.path.toStdString());
        open_sessions(request, *opened, engine, progress);
        if (progress.cancelled()) return {};
        if (opened->project.output && opened->failures.empty())
          opened->output = std::make_shared<const PipelineOutput>(std::move(*opened->project.output));
        opened->project.output.reset();
        return [this, request, opened] { take_project(request, *opened); };
      },
      report_failure());
  emit state_changed();
}

void Workbench::begin_project() {
  if (opening() || calibrating()) {
    emit message(Severity::Warning, {},
                 tr("Wait until the present work is done, or cancel it, before beginning a project."));
    return;
  }
  restore({}, {}, nullptr);
  ++project_;
  recovered_ = false;
  hold(nullptr, false);
  ++revision_;
  set_project({}, revision_);
}

void Workbench::take_project(const ProjectToOpen& request, OpenedProject& opened) {
  if (!opened.missing.isEmpty()) {
    emit sessions_missing(request, opened.missing);
    return;
  }
  restore(opened.sessions, opened.project, opened.output);
  ++project_;
  recovered_ = request.recovered || request.access == ProjectToOpen::Access::Copy;
  // What could not be opened in full must not replace the file that has it in full.
  const bool whole = opened.failures.empty(), copy = request.access == ProjectToOpen::Access::Copy;
  const bool as_saved = whole && !request.recovered && !copy && request.moved.empty();
  const QString own_path = whole && !copy ? own_path_of(request) : QString();
  ++revision_;
  if (own_path.isEmpty())
    hold(nullptr, false);  // nobody else can have what has no file
  else
    hold(opened.lock.lock, request.access == ProjectToOpen::Access::ReadOnly);
  set_project(own_path, as_saved ? revision_ : revision_ - 1);
  if (!opened.lock.why_none.empty())
    emit logged(Severity::Note, own_path,
                tr("another window could open it at the same time, no lock can be made: %1")
                    .arg(model_text(opened.lock.why_none)));
  emit project_opened(request, whole);
  if (const QStringList changes = changes_since_output(); !changes.isEmpty())
    emit message(Severity::Warning, request.path,
                 tr("holds a result that was made with other settings than it holds now: %1.\n"
                    "Calibrate again (F5).")
                     .arg(changes.join(QStringLiteral("; "))));
  for (const JobFailure& failure : opened.failures) emit message(Severity::Problem, failure.where, failure.what);
}

void Workbench::restore(std::vector<std::shared_ptr<const Session>> sessions, const Project& project,
                        OutputPtr output) {
  for (int job : {solve_job_, cloud_job_, hash_job_, map_job_}) jobs_.cancel(job);
  solve_job_ = cloud_job_ = hash_job_ = map_job_ = 0;
  ++solution_;
  sessions_ = std::move(sessions);
  settings_ = project.settings;
  nominal_ins_from_lidar_ = project.nominal_ins_from_lidar;
  output_before_ = nullptr;
  moved_by_.clear();
  output_ = std::move(output);
  output_solved_ = project.solution_pending ? nullptr : output_;
  run_input_ = input_of_next_run();
  if (output_) {
    run_input_.settings = project.basis.settings;
    run_input_.nominal_ins_from_lidar = project.basis.nominal_ins_from_lidar;
    run_input_.sessions.resize(std::min(sessions_.size(), project.basis.session_count));
  }
  input_files_ = project.inputs;
  whole_run_.reset();
  decisions_.clear();
  // Also those on pairs that the result does not hold: another method has none.
  for (const PairVerdict& verdict : project.verdicts) {
    const auto session = static_cast<std::size_t>(verdict.session);
    if (session < sessions_.size())
      decisions_[{sessions_[session]->path.string(), verdict.stamp_a_ns, verdict.stamp_b_ns}] = {verdict.state,
                                                                                                 verdict.reason};
  }
  for (std::size_t i = 0; output_ && i < output_->pairs.size(); ++i)
    if (output_->pairs[i].decided_by == DecidedBy::User)
      decisions_[key_of(run_input_, *output_, output_->pairs[i])] = {output_->pairs[i].state, output_->pairs[i].reason};
  data_changed_ = false;
  const bool whole = output_ && output_ == output_solved_;
  exported_ = whole && project.exported ? Exported::Written : Exported::No;
  confirmed_ = whole && project.confirmed;
  if (whole && is_aligned_together(output_->result)) whole_run_ = WholeRun{run_input_, output_, decisions_};
  undo_.clear();
  check_map_soon();
  emit project_replaced();
  emit sessions_changed();
  emit settings_changed();
  emit nominal_changed();
  emit output_changed();
  emit state_changed();
  selected_ = -1;
  select_pair(output_ && !output_->pairs.empty() ? 0 : -1);
  if (output_) compare_input_files();
  if (output_ != output_solved_) start_solve(tr("decisions before it was saved"), FirstAnswer::None);
}

void Workbench::announce() {
  emit sessions_changed();
  emit settings_changed();
  emit nominal_changed();
  emit output_changed();
  emit project_changed();
  emit state_changed();
  const int selected = std::exchange(selected_, -1);
  select_pair(selected);
}

void Workbench::compare_input_files() {
  if (input_files_.empty()) return;  // the calibration was made without hashes, or by another version
  auto job = std::make_shared<int>(0);
  hash_job_ = jobs_.start(
      [this, job, sessions = run_input_.sessions, then = input_files_](Progress& progress) -> JobRunner::Deliver {
        const std::vector<InputFile> now = hash_inputs(sessions, 1, progress);
        const QString changed = progress.cancelled() ? QString() : QString::fromStdString(changed_file(then, now));
        return [this, job, changed] {
          if (*job != hash_job_ || changed.isEmpty()) return;
          data_changed_ = true;
          emit message(Severity::Warning, changed,
                       tr("is not as it was when the result that is shown was made. Calibrate again (F5)."));
          emit state_changed();
        };
      },
      report_failure());
  *job = hash_job_;
}

}  // namespace remount
