#include "app/gui/features/project_feature.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>

#include "app/gui/basics/sample.h"
#include "app/gui/document/project_keeper.h"
#include "app/gui/shell/main_window.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/sessions/sessions_below_dialog.h"
#include "widgets/shell/welcome_panel.h"

namespace remount::gui {
namespace {

const QString kSuffix = QStringLiteral(".remount");

struct KeptWork : Feature::Kept {
  std::unique_ptr<Autosave> autosave;  ///< null where work is not kept
};

}  // namespace

ProjectFeature::ProjectFeature(MainWindow& window) : Feature(window), keeper_(new ProjectKeeper(workbench_, window)) {
  make_menu();
  make_welcome();
  connect(&window, &MainWindow::paths_requested, this, &ProjectFeature::open_paths);
  connect(keeper_, &ProjectKeeper::open_requested, this, &ProjectFeature::open_paths);
  connect(&workbench_.document(), &ProjectDocument::changed, this, &ProjectFeature::show_project);
  connect(&workbench_.sessions(), &SessionList::found_below, this, &ProjectFeature::ask_for_sessions_below);
}

void ProjectFeature::make_menu() {
  Menus& menus = window_.menus();
  menus.add(MenuPlace::FileNew, tr("&New project"), QKeySequence::New, [this] { begin_project(); });
  menus.add(MenuPlace::OpenDrive, tr("&Folder of a drive…"), QKeySequence::Open, [this] { ask_for_folder(); });
  menus.add(MenuPlace::OpenDrive, tr("&Log or bag file…"), tr("Ctrl+Shift+O"), [this] { ask_for_file(); });
  menus.add(MenuPlace::OpenProject, tr("&Project…"), tr("Ctrl+P"), [this] { open_project(); });
  QMenu* recent = menus.add_menu(MenuPlace::FileRecent, tr("Open &recent"));
  recent->setToolTipsVisible(true);
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { keeper_->fill_recent_menu(*recent); });
  menus.add(MenuPlace::FileSave, tr("&Save project"), QKeySequence::Save, [this] { save_project(false); });
  menus.add(MenuPlace::FileSave, tr("Save project &as…"), QKeySequence::SaveAs, [this] { save_project(true); });
}

void ProjectFeature::make_welcome() {
  auto* welcome = new widgets::WelcomePanel(&window_);
  welcome->set_sample_available(!sample_path().isEmpty());
  window_.set_welcome(welcome);
  welcome->set_open_menu(window_.menus().open_menu());
  connect(welcome, &widgets::WelcomePanel::sample_requested, this, &ProjectFeature::open_sample);
  connect(welcome, &widgets::WelcomePanel::recent_requested, this, [this](const QString& path) { open_paths({path}); });
  const auto show_recent = [this, welcome] {
    welcome->show_recent(keeper_->recent().paths(), keeper_->recent().labels());
  };
  connect(keeper_, &ProjectKeeper::recent_changed, this, show_recent);
  show_recent();
}

void ProjectFeature::open_sample() {
  if (sample_path().isEmpty())
    workbench_.notices().say(
        drive::Severity::Problem, {},
        tr("The sample session is not installed. Install the package again, or open a recorded drive of yours "
           "(Ctrl+O)."));
  else
    workbench_.sessions().open({sample_path()});
}

void ProjectFeature::open_paths(const QStringList& paths) {
  QStringList sessions;
  for (const QString& path : paths) {
    if (path.endsWith(kSuffix))
      replace_by(path);
    else
      sessions << path;
  }
  if (!sessions.isEmpty()) workbench_.sessions().open(sessions);
}

void ProjectFeature::ask_for_folder() {
  const QString path =
      widgets::ask_for_folder(&window_, tr("Open the folder of a recorded drive"), widgets::FileKind::Recordings);
  if (!path.isEmpty()) open_paths({path});
}

