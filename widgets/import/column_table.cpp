#include "widgets/import/column_table.h"

#include <QComboBox>
#include <QHeaderView>
#include <QScrollBar>
#include <algorithm>

#include "widgets/basics/rows.h"
#include "widgets/basics/wheel_scrolls.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

using guesses::ColumnRole;

/// Where lists have a line between kinds of columns.
bool ends_kind(ColumnRole role) {
  return role == ColumnRole::Ignored || role == guesses::kTimeRoles.back() || role == guesses::kPositionRoles.back() ||
         role == guesses::kAngleRoles.back() || role == guesses::kQuaternionRoles.back() ||
         role == guesses::kAttitudeSigmaRoles.back();
}

}  // namespace

ColumnTable::ColumnTable(QWidget* parent) : QTableWidget(parent) {
  setAccessibleName(tr("Columns of the table"));
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::NoSelection);
  setTabKeyNavigation(false);  // Tab goes from list to list
  setAlternatingRowColors(true);
  setWordWrap(false);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  verticalHeader()->setVisible(false);
  verticalHeader()->setMinimumSectionSize(1);
}

void ColumnTable::show_table(const guesses::ImportTable& table) {
  clear();
  lists_.clear();
  setRowCount(qt_count(table.first_rows.size()) + 1);
  setColumnCount(qt_count(table.table.columns.size()));
  const int line = fontMetrics().height() + 4;
  for (std::size_t column = 0; column < table.table.columns.size(); ++column) {
    const guesses::SampledColumn& one = table.table.columns[column];
    QString title = QString::fromStdString(table.table.label(column));
    if (one.title.empty()) title = tr("column %1").arg(column);
    auto* head = new QTableWidgetItem(one.unit.empty() ? title : title + ' ' + QString::fromStdString(one.unit));
    head->setToolTip(head->text());
    setHorizontalHeaderItem(qt_count(column), head);
    QComboBox* list = make_list(column, title);
    lists_.push_back(list);
    setCellWidget(0, qt_count(column), list);
    for (std::size_t row = 0; row < table.first_rows.size(); ++row) {
      const std::vector<std::string>& fields = table.first_rows[row];
      auto* item = new QTableWidgetItem(column < fields.size() ? QString::fromStdString(fields[column]) : QString());
      item->setFlags(Qt::ItemIsEnabled);
      setItem(qt_count(row) + 1, qt_count(column), item);
    }
  }
  resizeColumnsToContents();
  constexpr int kNarrowest_em = 11, kWidest_em = 16;
  const int em = fontMetrics().horizontalAdvance('m');
  for (int column = 0; column < columnCount(); ++column)
    setColumnWidth(column, std::clamp(columnWidth(column), kNarrowest_em * em, kWidest_em * em));
  for (int row = 1; row < rowCount(); ++row) setRowHeight(row, line);
  if (!lists_.empty()) setRowHeight(0, lists_.front()->sizeHint().height());
  int height = horizontalHeader()->sizeHint().height() + 2 * frameWidth() + horizontalScrollBar()->sizeHint().height();
  for (int row = 0; row < rowCount(); ++row) height += rowHeight(row);
  setMaximumHeight(height);
}

QComboBox* ColumnTable::make_list(std::size_t column, const QString& title) {
  auto* list = new QComboBox(this);
  for (std::size_t i = 0; i < guesses::kColumnRoleCount; ++i) {
    const auto role = static_cast<ColumnRole>(i);
    list->addItem(model_text(guesses::words(role)), static_cast<int>(i));
    if (ends_kind(role)) list->insertSeparator(list->count());
  }
  list->setMaxVisibleItems(32);
  list->setFocusPolicy(Qt::StrongFocus);
  let_wheel_scroll(*list);
  list->setAccessibleName(tr("What column %1 is").arg(title));
  connect(list, &QComboBox::activated, this,
          [this, list, column] { emit role_chosen(column, static_cast<ColumnRole>(list->currentData().toInt())); });
  return list;
}

void ColumnTable::show_roles(const std::vector<guesses::ColumnRole>& roles) {
  for (std::size_t column = 0; column < std::min(roles.size(), lists_.size()); ++column) {
    QComboBox& list = *lists_[column];
    list.setCurrentIndex(list.findData(static_cast<int>(roles[column])));
    QFont font = this->font();
    font.setBold(roles[column] != ColumnRole::Ignored);
    list.setFont(font);
  }
}

}  // namespace remount::widgets
