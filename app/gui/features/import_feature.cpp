#include "app/gui/features/import_feature.h"

#include <QDir>
#include <QFileInfo>

#include "app/gui/features/help_feature.h"
#include "app/gui/shell/main_window.h"
#include "widgets/basics/file_dialogs.h"

namespace remount::gui {

ImportFeature::ImportFeature(MainWindow& window) : Feature(window) {
  window.menus().add(MenuPlace::OpenDrive, tr("&Import a table…"), tr("Ctrl+I"), [this] { ask_for_table(); });
  connect(&workbench_.sessions(), &SessionList::not_recognised, this, &ImportFeature::offer);
  connect(&workbench_.sessions(), &SessionList::half_opened, this, &ImportFeature::offer);
  // The page lies over the window: why its manifest cannot be opened is said on it, too.
  connect(&workbench_.notices(), &Notices::message, this,
          [this](drive::Severity severity, const QString& where, const QString& what) {
            if (severity != drive::Severity::Problem || opening_.isEmpty() || !dialog_) return;
            if (where.startsWith(opening_)) dialog_->show_note(tr("It cannot be opened: %1").arg(what));
          });
  connect(&workbench_.sessions(), &SessionList::session_opened, this, [this](const QString& path) {
    if (opening_.isEmpty() || QFileInfo(path) != QFileInfo(opening_)) return;
    opening_.clear();
    if (dialog_ && controller_->is_saved()) dialog_->close();  // not over what was changed since
  });
}

bool ImportFeature::may_close(const std::function<void()>& again) {
  if (!controller_ || !controller_->saving()) return true;
  constexpr auto kOnce = static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection);
  disconnect(closing_);  // who tries twice is asked once
  closing_ = connect(controller_, &ImportController::save_ended, this, again, kOnce);
  return false;
}

void ImportFeature::offer(const QString& path) {
  workbench_.notices().offer(tr("Import a table…"), [self = QPointer(this), path] {
    if (self) self->import(path);
  });
}

void ImportFeature::ask_for_table() {
  const QString path =
      widgets::ask_for_file(&window_, tr("The table with the motion of the INS"), widgets::FileKind::Recordings,
                            tr("Tables (*.csv *.txt *.tsv *.dat *.asc *.log *.pos);;All files (*)"));
  if (!path.isEmpty()) import(path);
}

void ImportFeature::import(const QString& path) {
  if (dialog_ && !dialog_->close()) return dialog_->raise();  // it saves, or asks something
  opening_.clear();
  dialog_ = make_dialog();
  dialog_->show();
  const QFileInfo info(path);
  // What belongs to a table lies beside it.
  if (info.isDir())
    controller_->look_at({path}, {});
  else
    controller_->look_at({info.absolutePath()}, {info.absoluteFilePath()});
}

widgets::ImportDialog* ImportFeature::make_dialog() {
  auto* dialog = new widgets::ImportDialog(&window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  controller_ = new ImportController(workbench_, *dialog);
  connect(controller_, &ImportController::open_requested, this, &ImportFeature::open);
  connect(dialog, &widgets::ImportDialog::help_requested, this, [this] {
    if (auto* help = window_.feature<HelpFeature>()) help->show_page(QStringLiteral("import"));
  });
  return dialog;
}

void ImportFeature::open(const QString& manifest) {
  opening_ = manifest;
  window_.open_paths({manifest});
}

}  // namespace remount::gui
