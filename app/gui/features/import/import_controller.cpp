#include "app/gui/features/import/import_controller.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <algorithm>

#include "algorithms/core/error.h"
#include "app/gui/basics/ask_to_replace.h"
#include "app/gui/jobs/error_words.h"
#include "app/gui/workbench/workbench.h"
#include "model/formats/documents/document.h"
#include "model/formats/files/atomic_save.h"
#include "model/guesses/manifest.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/import/import_dialog.h"
#include "widgets/text/model_text.h"

namespace remount::gui {
namespace {

namespace fs = std::filesystem;

const QString kManifestName = QStringLiteral("session.yaml");

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

std::vector<std::string> titles_of(const guesses::SampledTable& table) {
  std::vector<std::string> titles;
  for (const guesses::SampledColumn& column : table.columns) titles.push_back(column.title);
  return titles;
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return a == b || fs::equivalent(a, b, error);
}

std::vector<fs::path> files_of(const QStringList& paths) {
  std::vector<fs::path> files;
  for (const QString& path : paths) files.emplace_back(path.toStdString());
  return files;
}

/// @param meant the tables that are asked for; shown is the first that is one
guesses::ImportData look_for(const std::vector<fs::path>& files, const std::vector<fs::path>& meant,
                             const std::optional<fs::path>& shown_before, Progress& progress) {
  guesses::ImportData data =
      guesses::look_for_import(files, progress, meant.empty() ? shown_before : std::optional(meant.front()));
  std::vector<fs::path> wanted = meant;
  if (shown_before) wanted.push_back(*shown_before);
  for (const fs::path& file : wanted) {
    const auto found = std::ranges::find_if(data.tables, [&](const fs::path& one) { return is_same_file(one, file); });
    if (found == data.tables.end()) continue;
    if (!progress.cancelled() && (!data.table || data.table->file != *found))
      data.table = guesses::import_table(*found, data.description, progress);
    break;
  }
  return data;
}

/// False where it was cancelled. Throws Error where the table gives no motion, or the file cannot be replaced.
bool write_manifest(const guesses::ImportData& data, const guesses::ImportChoice& choice, const fs::path& file,
                    Language language, const Progress& progress) {
  const auto made = guesses::description_to_save(data.description, choice, progress);
  if (!made) return false;
  formats::check_replaces_its_like(file, "remount-session/");
  formats::save_atomically(file, formats::to_yaml(guesses::manifest_of(*made, file.parent_path(), language)));
  return true;
}

}  // namespace

ImportController::ImportController(Workbench& workbench, widgets::ImportDialog& dialog)
    : QObject(&dialog), workbench_(workbench), dialog_(dialog) {
  using widgets::ImportDialog;
  constexpr int kUntilCheck_ms = 50;  // of several changes that follow each other, the last is checked
  until_check_.setSingleShot(true);
  until_check_.setInterval(kUntilCheck_ms);
  connect(&until_check_, &QTimer::timeout, this, &ImportController::check);
  connect(&dialog, &ImportDialog::edited, this, &ImportController::check_soon);
  connect(&dialog, &ImportDialog::log_chosen, this, &ImportController::take_log);
  connect(&dialog, &ImportDialog::table_requested, this, &ImportController::take_table);
  connect(&dialog, &ImportDialog::folder_requested, this, &ImportController::ask_for_folder);
  connect(&dialog, &ImportDialog::files_requested, this, &ImportController::ask_for_files);
  connect(&dialog, &ImportDialog::save_requested, this, &ImportController::ask_for_place);
  connect(&dialog, &ImportDialog::open_requested, this, &ImportController::save_and_open);
}

/// A save that somebody confirmed goes on to its end.
ImportController::~ImportController() { cancel(work_); }

void ImportController::cancel(Task& task) {
  ++task.turn;
  if (task.job != 0) workbench_.jobs().cancel(task.job);
  task.job = 0;
}

/// The one before is asked to stop, and its answer is dropped.
template <class Made>
void ImportController::start(Task ImportController::*task, std::function<Made(Progress&)> make,
                             std::function<void(const Made&)> take, Failed failed) {
  cancel(this->*task);
  const auto counts = [self = QPointer<ImportController>(this), task, turn = (this->*task).turn] {
    if (!self || (self.data()->*task).turn != turn) return false;
    (self.data()->*task).job = 0;
    return true;
  };
  (this->*task).job = workbench_.jobs().start(
      [counts, make = std::move(make), take = std::move(take)](Progress& progress) -> JobRunner::Deliver {
        auto made = std::make_shared<const Made>(make(progress));
        return [counts, made, take] {
          if (counts()) take(*made);
        };
      },
      [counts, failed = std::move(failed)](const JobFailure& failure) {
        if (counts()) failed(failure);
      });
}

/// While a dialog asks over the page, the page stays: it owns that dialog. No answer where the page is gone all the
/// same.
template <class Answer>
Answer ImportController::ask(const std::function<Answer()>& question) {
  const QPointer<ImportController> self(this);
  dialog_.set_held(true);
  Answer answer = question();
  if (!self) return {};
  dialog_.set_held(false);
  return answer;
}

void ImportController::keep_choices() {
  const guesses::ImportChoice choice = dialog_.choice();
  if (!data_) return;
  kept_table_ = choice.table;
  if (choice.table) {
    kept_.erase(choice.table->file);
    if (choice.choices != choice.table->preset)
      kept_[choice.table->file] = {choice.choices, titles_of(choice.table->table)};
  }
  kept_left_out_.clear();
  for (const std::size_t lidar : choice.left_out) kept_left_out_.insert(data_->description.lidars.at(lidar).directory);
}

/// Where the table in the dialog still has the same columns.
void ImportController::put_kept_back() {
  std::set<std::size_t> left_out;
  const std::vector<guesses::ScansGuess>& lidars = data_->description.lidars;
  for (std::size_t i = 0; i < lidars.size(); ++i)
    if (kept_left_out_.contains(lidars[i].directory)) left_out.insert(i);
  dialog_.leave_out(left_out);
  const guesses::ImportChoice choice = dialog_.choice();
  if (!choice.table) return;
  const auto kept = kept_.find(choice.table->file);
  if (kept != kept_.end() && kept->second.titles == titles_of(choice.table->table))
    dialog_.choose(kept->second.choices);
}

void ImportController::look_at(const QStringList& paths, const QStringList& meant) {
  if (!reading_) keep_choices();
  saved_.clear();
  asked_paths_ = paths;
  reading_ = true;
  dialog_.show_looking(paths.join(QStringLiteral(", ")));
  const std::optional<fs::path> before = kept_table_ ? std::optional(kept_table_->file) : std::nullopt;
  start<guesses::ImportData>(
      &ImportController::work_,
      [files = files_of(paths), wanted = files_of(meant), before](Progress& progress) {
        return look_for(files, wanted, before, progress);
      },
      [this](const guesses::ImportData& data) { take_data(data); },
      [this](const JobFailure& failure) { tell_not_looked_at(failure); });
}

void ImportController::take_data(const guesses::ImportData& data) {
  reading_ = false;
  paths_ = asked_paths_;
  data_ = std::make_shared<const guesses::ImportData>(data);
  dialog_.show_data(data_);
  put_kept_back();
  check();
}

/// What was there before is shown again.
void ImportController::tell_not_looked_at(const JobFailure& failure) {
  reading_ = false;
  asked_paths_ = paths_;
  if (!data_) return dialog_.show_problem(in_words(failure));
  dialog_.show_data(data_);
  if (kept_table_) dialog_.show_table(*kept_table_);
  put_kept_back();
  check();
  dialog_.show_note(in_words(failure));
}

void ImportController::check_soon() {
  ++edits_;
  saved_.clear();
  if (!data_ || reading_) return;
  dialog_.show_checking();
  until_check_.start();
}

void ImportController::check() {
  until_check_.stop();
  if (!data_ || reading_) return;
  dialog_.show_checking();
  start<Checked>(
      &ImportController::work_,
      [data = data_, choice = dialog_.choice()](Progress& progress) { return check_all(*data, choice, progress); },
      [this](const Checked& checked) { dialog_.show_checks(checked.checks, checked.missing); },
      [this](const JobFailure& failure) { dialog_.show_note(in_words(failure)); });
}

void ImportController::take_table(const QString& file) {
  if (!data_) return;
  reading_ = true;
  ++edits_;
  saved_.clear();
  dialog_.show_checking();
  start<guesses::ImportTable>(
      &ImportController::work_,
      [data = data_, file](Progress& progress) {
        return guesses::import_table(file.toStdString(), data->description, progress);
      },
      [this](const guesses::ImportTable& table) {
        reading_ = false;
        keep_choices();
        dialog_.show_table(table);
        put_kept_back();
        check();
      },
      [this](const JobFailure& failure) {
        reading_ = false;
        check();
        dialog_.show_note(in_words(failure));
      });
}

void ImportController::take_log() {
  cancel(work_);  // a table that is being read is not wanted any more
  reading_ = false;
  keep_choices();
  dialog_.show_no_table();
  check_soon();
}

void ImportController::ask_for_folder() {
  const QString path = ask<QString>([this] {
    return QFileDialog::getExistingDirectory(
        &dialog_, tr("Folder with scans or tables"),
        asked_paths_.value(0, widgets::usual_folder(widgets::FileKind::Recordings)));
  });
  if (!path.isEmpty()) look_at(asked_paths_ + QStringList{path}, {});
}

void ImportController::ask_for_files() {
  const QStringList paths = ask<QStringList>([this] {
    return QFileDialog::getOpenFileNames(&dialog_, tr("Tables, captures or other files"),
                                         asked_paths_.value(0, widgets::usual_folder(widgets::FileKind::Recordings)));
  });
  if (!paths.isEmpty()) look_at(asked_paths_ + paths, paths);
}

QString ImportController::usual_place() const {
  return data_ ? QDir(QString::fromStdString(data_->folder.string())).filePath(kManifestName) : QString();
}

void ImportController::ask_for_place() {
  const QString path = ask<QString>([this] {
    return QFileDialog::getSaveFileName(&dialog_, tr("Save the manifest"), usual_place(), tr("Manifests (*.yaml)"),
                                        nullptr, QFileDialog::DontConfirmOverwrite);
  });
  if (!path.isEmpty()) save(path);
}

void ImportController::save_and_open() {
  if (!saved_.isEmpty()) {
    if (!tells_that_it_is_open(saved_)) emit open_requested(saved_);
    return;
  }
  const QString path = usual_place();
  save(path, [this, path] { emit open_requested(path); });
}

/// What is open would go on with the data of before.
bool ImportController::tells_that_it_is_open(const QString& manifest) {
  const fs::path file = manifest.toStdString();
  const bool usual = QFileInfo(manifest).fileName() == kManifestName;
  const bool open = std::ranges::any_of(workbench_.sessions().all(), [&](const auto& session) {
    return is_same_file(session->path, file) || (usual && is_same_file(session->path, file.parent_path()));
  });
  if (open)
    dialog_.show_note(tr("%1 is open. Close that session first, or save the manifest elsewhere. Nothing was written.")
                          .arg(QDir::toNativeSeparators(manifest)));
  return open;
}

void ImportController::end_save() {
  dialog_.set_saving(false);
  emit save_ended();
}

void ImportController::save(const QString& asked, std::function<void()> then) {
  if (!data_ || reading_ || saving()) return;
  const bool named = asked.endsWith(QStringLiteral(".yaml")) || asked.endsWith(QStringLiteral(".yml"));
  const QString path = named ? asked : asked + QStringLiteral(".yaml");
  if (tells_that_it_is_open(path) || !ask<bool>([this, path] { return ask_to_replace({path}, dialog_); })) return;
  dialog_.set_saving(true);
  dialog_.show_note(tr("Saving %1…").arg(QDir::toNativeSeparators(path)));
  start<bool>(
      &ImportController::save_,
      [data = data_, choice = dialog_.choice(), path, language = widgets::window_language()](Progress& progress) {
        return write_manifest(*data, choice, path.toStdString(), language, progress);
      },
      [this, path, edits = edits_, then = std::move(then)](bool written) {
        end_save();
        if (!written) return dialog_.show_note({});
        if (edits == edits_) saved_ = path;
        dialog_.show_note(tr("Saved as %1").arg(QDir::toNativeSeparators(path)));
        emit saved(path);
        if (then) then();
      },
      [this](const JobFailure& failure) {
        end_save();
        dialog_.show_note(in_words(failure));
      });
}

}  // namespace remount::gui
