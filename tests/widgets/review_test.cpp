// Review of pairs: reasons, the line in the chart, keys, and how X moved.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <atomic>
#include <thread>

#include "algorithms/messages/render.h"
#include "app/gui/document/result_files.h"
#include "app/gui/features/help_feature.h"
#include "app/gui/workbench/wording.h"
#include "model/project/project.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/pairs/error_bar_chart.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/result/result_panel.h"
#include "widgets/shell/keys_dialog.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {

using motion::PairIndex;

namespace {

using testing::kPatience_ms;
using review = testing::WindowFixture;

TEST_F(review, one_key_rejects_with_a_reason_that_is_saved_and_exported) {
  show();
  calibrate_drive();
  workbench_.selection().select(PairIndex{5});
  trigger("2");
  EXPECT_EQ(pair(5).state, motion::PairState::Rejected);
  EXPECT_EQ(english(pair(5).reason), "aligned wrongly");
  EXPECT_EQ(workbench_.history().stack().undoText(), "reject pair 5: aligned wrongly");
  ASSERT_TRUE(settle());
  EXPECT_EQ(english(pair(5).reason), "aligned wrongly") << "a new solution keeps it";
  EXPECT_TRUE(gui::export_text(workbench_, "yaml").contains("aligned wrongly"));
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_EQ(english(pair(5).reason), "aligned wrongly") << "a new calibration keeps it";
  QTemporaryDir folder;
  const QString path = folder.filePath("job.remount");
  workbench_.document().save(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.document().path() == path; }, kPatience_ms));
  workbench_.document().open(path);
  ASSERT_TRUE(settle());
  EXPECT_EQ(english(pair(5).reason), "aligned wrongly") << "a project keeps it";
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_EQ(english(pair(5).reason), "aligned wrongly") << "and a calibration of the project";
}

TEST_F(review, saying_why_after_rejecting_is_one_edit_and_solves_only_once) {
  show();
  calibrate_drive();
  workbench_.selection().select(PairIndex{5});
  trigger("R");
  ASSERT_TRUE(settle());
  const double rejected_m = x_m();
  trigger("1");
  EXPECT_FALSE(workbench_.activity().solving()) << "the pairs are the same";
  EXPECT_EQ(english(pair(5).reason), "moving objects");
  EXPECT_EQ(edits_since_calibration(), 1);
  EXPECT_EQ(x_m(), rejected_m);
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_NE(pair(5).decided_by, motion::DecidedBy::User);
  EXPECT_NE(x_m(), rejected_m);
}

TEST_F(review, a_reason_can_be_typed) {
  show();
  calibrate_drive();
  workbench_.selection().select(PairIndex{8});
  trigger("Shift+R");
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_TRUE(dialog);
  dialog->setTextValue("  tram in front of us ");
  dialog->accept();
  EXPECT_EQ(english(pair(8).reason), "tram in front of us");
  EXPECT_EQ(pair(8).decided_by, motion::DecidedBy::User);
  ASSERT_TRUE(settle());
}

