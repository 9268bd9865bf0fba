// What runs, and what is said to the user about it.
#pragma once

#include <QElapsedTimer>

#include "app/gui/shell/feature.h"
#include "model/drive/finding.h"

class QAction;

namespace remount::widgets {
class MessageBanner;
class ProgressStrip;
}  // namespace remount::widgets

namespace remount::gui {

/// Calibrate and cancel, the status strip, and the banner for what must not be missed.
class RunFeature : public Feature {
  Q_OBJECT
 public:
  explicit RunFeature(MainWindow& window);
  void show_state() override;

 private:
  void tell(const QString& text);  ///< unless a calibration reports there
  void forget_project();
  void show_busy(bool busy);
  void show_message(drive::Severity severity, const QString& where, const QString& what);

  QAction *calibrate_, *cancel_;
  widgets::ProgressStrip* progress_;
  widgets::MessageBanner* banner_;
  bool was_busy_ = false;
  QElapsedTimer solving_since_;  // of solutions after edits; not valid while there is none
  QString idle_;                 // what the status strip said last while nothing ran
  QString note_at_end_;          // what it says when the present work is done
};

}  // namespace remount::gui
