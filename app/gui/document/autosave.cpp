#include "app/gui/document/autosave.h"

#include "app/gui/jobs/error_words.h"
#include "widgets/basics/rows.h"

namespace remount::gui {
namespace {
constexpr int kAgain_ms = 60000;
constexpr int kUnanswered_ms = 10000;  // a disk that was asleep has woken up by then
}  // namespace

Autosave::Autosave(Workbench& workbench, const QString& data_folder, QObject* parent)
    : QObject(parent), workbench_(workbench), saved_revision_(workbench.document().revision()) {
  // The disk may take its time, and the window opens meanwhile.
  job_ = jobs_->start(
      [this, data_folder](Progress&) -> JobRunner::Deliver {
        const std::vector<RecoveryOffer> offers = find_recoveries(data_folder);
        auto notes = std::make_shared<std::unique_ptr<RecoveryNotes>>(std::make_unique<RecoveryNotes>(data_folder));
        return [this, offers, notes] {
          begin(std::move(*notes));
          if (!offers.empty() && !finished_) emit found(offers);
        };
      },
      [this](const JobFailure& failure) {
        job_ = 0;
        could_not(failure);
      });
  QTimer::singleShot(kUnanswered_ms, this, [this, data_folder] {
    if (!notes_ && job_ != 0 && !finished_) could_not({data_folder, tr("the disk does not answer")});
  });
}

void Autosave::begin(std::unique_ptr<RecoveryNotes> notes) {
  job_ = 0;
  notes_ = std::move(notes);
  complained_ = false;
  if (finished_) return notes_->clear();
  soon_.setSingleShot(true);
  soon_.setInterval(0);  // one for all that an edit sets off
  again_.setInterval(kAgain_ms);
  again_.start();
  connect(&soon_, &QTimer::timeout, this, &Autosave::write);
  connect(&again_, &QTimer::timeout, this, &Autosave::look);
  connect(&beats_, &QTimer::timeout, this, &Autosave::show_life);
  beats_.start(project::HolderLock::kBeat_ms);
  connect(&workbench_.document(), &ProjectDocument::changed, this, &Autosave::look);
  connect(&workbench_.document(), &ProjectDocument::opened, this, &Autosave::take_over);
  look();  // at what was edited until now
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
  workbench_.document().open(request);
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
  if (!workbench_.document().unsaved()) {
    saved_revision_ = workbench_.document().revision();
    in_notes_ = false;  // where the project was saved, its autosaves can be
    if (job_ == 0 && !notes_->empty()) clear();
    return;
  }
  if (saved_revision_ != workbench_.document().revision() && !soon_.isActive() && job_ == 0) soon_.start();
}

void Autosave::clear() {
  job_ = jobs_->start(
      [this, notes = notes_.get()](Progress&) -> JobRunner::Deliver {
        notes->clear();
        return [this] {
          job_ = 0;
          look();  // at what was edited meanwhile
        };
      },
      [this](const JobFailure&) { job_ = 0; });
}

AutosaveSummary Autosave::summary() const {
  AutosaveSummary summary;
  summary.project_path = workbench_.document().path();
  for (const auto& session : workbench_.sessions().all())
    summary.sessions << QString::fromStdString(session->path.string());
  summary.decisions = workbench_.decisions().count();
  if (const OutputPtr output = workbench_.outcome().output()) {
    summary.pairs = widgets::qt_count(output->pairs.size());
    const std::string_view status = to_string(output->result.status);
    summary.status = QString::fromUtf8(status);
  }
  return summary;
}

void Autosave::write() {
  if (finished_ || job_ != 0 || !workbench_.document().unsaved()) return;
  const AutosaveSummary figures = summary();
  const bool away = in_notes_ || workbench_.document().read_only();  // who has the project keeps autosaves beside it
  // Nobody else touches the notes before job_ is 0 again.
  job_ = jobs_->start(
      [this, away, figures, notes = notes_.get(), restored = restored_,
       snapshot = workbench_.document().snapshot()](Progress&) -> JobRunner::Deliver {
        const int revision = snapshot.revision;
        const QString path = away ? notes->next_path_in_notes() : notes->next_path(figures.project_path);
        write_snapshot(snapshot, path);
        write_note(notes->folder(), path, figures);
        notes->adopt(path);
        for (const RecoveryOffer& offer : restored) discard(offer);  // the snapshot holds their work
        return [this, path, revision, count = std::ssize(restored)] { written(path, revision, count); };
      },
      [this](const JobFailure& failure) {
        job_ = 0;
        const bool beside_project = !in_notes_ && !workbench_.document().path().isEmpty();
        in_notes_ = true;  // the project's folder may not be writable, or its disk is gone
        if (!beside_project) return could_not(failure);
        emit moved(failure.where, failure.what, notes_->folder());
        write();
      });
}

void Autosave::written(const QString& path, int revision, std::ptrdiff_t discarded) {
  job_ = 0;
  if (finished_) return notes_->clear();
  saved_revision_ = revision;
  complained_ = false;
  restored_.erase(restored_.begin(), restored_.begin() + discarded);
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

}  // namespace remount::gui
