// What a calibration, another method or a closed session takes away, and how it comes back.
#include <gtest/gtest.h>

#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "algorithms/messages/render.h"
#include "app/gui/features/method_controller.h"
#include "app/gui/workbench/edit_commands.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/shell/log_panel.h"
#include "widgets/shell/progress_strip.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// Methods but the one of pairs leave none; a session may know a nominal.
gui::Engine engine_of_methods(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = testing::sample_engine(10, std::move(hold_at));
  engine.open = [open = engine.open](const std::filesystem::path& path, const drive::TopicChoice& topics,
                                     Progress& progress) {
    drive::Session session = open(path, topics, progress);
    if (session.name.ends_with("with_nominal")) session.nominal_ins_from_lidar = RigidTransform::Identity();
    return session;
  };
  engine.run = [of_pairs = engine.run](const pipeline::PipelineInput& input, Progress& progress) {
    pipeline::PipelineOutput output = of_pairs(input, progress);
    if (input.settings.run.method == method_registry::MethodChoice("pairwise")) return output;
    output.method = "trajectory";
    output.pairs.clear();
    output.keyframes.clear();
    return output;
  };
  return engine;
}

class history : public testing::WindowFixture {
 protected:
  history() : WindowFixture(&engine_of_methods) {}
  void calibrate_by(method_registry::MethodChoice method) {
    workbench_.setup().edit_option("run", "method", static_cast<int>(method));
    workbench_.calibrations().calibrate();
    ASSERT_TRUE(settle());
    ASSERT_TRUE(workbench_.outcome().output());
  }
  void reject(int pair) {
    workbench_.decisions().decide({index_at<motion::PairIndex>(pair)}, motion::PairState::Rejected,
                                  Message::verbatim("lorry"));
    ASSERT_TRUE(settle());
  }
  QString log() { return child<LogPanel>().toPlainText(); }
  QString status_line() { return child<ProgressStrip>().findChild<QLabel*>()->text(); }
  QUndoStack& edits() { return workbench_.history().stack(); }
};

TEST_F(history, another_method_is_taken_back_with_the_pairs_and_decisions_before) {
  show();
  calibrate_drive();
  reject(5);
  const gui::OutputPtr before = workbench_.outcome().output();
  calibrate_by(method_registry::MethodChoice("trajectory"));
  ASSERT_TRUE(workbench_.outcome().output()->pairs.empty());
  EXPECT_TRUE(log().contains("no pairs") && log().contains("Ctrl+Z")) << log().toStdString();
  EXPECT_EQ(edits().undoText(), "calibration (Trajectory alignment)") << edits().undoText().toStdString();
  const gui::OutputPtr of_trajectory = workbench_.outcome().output();
  edits().undo();
  EXPECT_EQ(workbench_.outcome().output(), before);
  EXPECT_EQ(english(pair(5).reason), "lorry");
  edits().undo();  // the method
  edits().undo();  // the decision
  ASSERT_TRUE(settle());
  EXPECT_NE(pair(5).decided_by, motion::DecidedBy::User) << "edits from before the calibration can be taken back too";
  for (int edit = 0; edit < 3; ++edit) edits().redo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.outcome().output(), of_trajectory);
  edits().undo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(english(pair(5).reason), "lorry");
}

TEST_F(history, decisions_outlive_a_result_without_pairs_also_in_the_project) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("job.remount");
  show();
  calibrate_drive();
  reject(5);
  calibrate_by(method_registry::MethodChoice("trajectory"));
  workbench_.document().save(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.document().path() == path; }, kPatience_ms));
  workbench_.document().open(path);
  ASSERT_TRUE(settle());
  ASSERT_EQ(workbench_.outcome().output()->method, "trajectory");
  EXPECT_EQ(workbench_.decisions().count(), 1);
  calibrate_by(method_registry::MethodChoice("pairwise"));
  EXPECT_EQ(pair(5).decided_by, motion::DecidedBy::User);
  EXPECT_EQ(english(pair(5).reason), "lorry");
}

TEST_F(history, a_first_calibration_takes_the_place_of_nothing) {
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  edits().clear();  // as in a project that was opened
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_FALSE(edits().canUndo());
}

TEST_F(history, opened_sessions_are_closed_again_by_undo_and_bring_their_nominal_back_by_redo) {
  show();
  calibrate_drive();
  const gui::OutputPtr before = workbench_.outcome().output();
  const auto sessions = workbench_.sessions().all();
  window_.open_paths({"/data/drive2_with_nominal"});
  ASSERT_TRUE(settle());
  ASSERT_EQ(workbench_.sessions().all().size(), 2U);
  EXPECT_TRUE(workbench_.setup().nominal_ins_from_lidar());
  EXPECT_TRUE(workbench_.calibrations().out_of_date());
  EXPECT_EQ(edits().undoText(), "open drive2_with_nominal") << edits().undoText().toStdString();
  edits().undo();
  EXPECT_EQ(workbench_.sessions().all(), sessions);
  EXPECT_FALSE(workbench_.setup().nominal_ins_from_lidar());
  EXPECT_EQ(workbench_.outcome().output(), before) << "it was not made with that session";
  EXPECT_FALSE(workbench_.calibrations().out_of_date());
  edits().redo();
  EXPECT_EQ(workbench_.sessions().all().size(), 2U);
  EXPECT_TRUE(workbench_.setup().nominal_ins_from_lidar());
  EXPECT_EQ(workbench_.outcome().output(), before);
}