TEST_F(review, dragging_the_line_counts_live_and_rejects_on_release_as_one_edit) {
  show();
  calibrate_drive();
  auto& chart = child<ErrorBarChart>();
  QSignalSpy moved(&chart, &ErrorBarChart::threshold_moved);
  const QPoint start = chart.handle();
  QTest::mousePress(&chart, Qt::LeftButton, {}, start);
  std::vector<PairIndex> above;
  int y = start.y();
  while (above.size() < 3 && y < chart.height()) {
    y += 2;
    QTest::mouseMove(&chart, {start.x() - 40, y});
    above = chart.above_threshold();
    EXPECT_EQ(moved.last()[0].toInt(), chart.threshold() ? static_cast<int>(above.size()) : -1);
  }
  ASSERT_GE(above.size(), 3U);
  EXPECT_EQ(moved.last()[1].toInt(), 43) << "7 of 50 are rejected already";
  EXPECT_EQ(edits_since_calibration(), 0) << "nothing happens before the line is let go";
  photograph(window_, "20-threshold");
  QTest::mouseRelease(&chart, Qt::LeftButton, {}, {start.x() - 40, y});
  EXPECT_EQ(edits_since_calibration(), 1);
  EXPECT_TRUE(workbench_.history().stack().undoText().contains("residual translation above")) << "says what was done";
  for (const PairIndex index : above) {
    EXPECT_EQ(pair(index).state, motion::PairState::Rejected);
    EXPECT_EQ(pair(index).decided_by, motion::DecidedBy::User);
    EXPECT_TRUE(english(pair(index).reason).starts_with("residual translation above")) << english(pair(index).reason);
  }
  ASSERT_TRUE(settle());
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  for (const PairIndex index : above) EXPECT_NE(pair(index).decided_by, motion::DecidedBy::User);
}

TEST(error_bar_chart, counts_by_the_decisions_of_now) {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  auto output = std::make_shared<pipeline::PipelineOutput>(testing::sample_output(input, 10));
  std::vector<PairIndex> all;
  for (PairIndex i; i < 10U; ++i) {
    all.push_back(i);
    output->pairs[i].state = motion::PairState::Accepted;
    output->pairs[i].residual_translation_m = 0.1 * static_cast<double>(i + 1);
  }
  ErrorBarChart chart;
  QSignalSpy moved(&chart, &ErrorBarChart::threshold_moved);
  chart.show_output(output);
  chart.show_pairs(all);
  chart.set_threshold(75.0);  // cm
  ASSERT_FALSE(moved.isEmpty());
  EXPECT_EQ(moved.last(), (QList<QVariant>{3, 10}));
  auto decided = std::make_shared<pipeline::PipelineOutput>(*output);
  decided->pairs[9].state = motion::PairState::Rejected;
  chart.show_output(decided);
  EXPECT_EQ(moved.last(), (QList<QVariant>{2, 9}));
  EXPECT_EQ(chart.above_threshold(), (std::vector<PairIndex>{PairIndex{7}, PairIndex{8}}));
}

TEST_F(review, the_line_moves_with_keys_and_escape_lets_go) {
  show();
  calibrate_drive();
  auto& chart = child<ErrorBarChart>();
  QTest::keyClick(&chart, Qt::Key_PageDown);
  ASSERT_TRUE(chart.threshold());
  EXPECT_NEAR(*chart.threshold(), 0.9 * chart.top_of_axis(), 1e-9);
  QTest::keyClick(&chart, Qt::Key_Escape);
  EXPECT_FALSE(chart.threshold());
  QTest::keyClick(&chart, Qt::Key_Return);
  EXPECT_EQ(edits_since_calibration(), 0) << "at rest the line rejects nothing";
  while (chart.above_threshold().size() < 2) QTest::keyClick(&chart, Qt::Key_Down);
  const auto above = chart.above_threshold();
  QTest::keyClick(&chart, Qt::Key_Return);
  EXPECT_EQ(edits_since_calibration(), 1);
  EXPECT_EQ(pair(above.front()).state, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
}

TEST_F(review, a_drag_that_ends_where_it_began_or_above_the_chart_rejects_nothing) {
  show();
  calibrate_drive();
  auto& chart = child<ErrorBarChart>();
  chart.set_threshold(0.5 * chart.top_of_axis());
  QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.handle());
  EXPECT_EQ(edits_since_calibration(), 0);
  QTest::mousePress(&chart, Qt::LeftButton, {}, chart.handle());
  QTest::mouseMove(&chart, {chart.width() - 30, chart.height() / 2});
  QTest::mouseMove(&chart, {chart.width() - 30, 0});
  QTest::mouseRelease(&chart, Qt::LeftButton, {}, {chart.width() - 30, 0});
  EXPECT_EQ(edits_since_calibration(), 0);
  EXPECT_FALSE(chart.threshold());
}

