#include "app/gui/shell/key_bindings.h"

#include <QAction>
#include <QSettings>
#include <algorithm>

#include "widgets/basics/remembering.h"

namespace remount::gui {
namespace {
const QString kKeys = QStringLiteral("keys"), kReason = QStringLiteral("reason-"), kView = QStringLiteral("view-");

QString plain(QString text) { return text.remove('&').remove(QStringLiteral("…")); }
}  // namespace

KeyBindings::KeyBindings(QMainWindow& window) : QObject(&window), window_(window) {}

QAction* KeyBindings::bind(const QString& id, QAction* action) {
  bound_.push_back({id, action, action->shortcut()});
  return action;
}

void KeyBindings::restore() {
  if (!widgets::remembers()) return;
  std::vector<widgets::KeyBinding> bindings = list();
  const QSettings settings;
  for (widgets::KeyBinding& binding : bindings) {
    const QVariant saved = settings.value(kKeys + '/' + binding.id);
    if (!binding.id.isEmpty() && saved.isValid())
      binding.key = QKeySequence(saved.toString(), QKeySequence::PortableText);
  }
  apply(bindings);
}

std::vector<widgets::KeyBinding> KeyBindings::list() const {
  std::vector<widgets::KeyBinding> bindings;
  for (const Bound& bound : bound_) {
    QString text = plain(bound.action->text());
    if (bound.id.startsWith(kReason)) text = tr("Reject: %1").arg(text);
    if (bound.id.startsWith(kView)) text = tr("3-D view: %1").arg(text);
    bindings.push_back({bound.id, text, bound.action->shortcut(), bound.standard});
  }
  for (const QAction* action : window_.findChildren<QAction*>()) {
    const bool listed =
        std::any_of(bound_.begin(), bound_.end(), [&](const Bound& bound) { return bound.action == action; });
    if (listed || action->shortcut().isEmpty()) continue;
    bindings.push_back({{}, plain(action->text()), action->shortcut(), action->shortcut()});
  }
  return bindings;
}

void KeyBindings::apply(const std::vector<widgets::KeyBinding>& bindings) {
  for (const widgets::KeyBinding& binding : bindings)
    for (const Bound& bound : bound_)
      if (bound.id == binding.id) bound.action->setShortcut(binding.key);
}

void KeyBindings::ask() {
  auto* dialog = new widgets::KeysDialog(list(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    apply(dialog->bindings());
    if (!widgets::remembers()) return;
    QSettings settings;
    for (const widgets::KeyBinding& binding : dialog->bindings())
      if (!binding.id.isEmpty())
        settings.setValue(kKeys + '/' + binding.id, binding.key.toString(QKeySequence::PortableText));
  });
  dialog->open();
}

}  // namespace remount::gui
