#include "widgets/panels/sessions_panel.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QTreeView>

#include "widgets/itemmodels/session_list_model.h"
#include "widgets/itemmodels/wrapping_delegate.h"

namespace remount {

SessionsPanel::SessionsPanel(SessionListModel& model, QWidget* parent)
    : QWidget(parent), model_(model), tree_(new QTreeView(this)), remove_(new QPushButton(tr("Remove"), this)) {
  tree_->setModel(&model_);
  tree_->setAccessibleName(tr("Open sessions and findings"));
  tree_->setHeaderHidden(true);
  tree_->setMinimumHeight(6 * tree_->fontMetrics().lineSpacing());  // several drives, and what was found in one
  tree_->setItemDelegate(new WrappingDelegate(*tree_));
  auto* open = new QPushButton(tr("Open…"), this);
  open->setToolTip(tr("A folder or file with a recorded drive; several drives of one vehicle are calibrated together"));
  connect(open, &QPushButton::clicked, this, &SessionsPanel::open_requested);
  connect(remove_, &QPushButton::clicked, this, [this] {
    const int session = model_.session_of(tree_->currentIndex());
    if (session >= 0) emit remove_requested(session);
  });
  connect(&model_, &QAbstractItemModel::modelReset, this, &SessionsPanel::after_reset);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& current) { remove_->setEnabled(current.isValid()); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(open);
  buttons->addWidget(remove_);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(buttons);
  column->addWidget(tree_, 1);
  after_reset();
}

void SessionsPanel::after_reset() {
  remove_->setEnabled(false);
  tree_->expandAll();  // what was found is not to be hidden
}

}  // namespace remount
