#include "widgets/pairs/pairs_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/text/readable.h"

namespace remount::widgets {
namespace {
constexpr int kMeasuredRows = 60;  // that a column's width follows: all of a hundred thousand would take seconds

/// Of a pair that the user decided, pixels.
int widest_state(const QFontMetrics& metrics) {
  motion::Pair pair;
  pair.decided_by = motion::DecidedBy::User;
  int widest = 0;
  for (const motion::PairState state : {motion::PairState::Accepted, motion::PairState::Rejected}) {
    pair.state = state;
    widest = std::max(widest, metrics.horizontalAdvance(state_text(pair)));
  }
  return widest + 2 * metrics.averageCharWidth();
}
}  // namespace

PairsPanel::PairsPanel(PairTableModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      filter_(new PairFilter(this)),
      table_(new QTableView(this)),
      state_(new QComboBox(this)),
      group_(new QComboBox(this)),
      text_(new QLineEdit(this)),
      count_(new QLabel(this)),
      seen_(new QLabel(this)),
      sort_again_(new QToolButton(this)),
      accept_(new QPushButton(tr("✓ Accept"), this)),
      reject_(new QToolButton(this)) {
  filter_->setSourceModel(&model_);
  make_table();
  auto* row = new QHBoxLayout;
  make_filters(*row);
  make_buttons(*row);
  connect(filter_, &PairFilter::shown_changed, this, [this] {
    update_count();
    show_selected(selected_);
    emit shown_changed();
  });
  connect(filter_, &PairFilter::order_kept, this, [this] {
    sort_again_->setVisible(!filter_->in_order());
    update_count();
  });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->addLayout(row);
  column->addWidget(table_, 1);
  update_count();
}

void PairsPanel::make_table() {
  table_->setModel(filter_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(PairTableModel::Number, Qt::AscendingOrder);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  table_->setAlternatingRowColors(true);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setResizeContentsPrecision(kMeasuredRows);
  table_->setAccessibleName(tr("Pairs"));
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (!current.isValid()) return;
    last_row_ = current.row();
    emit pair_selected(filter_->pairs().at(index_at(current.row())));
  });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PairsPanel::update_decisions);
  table_->installEventFilter(this);
}

void PairsPanel::make_filters(QHBoxLayout& row) {
  state_->addItems({tr("All states"), tr("Proposed"), tr("Accepted"), tr("Rejected")});
  state_->setAccessibleName(tr("Show pairs of this state"));
  group_->addItems({tr("All pairs"), tr("Not decided by you"), tr("Not looked at"), tr("Flagged or commented"),
                    tr("Worst %1").arg(kWorst), tr("INS and LiDAR disagree"),
                    tr("Few shared objects (< %1)").arg(kFewShared), tr("Not aligned")});
  group_->setItemData(static_cast<int>(PairGroup::Worst10), tr("By what the bars show, among those of the state"),
                      Qt::ToolTipRole);
  group_->setItemData(static_cast<int>(PairGroup::ScrewFailed),
                      tr("Turn and advance of INS and LiDAR differ, whatever the mounting (screw test)"),
                      Qt::ToolTipRole);
  group_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  group_->setMinimumContentsLength(9);  // the buttons that decide are to be seen in a narrow panel, too
  group_->setAccessibleName(tr("Show pairs of this kind"));
  text_->setPlaceholderText(tr("Number or text"));
  keep_placeholder_readable(*text_);
  text_->setToolTip(tr("Shows pairs of this number, or with this text in state, session, reason or comment"));
  text_->setClearButtonEnabled(true);
  text_->setAccessibleName(tr("Show pairs that contain this text"));
  text_->setMinimumWidth(60);
  text_->installEventFilter(this);
  sort_again_->setText(tr("Sort again"));
  sort_again_->setToolTip(
      tr("Pairs stay where they were while you decide about them. This puts them where they belong now."));
  sort_again_->hide();
  connect(sort_again_, &QToolButton::clicked, filter_, &PairFilter::sort_again);
  connect(state_, &QComboBox::currentIndexChanged, this, &PairsPanel::apply_criteria);
  connect(group_, &QComboBox::currentIndexChanged, this, &PairsPanel::apply_criteria);
  connect(text_, &QLineEdit::textChanged, this, &PairsPanel::apply_criteria);
  row.addWidget(state_);
  row.addWidget(group_);
  row.addWidget(text_, 1);
  row.addWidget(sort_again_);
  row.addWidget(count_);
  row.addWidget(seen_);
}

