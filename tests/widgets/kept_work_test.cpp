// What the user decided, confirmed and compared is what the window goes on with.
#include <gtest/gtest.h>

#include <QClipboard>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QThread>
#include <atomic>

#include "app/gui/basics/language.h"
#include "app/gui/features/method_controller.h"
#include "app/gui/features/obstacle_controller.h"
#include "app/gui/window_host.h"
#include "app/gui/workbench/steps.h"
#include "app/gui/workbench/wording.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/quality/obstacle_dialog.h"
#include "widgets/result/export_dialog.h"
#include "widgets/result/nominal_panel.h"
#include "widgets/shell/message_banner.h"
#include "widgets/shell/welcome_panel.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// Leaves no pair without a judgement, as the model does.
gui::Engine engine_that_judges(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = testing::sample_engine(10, std::move(hold_at));
  const auto solve_again = [solve = engine.solve_again](const pipeline::PipelineInput& input,
                                                        pipeline::PipelineOutput& output, Progress& progress) {
    for (motion::Pair& pair : output.pairs)
      if (pair.decided_by == motion::DecidedBy::Nobody)
        pair.state = motion::PairState::Accepted, pair.decided_by = motion::DecidedBy::Program;
    return solve(input, output, progress);
  };
  engine.solve_again = solve_again;
  engine.run = [run = engine.run, solve_again](const pipeline::PipelineInput& input, Progress& progress) {
    pipeline::PipelineOutput output = run(input, progress);
    if (output.result.status != calibration::Status::Cancelled) solve_again(input, output, progress);
    return output;
  };
  return engine;
}

class kept_work : public testing::WindowFixture {
 protected:
  kept_work() : WindowFixture(&engine_that_judges) {}
  StepInfo step(Step which) { return gui::describe_steps(workbench_)[static_cast<std::size_t>(which)]; }
  /// Calibrates again, and does `meanwhile` while that runs.
  void calibrate_and(const std::function<void()>& meanwhile) {
    *hold_at_ = 5;
    workbench_.calibrations().calibrate();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.activity().stage().empty(); }, kPatience_ms));
    ASSERT_TRUE(workbench_.activity().calibrating());
    meanwhile();
    *hold_at_ = -1;
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.activity().calibrating(); }, kPatience_ms));
    ASSERT_TRUE(settle());
  }
};

TEST_F(kept_work, what_x_is_so_far_is_shown_while_a_calibration_runs_and_not_after_it) {
  gui::Engine engine = testing::sample_engine();
  const auto go_on = std::make_shared<std::atomic<bool>>(false);
  engine.run = [run = engine.run, go_on](const pipeline::PipelineInput& input, Progress& progress) {
    input.tell_so_far(Message::verbatim("So far, by 80 of 900 pairs"));
    while (!*go_on) QThread::msleep(1);
    return run(input, progress);
  };
  gui::Workbench workbench(engine);
  workbench.sessions().open({"/data/drive1"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  for (int calibration = 0; calibration < 2; ++calibration) {
    *go_on = false;
    workbench.calibrations().calibrate();
    EXPECT_TRUE(workbench.activity().so_far().empty()) << "that of the one before is gone";
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().so_far().empty(); }, kPatience_ms));
    EXPECT_EQ(gui::next_text(workbench), "So far, by 80 of 900 pairs");
    *go_on = true;
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().calibrating(); }, kPatience_ms));
    EXPECT_NE(gui::next_text(workbench), "So far, by 80 of 900 pairs");
  }
}

TEST_F(kept_work, a_decision_that_is_undone_while_a_calibration_runs_does_not_come_back) {
  calibrate_drive();
  const double before_m = x_m();
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  workbench_.decisions().decide({motion::PairIndex{8}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  calibrate_and([&] { workbench_.history().stack().undo(); });
  EXPECT_EQ(pair(8).decided_by, motion::DecidedBy::Program);
  EXPECT_EQ(pair(8).state, motion::PairState::Accepted);
  EXPECT_EQ(pair(5).decided_by, motion::DecidedBy::User) << "the other decision stays";
  EXPECT_NEAR(x_m() - before_m, 0.001, 1e-9) << "and X follows from it alone";
  EXPECT_FALSE(workbench_.solutions().incomplete());
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_EQ(pair(8).decided_by, motion::DecidedBy::Program);
}

TEST_F(kept_work, a_decision_that_is_redone_while_a_calibration_runs_counts) {
  calibrate_drive();
  workbench_.decisions().decide({motion::PairIndex{8}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  const double before_m = x_m();
  calibrate_and([&] { workbench_.history().stack().redo(); });
  EXPECT_EQ(pair(8).decided_by, motion::DecidedBy::User);
  EXPECT_NEAR(x_m() - before_m, 0.001, 1e-9);
}

TEST_F(kept_work, a_confirmed_result_is_confirmed_when_its_project_is_opened) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("job.remount");
  calibrate_drive();
  const int before = workbench_.document().revision();
  workbench_.outcome().confirm(true);
  EXPECT_GT(workbench_.document().revision(), before) << "it is work like any other, and to be saved";
  bool saved = false;
  workbench_.document().save(path, [&] { saved = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kPatience_ms));

  gui::Workbench again(testing::sample_engine());
  gui::ProjectToOpen copy;
  copy.path = path;
  copy.access = gui::ProjectToOpen::Access::Copy;
  again.document().open(copy);
  ASSERT_TRUE(QTest::qWaitFor([&] { return again.outcome().output() != nullptr; }, kPatience_ms));
  EXPECT_TRUE(again.outcome().confirmed());
  again.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !again.activity().solving(); }, kPatience_ms));
  EXPECT_FALSE(again.outcome().confirmed()) << "another result";
}

