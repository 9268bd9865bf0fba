#include "app/gui/features/pairs_feature.h"

#include <QAction>
#include <QActionGroup>
#include <QInputDialog>
#include <QMenu>
#include <QSettings>
#include <QTableView>
#include <QTimer>
#include <QToolButton>

#include "app/gui/basics/held_action.h"
#include "app/gui/shell/main_window.h"
#include "widgets/basics/remembering.h"
#include "widgets/pairs/error_chart_panel.h"
#include "widgets/pairs/pair_table_model.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/text/pair_reasons.h"

namespace remount::gui {
namespace {
const QString kGoesOn = QStringLiteral("review/goes-on");
}  // namespace

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
  dock_ = window_.add_dock({.title = tr("Pairs"),
                            .name = "pairs",
                            .content = pairs_,
                            .help_page = "pairs",
                            .width = 860,
                            .height = 300,
                            .for_review = true});
  window_.add_dock({.title = tr("Error chart"),
                    .name = "errors",
                    .content = errors_,
                    .help_page = "errors",
                    .arrangement = DockSpec::Arrangement::Beside,
                    .width = 420,
                    .for_review = true});
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
  make_notes_menu();
  // Held down they show every pair on the way: the next is gone to when the last is seen.
  const auto is_seen = [this] { return !workbench_.pair_scenes().awaited(); };
  new HeldAction(
      *add_review(MenuPlace::ReviewGo, "next", tr("&Next pair"), QKeySequence("N"), [this] { go(1, false); }), is_seen);
  new HeldAction(
      *add_review(MenuPlace::ReviewGo, "previous", tr("&Previous pair"), QKeySequence("P"), [this] { go(-1, false); }),
      is_seen);
  add_review(MenuPlace::ReviewGo, "next-undecided", tr("Next pair that yo&u have not decided"), QKeySequence("U"),
             [this] { go(1, true); });
  make_player();
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

void PairsFeature::make_notes_menu() {
  add_review(MenuPlace::ReviewDecide, "flag", tr("&Flag pair"), QKeySequence("F"),
             [this] { workbench_.review_notes().flip_flags(pairs_to_decide()); });
  add_review(MenuPlace::ReviewDecide, "comment", tr("&Comment on pair…"), QKeySequence("C"), [this] { ask_comment(); });
  goes_on_ = window_.menus().add(MenuPlace::ReviewDecide, tr("&Go on to the next pair after a decision"), {}, [] {});
  goes_on_->setCheckable(true);
  goes_on_->setChecked(widgets::remembers() && QSettings().value(kGoesOn).toBool());
  connect(goes_on_, &QAction::toggled, this, [](bool on) {
    if (widgets::remembers()) QSettings().setValue(kGoesOn, on);
  });
}

/// Pairs one after the other, as fast as was chosen or as they can be read.
void PairsFeature::make_player() {
  player_ = new QTimer(this);
  connect(player_, &QTimer::timeout, this, [this] {
    if (workbench_.pair_scenes().awaited()) return;
    if (const auto next = pairs_->neighbour(1, false))
      workbench_.selection().select(next);
    else
      plays_->setChecked(false);
  });
  plays_ = add_review(MenuPlace::ReviewGo, "play", tr("P&lay pairs"), QKeySequence("L"), [] {});
  plays_->setCheckable(true);
  auto* speeds = new QMenu(&window_);
  auto* group = new QActionGroup(speeds);
  for (const int pairs_per_s : {1, 2, 5, 10}) {
    QAction* speed = group->addAction(speeds->addAction(tr("%n pairs a second", nullptr, pairs_per_s)));
    speed->setCheckable(true);
    speed->setChecked(pairs_per_s == 2);
    connect(speed, &QAction::triggered, this, [this, pairs_per_s] { player_->setInterval(1000 / pairs_per_s); });
  }
  player_->setInterval(500);
  connect(plays_, &QAction::toggled, this, [this](bool on) { on ? player_->start() : player_->stop(); });
  auto* button = new QToolButton;
  button->setText(QStringLiteral("▶"));
  button->setToolTip(tr("Shows pairs one after the other (L); the arrow sets how fast"));
  button->setAccessibleName(tr("Play pairs"));
  button->setCheckable(true);
  button->setMenu(speeds);
  button->setPopupMode(QToolButton::MenuButtonPopup);
  connect(button, &QToolButton::toggled, plays_, &QAction::setChecked);
  connect(plays_, &QAction::toggled, button, &QToolButton::setChecked);
  pairs_->add_tool(button);
}

void PairsFeature::connect_panels() {
  Selection& selection = workbench_.selection();
  connect(pairs_, &widgets::PairsPanel::pair_selected, &selection, &Selection::select);
  connect(pairs_, &widgets::PairsPanel::accept_clicked, this, [this] { decide(motion::PairState::Accepted); });
  connect(pairs_, &widgets::PairsPanel::reject_clicked, this, [this] { decide(motion::PairState::Rejected); });
  connect(pairs_, &widgets::PairsPanel::shown_changed, this, [this] {
    errors_->chart()->show_pairs(pairs_->filter()->pairs());
    prepare_neighbours();
  });
  connect(errors_, &widgets::ErrorChartPanel::measure_changed, pairs_, &widgets::PairsPanel::set_measure);
  connect(errors_, &widgets::ErrorChartPanel::reject_requested, this, &PairsFeature::reject_above);
  connect(errors_, &widgets::ErrorChartPanel::take_back_requested, &workbench_.decisions(), &Decisions::take_back);
  connect(errors_->chart(), &widgets::ErrorBarChart::pair_clicked, &selection, &Selection::select);
  connect(&selection, &Selection::changed, this, [this](std::optional<motion::PairIndex> pair) {
    pairs_->show_selected(pair);
    errors_->chart()->show_selected(pair);
    prepare_neighbours();
  });
  connect(&workbench_.pair_scenes(), &PairScenes::ready, this,
          [this](motion::PairIndex pair) { workbench_.review_notes().mark_seen(pair); });
  connect(&workbench_.review_notes(), &ReviewNotes::changed, this, &PairsFeature::show_marks);
}

void PairsFeature::show_marks() {
  const ReviewNotes& notes = workbench_.review_notes();
  pairs_->show_marks(notes.marks(), notes.seen());
}

QList<QWidget*> PairsFeature::key_widgets() const { return {pairs_->table(), errors_->chart()}; }

widgets::PairFilter& PairsFeature::filter() const { return *pairs_->filter(); }

QItemSelectionModel& PairsFeature::marked() const { return *pairs_->table()->selectionModel(); }

void PairsFeature::review_pairs() {
  dock_->show();
  dock_->raise();
  pairs_->table()->setFocus();
}

void PairsFeature::show_output() {
  model_->show_output(workbench_.outcome().output(), workbench_.sessions().names());
  show_marks();
}

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
  const std::vector<motion::PairIndex> pairs = pairs_to_decide();
  workbench_.decisions().decide(pairs, state, reason);
  if (goes_on_->isChecked() && pairs.size() == 1) go(1, false);
}

void PairsFeature::ask_comment() {
  const std::vector<motion::PairIndex> pairs = pairs_to_decide();
  const widgets::PairMarksPtr marks = workbench_.review_notes().marks();
  if (pairs.empty() || !marks) return;
  auto* dialog = new QInputDialog(&window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Comment"));
  dialog->setLabelText(pairs.size() == 1 ? tr("Comment on pair %1:").arg(pairs.front())
                                         : tr("Comment on %1 pairs:").arg(pairs.size()));
  dialog->setTextValue(marks->at(pairs.front()).comment);
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, pairs](const QString& text) { workbench_.review_notes().comment(pairs, text); });
  dialog->open();
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

/// Whoever looks through pairs goes on, or back by one.
void PairsFeature::prepare_neighbours() { workbench_.pair_scenes().prepare_next(pairs_->neighbours({1, 2, -1, 3})); }

void PairsFeature::go(int step, bool undecided) {
  const std::optional<motion::PairIndex> pair = pairs_->neighbour(step, undecided);
  if (pair)
    workbench_.selection().select(pair);
  else if (undecided)
    window_.tell(tr("You have decided every pair that is shown."));
}

}  // namespace remount::gui
