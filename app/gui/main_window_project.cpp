// Project files in the window.
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/gui/main_window.h"

namespace remount {
namespace {
const QString kSuffix = QStringLiteral(".remount");
}

void MainWindow::open_project() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a project"), {}, tr("Remount projects (*%1)").arg(kSuffix));
  if (!path.isEmpty()) workbench_.open_project(path);
}

bool MainWindow::save_project(bool ask, std::function<void()> saved) {
  QString path = workbench_.project_path();
  if (path.isEmpty() || ask)
    path = QFileDialog::getSaveFileName(this, tr("Save the project"), path, tr("Remount projects (*%1)").arg(kSuffix));
  if (path.isEmpty()) return false;
  workbench_.save_project(path.endsWith(kSuffix) ? path : path + kSuffix, std::move(saved));
  return true;
}

void MainWindow::show_project() {
  const QString path = workbench_.project_path();
  setWindowTitle((path.isEmpty() ? QString() : QFileInfo(path).completeBaseName() + QStringLiteral("[*] – ")) +
                 tr("Remount"));
  setWindowModified(!path.isEmpty() && workbench_.has_unsaved_decisions());
}

bool MainWindow::may_close() {
  if (!workbench_.has_unsaved_decisions()) return true;
  const auto answer = QMessageBox::question(
      this, tr("Decisions are not saved"), tr("Save your decisions about pairs as a project before closing?"),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer != QMessageBox::Save) return answer == QMessageBox::Discard;
  // Closes once the file is known to be whole; a failure keeps the window open and says why.
  save_project(false, [this] { close(); });
  return false;
}

}  // namespace remount
