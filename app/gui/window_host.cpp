#include "app/gui/window_host.h"

#include <QTimer>
#include <utility>

#include "app/gui/basics/language.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/features/all_features.h"

namespace remount::gui {

WindowHost::WindowHost(Workbench& workbench, QObject* parent)
    : QObject(parent), workbench_(workbench), window_(std::make_unique<MainWindow>(workbench, all_features())) {
  connect_window();
}

void WindowHost::connect_window() {
  // From the loop: the menu that asks belongs to the window that goes.
  connect(window_.get(), &MainWindow::language_requested, this,
          [this](const QString& code) { QTimer::singleShot(0, this, [this, code] { change_language(code); }); });
  // Queued: the report's maker goes with the window.
  const auto change = [this] {
    if (!wanted_.isEmpty()) change_language(std::exchange(wanted_, {}));
  };
  connect(&report(), &ReportMaker::finished, this, change, Qt::QueuedConnection);
  connect(&report(), &ReportMaker::failed, this, change, Qt::QueuedConnection);
}

ReportMaker& WindowHost::report() { return *window_->findChild<ReportMaker*>(); }

void WindowHost::change_language(const QString& code) {
  wanted_.clear();
  if (code == spoken_language()) return;
  if (report().busy()) {
    wanted_ = code;
    workbench_.notices().say(drive::Severity::Note, {}, tr("The language changes as soon as the report is written."));
    return;
  }
  WindowHandover handover = window_->hand_over();
  speak(code, true);
  workbench_.history().name_edits_anew();
  auto next = std::make_unique<MainWindow>(workbench_, all_features());
  next->take_over(std::move(handover));
  const bool visible = window_->isVisible();
  if (visible) next->show();
  window_->hide();
  window_ = std::move(next);
  connect_window();
  workbench_.announce();
  if (visible) window_->activateWindow();
  emit window_changed();
}

}  // namespace remount::gui
