#include "app/gui/features/import/import_controller.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>

#include "algorithms/core/error.h"
#include "app/gui/basics/ask_to_replace.h"
#include "app/gui/jobs/error_words.h"
#include "app/gui/workbench/workbench.h"
#include "model/formats/documents/document.h"
#include "model/formats/files/atomic_save.h"
#include "model/guesses/manifest.h"
#include "widgets/import/import_dialog.h"
#include "widgets/text/model_text.h"

namespace remount::gui {
namespace {

/// What the checks found, and what the manifest would lack.
struct Checked {
  guesses::ImportChecks checks;
  std::vector<Message> missing;
};

Checked check_all(const guesses::ImportData& data, const guesses::ImportChoice& choice, const Progress& progress) {
  Checked checked;
  if (choice.table) checked.checks = guesses::check_choice(data.description, choice, progress);
  if (!progress.cancelled())
    checked.missing = guesses::description_of(data.description, choice, checked.checks).missing;
  return checked;
}

}  // namespace

ImportController::ImportController(Workbench& workbench, widgets::ImportDialog& dialog)
    : QObject(&dialog), workbench_(workbench), dialog_(dialog) {
  using widgets::ImportDialog;
  connect(&dialog, &ImportDialog::edited, this, &ImportController::check);
  connect(&dialog, &ImportDialog::table_requested, this, &ImportController::take_table);
  connect(&dialog, &ImportDialog::folder_requested, this, &ImportController::ask_for_folder);
  connect(&dialog, &ImportDialog::files_requested, this, &ImportController::ask_for_files);
  connect(&dialog, &ImportDialog::save_requested, this, &ImportController::ask_for_place);
  connect(&dialog, &ImportDialog::open_requested, this, &ImportController::save_and_open);
}

ImportController::~ImportController() { cancel(); }

void ImportController::cancel() {
  ++turn_;
  if (job_ != 0) workbench_.jobs().cancel(job_);
  job_ = 0;
}

/// The one before is asked to stop, and its answer is dropped.
template <class Made>
void ImportController::start(std::function<Made(Progress&)> make, std::function<void(const Made&)> take) {
  cancel();
  const QPointer<ImportController> self(this);
  job_ = workbench_.jobs().start(
      [self, turn = turn_, make = std::move(make), take = std::move(take)](Progress& progress) -> JobRunner::Deliver {
        auto made = std::make_shared<const Made>(make(progress));
        return [self, turn, made, take] {
          if (self && self->turn_ == turn) take(*made);
        };
      },
      [self, turn = turn_](const JobFailure& failure) {
        if (self && self->turn_ == turn) self->fail(failure);
      });
}

void ImportController::fail(const JobFailure& failure) {
  if (data_)
    dialog_.show_note(in_words(failure));
  else
    dialog_.show_problem(in_words(failure));
}

void ImportController::look_at(const QStringList& paths, const QString& meant) {
  paths_ = paths;
  meant_ = meant;
  saved_.clear();
  data_.reset();
  dialog_.show_looking(paths.join(QStringLiteral(", ")));
  std::vector<std::filesystem::path> files;
  for (const QString& path : paths) files.emplace_back(path.toStdString());
  const std::optional<std::filesystem::path> wanted =
      meant.isEmpty() ? std::nullopt : std::optional(std::filesystem::path(meant.toStdString()));
  start<guesses::ImportData>(
      [files, wanted](Progress& progress) { return guesses::look_for_import(files, progress, wanted); },
      [this](const guesses::ImportData& data) {
        data_ = std::make_shared<const guesses::ImportData>(data);
        dialog_.show_data(data_);
        check();
      });
}

void ImportController::check() {
  saved_.clear();
  if (!data_) return;
  dialog_.show_checking();
  start<Checked>(
      [data = data_, choice = dialog_.choice()](Progress& progress) { return check_all(*data, choice, progress); },
      [this](const Checked& checked) { dialog_.show_checks(checked.checks, checked.missing); });
}

void ImportController::take_table(const QString& file) {
  start<guesses::ImportTable>(
      [data = data_, file](Progress& progress) {
        return guesses::import_table(file.toStdString(), data->description, progress);
      },
      [this](const guesses::ImportTable& table) {
        dialog_.show_table(table);
        check();
      });
}

void ImportController::ask_for_folder() {
  const QString path = QFileDialog::getExistingDirectory(&dialog_, tr("Folder with scans or tables"), paths_.value(0));
  if (!path.isEmpty()) look_at(paths_ + QStringList{path}, meant_);
}

void ImportController::ask_for_files() {
  const QStringList paths =
      QFileDialog::getOpenFileNames(&dialog_, tr("Tables, captures or other files"), paths_.value(0));
  if (!paths.isEmpty()) look_at(paths_ + paths, paths.front());
}

QString ImportController::usual_place() const {
  return data_ ? QDir(QString::fromStdString(data_->folder.string())).filePath(QStringLiteral("session.yaml"))
               : QString();
}

void ImportController::ask_for_place() {
  const QString path =
      QFileDialog::getSaveFileName(&dialog_, tr("Save the manifest"), usual_place(), tr("Manifests (*.yaml)"), nullptr,
                                   QFileDialog::DontConfirmOverwrite);
  if (!path.isEmpty()) save(path);
}

void ImportController::save_and_open() {
  if (!saved_.isEmpty()) {
    emit open_requested(saved_);
    return;
  }
  const QString path = usual_place();
  save(path, [this, path] { emit open_requested(path); });
}

void ImportController::save(const QString& path, std::function<void()> then) {
  if (!data_ || !ask_to_replace({path}, dialog_)) return;
  start<QString>(
      [data = data_, choice = dialog_.choice(), path, language = widgets::window_language()](Progress& progress) {
        guesses::ImportChecks checks;
        if (choice.table) checks = guesses::check_choice(data->description, choice, progress);
        if (progress.cancelled()) return QString();
        const guesses::Description made = guesses::description_of(data->description, choice, checks);
        const std::filesystem::path file = path.toStdString();
        formats::save_atomically(file, formats::to_yaml(guesses::manifest_of(made, file.parent_path(), language)));
        return path;
      },
      [this, then = std::move(then)](const QString& written) {
        if (written.isEmpty()) return;
        saved_ = written;
        dialog_.show_note(tr("Saved as %1").arg(QDir::toNativeSeparators(written)));
        emit saved(written);
        if (then) then();
      });
}

}  // namespace remount::gui