void PairsPanel::make_buttons(QHBoxLayout& row) {
  accept_->setToolTip(tr("Accept the marked pairs"));
  reject_->setText(tr("✕ Reject"));
  reject_->setToolTip(tr("Reject the marked pairs; the arrow gives reasons"));
  reject_->setAccessibleName(tr("Reject"));
  reject_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  reject_->setFocusPolicy(Qt::StrongFocus);
  reject_->setMinimumHeight(accept_->sizeHint().height());
  connect(accept_, &QPushButton::clicked, this, &PairsPanel::accept_clicked);
  connect(reject_, &QToolButton::clicked, this, &PairsPanel::reject_clicked);
  tools_ = new QHBoxLayout;
  row.addLayout(tools_);
  row.addWidget(accept_);
  row.addWidget(reject_);
}

void PairsPanel::set_reason_menu(QMenu* menu) {
  reject_->setMenu(menu);
  reject_->setPopupMode(QToolButton::MenuButtonPopup);
}

void PairsPanel::show_marks(PairMarksPtr marks, int seen) {
  model_.show_marks(std::move(marks));
  seen_->setText(model_.rowCount() == 0 ? QString() : tr("%1 looked at").arg(seen));
  seen_->setToolTip(
      tr("%1 of %2 pairs were looked at; the numbers of the others are bold").arg(seen).arg(model_.rowCount()));
}

void PairsPanel::add_tool(QWidget* tool) { tools_->addWidget(tool); }

void PairsPanel::set_measure(PairMeasure measure) {
  PairCriteria criteria = filter_->criteria();
  criteria.measure = measure;
  filter_->set_criteria(criteria);
}

void PairsPanel::apply_criteria() {
  PairCriteria criteria = filter_->criteria();
  criteria.state = state_->currentIndex() == 0
                       ? std::nullopt
                       : std::optional(static_cast<motion::PairState>(state_->currentIndex() - 1));
  criteria.group = static_cast<PairGroup>(group_->currentIndex());
  criteria.text = text_->text();
  filter_->set_criteria(criteria);
}

void PairsPanel::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  update_count();
  if (!output || output->pairs.empty()) {
    sized_ = false;
    return;
  }
  if (sized_) return;
  sized_ = true;
  for (int column = 0; column < PairTableModel::Reason; ++column) table_->resizeColumnToContents(column);
  // Decisions make words longer than those that are there now.
  table_->setColumnWidth(PairTableModel::State,
                         std::max(table_->columnWidth(PairTableModel::State), widest_state(table_->fontMetrics())));
}

void PairsPanel::show_selected(std::optional<motion::PairIndex> pair) {
  selected_ = pair;
  filter_->hold(pair);
  const int row = filter_->row_of(pair);
  const QSignalBlocker quiet(this);
  if (row < 0) {
    table_->clearSelection();
    return;
  }
  last_row_ = row;
  const QModelIndex index = filter_->index(row, 0);
  if (table_->currentIndex().row() != row || !table_->selectionModel()->isRowSelected(row, {})) {
    table_->setCurrentIndex(index);
    table_->scrollTo(index);
  }
}

std::vector<motion::PairIndex> PairsPanel::marked_pairs() const {
  std::vector<motion::PairIndex> pairs;
  for (const QModelIndex& index : table_->selectionModel()->selectedRows())
    pairs.push_back(filter_->pairs().at(index_at(index.row())));
  std::sort(pairs.begin(), pairs.end());
  if (!selected_) return pairs;
  return std::binary_search(pairs.begin(), pairs.end(), *selected_) ? pairs : std::vector{*selected_};
}

