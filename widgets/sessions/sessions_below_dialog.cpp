#include "widgets/sessions/sessions_below_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/basics/rows.h"
#include "widgets/basics/screen_room.h"

namespace remount::widgets {

SessionsBelowDialog::SessionsBelowDialog(const QString& folder, const QStringList& paths, QWidget* parent)
    : QDialog(parent), list_(new QListWidget(this)), paths_(paths) {
  setWindowTitle(tr("Which sessions?"));
  auto* head = new QLabel(tr("%1 is no session itself, but %n session(s) lie in it. Open together those of one vehicle "
                             "between which the LiDAR was not moved.",
                             nullptr, qt_count(paths.size()))
                              .arg(QDir::toNativeSeparators(folder)),
                          this);
  head->setWordWrap(true);
  list_->setAccessibleName(tr("Sessions in the folder"));
  for (const QString& path : paths) {
    auto* item = new QListWidgetItem(QFileInfo(path).fileName(), list_);
    item->setToolTip(QDir::toNativeSeparators(path));
    item->setCheckState(Qt::Checked);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  open_ = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
  open_->setDefault(true);
  connect(list_, &QListWidget::itemChanged, this, &SessionsBelowDialog::update_button);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(head);
  column->addWidget(list_, 1);
  column->addWidget(buttons);
  resize(within_screen(*this, {560, 320}));
  update_button();
}

QStringList SessionsBelowDialog::chosen() const {
  QStringList chosen;
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->checkState() == Qt::Checked) chosen << paths_[i];
  return chosen;
}

void SessionsBelowDialog::update_button() { open_->setEnabled(!chosen().isEmpty()); }

}  // namespace remount::widgets