TEST_F(review, the_line_stays_where_it_was_dropped_and_gives_back_what_it_rejected_when_it_is_pulled_back) {
  show();
  calibrate_drive();
  auto& chart = child<ErrorBarChart>();
  const auto drag_to = [&](double share) {
    const int y = chart.handle().y() + 1, x = chart.handle().x();
    const QPoint to(x - 40, static_cast<int>(share * chart.height()));
    QTest::mousePress(&chart, Qt::LeftButton, {}, {x, y});
    QTest::mouseMove(&chart, {x - 40, (y + to.y()) / 2});
    QTest::mouseMove(&chart, to);
    QTest::mouseRelease(&chart, Qt::LeftButton, {}, to);
    ASSERT_TRUE(settle());
  };
  const auto by_user = [&] {
    std::vector<PairIndex> pairs;
    for (PairIndex i; i < 50U; ++i)
      if (pair(i).decided_by == motion::DecidedBy::User && pair(i).state == motion::PairState::Rejected)
        pairs.push_back(i);
    return pairs;
  };
  drag_to(0.5);
  ASSERT_TRUE(chart.threshold()) << "it stays";
  const std::vector<PairIndex> deep = by_user();
  ASSERT_GT(deep.size(), 3U);
  EXPECT_TRUE(chart.above_threshold().empty());
  photograph(window_, "22-line-stays");
  drag_to(0.3);
  const std::vector<PairIndex> high = by_user();
  ASSERT_GT(high.size(), 0U);
  EXPECT_LT(high.size(), deep.size()) << "pulled back, it gives back what is now below";
  for (const PairIndex index : high) EXPECT_GT(*chart.value_of(index), *chart.threshold());
  std::printf("the line rejected %zu pairs, pulled back %zu\n", deep.size(), high.size());
  EXPECT_EQ(edits_since_calibration(), 2);
  drag_to(0.0);
  EXPECT_FALSE(chart.threshold());
  EXPECT_TRUE(by_user().empty());
  workbench_.history().stack().undo();
  EXPECT_EQ(by_user(), high) << "also that is undone";
}

TEST(error_bar_chart, zooms_pans_and_shows_the_whole_again) {
  const testing::LanguageFor english("en");
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  auto output = std::make_shared<pipeline::PipelineOutput>(testing::sample_output(input, 3000));
  output->pairs[1500].residual_translation_m = 0.5;
  output->pairs[1500].state = motion::PairState::Accepted;
  std::vector<PairIndex> all;
  for (PairIndex i; i < 3000U; ++i) all.push_back(i);
  ErrorBarChart chart;
  chart.resize(500, 200);
  chart.show();
  chart.show_output(output);
  chart.show_pairs(all);
  const auto wheel = [&](const QPointF& at, int angle) {
    QWheelEvent event(at, chart.mapToGlobal(at), {}, {0, angle}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&chart, &event);
  };
  int x = 0;
  while (x < 500 && chart.pair_at({x, 100}) != PairIndex{1500}) ++x;
  ASSERT_LT(x, 500) << "the largest of seven pairs that share a bar is the one that is hit";
  EXPECT_EQ(chart.pair_at({x + 1, 100}), PairIndex{1500}) << "bars are two pixels wide";
  wheel(QPointF(x, 100), 1800);
  EXPECT_LT(chart.seen().length(), 300.0);
  EXPECT_TRUE(chart.seen().holds(1500.0)) << "what is under the cursor stays";
  const double low = chart.seen().low;
  QTest::mousePress(&chart, Qt::RightButton, {}, {200, 100});
  QTest::mouseMove(&chart, {100, 100});
  QTest::mouseRelease(&chart, Qt::RightButton, {}, {100, 100});
  EXPECT_GT(chart.seen().low, low);
  chart.show_selected(PairIndex{20});
  EXPECT_TRUE(chart.seen().holds(20.0)) << "what is selected elsewhere comes into view";
  const double top = chart.top_of_axis();
  wheel(QPointF(5, 100), 240);
  EXPECT_NEAR(chart.top_of_axis(), top / 1.44, 1e-9);
  EXPECT_TRUE(chart.words_of(PairIndex{1500}).startsWith("pair 1500: 50 cm")) << "hovering tells it";
  QTest::mouseDClick(&chart, Qt::LeftButton, {}, {200, 100});
  EXPECT_EQ(chart.seen(), (AxisSpan{0.0, 3000.0}));
  EXPECT_NEAR(chart.top_of_axis(), top, 1e-9);
}

