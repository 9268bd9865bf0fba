#include "app/gui/basics/undo_keys.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSpinBox>

namespace remount::gui {
namespace {

/// What is typed into a widget; null where it is no field.
const QLineEdit* text_of(const QObject& widget) {
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) return line;
  if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) return combo->lineEdit();
  return qobject_cast<const QAbstractSpinBox*>(&widget) ? widget.findChild<const QLineEdit*>() : nullptr;
}

/// A number that was taken over is an edit of the work, though the field could still take its digits back.
bool taken_over(const QObject& widget) {
  if (const auto* real = qobject_cast<const QDoubleSpinBox*>(&widget))
    return real->cleanText() == real->textFromValue(real->value());
  if (const auto* whole = qobject_cast<const QSpinBox*>(&widget))
    return whole->locale().toInt(whole->cleanText()) == whole->value();
  return false;
}

}  // namespace

UndoKeys::UndoKeys(QObject* parent) : QObject(parent) { QCoreApplication::instance()->installEventFilter(this); }

bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const auto* key = static_cast<const QKeyEvent*>(event);
  const bool undo = key->matches(QKeySequence::Undo);
  const bool to_the_end = key->key() == Qt::Key_E && key->modifiers() == Qt::ControlModifier;  // X11; End does it too
  if (!undo && !to_the_end && !key->matches(QKeySequence::Redo)) return false;
  const QLineEdit* text = text_of(*watched);
  if (!text) return false;
  if (to_the_end) {
    event->ignore();
    return true;
  }
  if (undo ? text->isUndoAvailable() && !taken_over(*watched) : text->isRedoAvailable()) return false;
  event->ignore();
  return true;
}

}  // namespace remount::gui
