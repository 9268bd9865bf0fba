#include "app/gui/workbench/project_document.h"

#include <algorithm>
#include <utility>

#include "app/gui/workbench/workbench.h"
#include "model/results/result_words.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

ProjectDocument::ProjectDocument(const Desk& desk, Workbench& workbench, std::unique_ptr<LockKeeper> locks)
    : WorkbenchPart(desk), workbench_(workbench), locks_(std::move(locks)) {
  connect(&beats_, &QTimer::timeout, this, &ProjectDocument::show_life);
  beats_.start(project::HolderLock::kBeat_ms);
}

bool ProjectDocument::has_unsaved_decisions() const { return unsaved() && !workbench_.decisions().empty(); }

bool ProjectDocument::has_unsaved_work() const {
  return unsaved() && (workbench_.outcome().output() || !path_.isEmpty() || desk_.history.has_edits() || recovered_);
}

ProjectSnapshot ProjectDocument::snapshot() const {
  const Outcome& outcome = workbench_.outcome();
  const Setup& setup = workbench_.setup();
  ProjectSnapshot snapshot;
  for (const auto& session : workbench_.sessions().all()) {
    snapshot.project.sessions.push_back(session->path);
    snapshot.project.topics.push_back(session->topic_choice);
  }
  snapshot.project.verdicts = workbench_.decisions().verdicts();
  snapshot.project.notes = workbench_.review_notes().saved();
  snapshot.project.settings = setup.settings();
  snapshot.project.nominal_ins_from_lidar = setup.nominal_ins_from_lidar();
  if (outcome.output()) snapshot.project.basis = project::basis_of(outcome.input());
  snapshot.project.inputs = outcome.input_files();
  snapshot.output = outcome.output();
  snapshot.project.solution_pending = !outcome.whole();
  snapshot.project.confirmed = outcome.confirmed();
  snapshot.project.exported = outcome.exported() == Exported::Written;
  snapshot.other_lidars = workbench_.vehicle().others_to_save();
  snapshot.common = workbench_.vehicle().common();
  snapshot.revision = revision_;
  return snapshot;
}

void ProjectDocument::set_path(const QString& path, int saved_revision) {
  path_ = path;
  saved_revision_ = saved_revision;
  emit changed();
}

void ProjectDocument::mark_edited() {
  ++revision_;
  emit changed();
}

void ProjectDocument::save(const QString& path, std::function<void()> saved) {
  saves_.push_back({path, snapshot(), std::move(saved), project_});
  if (saves_.size() == 1) start_save(nullptr);
}

void ProjectDocument::start_save(const LockPtr& of_last) {
  desk_.jobs.start(
      [this, save = saves_.front(), of_last = of_last, of_project = lock_](Progress&) mutable -> JobRunner::Deliver {
        // Where links lead only the disk knows, which may take its time.
        const bool same = of_last && of_last->path() == project::lock_path_of(save.path.toStdString());
        const LockPtr lock = lock_to_save(save.path, same ? of_last : of_project, *locks_);
        of_last.reset();  // another save may be waiting for it
        write_snapshot(save.snapshot, save.path);
        return [this, save, lock] { take_saved(save, lock); };
      },
      [this](const JobFailure& failure) {
        end_save(nullptr);
        desk_.notices.say(drive::Severity::Problem, failure.where, failure.what);
      });
}

void ProjectDocument::take_saved(const Save& save, const LockPtr& lock) {
  if (save.project == project_) hold(lock, false);
  end_save(lock);
  desk_.notices.say(drive::Severity::Note, save.path, tr("project saved"));
  emit saved(save.path);
  if (save.project != project_) return;
  recovered_ = false;
  set_path(save.path, save.snapshot.revision);
  if (save.saved) save.saved();
}

void ProjectDocument::end_save(const LockPtr& lock) {
  saves_.pop_front();
  if (!saves_.empty()) start_save(lock);
}

void ProjectDocument::hold(LockPtr lock, bool read_only) {
  lock_ = std::move(lock);
  read_only_ = read_only;
}

void ProjectDocument::show_life() {
  if (!lock_) return;
  desk_.jobs.start(
      [this, lock = lock_](Progress&) -> JobRunner::Deliver {
        const std::optional<project::LockHolder> other = lock->beat();
        if (!other) return {};
        return [this, lock, other] {
          if (lock != lock_) return;
          hold(nullptr, true);
          emit changed();
          emit lost(path_, *other);
        };
      },
      [](const JobFailure&) {});
}