TEST_F(review, the_chart_shows_the_pairs_of_the_table_in_its_order) {
  show();
  calibrate_drive();
  auto& chart = child<ErrorBarChart>();
  auto& panel = child<PairsPanel>();
  const auto drawn = [&] {
    std::vector<PairIndex> pairs;
    for (int x = 0; x < chart.width(); ++x) {
      const auto pair = chart.pair_at({x, 50});
      if (pair && (pairs.empty() || pairs.back() != *pair)) pairs.push_back(*pair);
    }
    return pairs;
  };
  EXPECT_EQ(drawn().size(), 50U);
  panel.table()->sortByColumn(PairTableModel::ResidualTranslation, Qt::DescendingOrder);
  EXPECT_EQ(drawn(), panel.filter()->pairs());
  const auto combos = panel.findChildren<QComboBox*>();
  combos.at(1)->setCurrentIndex(static_cast<int>(PairGroup::Worst10));
  EXPECT_EQ(drawn().size(), 11U) << "the worst, and the pair that is looked at";
  EXPECT_EQ(drawn(), panel.filter()->pairs());
  photograph(window_, "21-worst");
  chart.show_selected(drawn().at(3));
  QSignalSpy clicked(&chart, &ErrorBarChart::pair_clicked);
  QTest::keyClick(&chart, Qt::Key_Right);
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked[0][0].value<PairIndex>(), drawn().at(4)) << "the neighbour that is seen";
  EXPECT_EQ(workbench_.selection().pair(), drawn().at(4));
}

TEST_F(review, how_x_moved_is_shown_in_millimetres_with_what_moved_it) {
  show();
  calibrate_drive();
  workbench_.selection().select(PairIndex{5});
  trigger("R");
  ASSERT_TRUE(settle());
  QStringList texts;
  for (const QLabel* label : child<ResultPanel>().findChildren<QLabel*>())
    if (label->isVisible()) texts << label->text();
  EXPECT_TRUE(texts.contains("+1.00 mm")) << texts.join(" | ").toStdString();
  EXPECT_TRUE(texts.join('\n').contains("reject pair 5")) << texts.join(" | ").toStdString();
  EXPECT_EQ(workbench_.outcome().moved_by(), "reject pair 5");
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.outcome().moved_by(), "undo: reject pair 5");
  photograph(window_, "22-moved");
}

/// Answers at once, by moving X half a metre, and gives the whole solution once it is allowed to.
gui::Engine two_step_engine(const std::atomic<bool>& complete) {
  gui::Engine engine = testing::sample_engine();
  const auto whole = engine.solve_again;
  engine.solve_again = [&complete, whole](const pipeline::PipelineInput& input, pipeline::PipelineOutput& output,
                                          Progress& progress) {
    while (!complete && !progress.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return !progress.cancelled() && whole(input, output, progress);
  };
  // Half a metre for each pair that the user rejected; and far from the whole solution, which nobody may notice.
  engine.solve_at_once = [](const pipeline::PipelineInput&, pipeline::PipelineOutput& output, const Progress&) {
    double& x_m = output.result.mounting.reference_from_sensor.translation().x();
    x_m = 10.0;
    for (const motion::Pair& pair : output.pairs)
      if (pair.decided_by == motion::DecidedBy::User && pair.state == motion::PairState::Rejected) x_m += 0.5;
    return true;
  };
  return engine;
}

bool calibrated(gui::Workbench& workbench) {
  workbench.sessions().open({"/data/drive1"});
  if (!QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms)) return false;
  workbench.calibrations().calibrate();
  return QTest::qWaitFor([&] { return !workbench.activity().calibrating(); }, kPatience_ms) &&
         workbench.outcome().output();
}

