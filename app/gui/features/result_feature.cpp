#include "app/gui/features/result_feature.h"

#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>

#include "app/gui/basics/ask_to_replace.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/document/result_files.h"
#include "app/gui/jobs/error_words.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/workbench/wording.h"
#include "model/drive/session_frames.h"
#include "model/results/result_words.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/result/result_panel.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

ResultFeature::ResultFeature(MainWindow& window) : Feature(window), result_(new widgets::ResultPanel) {
  result_->setMinimumWidth(200);
  QDockWidget* dock = window.add_dock({.title = tr("Result"),
                                       .name = "result",
                                       .content = result_,
                                       .area = Qt::RightDockWidgetArea,
                                       .help_page = "result",
                                       .width = 325});
  window.on_step(widgets::Step::Solve, [dock] { dock->show(); });
  window.on_step(widgets::Step::Export, [this] { show_export(); });
  make_actions();
  make_report();
  connect(result_, &widgets::ResultPanel::copy_requested, this, &ResultFeature::copy_result);
  connect(result_, &widgets::ResultPanel::export_requested, this, &ResultFeature::show_export);
  connect(result_, &widgets::ResultPanel::clock_offset_asked, &workbench_.setup(), &Setup::use_clock_offset);
}

void ResultFeature::make_actions() {
  Menus& menus = window_.menus();
  export_ = menus.add(MenuPlace::FileResult, tr("&Export result…"), tr("Ctrl+E"), [this] { show_export(); });
  make_report_ = menus.add(MenuPlace::FileResult, tr("Make &report…"), tr("Ctrl+R"), [this] { ask_for_report(); });
  copy_ = menus.add(MenuPlace::EditCopy, tr("&Copy result"), tr("Ctrl+Shift+C"), [this] { copy_result(); });
  use_as_nominal_ = menus.add(MenuPlace::CalibrateResult, tr("Use the result as &nominal mounting"), {},
                              [this] { use_as_nominal(); });
}

void ResultFeature::make_report() {
  report_ = new ReportMaker(workbench_, &window_);
  connect(report_, &ReportMaker::progressed, &window_, &MainWindow::tell);
  connect(report_, &ReportMaker::finished, this, [this](const QString& html, const QString& pdf) {
    workbench_.notices().say(drive::Severity::Note, html, tr("report saved, and as %1").arg(pdf));
    offer_to_open_report(workbench_.notices(), html);
  });
  connect(report_, &ReportMaker::failed, this, [this](const QString& where, const QString& what) {
    workbench_.notices().say(drive::Severity::Problem, where, what);
  });
}

void ResultFeature::show_output() {
  const Outcome& outcome = workbench_.outcome();
  result_->show_output(outcome.output(), outcome.output_before(), outcome.moved_by());
}

void ResultFeature::show_state() {
  const OutputPtr output = workbench_.outcome().output();
  export_->setEnabled(output && calibration::is_usable(output->result));
  make_report_->setEnabled(output != nullptr);
  copy_->setEnabled(output && results::has_mounting(output->result));
  use_as_nominal_->setEnabled(output && calibration::is_usable(output->result));
  result_->show_standing(standing_of(workbench_), standing_note(workbench_), next_text(workbench_));
}

void ResultFeature::show_export() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output || !calibration::is_usable(output->result))
    return workbench_.notices().say(
        drive::Severity::Warning, {},
        tr("There is no result to export yet. Open a session (Ctrl+O) and calibrate (F5)."));
  auto* dialog = new widgets::ExportDialog(
      export_formats(),
      [this](const QString& id) -> widgets::ExportText {
        try {
          return {export_text(workbench_, id), {}};
        } catch (const Error& error) {
          return {{}, tr("Cannot be written in this format: %1").arg(failure_of(error).what)};
        }
      },
      &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  follow_result(*dialog);
  connect(dialog, &widgets::ExportDialog::copied, this,
          [this] { workbench_.outcome().mark_exported(Exported::Copied); });
  connect(
      dialog, &widgets::ExportDialog::save_requested, this,
      [this, dialog](const QString&, const QString& path, const QString& text) { save_export(*dialog, path, text); });
  dialog->open();
}

void ResultFeature::follow_result(widgets::ExportDialog& dialog) {
  const auto follow = [this, &dialog] {
    const OutputPtr now = workbench_.outcome().output();
    if (!now || !calibration::is_usable(now->result)) return dialog.reject();
    dialog.show_warning(export_warning(workbench_));
    dialog.set_final(!workbench_.activity().solving());
    dialog.show_current();  // what is saved is what is the result then
  };
  follow();
  connect(&workbench_.outcome(), &Outcome::changed, &dialog, follow);
  connect(&workbench_, &Workbench::state_changed, &dialog, follow);
}

void ResultFeature::save_export(widgets::ExportDialog& dialog, const QString& path, const QString& text) {
  try {
    save_text(path, text);
    workbench_.outcome().mark_exported(Exported::Written);
    workbench_.notices().say(drive::Severity::Note, path, tr("saved"));
    dialog.show_outcome(tr("Saved: %1").arg(path), false);
  } catch (const Error& error) {
    const JobFailure failure = failure_of(error);
    workbench_.notices().say(drive::Severity::Problem, failure.where, failure.what);
    dialog.show_outcome(in_words(failure), true);
  }
}

void ResultFeature::ask_for_report() {
  if (report_->busy())
    return workbench_.notices().say(
        drive::Severity::Warning, {},
        tr("A report is being written already. Wait until the status line says that it is saved."));
  const QString project = workbench_.document().path();
  const QString suggested = project.isEmpty()
                                ? tr("report.html")
                                : QFileInfo(project).dir().filePath(QFileInfo(project).completeBaseName() + ".html");
  // The dialog knows of neither the suffix nor the PDF: what will be replaced is asked afterwards, once for both.
  QString path =
      widgets::ask_where_to_save(&window_, tr("Save the report (HTML, and PDF beside it)"), widgets::FileKind::Reports,
                                 suggested, tr("Web pages (*.html)"), QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  path = html_beside(path);
  if (ask_to_replace({path, pdf_beside(path)}, window_)) report_->make(path);
}

void ResultFeature::copy_result() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output) return;
  QString text = widgets::result_as_text(output->result);
  // With the numbers that an export has, for those who go on to paste them.
  if (calibration::is_usable(output->result)) {
    text += QStringLiteral("\n\n") + export_text(workbench_, QStringLiteral("matrix"));
    workbench_.outcome().mark_exported(Exported::Copied);
  }
  QGuiApplication::clipboard()->setText(text);
}

void ResultFeature::use_as_nominal() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output || !calibration::is_usable(output->result)) return;
  if (const Message problem = results::not_in_ins_frame(output->result.mounting.frames()); !problem.empty())
    workbench_.notices().say(drive::Severity::Problem, tr("Nominal mounting"), widgets::model_text(problem));
  else
    workbench_.setup().edit_nominal(output->result.mounting.ins_from_lidar());
}

}  // namespace remount::gui