void ProjectFeature::ask_for_file() {
  const QStringList paths =
      widgets::ask_for_files(&window_, tr("Open files of recorded drives"), widgets::FileKind::Recordings);
  if (!paths.isEmpty()) open_paths(paths);
}

void ProjectFeature::ask_for_sessions_below(const QString& folder, const QStringList& paths) {
  auto* dialog = new widgets::SessionsBelowDialog(folder, paths, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { open_paths(dialog->chosen()); });
  dialog->open();
}

void ProjectFeature::open_project() {
  const QString path = widgets::ask_for_file(&window_, tr("Open a project"), widgets::FileKind::Projects,
                                             tr("Remount projects (*%1)").arg(kSuffix));
  if (!path.isEmpty()) replace_by(path);
}

bool ProjectFeature::save_project(bool ask, std::function<void()> saved) {
  ProjectDocument& document = workbench_.document();
  QString path = document.path();
  if (path.isEmpty() || ask || document.read_only())
    path = widgets::ask_where_to_save(&window_, tr("Save the project"), widgets::FileKind::Projects, path,
                                      tr("Remount projects (*%1)").arg(kSuffix));
  if (path.isEmpty()) return false;
  document.save(path.endsWith(kSuffix) ? path : path + kSuffix, std::move(saved));
  return true;
}

void ProjectFeature::show_project() {
  const ProjectDocument& document = workbench_.document();
  const QString path = document.path();
  QString name = !path.isEmpty()               ? QFileInfo(path).completeBaseName()
                 : document.has_unsaved_work() ? tr("Not saved yet")
                                               : QString();
  if (document.read_only()) name = tr("%1 (read-only)").arg(name);
  window_.setWindowTitle((name.isEmpty() ? name : name + QStringLiteral("[*] – ")) + tr("Remount"));
  window_.setWindowModified(document.has_unsaved_work());
}

void ProjectFeature::keep_work_in(const QString& data_folder) { keeper_->keep_in(data_folder); }

void ProjectFeature::replace_by(const QString& project) {
  // The window may be gone by then: another language makes a new one. What was edited while the file was written is
  // asked about again.
  if (may_close([self = QPointer(this), project] {
        if (self) self->replace_by(project);
      }))
    workbench_.document().open(project);
}

void ProjectFeature::begin_project() {
  if (may_close([self = QPointer(this)] {
        if (self) self->begin_project();
      }))
    workbench_.document().begin();
}

bool ProjectFeature::may_close(const std::function<void()>& again) {
  const ProjectDocument& document = workbench_.document();
  if (!document.has_unsaved_work()) return true;
  QStringList unsaved;
  if (workbench_.outcome().output()) unsaved << tr("the result of the calibration");
  if (const int decisions = workbench_.decisions().count(); decisions > 0)
    unsaved << tr("%n decision(s) about pairs", nullptr, decisions);
  const QString name = QFileInfo(document.path()).fileName();
  const auto answer = QMessageBox::question(
      &window_, tr("Work is not saved"),
      !name.isEmpty()     ? tr("Save your changes to %1 first?").arg(name)
      : unsaved.isEmpty() ? tr("Save your work as a project first?")
                          : tr("Save your work as a project first? Not saved: %1.").arg(unsaved.join(", ")),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer != QMessageBox::Save) return answer == QMessageBox::Discard;
  // Goes on once the file is known to be whole; a failure keeps the window as it is and says why.
  save_project(false, again);
  return false;
}

void ProjectFeature::finish() { keeper_->finish(); }

std::unique_ptr<Feature::Kept> ProjectFeature::hand_over() {
  auto kept = std::make_unique<KeptWork>();
  kept->autosave = keeper_->take_autosave();
  return kept;
}

void ProjectFeature::take_over(Kept* kept) {
  if (auto* work = dynamic_cast<KeptWork*>(kept)) keeper_->put_autosave(std::move(work->autosave));
}

}  // namespace remount::gui