TEST_F(kept_work, an_exported_result_is_exported_when_its_project_is_opened) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("job.remount");
  calibrate_drive();
  const int before = workbench_.document().revision();
  workbench_.outcome().mark_exported(gui::Exported::Written);
  EXPECT_GT(workbench_.document().revision(), before) << "it is to be saved";
  bool saved = false;
  workbench_.document().save(path, [&] { saved = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kPatience_ms));
  gui::Workbench again(testing::sample_engine());
  gui::ProjectToOpen copy;
  copy.path = path;
  copy.access = gui::ProjectToOpen::Access::Copy;
  again.document().open(copy);
  ASSERT_TRUE(QTest::qWaitFor([&] { return again.outcome().output() != nullptr; }, kPatience_ms));
  EXPECT_EQ(again.outcome().exported(), gui::Exported::Written);
}

TEST_F(kept_work, what_was_calibrated_is_there_again_when_all_decisions_are_undone) {
  calibrate_drive();
  const gui::OutputPtr calibrated = workbench_.outcome().output();
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  workbench_.decisions().decide({motion::PairIndex{8}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_NE(workbench_.outcome().output(), calibrated);
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.outcome().output(), calibrated) << "with its last steps, which no decision repeats";
  EXPECT_FALSE(workbench_.solutions().incomplete());
  workbench_.setup().edit_option("range", "x_max_m", 0.95);
  ASSERT_TRUE(settle());
  EXPECT_NE(workbench_.outcome().output(), calibrated);
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.outcome().output(), calibrated);
}

TEST_F(kept_work, what_was_calibrated_and_saved_is_there_again_when_decisions_about_it_are_undone) {
  gui::Engine engine = testing::sample_engine();
  engine.run = [run = engine.run](const pipeline::PipelineInput& input, Progress& progress) {
    pipeline::PipelineOutput output = run(input, progress);
    output.result.candidates.push_back({});
    output.result.candidates.back().source = calibration::MountingSource::JointClouds;  // as a whole calibration ends
    return output;
  };
  const QTemporaryDir folder;
  const QString path = folder.filePath("job.remount");
  {
    gui::Workbench first(engine);
    first.sessions().open({"/data/drive1"});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !first.activity().opening(); }, kPatience_ms));
    first.calibrations().calibrate();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return first.outcome().output() && !first.activity().calibrating(); }, kPatience_ms));
    bool saved = false;
    first.document().save(path, [&] { saved = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kPatience_ms));
  }
  gui::Workbench again(engine);
  gui::ProjectToOpen project;
  project.path = path;
  again.document().open(project);
  ASSERT_TRUE(QTest::qWaitFor([&] { return again.outcome().output() != nullptr; }, kPatience_ms));
  const gui::OutputPtr saved = again.outcome().output();
  again.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !again.activity().solving(); }, kPatience_ms));
  EXPECT_NE(again.outcome().output(), saved);
  again.history().stack().undo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !again.activity().solving(); }, kPatience_ms));
  EXPECT_EQ(again.outcome().output(), saved) << "with its last steps, which no decision repeats";
}

TEST_F(kept_work, the_selected_pair_stays_where_the_next_calibration_has_it_too) {
  calibrate_drive();
  workbench_.selection().select(motion::PairIndex{17});
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.selection().pair(), motion::PairIndex{17});
}

TEST_F(kept_work, a_cancelled_calibration_says_that_the_result_before_is_kept) {
  show();
  calibrate_drive();
  const gui::OutputPtr before = workbench_.outcome().output();
  calibrate_and([&] { workbench_.cancel(); });
  EXPECT_EQ(workbench_.outcome().output(), before);
  auto& banner = child<MessageBanner>();
  EXPECT_TRUE(banner.isVisible());
  const QString said = banner.findChild<QLabel*>()->text();
  EXPECT_TRUE(said.contains("before is kept") && said.contains("of 50 pairs")) << said.toStdString();
}

TEST_F(kept_work, a_session_is_not_removed_from_a_calibration_that_runs) {
  calibrate_drive();
  const QSignalSpy said(&workbench_.notices(), &gui::Notices::message);
  calibrate_and([&] {
    workbench_.session_edits().remove(motion::SessionIndex{0});
    ASSERT_FALSE(said.isEmpty());
    EXPECT_TRUE(said.back().at(2).toString().contains("is being calibrated"));
  });
  EXPECT_EQ(workbench_.sessions().all().size(), 1U);
}

