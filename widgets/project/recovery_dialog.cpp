#include "widgets/project/recovery_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "algorithms/core/index.h"
#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/wheel_scrolls.h"

namespace remount::widgets {

RecoveryDialog::RecoveryDialog(const std::vector<RecoveryEntry>& entries, QWidget* parent)
    : QDialog(parent), left_(qt_count(entries.size())) {
  setWindowTitle(tr("Unsaved work was found"));
  auto* column = new QVBoxLayout(this);
  auto* head = new QLabel(
      tr("Remount ended without closing the last time. This was kept; nothing is changed until you choose."), this);
  head->setWordWrap(true);
  column->addWidget(head);
  auto* list = new QWidget;
  auto* rows = new QVBoxLayout(list);
  rows->setContentsMargins(0, 0, 0, 0);
  for (int i = 0; i < left_; ++i) rows->addWidget(make_entry(i, entries[index_at(i)]));
  rows->addStretch();
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(list);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  column->addWidget(scroll, 1);
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* later = buttons->addButton(tr("Decide later"), QDialogButtonBox::RejectRole);
  later->setToolTip(tr("Keeps it; the next start asks again"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  resize(within_screen(*this, {560, std::min(160 + 150 * left_, 560)}));
}

QWidget* RecoveryDialog::make_entry(int index, const RecoveryEntry& entry) {
  auto* group = new QGroupBox(entry.title);
  auto* column = new QVBoxLayout(group);
  auto* contents = new QLabel(entry.contents);
  contents->setWordWrap(true);
  contents->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(contents);
  auto* generations = new QComboBox;
  generations->addItems(entry.generations);
  generations->setAccessibleName(tr("Which state"));
  let_wheel_scroll(*generations);
  generations->setToolTip(
      tr("The newest state is usually the right one; older ones are kept for the case that it is not"));
  auto* restore = new QPushButton(tr("Restore"));
  restore->setDefault(index == 0);
  auto* discard = new QPushButton(tr("Discard"));
  discard->setToolTip(tr("Removes what was kept for good"));
  press_on_purpose(*discard);
  auto* row = new QHBoxLayout;
  row->addWidget(generations, 1);
  row->addWidget(restore);
  row->addWidget(discard);
  column->addLayout(row);
  connect(restore, &QPushButton::clicked, this, [this, index, generations] {
    accept();
    emit restore_requested(index, generations->currentIndex());
  });
  connect(discard, &QPushButton::clicked, this, [this, index, group] {
    emit discard_requested(index);
    drop(group);
  });
  return group;
}

void RecoveryDialog::drop(QWidget* entry) {
  entry->hide();
  if (--left_ == 0) reject();
}

}  // namespace remount::widgets
