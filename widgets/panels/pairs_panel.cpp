#include "widgets/panels/pairs_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableView>
#include <algorithm>

#include "widgets/charts/error_bar_chart.h"

namespace remount {

PairsPanel::PairsPanel(PairTableModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      filter_(new PairFilter(this)),
      table_(new QTableView(this)),
      chart_(new ErrorBarChart(this)) {
  filter_->setSourceModel(&model_);
  table_->setModel(filter_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(PairTableModel::Number, Qt::AscendingOrder);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  table_->setAlternatingRowColors(true);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setAccessibleName(tr("Pairs"));
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (current.isValid()) emit pair_selected(filter_->mapToSource(current).row());
  });
  connect(chart_, &ErrorBarChart::pair_clicked, this, &PairsPanel::pair_selected);
  connect(filter_, &QAbstractItemModel::rowsInserted, this, &PairsPanel::update_count);
  connect(filter_, &QAbstractItemModel::rowsRemoved, this, &PairsPanel::update_count);
  connect(filter_, &QAbstractItemModel::modelReset, this, &PairsPanel::update_count);

  auto* left = new QWidget(this);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(make_filter_row());
  column->addWidget(table_, 1);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(left);
  splitter->addWidget(make_chart_side());
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addWidget(splitter);
  update_count();
}

QWidget* PairsPanel::make_filter_row() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  state_ = new QComboBox(row);
  state_->addItems({tr("All states"), tr("Proposed"), tr("Accepted"), tr("Rejected")});
  state_->setAccessibleName(tr("Show pairs of this state"));
  text_ = new QLineEdit(row);
  text_->setPlaceholderText(tr("Filter by text"));
  text_->setClearButtonEnabled(true);
  text_->setAccessibleName(tr("Show pairs that contain this text"));
  count_ = new QLabel(row);
  accept_ = new QPushButton(tr("✓ Accept"), row);
  accept_->setToolTip(tr("Accept the marked pairs (A)"));
  reject_ = new QPushButton(tr("✕ Reject"), row);
  reject_->setToolTip(tr("Reject the marked pairs (R)"));
  connect(accept_, &QPushButton::clicked, this, &PairsPanel::accept_clicked);
  connect(reject_, &QPushButton::clicked, this, &PairsPanel::reject_clicked);
  connect(state_, &QComboBox::currentIndexChanged, this, [this](int index) {
    filter_->set_state(index == 0 ? std::nullopt : std::optional(static_cast<PairState>(index - 1)));
  });
  connect(text_, &QLineEdit::textChanged, filter_, &PairFilter::set_text);
  layout->addWidget(state_);
  layout->addWidget(text_, 1);
  layout->addWidget(count_);
  layout->addWidget(accept_);
  layout->addWidget(reject_);
  return row;
}

QWidget* PairsPanel::make_chart_side() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  auto* measure = new QComboBox(side);
  measure->addItems({tr("Residual translation"), tr("Residual rotation"), tr("Alignment RMSE"), tr("Screw test")});
  measure->setAccessibleName(tr("What the bars show"));
  connect(measure, &QComboBox::currentIndexChanged, this,
          [this](int index) { chart_->set_measure(static_cast<PairMeasure>(index)); });
  column->addWidget(measure);
  column->addWidget(chart_, 1);
  return side;
}

void PairsPanel::show_output(std::shared_ptr<const PipelineOutput> output) {
  chart_->show_output(std::move(output));
  update_count();
  if (model_.rowCount() == 0) return;
  for (int column = 0; column < PairTableModel::Reason; ++column) table_->resizeColumnToContents(column);
}

void PairsPanel::show_selected(int pair) {
  chart_->show_selected(pair);
  const QModelIndex index = filter_->mapFromSource(model_.index(pair, 0));
  const QSignalBlocker quiet(this);
  if (!index.isValid()) {
    table_->clearSelection();
  } else if (table_->currentIndex().row() != index.row() || !table_->selectionModel()->isRowSelected(index.row(), {})) {
    table_->setCurrentIndex(index);
    table_->scrollTo(index);
  }
}

std::vector<int> PairsPanel::marked_pairs() const {
  std::vector<int> pairs;
  for (const QModelIndex& index : table_->selectionModel()->selectedRows())
    pairs.push_back(filter_->mapToSource(index).row());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

int PairsPanel::neighbour(int step, bool undecided) const {
  const int rows = filter_->rowCount();
  const int current = table_->currentIndex().isValid() ? table_->currentIndex().row() : (step > 0 ? -1 : rows);
  for (int moved = 1; moved <= rows; ++moved) {
    int row = current + step * moved;
    if (undecided) row = ((row % rows) + rows) % rows;  // goes on from the start: none is forgotten
    if (row < 0 || row >= rows) return -1;
    const int pair = filter_->mapToSource(filter_->index(row, 0)).row();
    if (!undecided || model_.pair(pair)->decided_by != DecidedBy::User) return pair;
  }
  return -1;
}

void PairsPanel::update_count() {
  if (!count_) return;
  const int shown = filter_->rowCount(), all = model_.rowCount();
  for (QPushButton* button : {accept_, reject_}) button->setEnabled(shown > 0);
  count_->setText(all == 0       ? tr("no pairs yet")
                  : shown == all ? tr("%1 pairs").arg(all)
                                 : tr("%1 of %2 pairs").arg(shown).arg(all));
}

}  // namespace remount
