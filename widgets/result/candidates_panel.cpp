#include "widgets/result/candidates_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include "widgets/basics/rows.h"
#include "widgets/result/candidate_table_model.h"

namespace remount::widgets {

CandidatesPanel::CandidatesPanel(CandidateTableModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QTableView(this)),
      position_(new CandidatePlot(CandidatePlot::Kind::Position, this)),
      attitude_(new CandidatePlot(CandidatePlot::Kind::Attitude, this)),
      note_(new QLabel(this)),
      legend_(new QLabel(tr("● in range  ○ out of it  ✚ nominal  ◯ result  ▭ range"), this)) {
  make_table();
  for (CandidatePlot* plot : {position_, attitude_})
    connect(plot, &CandidatePlot::candidate_pointed, this, &CandidatesPanel::select);
  auto* plots = new QSplitter(Qt::Vertical, this);
  plots->addWidget(position_);
  plots->addWidget(attitude_);
  plots->setChildrenCollapsible(false);
  auto* right = new QWidget(this);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(plots, 1);
  column->addWidget(legend_);
  legend_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(make_left());
  splitter->addWidget(right);
  splitter->setStretchFactor(0, 1);
  splitter->setStretchFactor(1, 1);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 4, 6, 4);
  row->addWidget(splitter);
}

QWidget* CandidatesPanel::make_left() {
  auto* left = new QWidget(this);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(table_, 1);
  note_->setWordWrap(true);
  note_->hide();
  column->addWidget(note_);
  return left;
}

void CandidatesPanel::make_table() {
  sorted_->setSourceModel(&model_);
  sorted_->setSortRole(CandidateTableModel::SortRole);
  table_->setModel(sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(CandidateTableModel::Rank, Qt::AscendingOrder);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setAccessibleName(tr("Candidates"));
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (current.isValid()) select(index_at<calibration::CandidateIndex>(sorted_->mapToSource(current).row()));
  });
}

void CandidatesPanel::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  for (CandidatePlot* plot : {position_, attitude_}) {
    plot->show_selected(std::nullopt);  // the number is another candidate's now
    plot->show_output(output);
  }
  const int result = output ? qt_row(place_of_result(output->result)) : -1;
  note_->setVisible(result > 0);
  note_->setText(tr("The result has rank %1: ranks count every pair alike, the result weighs each pair by its noise.")
                     .arg(result + 1));
  const bool any = model_.rowCount() > 0;
  // Once, for every decision would pay for it, and in a turn of its own: ten milliseconds of a table that is mostly
  // behind others.
  if (any && !sized_) QTimer::singleShot(0, table_, &QTableView::resizeColumnsToContents);
  sized_ = any;
}

void CandidatesPanel::show_range(const calibration::SearchRange& range) {
  position_->show_range(range);
  attitude_->show_range(range);
}

void CandidatesPanel::show_nominal(const std::optional<RigidTransform>& nominal) {
  position_->show_nominal(nominal);
  attitude_->show_nominal(nominal);
}

void CandidatesPanel::select(calibration::CandidateIndex candidate) {
  if (candidate == position_->selected()) return;
  position_->show_selected(candidate);
  attitude_->show_selected(candidate);
  const QModelIndex index = sorted_->mapFromSource(model_.index(qt_row(candidate), 0));
  if (index.isValid() && table_->currentIndex().row() != index.row()) {
    table_->setCurrentIndex(index);
    table_->scrollTo(index);
  }
  emit candidate_selected(candidate);
}

}  // namespace remount::widgets
