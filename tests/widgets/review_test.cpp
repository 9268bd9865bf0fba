// Review of pairs: reasons, keys, and how X moved.
#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <atomic>
#include <thread>

#include "algorithms/messages/render.h"
#include "app/gui/document/result_files.h"
#include "app/gui/workbench/wording.h"
#include "model/project/project.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
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

TEST(spread_text, is_never_nothing) {
  EXPECT_EQ(spread_text(0.00123, 4), "± 0.0012");
  EXPECT_EQ(spread_text(0.00003, 4), "± < 0.0001");
  EXPECT_EQ(spread_text(0.00006, 4), "± 0.0001");
  EXPECT_EQ(spread_text(0.0, 2), "± 0.00") << "of what is known exactly";
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
