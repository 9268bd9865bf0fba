#include "widgets/shell/log_panel.h"

#include <QDateTime>
#include <QEvent>
#include <QTextBlock>

#include "widgets/basics/theme.h"
#include "widgets/text/readable.h"

namespace remount::widgets {

LogPanel::LogPanel(QWidget* parent) : QPlainTextEdit(parent) {
  setReadOnly(true);
  setMaximumBlockCount(5000);
  setAccessibleName(tr("Log"));
  setPlaceholderText(tr("What the program does and finds appears here."));
  keep_placeholder_readable(*this);
}

void LogPanel::add(drive::Severity severity, const QString& where, const QString& what) {
  QTextCursor cursor(document());
  cursor.movePosition(QTextCursor::End);
  if (!document()->isEmpty()) cursor.insertBlock();
  const QString time = QDateTime::currentDateTime().toString(QStringLiteral("hh:mm:ss  "));
  cursor.insertText(
      time + severity_sign(severity) + ' ' + (where.isEmpty() ? QString() : where + QStringLiteral(": ")) + what,
      format_of(severity));
  cursor.block().setUserState(static_cast<int>(severity));
  moveCursor(QTextCursor::End);
  ensureCursorVisible();
}

// Notes are in the colour of all text.
QTextCharFormat LogPanel::format_of(drive::Severity severity) const {
  QTextCharFormat format;
  if (severity != drive::Severity::Note) format.setForeground(severity_color(severity, palette()));
  return format;
}

void LogPanel::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    if (block.userState() < 0) continue;
    QTextCursor cursor(block);
    cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    cursor.setCharFormat(format_of(static_cast<drive::Severity>(block.userState())));
  }
}

}  // namespace remount::widgets
