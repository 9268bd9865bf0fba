#include "app/gui/features/pairs_feature.h"

#include <QAction>
#include <QInputDialog>
#include <QTableView>

#include "app/gui/shell/main_window.h"
#include "widgets/pairs/error_chart_panel.h"
#include "widgets/pairs/pair_table_model.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/text/pair_reasons.h"

namespace remount::gui {

PairsFeature::PairsFeature(MainWindow& window)
    : Feature(window),
      model_(new widgets::PairTableModel(&window)),
      pairs_(new widgets::PairsPanel(*model_)),
      errors_(new widgets::ErrorChartPanel) {
  make_docks();
  make_menu();
  connect_panels();
  window.on_step(widgets::Step::Review, [this] { review_pairs(); });
  for (const widgets::Step step : {widgets::Step::Pairs, widgets::Step::Align})
    window.on_step(step, [this] {
      if (!workbench_.outcome().output() || workbench_.calibrations().out_of_date())
        workbench_.calibrations().calibrate();
      review_pairs();
    });
}

void PairsFeature::make_docks() {
  dock_ = window_.add_dock(
      {.title = tr("Pairs"), .name = "pairs", .content = pairs_, .help_page = "pairs", .width = 860, .height = 300});
  window_.add_dock({.title = tr("Error chart"),
                    .name = "errors",
                    .content = errors_,
                    .help_page = "errors",
                    .arrangement = DockSpec::Arrangement::Beside,
                    .width = 420});
}

QAction* PairsFeature::add_review(MenuPlace place, const QString& id, const QString& text, const QKeySequence& key,
                                  const std::function<void()>& act) {
  review_actions_.push_back(window_.keys().bind(id, window_.menus().add(place, text, key, act)));
  return review_actions_.back();
}

void PairsFeature::make_menu() {
  add_review(MenuPlace::ReviewDecide, "accept", tr("&Accept pair"), QKeySequence("A"),
             [this] { decide(motion::PairState::Accepted); });
  add_review(MenuPlace::ReviewDecide, "reject", tr("&Reject pair"), QKeySequence("R"),
             [this] { decide(motion::PairState::Rejected); });
  make_reason_menu();
  add_review(MenuPlace::ReviewGo, "next", tr("&Next pair"), QKeySequence("N"), [this] { go(1, false); });
  add_review(MenuPlace::ReviewGo, "previous", tr("&Previous pair"), QKeySequence("P"), [this] { go(-1, false); });
  add_review(MenuPlace::ReviewGo, "next-undecided", tr("Next pair that yo&u have not decided"), QKeySequence("U"),
             [this] { go(1, true); });
}

void PairsFeature::make_reason_menu() {
  QMenu& menu = *window_.menus().add_menu(MenuPlace::ReviewDecide, tr("Reject &because"));
  const auto add = [&](const QString& id, const QString& text, const QString& key, const std::function<void()>& act) {
    QAction* action = menu.addAction(text);
    action->setShortcut(QKeySequence(key));
    connect(action, &QAction::triggered, this, act);
    review_actions_.push_back(window_.keys().bind(QStringLiteral("reason-") + id, action));
  };
  int number = 1;
  for (const auto& reason : widgets::quick_reasons()) {
    const QString key = QString::number(number);
    add(key, widgets::reason_words(reason()), key, [this, reason] { decide(motion::PairState::Rejected, reason()); });
    ++number;
  }
  add("other", tr("&Other reason…"), "Shift+R", [this] { ask_reason(); });
  pairs_->set_reason_menu(&menu);
}

void PairsFeature::connect_panels() {
  Selection& selection = workbench_.selection();
  connect(pairs_, &widgets::PairsPanel::pair_selected, &selection, &Selection::select);
  connect(pairs_, &widgets::PairsPanel::accept_clicked, this, [this] { decide(motion::PairState::Accepted); });
  connect(pairs_, &widgets::PairsPanel::reject_clicked, this, [this] { decide(motion::PairState::Rejected); });
  connect(pairs_, &widgets::PairsPanel::shown_changed, this,
          [this] { errors_->chart()->show_pairs(pairs_->filter()->pairs()); });
  connect(errors_, &widgets::ErrorChartPanel::measure_changed, pairs_, &widgets::PairsPanel::set_measure);
  connect(errors_, &widgets::ErrorChartPanel::reject_requested, this, &PairsFeature::reject_above);
  connect(errors_, &widgets::ErrorChartPanel::take_back_requested, &workbench_.decisions(), &Decisions::take_back);
  connect(errors_->chart(), &widgets::ErrorBarChart::pair_clicked, &selection, &Selection::select);
  connect(&selection, &Selection::changed, this, [this](std::optional<motion::PairIndex> pair) {
    pairs_->show_selected(pair);
    errors_->chart()->show_selected(pair);
  });
}

QList<QWidget*> PairsFeature::key_widgets() const { return {pairs_->table(), errors_->chart()}; }

void PairsFeature::review_pairs() {
  dock_->show();
  dock_->raise();
  pairs_->table()->setFocus();
}

void PairsFeature::show_output() { model_->show_output(workbench_.outcome().output(), workbench_.sessions().names()); }

std::vector<TurnQueue::Piece> PairsFeature::show_output_later() {
  return {[this] { pairs_->show_output(workbench_.outcome().output()); }, [this] { show_errors(); },
          [this] { pairs_->show_selected(workbench_.selection().pair()); }};
}

void PairsFeature::show_errors() {
  errors_->chart()->show_output(workbench_.outcome().output());
  errors_->chart()->show_pairs(pairs_->filter()->pairs());
  errors_->chart()->show_selected(workbench_.selection().pair());
}

void PairsFeature::show_state() {
  const OutputPtr output = workbench_.outcome().output();
  const bool busy = workbench_.activity().opening() || workbench_.activity().calibrating();
  if (was_busy_ && !busy && output) pairs_->table()->setFocus();
  was_busy_ = busy;
  for (QAction* review : review_actions_) review->setEnabled(output != nullptr);
}

void PairsFeature::show_palette(const QPalette& palette) { model_->set_palette(palette); }

void PairsFeature::take_over(Kept*) {
  if (workbench_.outcome().output()) pairs_->table()->setFocus();  // else the first step takes it
}

std::vector<motion::PairIndex> PairsFeature::pairs_to_decide() const {
  std::vector<motion::PairIndex> pairs = pairs_->marked_pairs();
  const std::optional<motion::PairIndex> selected = workbench_.selection().pair();
  if (pairs.empty() && selected) pairs = {*selected};
  return pairs;
}

void PairsFeature::decide(motion::PairState state, const Message& reason) {
  workbench_.decisions().decide(pairs_to_decide(), state, reason);
}

void PairsFeature::ask_reason() {
  const std::vector<motion::PairIndex> pairs = pairs_to_decide();
  const OutputPtr output = workbench_.outcome().output();
  if (pairs.empty() || !output) return;
  auto* dialog = new QInputDialog(&window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Reject"));
  dialog->setLabelText(pairs.size() == 1 ? tr("Why is pair %1 rejected?").arg(pairs.front())
                                         : tr("Why are %1 pairs rejected?").arg(pairs.size()));
  const motion::Pair& first = output->pairs.at(pairs.front());
  const bool has_reason = first.decided_by == motion::DecidedBy::User && first.state == motion::PairState::Rejected;
  const Message before = has_reason && !widgets::tells_who_only(first.reason) ? first.reason : Message();
  const QString shown = widgets::reason_words(before);
  dialog->setTextValue(shown);
  connect(dialog, &QInputDialog::textValueSelected, this, [this, pairs, before, shown](const QString& reason) {
    const bool kept = reason == shown;  // a reason of the list stays one
    workbench_.decisions().decide(pairs, motion::PairState::Rejected,
                                  kept ? before : Message::verbatim(reason.trimmed().toStdString()));
  });
  dialog->open();
}

void PairsFeature::reject_above(const std::vector<motion::PairIndex>& pairs, const QString& reason) {
  workbench_.decisions().decide(pairs, motion::PairState::Rejected, Message::verbatim(reason.toStdString()));
}

void PairsFeature::go(int step, bool undecided) {
  const std::optional<motion::PairIndex> pair = pairs_->neighbour(step, undecided);
  if (pair)
    workbench_.selection().select(pair);
  else if (undecided)
    window_.tell(tr("You have decided every pair that is shown."));
}

}  // namespace remount::gui
