// Progress in the status bar: stage, count, remaining time, cancel.
#pragma once

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QTimer;
class QToolButton;

namespace remount {

class ProgressStrip : public QWidget {
  Q_OBJECT
 public:
  explicit ProgressStrip(QWidget* parent = nullptr);
  void start(const QString& what);
  void show_progress(const QString& stage, qulonglong done, qulonglong total);
  void show_cancelling();
  void stop(const QString& what);

 signals:
  void cancel_clicked();

 private:
  QLabel* text_;
  QProgressBar* bar_;
  QToolButton* cancel_;
  void say();

  QElapsedTimer since_stage_;
  QTimer* second_;  ///< so that a long step is not "about 1 s left" until it ends
  QString stage_;
  qulonglong done_at_start_ = 0, done_ = 0, total_ = 0;
};

/// "about 2 min left in this step" from how long `done` of `total` took; empty where it is too early to say.
QString remaining_text(qint64 elapsed_ms, double done, double total);

}  // namespace remount
