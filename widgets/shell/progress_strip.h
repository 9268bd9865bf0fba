// Progress in the status bar: stage, count, remaining time, cancel.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "algorithms/core/remaining_time.h"
#include "algorithms/messages/message.h"

class QLabel;
class QTimer;
class QToolButton;

namespace remount::widgets {

class BusyBar;

class ProgressStrip : public QWidget {
  Q_OBJECT
 public:
  explicit ProgressStrip(QWidget* parent = nullptr);
  void start(const QString& what);
  /// Work that nobody is kept from working by: shows a moving bar once it takes longer, and how long it has taken.
  void wait(const QString& what, const QElapsedTimer& since);
  void show_progress(const Message& stage, qulonglong done, qulonglong total);
  void show_cancelling();
  void stop(const QString& what);

 signals:
  void cancel_clicked();

 private:
  void tick();
  void say();

  QLabel *text_, *elapsed_;
  BusyBar* bar_;
  QToolButton* cancel_;
  QElapsedTimer since_stage_, since_shown_;
  QTimer* second_;  ///< so that what is left counts down where nothing is reported for a while
  RemainingTime remaining_;
  Message stage_;
  qulonglong done_at_start_ = 0, done_ = 0, total_ = 0;
};

/// "12 s", "2 min 5 s".
QString elapsed_text(qint64 elapsed_ms);

/// "about 2 min 30 s left in this step": fine enough to be seen to count down.
QString remaining_text(double left_s);

}  // namespace remount::widgets
