#include "app/gui/features/run_feature.h"

#include <QAction>
#include <QStatusBar>

#include "app/gui/shell/main_window.h"
#include "app/gui/workbench/wording.h"
#include "widgets/shell/message_banner.h"
#include "widgets/shell/progress_strip.h"

namespace remount::gui {

RunFeature::RunFeature(MainWindow& window)
    : Feature(window), progress_(new widgets::ProgressStrip(&window)), banner_(new widgets::MessageBanner(&window)) {
  Menus& menus = window.menus();
  calibrate_ =
      menus.add(MenuPlace::CalibrateRun, tr("&Calibrate"), tr("F5"), [this] { workbench_.calibrations().calibrate(); });
  cancel_ = menus.add(MenuPlace::CalibrateRun, tr("C&ancel"), tr("Esc"), [this] { workbench_.cancel(); });
  window.statusBar()->addWidget(progress_, 1);
  window.add_banner(banner_);
  connect(progress_, &widgets::ProgressStrip::cancel_clicked, &workbench_, &Workbench::cancel);
  connect(progress_, &widgets::ProgressStrip::cancel_clicked, progress_, &widgets::ProgressStrip::show_cancelling);
  connect(cancel_, &QAction::triggered, this, [this] {
    if (was_busy_) progress_->show_cancelling();
  });
  connect(&window, &MainWindow::told, this, &RunFeature::tell);
  connect(&workbench_.notices(), &Notices::message, this, &RunFeature::show_message);
  connect(&workbench_.notices(), &Notices::offered, banner_, &widgets::MessageBanner::offer);
  connect(&workbench_.activity(), &Activity::progressed, progress_, &widgets::ProgressStrip::show_progress);
  connect(&workbench_.document(), &ProjectDocument::replaced, this, &RunFeature::forget_project);
}

void RunFeature::tell(const QString& text) {
  if (was_busy_) return;
  if (solving_since_.isValid() && text == idle_text(workbench_))
    progress_->wait(text, solving_since_);
  else
    progress_->stop(text);
}

void RunFeature::forget_project() {
  banner_->hide();
  note_at_end_.clear();
  idle_.clear();  // the strip speaks of the project before
}

void RunFeature::show_busy(bool busy) {
  if (busy && !was_busy_) {
    note_at_end_.clear();
    banner_->hide();  // what it says is answered by what was started
    progress_->start(workbench_.activity().opening() ? tr("Opening sessions…") : tr("Calibrating…"));
  }
  if (!busy && was_busy_) {
    was_busy_ = false;
    tell(note_at_end_.isEmpty() || workbench_.calibrations().out_of_date() ? idle_text(workbench_) : note_at_end_);
    idle_ = idle_text(workbench_);
  }
  was_busy_ = busy;
}

void RunFeature::show_state() {
  const bool busy = workbench_.activity().opening() || workbench_.activity().calibrating();
  if (!workbench_.activity().solving())
    solving_since_.invalidate();
  else if (!solving_since_.isValid())
    solving_since_.start();
  show_busy(busy);
  if (const QString idle = idle_text(workbench_); !busy && idle != idle_) {
    idle_ = idle;
    tell(idle);
  }
  calibrate_->setEnabled(!busy);
  cancel_->setEnabled(busy);
}

void RunFeature::show_message(drive::Severity severity, const QString& where, const QString& what) {
  if (what.isEmpty()) return;
  if (severity != drive::Severity::Note) return banner_->show_message(severity, where, what);
  note_at_end_ = where.isEmpty() ? what : where + QStringLiteral(": ") + what;
  tell(note_at_end_);
}

}  // namespace remount::gui