TEST(decisions, that_were_cancelled_before_they_were_answered_in_full_say_so_and_are_solved_when_opened) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("job.remount");
  std::atomic<bool> complete = false;
  gui::Workbench workbench(two_step_engine(complete));
  ASSERT_TRUE(calibrated(workbench));
  EXPECT_FALSE(workbench.solutions().incomplete());
  workbench.decisions().decide({PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.solutions().refining(); }, kPatience_ms));
  workbench.cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().solving(); }, kPatience_ms));
  EXPECT_TRUE(workbench.solutions().incomplete() && workbench.calibrations().out_of_date())
      << "its sigmas are of other pairs";
  EXPECT_TRUE(gui::standing_note(workbench).contains("decisions")) << gui::standing_note(workbench).toStdString();
  workbench.document().save(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.document().unsaved(); }, kPatience_ms));
  EXPECT_EQ(project::load_project(path.toStdString()).changes_since_calibration().size(), 1U);

  complete = true;
  gui::Workbench again(two_step_engine(complete));
  gui::ProjectToOpen request;
  request.path = path;
  request.access = gui::ProjectToOpen::Access::ReadOnly;  // `workbench` has it
  again.document().open(request);
  ASSERT_TRUE(QTest::qWaitFor([&] { return again.outcome().output() && !again.activity().solving(); }, kPatience_ms));
  EXPECT_FALSE(again.solutions().incomplete() || again.calibrations().out_of_date());
  EXPECT_EQ(again.outcome().output()->pairs[5].state, motion::PairState::Rejected);

  workbench.decisions().decide({PairIndex{6}}, motion::PairState::Rejected);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().solving(); }, kPatience_ms));
  EXPECT_FALSE(workbench.solutions().incomplete()) << "the next decision is answered in full";
}

TEST(decisions, are_answered_at_once_and_completed_later) {
  std::atomic<bool> complete = false;
  gui::Workbench workbench(two_step_engine(complete));
  ASSERT_TRUE(calibrated(workbench));
  const double before_m = workbench.outcome().output()->result.mounting.reference_from_sensor.translation().x();
  const auto moved_m = [&] {
    return workbench.outcome().output()->result.mounting.reference_from_sensor.translation().x() -
           workbench.outcome().output_before()->result.mounting.reference_from_sensor.translation().x();
  };
  workbench.decisions().decide({PairIndex{5}}, motion::PairState::Rejected);
  EXPECT_FALSE(workbench.solutions().refining());
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.solutions().refining(); }, kPatience_ms));
  EXPECT_NEAR(moved_m(), 0.5, 1e-12);
  workbench.decisions().decide({PairIndex{6}}, motion::PairState::Rejected);  // before the first is completed
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.solutions().refining(); }, kPatience_ms));
  EXPECT_EQ(workbench.outcome().moved_by(), "reject pair 5; reject pair 6");
  EXPECT_NEAR(moved_m(), 1.0, 1e-12) << "since the last complete result";
  complete = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().solving(); }, kPatience_ms));
  EXPECT_FALSE(workbench.solutions().refining());
  EXPECT_NEAR(moved_m(), 0.002, 1e-9);
  EXPECT_NEAR(workbench.outcome().output_before()->result.mounting.reference_from_sensor.translation().x(), before_m,
              1e-12);
  EXPECT_EQ(workbench.outcome().output()->pairs[5].state, motion::PairState::Rejected);
  EXPECT_EQ(workbench.outcome().output()->pairs[6].state, motion::PairState::Rejected);
}