bool ProjectDocument::may_open(const QString& why_not) {
  if (!desk_.activity.opening() && !desk_.activity.calibrating()) return true;
  desk_.notices.say(drive::Severity::Warning, {}, why_not);
  return false;
}

void ProjectDocument::open(const ProjectToOpen& request) {
  if (!may_open(tr("Wait until the present work is done, or cancel it, before opening a project."))) return;
  desk_.activity.start(
      Activity::Kind::Opening,
      [this, request, engine = desk_.engine, present = lock_](Progress& progress) -> JobRunner::Deliver {
        auto opened = std::make_shared<OpenedProject>();
        opened->lock = lock_to_open(request, present, *locks_);
        if (const auto& attempt = opened->lock; attempt.holder)
          return [this, request, attempt] { emit held(request, *attempt.holder, attempt.on_another_computer); };
        read_project(request, *opened, engine, progress);
        if (progress.cancelled()) return {};
        return [this, request, opened] { take(request, *opened); };
      },
      desk_.notices.report_failure());
}

void ProjectDocument::begin() {
  if (!may_open(tr("Wait until the present work is done, or cancel it, before beginning a project."))) return;
  restore({}, {}, nullptr);
  ++project_;
  recovered_ = false;
  hold(nullptr, false);
  ++revision_;
  set_path({}, revision_);
}

void ProjectDocument::take(const ProjectToOpen& request, OpenedProject& opened) {
  if (!opened.missing.isEmpty()) {
    emit sessions_missing(request, opened.missing);
    return;
  }
  restore(opened.sessions, opened.project, opened.output, std::move(opened.other_lidars));
  take_path(request, opened);
  if (!opened.lock.why_none.empty())
    desk_.notices.log(drive::Severity::Note, path_,
                      tr("another window could open it at the same time, no lock can be made: %1")
                          .arg(widgets::model_text(opened.lock.why_none)));
  emit this->opened(request, opened.failures.empty());
  if (const QStringList changes = workbench_.calibrations().changes_since_output(); !changes.isEmpty())
    desk_.notices.say(drive::Severity::Warning, request.path,
                      tr("holds a result that was made with other settings than it holds now: %1.\n"
                         "Calibrate again (F5).")
                          .arg(changes.join(QStringLiteral("; "))));
  for (const JobFailure& failure : opened.failures)
    desk_.notices.say(drive::Severity::Problem, failure.where, failure.what);
}

void ProjectDocument::take_path(const ProjectToOpen& request, const OpenedProject& opened) {
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
  set_path(own_path, as_saved ? revision_ : revision_ - 1);
}

void ProjectDocument::stop_all() {
  for (const auto kind : {Activity::Kind::Solving, Activity::Kind::CheckingMap}) desk_.activity.drop(kind);
  workbench_.input_files().stop();
}

void ProjectDocument::put_outcome(const project::Project& project, OutputPtr output) {
  workbench_.outcome().count_as_other();
  workbench_.outcome().put(calibrated_in(project, std::move(output), workbench_.calibrations().input_of_next()));
}

void ProjectDocument::restore(std::vector<SessionPtr> sessions, const project::Project& project, OutputPtr output,
                              std::vector<SavedLidar> other_lidars) {
  Outcome& outcome = workbench_.outcome();
  stop_all();
  workbench_.sessions().put(std::move(sessions));
  workbench_.setup().put(project.settings, project.nominal_ins_from_lidar);
  put_outcome(project, std::move(output));
  workbench_.decisions().put_saved(project.verdicts);
  workbench_.review_notes().put_saved(project.notes);
  workbench_.vehicle().restore(project, std::move(other_lidars));
  if (outcome.output() && outcome.whole() && results::is_aligned_together(outcome.output()->result))
    outcome.take_whole_run(workbench_.decisions().made());
  desk_.history.clear();
  workbench_.map_checks().begin_soon();
  announce_replaced();
  workbench_.selection().select_anew(
      outcome.output() && !outcome.output()->pairs.empty() ? std::optional(motion::PairIndex{0}) : std::nullopt);
  if (outcome.output()) workbench_.input_files().compare();
  if (!outcome.whole()) workbench_.solutions().solve(tr("decisions before it was saved"));
}

void ProjectDocument::announce_replaced() {
  emit replaced();
  workbench_.sessions().announce();
  workbench_.setup().announce();
  workbench_.outcome().announce();
  emit state_changed();
}

}  // namespace remount::gui