TEST_F(kept_work, a_new_project_has_nothing_of_the_one_before) {
  show();
  calibrate_drive();
  workbench_.setup().edit_nominal(rigid_from_six({1.5, 0.2, 0.9, 0.1, 0.0, 0.0}));
  workbench_.setup().edit_option("registration", "voxel_m", 0.5);
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  const QTemporaryDir folder;
  bool saved = false;
  workbench_.document().save(folder.filePath("job.remount"), [&] { saved = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kPatience_ms));
  trigger("Ctrl+N");
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.sessions().all().empty());
  EXPECT_FALSE(workbench_.outcome().output());
  EXPECT_TRUE(workbench_.document().path().isEmpty());
  EXPECT_FALSE(workbench_.document().has_unsaved_work());
  EXPECT_FALSE(workbench_.document().unsaved());
  EXPECT_FALSE(workbench_.setup().nominal_ins_from_lidar());
  EXPECT_EQ(workbench_.setup().settings().registration.voxel_m, settings::Settings{}.registration.voxel_m);
  EXPECT_FALSE(workbench_.history().stack().canUndo());
  EXPECT_EQ(workbench_.decisions().count(), 0);
  for (const auto* value : child<NominalPanel>().findChildren<QDoubleSpinBox*>())
    EXPECT_EQ(value->value(), 0.0) << value->accessibleName().toStdString();
  EXPECT_TRUE(child<WelcomePanel>().isVisible());
  window_.open_paths({folder.filePath("job.remount")});
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.decisions().count(), 1) << "the file is as it was saved, and free to be opened";
}

TEST_F(kept_work, what_was_only_copied_is_not_exported_yet) {
  calibrate_drive();
  EXPECT_EQ(step(Step::Export).detail, "ready (Ctrl+E)");
  trigger("Ctrl+Shift+C");
  EXPECT_FALSE(QGuiApplication::clipboard()->text().isEmpty());
  EXPECT_EQ(step(Step::Export).state, StepState::Next);
  EXPECT_TRUE(step(Step::Export).detail.startsWith("copied")) << step(Step::Export).detail.toStdString();
  trigger("Ctrl+E");
  auto& dialog = child<ExportDialog>();
  const QTemporaryDir folder;
  emit dialog.save_requested("matrix", folder.filePath("x.txt"), dialog.current_text());
  EXPECT_EQ(step(Step::Export).state, StepState::Done);
  emit dialog.copied("matrix");
  EXPECT_EQ(step(Step::Export).detail, "exported") << "the file is still there";
}

TEST_F(kept_work, distances_of_obstacles_are_measured_beside_the_window_for_what_was_typed_last) {
  calibrate_drive();
  const auto clouds = std::make_shared<const pipeline::PairClouds>(
      testing::sample_engine()
          .open_pairs(workbench_.outcome().input(), workbench_.outcome().output())
          ->load(motion::PairIndex{5}, {}));
  ObstacleDialog dialog("a scan", true, {});
  auto& table = *dialog.findChild<QTableWidget*>();
  const RigidTransform mounting = rigid_from_six(testing::kTruth);
  new gui::ObstacleController(workbench_.jobs(), dialog, clouds, mounting, mounting);
  EXPECT_EQ(table.rowCount(), 0) << "the window's thread does not measure";
  ASSERT_TRUE(QTest::qWaitFor([&] { return table.rowCount() == 4; }, kPatience_ms));
  const QString before = table.item(0, 2)->text();
  QDoubleSpinBox* left = nullptr;
  for (auto* spin : dialog.findChildren<QDoubleSpinBox*>())
    if (spin->toolTip().startsWith("Left side")) left = spin;
  ASSERT_TRUE(left);
  for (const double half_width_m : {1.5, 2.0, 2.5}) left->setValue(half_width_m);
  ASSERT_TRUE(QTest::qWaitFor([&] { return table.item(0, 2)->text() != before; }, kPatience_ms));
  left->setValue(-3.0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return table.rowCount() == 0; }, kPatience_ms)) << "an outline without width";
}

TEST(kept_results, of_methods_outlive_another_language) {
  const testing::LanguageFor as_before;
  gui::Workbench workbench(testing::sample_engine());
  gui::WindowHost host(workbench);
  host.window().open_paths({"/data/drive1"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  workbench.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().calibrating(); }, kPatience_ms));
  pipeline::PipelineOutput other = *workbench.outcome().output();
  other.method = "trajectory";
  project::Project project;
  project.basis.session_count = 1;
  workbench.document().restore(workbench.sessions().all(), project,
                               std::make_shared<const pipeline::PipelineOutput>(other));
  const auto compared = [&] { return host.window().findChild<gui::MethodController*>()->compared().of_methods; };
  ASSERT_EQ(compared().size(), 2U);
  const std::string name = compared().begin()->second.name;
  host.change_language("zh_CN");
  ASSERT_EQ(compared().size(), 2U) << "both are still compared";
  EXPECT_NE(compared().begin()->second.name, name) << "in the language of the window";
}

}  // namespace
}  // namespace remount::widgets
