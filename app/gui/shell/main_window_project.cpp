// Project files in the window.
#include <QCloseEvent>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>

#include "app/gui/document/project_keeper.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/shell/main_window.h"
#include "widgets/sessions/sessions_below_dialog.h"

namespace remount {
namespace {
const QString kSuffix = QStringLiteral(".remount");
}

void MainWindow::open_project() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a project"), {}, tr("Remount projects (*%1)").arg(kSuffix));
  if (!path.isEmpty()) replace_by(path);
}

bool MainWindow::save_project(bool ask, std::function<void()> saved) {
  QString path = workbench_.document().path();
  if (path.isEmpty() || ask || workbench_.document().read_only())
    path = QFileDialog::getSaveFileName(this, tr("Save the project"), path, tr("Remount projects (*%1)").arg(kSuffix));
  if (path.isEmpty()) return false;
  workbench_.document().save(path.endsWith(kSuffix) ? path : path + kSuffix, std::move(saved));
  return true;
}

void MainWindow::show_project() {
  const QString path = workbench_.document().path();
  QString name = !path.isEmpty()                            ? QFileInfo(path).completeBaseName()
                 : workbench_.document().has_unsaved_work() ? tr("Not saved yet")
                                                            : QString();
  if (workbench_.document().read_only()) name = tr("%1 (read-only)").arg(name);
  setWindowTitle((name.isEmpty() ? name : name + QStringLiteral("[*] – ")) + tr("Remount"));
  setWindowModified(workbench_.document().has_unsaved_work());
}

void MainWindow::ask_for_sessions_below(const QString& folder, const QStringList& paths) {
  auto* dialog = new SessionsBelowDialog(folder, paths, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { open_paths(dialog->chosen()); });
  dialog->open();
}

void MainWindow::keep_work_in(const QString& data_folder) { keeper_->keep_in(data_folder); }

void MainWindow::ask_for_report() {
  if (report_->busy())
    return show_message(Severity::Warning, {},
                        tr("A report is being written already. Wait until the status line says that it is saved."));
  const QString project = workbench_.document().path();
  const QString suggested = project.isEmpty()
                                ? tr("report.html")
                                : QFileInfo(project).dir().filePath(QFileInfo(project).completeBaseName() + ".html");
  // The dialog knows of neither the suffix nor the PDF: what will be replaced is asked afterwards, once for both.
  QString path = QFileDialog::getSaveFileName(this, tr("Save the report (HTML, and PDF beside it)"), suggested,
                                              tr("Web pages (*.html)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  path = html_beside(path);
  if (may_replace({path, pdf_beside(path)})) report_->make(path);
}

bool MainWindow::may_replace(QStringList files) {
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  for (QString& file : files) file = QDir::toNativeSeparators(file);
  return files.isEmpty() ||
         QMessageBox::question(this, tr("Replace files"),
                               tr("%n file(s) exist already. Replace?", nullptr, static_cast<int>(files.size())) +
                                   QStringLiteral("\n\n") + files.join('\n'),
                               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

void MainWindow::replace_by(const QString& project) {
  // The window may be gone by then: another language makes a new one. What was edited while the file was written is
  // asked about again.
  if (may_close([window = QPointer(this), project] {
        if (window) window->replace_by(project);
      }))
    workbench_.document().open(project);
}

void MainWindow::begin_project() {
  if (may_close([window = QPointer(this)] {
        if (window) window->begin_project();
      }))
    workbench_.document().begin();
}

bool MainWindow::may_close(std::function<void()> saved) {
  if (!workbench_.document().has_unsaved_work()) return true;
  QStringList unsaved;
  if (workbench_.outcome().output()) unsaved << tr("the result of the calibration");
  if (const int decisions = workbench_.decisions().count(); decisions > 0)
    unsaved << tr("%n decision(s) about pairs", nullptr, decisions);
  const QString name = QFileInfo(workbench_.document().path()).fileName();
  const auto answer = QMessageBox::question(
      this, tr("Work is not saved"),
      !name.isEmpty()     ? tr("Save your changes to %1 first?").arg(name)
      : unsaved.isEmpty() ? tr("Save your work as a project first?")
                          : tr("Save your work as a project first? Not saved: %1.").arg(unsaved.join(", ")),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer != QMessageBox::Save) return answer == QMessageBox::Discard;
  // Goes on once the file is known to be whole; a failure keeps the window as it is and says why.
  save_project(false, std::move(saved));
  return false;
}

}  // namespace remount
