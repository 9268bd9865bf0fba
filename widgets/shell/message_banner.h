// A line across the window that says what went wrong, where, and what to try; it waits to be read.
#pragma once

#include <QFrame>

#include "model/drive/session.h"

class QLabel;
class QScrollArea;

namespace remount::widgets {

class MessageBanner : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBanner(QWidget* parent = nullptr);
  void show_message(drive::Severity severity, const QString& where, const QString& what);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit_height();
  QLabel* text_;
  QScrollArea* scroll_;
};

}  // namespace remount::widgets
