#include "widgets/panels/log_panel.h"

#include <QDateTime>
#include <QTextCharFormat>

#include "widgets/readable.h"
#include "widgets/theme.h"

namespace remount {

LogPanel::LogPanel(QWidget* parent) : QPlainTextEdit(parent) {
  setReadOnly(true);
  setMaximumBlockCount(5000);
  setAccessibleName(tr("Log"));
  setPlaceholderText(tr("What the program does and finds appears here."));
  keep_placeholder_readable(*this);
}

void LogPanel::add(Severity severity, const QString& where, const QString& what) {
  QTextCharFormat format;
  format.setForeground(severity_color(severity, palette()));
  QTextCursor cursor(document());
  cursor.movePosition(QTextCursor::End);
  if (!document()->isEmpty()) cursor.insertBlock();
  const QString time = QDateTime::currentDateTime().toString(QStringLiteral("hh:mm:ss  "));
  cursor.insertText(
      time + severity_sign(severity) + ' ' + (where.isEmpty() ? QString() : where + QStringLiteral(": ")) + what,
      format);
  moveCursor(QTextCursor::End);
  ensureCursorVisible();
}

}  // namespace remount
