// What happened, line by line.
#pragma once

#include <QPlainTextEdit>
#include <QTextCharFormat>

#include "model/drive/session.h"

namespace remount::widgets {

class LogPanel : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit LogPanel(QWidget* parent = nullptr);
  void add(drive::Severity severity, const QString& where, const QString& what);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QTextCharFormat format_of(drive::Severity severity) const;
};

}  // namespace remount::widgets
