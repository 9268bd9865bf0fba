#include "app/gui/basics/held_action.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>

namespace remount::gui {
namespace {
constexpr int kPulse_ms = 15;
// Longer than the slowest keyboards take between two repetitions, and shorter than what is felt as running on.
constexpr int kLetGo_ms = 150;
}  // namespace

HeldAction::HeldAction(QAction& action, std::function<bool()> may_act)
    : QObject(&action), action_(action), may_act_(std::move(may_act)) {
  action_.setAutoRepeat(false);
  pulse_.setInterval(kPulse_ms);
  connect(&pulse_, &QTimer::timeout, this, &HeldAction::act_if_held);
  qApp->installEventFilter(this);
}

bool HeldAction::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride || !watched->isWidgetType()) return false;
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (!key.isAutoRepeat() || action_.shortcut() != QKeySequence(key.keyCombination())) return false;
  since_repeat_.start();
  if (action_.isEnabled() && !pulse_.isActive()) pulse_.start();
  return false;
}

void HeldAction::act_if_held() {
  if (since_repeat_.elapsed() > kLetGo_ms)
    pulse_.stop();
  else if (may_act_())
    action_.trigger();
}

}  // namespace remount::gui
