#include <QFileDialog>

#include "app/gui/main_window.h"

namespace remount {

void MainWindow::open_project() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Open a project"), {}, tr("Remount projects (*.remount)"));
  if (!path.isEmpty()) open_project_file(path);
}

void MainWindow::open_project_file(const QString& path) {}

void MainWindow::save_project() {}

}  // namespace remount
