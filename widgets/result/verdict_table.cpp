#include "widgets/result/verdict_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "algorithms/core/index.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"

namespace remount::widgets {
namespace {

constexpr int kVerdictRole = Qt::UserRole, kBar_px = 4;

QColor color_of(Verdict verdict, const QPalette& palette) {
  switch (verdict) {
    case Verdict::Good:
      return good_color(palette);
    case Verdict::Doubtful:
      return warning_color(palette);
    case Verdict::Bad:
      return bad_color(palette);
    case Verdict::Neutral:
      break;
  }
  return palette.color(QPalette::Disabled, QPalette::WindowText);
}

/// Colours never speak alone.
QString sign_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Good:
      return QStringLiteral("✓ ");
    case Verdict::Doubtful:
      return QStringLiteral("▲ ");
    case Verdict::Bad:
      return QStringLiteral("✕ ");
    case Verdict::Neutral:
      break;
  }
  return {};
}

}  // namespace

VerdictLabel::VerdictLabel(const QString& accessible_name, QWidget* parent) : QLabel(parent) {
  setWordWrap(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  setAccessibleName(accessible_name);
  setContentsMargins(kBar_px + 5, 4, 4, 4);
}

void VerdictLabel::show_verdict(Verdict verdict, const QString& text) {
  verdict_ = verdict;
  setText(sign_of(verdict) + text);
  update();
}

// Painted, for a style sheet would change the palette again while it changes.
void VerdictLabel::paintEvent(QPaintEvent* event) {
  const QColor color = color_of(verdict_, palette());
  {
    QPainter painter(this);
    painter.fillRect(rect(), tint(color, palette()));
    painter.fillRect(QRect(0, 0, kBar_px, height()), color);
  }
  QLabel::paintEvent(event);
}

NoteLabel::NoteLabel(QWidget* parent) : QLabel(parent) {
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void NoteLabel::show_note(const QString& text) {
  setText(text);
  setVisible(!text.isEmpty());
  fit_height();
}

void NoteLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit_height();
}

void NoteLabel::fit_height() {
  setMinimumHeight(0);  // heightForWidth is never below it
  setMinimumHeight(std::max(0, heightForWidth(width())));
}

FigureTable::FigureTable(const QString& accessible_name, QWidget* parent) : QTableWidget(parent) {
  setAccessibleName(accessible_name);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setAlternatingRowColors(true);
  setTabKeyNavigation(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
}

void FigureTable::show_rows(const QStringList& heads, const std::vector<std::vector<TableCell>>& rows) {
  clear();
  setColumnCount(qt_count(heads.size()));
  setHorizontalHeaderLabels(heads);
  setRowCount(qt_count(rows.size()));
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < columnCount(); ++column) {
      const TableCell& cell = rows[index_at(row)].at(index_at(column));
      auto* item = new QTableWidgetItem(sign_of(cell.verdict) + cell.text);
      item->setToolTip(cell.tool_tip);
      item->setTextAlignment(Qt::AlignVCenter | (column == 0 ? Qt::AlignLeft : Qt::AlignRight));
      item->setData(kVerdictRole, static_cast<int>(cell.verdict));
      setItem(row, column, item);
    }
  recolor();
  resizeColumnsToContents();
  fit_height();
}

// A few rows are seen whole, and the bar that moves a table of many columns; the page scrolls where there is no room.
void FigureTable::fit_height() {
  constexpr int kRows = 4, kFewColumns = 6;
  const int bar = columnCount() > kFewColumns ? horizontalScrollBar()->sizeHint().height() : 0;
  setMinimumHeight(horizontalHeader()->sizeHint().height() +
                   std::min(kRows, rowCount()) * verticalHeader()->defaultSectionSize() + 2 * frameWidth() + bar);
}

void FigureTable::recolor() {
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < columnCount(); ++column) {
      const auto verdict = static_cast<Verdict>(item(row, column)->data(kVerdictRole).toInt());
      item(row, column)
          ->setForeground(verdict == Verdict::Neutral ? palette().brush(QPalette::Text)
                                                      : QBrush(color_of(verdict, palette())));
    }
}

void FigureTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) recolor();
  QTableWidget::changeEvent(event);
}

TableCell unknown_cell(const QString& why) { return {QStringLiteral("–"), why, Verdict::Neutral}; }

}  // namespace remount::widgets