TEST(rounded_text, has_no_sign_before_what_rounds_to_zero) {
  EXPECT_EQ(rounded_text(-0.00004, 4), "0.0000");
  EXPECT_EQ(rounded_text(-0.00006, 4), "-0.0001");
  EXPECT_EQ(rounded_text(0.5, 1), "0.5");
}

TEST(moved_text, has_the_unit_that_suits) {
  EXPECT_EQ(moved_text(calibration::Parameter::X, 0.00124), "+1.24 mm");
  EXPECT_EQ(moved_text(calibration::Parameter::Z, -1.5), "-1.500 m");
  EXPECT_EQ(moved_text(calibration::Parameter::Yaw, -0.0031), "-0.0031°");
  EXPECT_EQ(moved_text(calibration::Parameter::Pitch, 2.5), "+2.500°");
  EXPECT_EQ(moved_text(calibration::Parameter::X, 1e-9), "0 mm");
  EXPECT_EQ(moved_text(calibration::Parameter::Roll, -1e-9), "0°");
}

TEST_F(review, keys_can_be_changed_and_a_key_with_two_meanings_is_named) {
  show();
  calibrate_drive();
  for (QAction* action : window_.findChildren<QAction*>())
    if (action->text() == gui::HelpFeature::tr("&Keys")) action->trigger();
  auto* dialog = window_.findChild<KeysDialog*>();
  ASSERT_TRUE(dialog);
  photograph(*dialog, "23-keys");
  const QList<QAction*> bound = window_.findChildren<QAction*>();
  const auto ok = [&] { return dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled(); };
  const auto words = [&] {
    QStringList texts;
    for (const QLabel* label : dialog->findChildren<QLabel*>())
      if (label->isVisibleTo(dialog)) texts << label->text();
    return texts.join('\n');
  };
  dialog->set_key("reject", QKeySequence("A"));
  EXPECT_TRUE(words().contains("A: Accept pair and Reject pair")) << words().toStdString();
  dialog->set_key("reject", QKeySequence("Ctrl+E"));
  EXPECT_TRUE(words().contains("Export result")) << "keys of other menus count";
  EXPECT_FALSE(ok());
  dialog->set_key("reject", QKeySequence("X"));
  EXPECT_TRUE(words().contains("3-D view: Top")) << "views have keys that can be changed, too";
  dialog->set_key("view-top", QKeySequence("X"));
  EXPECT_TRUE(words().contains("X: Reject pair and 3-D view: Top")) << words().toStdString();
  dialog->set_key("view-top", QKeySequence("T"));
  EXPECT_TRUE(ok());
  dialog->accept();
  EXPECT_EQ(std::count_if(bound.begin(), bound.end(),
                          [](const QAction* action) {
                            return action->shortcut() == QKeySequence("T") &&
                                   action->text() == gui::MainWindow::tr("&Top");
                          }),
            1);
  workbench_.selection().select(PairIndex{5});
  trigger("X");
  EXPECT_EQ(pair(5).decided_by, motion::DecidedBy::User);
  ASSERT_TRUE(settle());
}

TEST(keys_dialog, goes_back_to_the_standard) {
  KeysDialog dialog({{"a", "Accept", QKeySequence("Y"), QKeySequence("A")}, {"", "Quit", QKeySequence("Q"), {}}});
  dialog.set_key("a", QKeySequence("Q"));
  EXPECT_EQ(key_conflicts(dialog.bindings()).size(), 1);
  for (QPushButton* button : dialog.findChildren<QPushButton*>())
    if (button->text().contains("Defaults")) button->click();
  EXPECT_EQ(dialog.bindings().at(0).key, QKeySequence("A"));
  EXPECT_TRUE(key_conflicts(dialog.bindings()).isEmpty());
}

}  // namespace
}  // namespace remount::widgets