TEST_F(history, several_that_are_opened_at_once_are_one_step_and_none_is_there_twice) {
  show();
  window_.open_paths({"/data/drive1", "/data/drive2", "/data/drive1"});
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.sessions().all().size(), 2U);
  EXPECT_EQ(edits().count(), 1);
  EXPECT_FALSE(workbench_.document().has_unsaved_work()) << "opening again is quickly done";
  edits().undo();
  EXPECT_TRUE(workbench_.sessions().all().empty());
}

TEST_F(history, a_calibration_goes_before_the_session_that_it_was_made_with) {
  show();
  calibrate_drive();
  const gui::OutputPtr output = workbench_.outcome().output();
  edits().undo();
  EXPECT_FALSE(workbench_.outcome().output());
  ASSERT_EQ(workbench_.sessions().all().size(), 1U);
  edits().undo();
  EXPECT_TRUE(workbench_.sessions().all().empty());
  edits().redo();
  edits().redo();
  EXPECT_EQ(workbench_.sessions().all().size(), 1U);
  EXPECT_EQ(workbench_.outcome().output(), output);
}

TEST_F(history, a_session_that_the_result_was_made_without_takes_nothing_with_it) {
  show();
  calibrate_drive();
  const gui::OutputPtr output = workbench_.outcome().output();
  workbench_.outcome().confirm(true);
  window_.open_paths({"/data/drive2"});
  ASSERT_TRUE(settle());
  workbench_.session_edits().remove(motion::SessionIndex{1});
  EXPECT_EQ(workbench_.outcome().output(), output);
  EXPECT_TRUE(workbench_.outcome().confirmed());
  EXPECT_TRUE(log().contains("was made without it and stays")) << log().toStdString();
  EXPECT_FALSE(workbench_.calibrations().out_of_date());
  edits().undo();
  EXPECT_EQ(workbench_.sessions().all().size(), 2U);
  EXPECT_EQ(workbench_.outcome().output(), output);
}

TEST_F(history, a_session_of_which_no_pair_was_accepted_leaves_the_result) {
  show();
  calibrate_drive();
  window_.open_paths({"/data/drive2"});
  ASSERT_TRUE(settle());
  workbench_.calibrations().calibrate();  // all pairs are of the first
  ASSERT_TRUE(settle());
  reject(7);
  const gui::OutputPtr before = workbench_.outcome().output();
  const double x_before_m = x_m();
  workbench_.session_edits().remove(motion::SessionIndex{1});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_EQ(x_m(), x_before_m);
  EXPECT_EQ(english(pair(7).reason), "lorry");
  EXPECT_FALSE(workbench_.calibrations().out_of_date())
      << workbench_.calibrations().changes_since_output().join("; ").toStdString();
  EXPECT_TRUE(log().contains("No pair of it was accepted")) << log().toStdString();
  EXPECT_EQ(workbench_.outcome().input().sessions, workbench_.sessions().all());
  edits().undo();
  EXPECT_EQ(workbench_.sessions().all().size(), 2U);
  EXPECT_EQ(workbench_.outcome().output(), before);
  edits().redo();
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_EQ(x_m(), x_before_m);
}

TEST_F(history, a_closed_session_says_that_its_result_went_and_comes_back_with_it) {
  show();
  calibrate_drive();
  window_.open_paths({"/data/drive2"});
  ASSERT_TRUE(settle());
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  reject(7);
  const gui::OutputPtr before = workbench_.outcome().output();
  const auto sessions = workbench_.sessions().all();
  workbench_.session_edits().remove(motion::SessionIndex{0});
  EXPECT_FALSE(workbench_.outcome().output());
  EXPECT_EQ(workbench_.sessions().all().size(), 1U);
  EXPECT_TRUE(log().contains("belonged to the sessions before")) << log().toStdString();
  EXPECT_TRUE(status_line().contains("belonged to the sessions before")) << status_line().toStdString();
  edits().undo();
  EXPECT_EQ(workbench_.sessions().all(), sessions);
  EXPECT_EQ(workbench_.outcome().output(), before);
  EXPECT_EQ(english(pair(7).reason), "lorry");
  EXPECT_FALSE(workbench_.calibrations().out_of_date());
  edits().redo();
  EXPECT_FALSE(workbench_.outcome().output());
  EXPECT_EQ(workbench_.sessions().all().size(), 1U);
}

