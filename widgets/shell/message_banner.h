// A line across the window that says what went wrong, where, and what to try; it waits to be read.
#pragma once

#include <QFrame>
#include <functional>

#include "model/drive/session.h"

class QLabel;
class QPushButton;
class QScrollArea;

namespace remount::widgets {

class MessageBanner : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBanner(QWidget* parent = nullptr);
  void show_message(drive::Severity severity, const QString& where, const QString& what);
  /// A button beside the message that is shown: what can be done about it. It goes with the message.
  void offer(const QString& label, const std::function<void()>& act);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit_height();
  QLabel* text_;
  QScrollArea* scroll_;
  QPushButton* offer_;
  std::function<void()> act_;
};

}  // namespace remount::widgets
