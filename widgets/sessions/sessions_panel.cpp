#include "widgets/sessions/sessions_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTreeView>
#include <algorithm>

#include "widgets/basics/wrapping_delegate.h"
#include "widgets/sessions/session_list_model.h"

namespace remount::widgets {

SessionsPanel::SessionsPanel(SessionListModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      tree_(new QTreeView(this)),
      open_(new QPushButton(tr("Open"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      topics_(new QPushButton(tr("Topics…"), this)) {
  tree_->setModel(&model_);
  tree_->setAccessibleName(tr("Open sessions and findings"));
  tree_->setHeaderHidden(true);
  tree_->setItemDelegate(new WrappingDelegate(*tree_));
  tree_->setRootIsDecorated(false);  // there is nothing to fold, and the names are long
  open_->setToolTip(
      tr("A folder or file with a recorded drive; several drives of one vehicle are calibrated together"));
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (const auto session = model_.session_of(tree_->currentIndex())) emit remove_requested(*session);
  });
  topics_->setToolTip(tr("Which topics of a bag the session is made of"));
  connect(topics_, &QPushButton::clicked, this, [this] {
    if (const auto session = session_with_topics()) emit topics_requested(*session);
  });
  connect(&model_, &QAbstractItemModel::modelReset, this, &SessionsPanel::after_reset);
  connect(&model_, &QAbstractItemModel::dataChanged, this, &SessionsPanel::fit_height, Qt::QueuedConnection);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, &SessionsPanel::update_buttons);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(open_);
  buttons->addWidget(topics_);
  buttons->addWidget(remove_);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(buttons);
  column->addWidget(tree_, 1);
  tree_->viewport()->installEventFilter(this);
  after_reset();
}

void SessionsPanel::set_open_menu(QMenu& menu) { open_->setMenu(&menu); }

void SessionsPanel::after_reset() {
  tree_->expandAll();  // what was found is not to be hidden
  fit_height();
  update_buttons();
}

// Four drives, or a few and what was found in them, are seen without scrolling.
void SessionsPanel::fit_height() {
  constexpr int kFewestLines = 6, kMostLines = 14, kSessions = 4;
  const int line = tree_->fontMetrics().lineSpacing(), most = kMostLines * line;
  int rows = 2 * tree_->frameWidth();
  for (int session = 0; session < std::min(kSessions, model_.rowCount()); ++session) {
    const QModelIndex top = model_.index(session, 0);
    rows += tree_->visualRect(top).height();
    // Where a row stands is found by adding up those above it: of many findings, only those that count are asked.
    for (int finding = 0; finding < model_.rowCount(top) && rows < most; ++finding)
      rows += tree_->visualRect(model_.index(finding, 0, top)).height();
  }
  tree_->setMinimumHeight(std::clamp(rows, kFewestLines * line, most));
}

bool SessionsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == tree_->viewport() && event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(this, &SessionsPanel::fit_height, Qt::QueuedConnection);  // after the rows are laid out
  return QWidget::eventFilter(watched, event);
}

void SessionsPanel::update_buttons() {
  remove_->setEnabled(tree_->currentIndex().isValid());
  topics_->setEnabled(session_with_topics().has_value());
}

std::optional<motion::SessionIndex> SessionsPanel::session_with_topics() const {
  std::optional<motion::SessionIndex> session = model_.session_of(tree_->currentIndex());
  if (!session && model_.rowCount() == 1) session = motion::SessionIndex{0};  // of one it is clear which is meant
  return session && model_.has_topics(*session) ? session : std::nullopt;
}

}  // namespace remount::widgets