TEST_F(history, a_calibration_after_undo_leaves_no_older_one_to_redo) {
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  workbench_.setup().edit_nominal(rigid_from_six({1, 0, 1, 0, 0, 0}));
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  while (edits().index() > 1) edits().undo();  // all but opening the session
  ASSERT_FALSE(workbench_.outcome().output());
  ASSERT_TRUE(edits().canRedo());
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_FALSE(edits().canRedo()) << edits().redoText().toStdString();
}

TEST_F(history, a_session_that_was_opened_anew_is_not_there_twice_where_its_removal_is_undone) {
  show();
  calibrate_drive();
  const gui::OutputPtr before = workbench_.outcome().output();
  const auto sessions = workbench_.sessions().all();
  workbench_.session_edits().remove(motion::SessionIndex{0});
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  const auto opened_anew = workbench_.sessions().all();
  ASSERT_EQ(opened_anew.size(), 1U);
  edits().undo();
  EXPECT_TRUE(workbench_.sessions().all().empty());
  edits().undo();
  EXPECT_EQ(workbench_.sessions().all(), sessions);
  EXPECT_EQ(workbench_.outcome().output(), before);
  edits().redo();
  edits().redo();
  EXPECT_EQ(workbench_.sessions().all(), opened_anew);
  EXPECT_FALSE(workbench_.outcome().output());
}

/// Sessions whose names begin alike are copies of one recording.
gui::Engine engine_that_compares(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = testing::sample_engine(10, std::move(hold_at));
  engine.same_recording = [](const drive::Session& a, const drive::Session& b) {
    return a.name.substr(0, 6) == b.name.substr(0, 6);
  };
  return engine;
}

class copies : public testing::WindowFixture {
 protected:
  copies() : WindowFixture(&engine_that_compares) {}
  QString log() { return child<LogPanel>().toPlainText(); }
};

TEST_F(copies, of_a_session_are_refused_when_they_are_opened) {
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  const auto sessions = workbench_.sessions().all();
  window_.open_paths({"/data/drive1_copy", "/data/drive2", "/data/drive2_copy"});
  ASSERT_TRUE(settle());
  ASSERT_EQ(workbench_.sessions().all().size(), 2U);
  EXPECT_EQ(workbench_.sessions().all()[1]->name, "drive2");
  EXPECT_TRUE(log().contains("is the same recording as /data/drive1, which is open")) << log().toStdString();
  EXPECT_TRUE(log().contains("is the same recording as /data/drive2, which is open")) << log().toStdString();
  workbench_.history().stack().undo();
  EXPECT_EQ(workbench_.sessions().all(), sessions);
}

class history_of_topics : public history {
 protected:
  void SetUp() override {
    calibrate_drive();
    workbench_.setup().apply_nominal(rigid_from_six({1, 0, 0, 0, 0, 0}));
  }
  void choose_other_topics() {
    drive::Session other = *workbench_.sessions().all()[0];
    other.topic_choice = {{"lidar", "/rear/points"}};
    edits().push(new gui::TopicsCommand(workbench_.session_edits(), workbench_.setup(), workbench_.calibrations(),
                                        workbench_.sessions().all()[0], std::make_shared<const drive::Session>(other)));
  }
  double nominal_x_m() const { return workbench_.setup().nominal_ins_from_lidar()->translation().x(); }
};

TEST_F(history_of_topics, has_the_nominal_of_then) {
  choose_other_topics();
  // As a session does that is opened later and knows one; no edit of its own.
  workbench_.setup().apply_nominal(rigid_from_six({2.5, 0, 0, 0, 0, 0}));
  edits().undo();
  EXPECT_NEAR(nominal_x_m(), 1.0, 1e-12);
  edits().redo();
  EXPECT_NEAR(nominal_x_m(), 2.5, 1e-12) << "the one that came later";
  edits().undo();
  EXPECT_NEAR(nominal_x_m(), 1.0, 1e-12);
}

TEST_F(history_of_topics, has_the_results_of_other_methods_that_were_compared) {
  calibrate_by(method_registry::MethodChoice("trajectory"));
  const auto compared = [&] { return window_.findChild<gui::MethodController*>()->compared().of_methods.size(); };
  ASSERT_EQ(compared(), 2U);
  choose_other_topics();
  EXPECT_EQ(compared(), 0U) << "they are of other data";
  edits().undo();
  EXPECT_EQ(compared(), 2U);
  edits().redo();
  EXPECT_EQ(compared(), 0U);
}

TEST_F(history, a_run_whose_sessions_have_changed_is_not_left_out_in_silence) {
  show();
  calibrate_drive();
  const gui::OutputPtr before = workbench_.outcome().output();
  window_.open_paths({"/data/drive2"});
  ASSERT_TRUE(settle());
  workbench_.session_edits().remove(motion::SessionIndex{1});
  *hold_at_ = 5;
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench_.activity().stage().empty(); }, kPatience_ms));
  edits().undo();
  *hold_at_ = -1;
  ASSERT_TRUE(settle());
  EXPECT_TRUE(log().contains("was of other sessions or topics")) << log().toStdString();
  EXPECT_EQ(workbench_.outcome().output(), before);
}

}  // namespace
}  // namespace remount::widgets