std::optional<motion::PairIndex> PairsPanel::neighbour(int step, bool undecided) const {
  const int rows = filter_->rowCount();
  const int present = filter_->row_of(selected_);
  // Where the present pair is no longer shown, the next one has moved into its place.
  int current = present >= 0 ? present : std::min(last_row_, rows) - (step > 0 ? 1 : 0);
  if (!selected_) current = step > 0 ? -1 : rows;
  for (int moved = 1; moved <= rows; ++moved) {
    int row = current + step * moved;
    if (undecided) row = ((row % rows) + rows) % rows;  // goes on from the start: none is forgotten
    if (row < 0 || row >= rows) return std::nullopt;
    const motion::PairIndex pair = filter_->pairs()[index_at(row)];
    if (!undecided || model_.pair(pair)->decided_by != motion::DecidedBy::User) return pair;
  }
  return std::nullopt;
}

std::vector<motion::PairIndex> PairsPanel::neighbours(std::initializer_list<int> steps) const {
  const int present = filter_->row_of(selected_);
  std::vector<motion::PairIndex> pairs;
  for (const int step : steps)
    if (const int row = present + step; present >= 0 && row >= 0 && row < filter_->rowCount())
      pairs.push_back(filter_->pairs()[index_at(row)]);
  return pairs;
}

void PairsPanel::update_count() {
  const int shown = filter_->rowCount(), all = model_.rowCount();
  const int matching = qt_count(filter_->matching());
  accept_->setEnabled(shown > 0);
  reject_->setEnabled(shown > 0);
  count_->setText(all == 0          ? tr("no pairs yet")
                  : matching == 0   ? tr("none of %1 pairs matches").arg(all)
                  : matching == all ? tr("%n pairs", nullptr, all)
                                    : tr("%1 of %2 pairs").arg(matching).arg(all));
  update_decisions();
}

/// Of several pairs the buttons say how many they meet.
void PairsPanel::update_decisions() {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (rows.size() == 1) anchor_row_ = rows.front().row();
  const int marked = qt_count(marked_pairs().size());
  accept_->setText(marked > 1 ? tr("✓ Accept %1").arg(marked) : tr("✓ Accept"));
  reject_->setText(marked > 1 ? tr("✕ Reject %1").arg(marked) : tr("✕ Reject"));
}

/// Qt would mark from the row that was clicked on last, wherever the keys have gone since.
void PairsPanel::extend_marks(int steps) {
  const int to = std::clamp(table_->currentIndex().row() + steps, 0, filter_->rowCount() - 1);
  const QItemSelection marks(filter_->index(std::min(anchor_row_, to), 0),
                             filter_->index(std::max(anchor_row_, to), 0));
  table_->selectionModel()->select(marks, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  table_->selectionModel()->setCurrentIndex(filter_->index(to, 0), QItemSelectionModel::NoUpdate);
}

bool PairsPanel::eventFilter(QObject* watched, QEvent* event) {
  // Or the window's Esc, which cancels work, would take it.
  if (watched == text_ && event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  auto& key = static_cast<QKeyEvent&>(*event);
  // What was typed is found: the keys are for the pairs again.
  const bool leaves = key.key() == Qt::Key_Escape || key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter ||
                      key.key() == Qt::Key_Down;
  if (watched == text_ && leaves) {
    if (key.key() == Qt::Key_Escape) text_->clear();
    table_->setFocus();
    return true;
  }
  // With Ctrl these would move the current row and leave another one marked, which a decision would meet unseen.
  const bool jumps = key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
  if (watched == table_ && jumps && key.modifiers() == Qt::ControlModifier && filter_->rowCount() > 0) {
    table_->selectionModel()->setCurrentIndex(
        filter_->index(key.key() == Qt::Key_Home ? 0 : filter_->rowCount() - 1, 0),
        QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    return true;
  }
  const int page = std::max(1, table_->viewport()->height() / table_->verticalHeader()->defaultSectionSize());
  const int steps = key.key() == Qt::Key_Up         ? -1
                    : key.key() == Qt::Key_Down     ? 1
                    : key.key() == Qt::Key_PageUp   ? -page
                    : key.key() == Qt::Key_PageDown ? page
                                                    : 0;
  if (watched == table_ && key.modifiers() == Qt::ShiftModifier && steps != 0 && filter_->rowCount() > 0) {
    extend_marks(steps);
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace remount::widgets
