#include "app/gui/autosave.h"

#include "app/gui/error_words.h"

namespace remount {
namespace {
constexpr int kAgain_ms = 60000;
}

Autosave::Autosave(Workbench& workbench, const QString& data_folder, QObject* parent)
    : QObject(parent), workbench_(workbench), saved_revision_(workbench.revision()) {
  try {
    notes_ = std::make_unique<RecoveryNotes>(data_folder);
  } catch (const Error& error) {
    const JobFailure failure = failure_of(error);
    QTimer::singleShot(0, this, [this, failure] { could_not(failure); });
    return;
  }
  soon_.setSingleShot(true);
  soon_.setInterval(0);  // one for all that an edit sets off
  again_.setInterval(kAgain_ms);
  again_.start();
  connect(&soon_, &QTimer::timeout, this, &Autosave::write);
  connect(&again_, &QTimer::timeout, this, &Autosave::look);
  connect(&beats_, &QTimer::timeout, this, &Autosave::show_life);
  beats_.start(HolderLock::kBeat_ms);
  connect(&workbench_, &Workbench::project_changed, this, &Autosave::look);
  connect(&workbench_, &Workbench::project_opened, this, &Autosave::take_over);
}

Autosave::~Autosave() {
  jobs_.reset();  // waits for a file that is being written
  if (finished_ && notes_) notes_->clear();
}

void Autosave::restore(const RecoveryOffer& offer, const AutosaveGeneration& generation) {
  restoring_ = {offer};
  ProjectToOpen request;
  request.path = generation.path;
  request.recovered = true;
  request.belongs_to = offer.summary.project_path;
  workbench_.open_project(request);
}

void Autosave::take_over(const ProjectToOpen& request, bool whole) {
  // What was opened only in part must not replace what has it in full.
  for (const RecoveryOffer& offer : restoring_)
    for (const AutosaveGeneration& generation : offer.generations)
      if (whole && request.recovered && generation.path == request.path) restored_.push_back(offer);
  restoring_.clear();
}

void Autosave::show_life() {
  jobs_->start(
      [lock = notes_->lock()](Progress&) -> JobRunner::Deliver {
        lock->beat();
        return {};
      },
      [](const JobFailure&) {});
}

void Autosave::look() {
  if (finished_ || !notes_) return;
  if (!workbench_.unsaved()) {
    saved_revision_ = workbench_.revision();
    in_notes_ = false;  // where the project was saved, its autosaves can be
    if (job_ == 0 && !notes_->empty()) notes_->clear();
    return;
  }
  if (saved_revision_ != workbench_.revision() && !soon_.isActive() && job_ == 0) soon_.start();
}

AutosaveSummary Autosave::summary() const {
  AutosaveSummary summary;
  summary.project_path = workbench_.project_path();
  for (const auto& session : workbench_.sessions()) summary.sessions << QString::fromStdString(session->path.string());
  summary.decisions = workbench_.decision_count();
  if (const OutputPtr output = workbench_.output()) {
    summary.pairs = static_cast<int>(output->pairs.size());
    const std::string_view status = to_string(output->result.status);
    summary.status = QString::fromUtf8(status);
  }
  return summary;
}

void Autosave::write() {
  if (finished_ || job_ != 0 || !workbench_.unsaved()) return;
  const AutosaveSummary figures = summary();
  const bool away = in_notes_ || workbench_.read_only();  // who has the project keeps autosaves beside it
  const QString path = away ? notes_->next_path_in_notes() : notes_->next_path(figures.project_path);
  job_ = jobs_->start(
      [this, path, figures, folder = notes_->folder(),
       snapshot = workbench_.snapshot()](Progress&) -> JobRunner::Deliver {
        const int revision = snapshot.revision;
        write_snapshot(snapshot, path);
        write_note(folder, path, figures);
        return [this, path, revision] { written(path, revision); };
      },
      [this](const JobFailure& failure) {
        job_ = 0;
        const bool beside_project = !in_notes_ && !workbench_.project_path().isEmpty();
        in_notes_ = true;  // the project's folder may not be writable, or its disk is gone
        if (!beside_project) return could_not(failure);
        emit moved(failure.where, failure.what, notes_->folder());
        write();
      });
}

void Autosave::written(const QString& path, int revision) {
  job_ = 0;
  if (finished_) return notes_->clear();
  notes_->adopt(path);
  saved_revision_ = revision;
  complained_ = false;
  for (const RecoveryOffer& offer : restored_) discard(offer);
  restored_.clear();
  emit saved(path);
  look();
}

void Autosave::could_not(const JobFailure& failure) {
  if (!complained_) emit failed(failure.where, failure.what);
  complained_ = true;
}

void Autosave::finish() {
  finished_ = true;
  soon_.stop();
  again_.stop();
  for (const RecoveryOffer& offer : restored_) discard(offer);
  restored_.clear();
  // One that is being written is removed once it is there: by the destructor, or when it is delivered.
  if (notes_ && job_ == 0) notes_->clear();
}

}  // namespace remount
