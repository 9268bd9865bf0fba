#include "widgets/shell/keys_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/theme.h"

namespace remount::widgets {

QStringList key_conflicts(const std::vector<KeyBinding>& bindings) {
  QStringList conflicts;
  for (std::size_t i = 0; i < bindings.size(); ++i)
    for (std::size_t k = i + 1; k < bindings.size(); ++k) {
      const QKeySequence &first = bindings[i].key, &second = bindings[k].key;
      if (first.isEmpty() || second.isEmpty()) continue;
      // Typing the shorter would never let the longer be finished.
      if (first.matches(second) == QKeySequence::NoMatch && second.matches(first) == QKeySequence::NoMatch) continue;
      conflicts << KeysDialog::tr("%1: %2 and %3")
                       .arg(first.toString(QKeySequence::NativeText), bindings[i].text, bindings[k].text);
    }
  return conflicts;
}

KeysDialog::KeysDialog(const std::vector<KeyBinding>& bindings, QWidget* parent)
    : QDialog(parent), bindings_(bindings), conflicts_(new QLabel(this)) {
  setWindowTitle(tr("Keys"));
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(make_rows());
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  conflicts_->setWordWrap(true);
  auto* note = new QLabel(tr("Several pairs can be marked with Ctrl or Shift and decided together."), this);
  note->setWordWrap(true);
  note->setEnabled(false);
  auto* column = new QVBoxLayout(this);
  column->addWidget(scroll, 1);
  column->addWidget(conflicts_);
  column->addWidget(note);
  column->addWidget(make_buttons());
  resize(within_screen(*this, {440, 520}));
  check();
}

QWidget* KeysDialog::make_rows() {
  auto* rows = new QWidget(this);
  auto* grid = new QGridLayout(rows);
  int row = 0;
  for (std::size_t i = 0; i < bindings_.size(); ++i) {
    editors_.push_back(bindings_[i].id.isEmpty() ? nullptr : make_editor(i));
    if (!editors_.back()) continue;
    auto* label = new QLabel(bindings_[i].text, this);
    label->setBuddy(editors_.back());
    grid->addWidget(label, row, 0);
    grid->addWidget(editors_.back(), row++, 1);
  }
  grid->setColumnStretch(0, 1);
  grid->setRowStretch(row, 1);
  return rows;
}

QKeySequenceEdit* KeysDialog::make_editor(std::size_t binding) {
  const KeyBinding& bound = bindings_[binding];
  auto* editor = new QKeySequenceEdit(bound.key, this);
  editor->setClearButtonEnabled(true);
  editor->setAccessibleName(tr("Key of %1").arg(bound.text));
  editor->setToolTip(
      tr("Click and press the key. Standard: %1").arg(bound.standard.toString(QKeySequence::NativeText)));
  connect(editor, &QKeySequenceEdit::keySequenceChanged, this, [this, binding](const QKeySequence& key) {
    bindings_[binding].key = key;
    check();
  });
  return editor;
}

QWidget* KeysDialog::make_buttons() {
  auto* buttons =
      new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  QPushButton* defaults = buttons->button(QDialogButtonBox::RestoreDefaults);
  press_on_purpose(*defaults);
  connect(defaults, &QPushButton::clicked, this, &KeysDialog::reset);
  return buttons;
}

void KeysDialog::set_key(const QString& id, const QKeySequence& key) {
  for (std::size_t i = 0; i < bindings_.size(); ++i)
    if (editors_[i] && bindings_[i].id == id) editors_[i]->setKeySequence(key);
}

void KeysDialog::reset() {
  for (std::size_t i = 0; i < bindings_.size(); ++i)
    if (editors_[i]) editors_[i]->setKeySequence(bindings_[i].standard);
}

void KeysDialog::check() {
  const QStringList conflicts = key_conflicts(bindings_);
  conflicts_->setVisible(!conflicts.isEmpty());
  set_style(*conflicts_, text_in(bad_color));
  conflicts_->setText(tr("Keys with two meanings:\n%1").arg(conflicts.join('\n')));
  ok_->setEnabled(conflicts.isEmpty());
}

}  // namespace remount::widgets
