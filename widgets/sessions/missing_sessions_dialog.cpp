#include "widgets/sessions/missing_sessions_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/screen_room.h"

namespace remount::widgets {

MissingSessionsDialog::MissingSessionsDialog(const QString& project, const QStringList& missing, QWidget* parent)
    : QDialog(parent), list_(new QTreeWidget(this)), found_(missing.size(), QString()) {
  setWindowTitle(tr("Where do the sessions lie now?"));
  auto* head = new QLabel(tr("%1 names sessions that are not there. Show where one of them lies now; the others that "
                             "were moved with it are then found by themselves. The project remembers it when it is "
                             "saved.")
                              .arg(project),
                          this);
  head->setWordWrap(true);
  list_->setColumnCount(2);
  list_->setHeaderLabels({tr("Was at"), tr("Lies now at")});
  list_->setRootIsDecorated(false);
  list_->setAccessibleName(tr("Sessions that are missing"));
  list_->setTextElideMode(Qt::ElideLeft);  // folders are told apart by their ends
  list_->header()->setSectionResizeMode(QHeaderView::Stretch);
  for (const QString& path : missing) {
    auto* item = new QTreeWidgetItem(list_, {path, tr("not found yet")});
    item->setToolTip(0, path);
  }
  list_->setCurrentItem(list_->topLevelItem(0));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  locate_ = buttons->addButton(tr("Locate…"), QDialogButtonBox::ActionRole);
  without_ = buttons->addButton(tr("Open without them"), QDialogButtonBox::ActionRole);
  press_on_purpose(*without_);
  without_->setToolTip(
      tr("Their pairs and the result that rests on them are left out. The project's file is left as it is."));
  open_ = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
  const auto locate = [this] { emit locate_requested(list_->indexOfTopLevelItem(list_->currentItem())); };
  connect(locate_, &QPushButton::clicked, this, locate);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, locate);
  connect(without_, &QPushButton::clicked, this, [this] {
    accept();
    emit open_requested(true);
  });
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    accept();
    emit open_requested(false);
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(head);
  column->addWidget(list_, 1);
  column->addWidget(buttons);
  resize(within_screen(*this, {760, 320}));
  update_buttons();
}

void MissingSessionsDialog::show_found(int row, const QString& path) {
  found_[row] = path;
  list_->topLevelItem(row)->setText(1, path);
  list_->topLevelItem(row)->setToolTip(1, path);
  update_buttons();
}

void MissingSessionsDialog::update_buttons() {
  const bool all = !found_.contains(QString());
  open_->setEnabled(all);
  open_->setDefault(all);
  locate_->setDefault(!all);
  without_->setEnabled(!all);
}

}  // namespace remount::widgets
