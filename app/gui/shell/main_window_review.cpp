// Decisions about pairs: accept, reject with a reason, go on; and the keys for it.
#include <QAction>
#include <QInputDialog>
#include <QMenuBar>
#include <QSettings>
#include <QTableView>

#include "app/gui/basics/remembering.h"
#include "app/gui/shell/main_window.h"
#include "widgets/pairs/error_chart_panel.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/shell/keys_dialog.h"
#include "widgets/text/pair_reasons.h"

namespace remount {
namespace {
const QString kKeys = QStringLiteral("keys"), kReason = QStringLiteral("reason-"), kView = QStringLiteral("view-");

QString plain(QString text) { return text.remove('&').remove(QStringLiteral("…")); }
}  // namespace

QAction* MainWindow::add_review(QMenu& menu, const char* id, const QString& text, const char* key,
                                const std::function<void()>& act) {
  review_actions_.push_back(add_bound(menu, QString::fromLatin1(id), text, QKeySequence(QLatin1String(key)), act));
  return review_actions_.back();
}

QAction* MainWindow::add_bound(QMenu& menu, const QString& id, const QString& text, const QKeySequence& key,
                               const std::function<void()>& act) {
  bound_actions_.push_back({id, add_action(menu, text, key, act), key});
  return bound_actions_.back().action;
}

void MainWindow::make_review_menu() {
  QMenu& review = *menuBar()->addMenu(tr("&Review"));
  add_review(review, "accept", tr("&Accept pair"), "A", [this] { decide(PairState::Accepted); });
  add_review(review, "reject", tr("&Reject pair"), "R", [this] { decide(PairState::Rejected); });
  make_reason_menu(review);
  review.addSeparator();
  add_review(review, "next", tr("&Next pair"), "N", [this] { go(1, false); });
  add_review(review, "previous", tr("&Previous pair"), "P", [this] { go(-1, false); });
  add_review(review, "next-undecided", tr("Next pair that yo&u have not decided"), "U", [this] { go(1, true); });
  review.addSeparator();
  QAction* flip = add_review(review, "flip", tr("&Flip before and after"), "Space", [this] { pair_view_->flip(); });
  // In the whole window Space would no longer press the button that has the focus.
  flip->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  for (QWidget* widget : std::initializer_list<QWidget*>{pairs_->table(), errors_->chart(), pair_view_->canvas()})
    if (widget) widget->addAction(flip);
  add_review(review, "blink", tr("&Blink"), "B", [this] { pair_view_->set_blinking(!pair_view_->blinking()); });
  review.addSeparator();
  add_action(review, tr("&Keys…"), {}, [this] { show_keys(); });
}

void MainWindow::restore_keys() {
  if (!remembers()) return;
  std::vector<KeyBinding> bindings = key_bindings();
  const QSettings settings;
  for (KeyBinding& binding : bindings) {
    const QVariant saved = settings.value(kKeys + '/' + binding.id);
    if (!binding.id.isEmpty() && saved.isValid())
      binding.key = QKeySequence(saved.toString(), QKeySequence::PortableText);
  }
  apply_keys(bindings);
}

void MainWindow::make_reason_menu(QMenu& review) {
  QMenu& menu = *review.addMenu(tr("Reject &because"));
  int number = 1;
  for (const auto& reason : quick_reasons()) {
    const QByteArray key = QByteArray::number(number), id = kReason.toLatin1() + key;
    add_review(menu, id.constData(), reason_words(reason()), key.constData(),
               [this, reason] { decide(PairState::Rejected, reason()); });
    ++number;
  }
  add_review(menu, "reason-other", tr("&Other reason…"), "Shift+R", [this] { ask_reason(); });
  pairs_->set_reason_menu(&menu);
}

std::vector<int> MainWindow::pairs_to_decide() const {
  std::vector<int> pairs = pairs_->marked_pairs();
  if (pairs.empty() && workbench_.selection().pair() >= 0) pairs = {workbench_.selection().pair()};
  return pairs;
}

void MainWindow::decide(PairState state, const Message& reason) {
  workbench_.decisions().decide(pairs_to_decide(), state, reason);
}

void MainWindow::ask_reason() {
  const std::vector<int> pairs = pairs_to_decide();
  if (pairs.empty() || !workbench_.outcome().output()) return;
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Reject"));
  dialog->setLabelText(pairs.size() == 1 ? tr("Why is pair %1 rejected?").arg(pairs.front())
                                         : tr("Why are %1 pairs rejected?").arg(pairs.size()));
  const Pair& first = workbench_.outcome().output()->pairs.at(static_cast<std::size_t>(pairs.front()));
  const bool has_reason = first.decided_by == DecidedBy::User && first.state == PairState::Rejected;
  const Message before = has_reason && !tells_who_only(first.reason) ? first.reason : Message();
  const QString shown = reason_words(before);
  dialog->setTextValue(shown);
  connect(dialog, &QInputDialog::textValueSelected, this, [this, pairs, before, shown](const QString& reason) {
    const bool kept = reason == shown;  // a reason of the list stays one
    workbench_.decisions().decide(pairs, PairState::Rejected,
                                  kept ? before : Message::verbatim(reason.trimmed().toStdString()));
  });
  dialog->open();
}

void MainWindow::reject_above(const std::vector<int>& pairs, const QString& reason) {
  workbench_.decisions().decide(pairs, PairState::Rejected, Message::verbatim(reason.toStdString()));
}

void MainWindow::go(int step, bool undecided) {
  const int pair = pairs_->neighbour(step, undecided);
  if (pair >= 0)
    workbench_.selection().select(pair);
  else if (undecided)
    progress_text(tr("You have decided every pair that is shown."));
}

std::vector<KeyBinding> MainWindow::key_bindings() const {
  std::vector<KeyBinding> bindings;
  for (const BoundAction& bound : bound_actions_) {
    QString text = plain(bound.action->text());
    if (bound.id.startsWith(kReason)) text = tr("Reject: %1").arg(text);
    if (bound.id.startsWith(kView)) text = tr("3-D view: %1").arg(text);
    bindings.push_back({bound.id, text, bound.action->shortcut(), bound.standard});
  }
  for (const QAction* action : findChildren<QAction*>()) {
    const bool listed = std::any_of(bound_actions_.begin(), bound_actions_.end(),
                                    [&](const BoundAction& bound) { return bound.action == action; });
    if (listed || action->shortcut().isEmpty()) continue;
    bindings.push_back({{}, plain(action->text()), action->shortcut(), action->shortcut()});
  }
  return bindings;
}

void MainWindow::apply_keys(const std::vector<KeyBinding>& bindings) {
  for (const KeyBinding& binding : bindings)
    for (const BoundAction& bound : bound_actions_)
      if (bound.id == binding.id) bound.action->setShortcut(binding.key);
}

void MainWindow::show_keys() {
  auto* dialog = new KeysDialog(key_bindings(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    apply_keys(dialog->bindings());
    if (!remembers()) return;
    QSettings settings;
    for (const KeyBinding& binding : dialog->bindings())
      if (!binding.id.isEmpty())
        settings.setValue(kKeys + '/' + binding.id, binding.key.toString(QKeySequence::PortableText));
  });
  dialog->open();
}

}  // namespace remount
