// The comparison of the accumulated map, which is made beside the result: nobody waits for it with the result in hand.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <atomic>
#include <thread>

#include "algorithms/core/error.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/features/quality_controller.h"
#include "app/gui/workbench/steps.h"
#include "app/gui/workbench/wording.h"
#include "model/pipeline/sharpness_stage.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/quality/quality_view.h"
#include "widgets/quality/sharpness_view.h"
#include "widgets/result/verdict_table.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

QString verdict_on(const QWidget& view) { return view.findChild<VerdictLabel*>()->text(); }

/// A calibrated drive whose map is compared when `go` says so, by `compare`.
struct Checked {
  using Compare = std::function<void(pipeline::PipelineOutput&)>;

  explicit Checked(Compare how) : compare(std::move(how)) {
    workbench.sessions().open({"/data/drive1"});
    (void)QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms);
    workbench.calibrations().calibrate();
    (void)QTest::qWaitFor([&] { return !workbench.activity().calibrating(); }, kPatience_ms);
  }
  gui::Engine engine() {
    gui::Engine engine = testing::sample_engine(2);
    engine.run = [this, run = engine.run](const pipeline::PipelineInput& input, Progress& progress) {
      pipeline::PipelineOutput output = run(input, progress);
      run_was_to_compare = input.settings.run.map_check;
      output.map_check = pipeline::MapCheck::SwitchedOff;
      return output;
    };
    engine.check_map = [this](const pipeline::PipelineInput&, pipeline::PipelineOutput& output, Progress& progress) {
      while (!go && !progress.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      if (!progress.cancelled()) compare(output);
    };
    return engine;
  }
  bool says(const QString& words) {
    return QTest::qWaitFor([&] { return verdict_on(*view.sharpness()).contains(words); }, kPatience_ms);
  }

  const testing::LanguageFor english{"en"};
  std::atomic<bool> go = false, run_was_to_compare = false;
  Compare compare;
  gui::Workbench workbench{engine()};
  QualityView view;
  const gui::QualityController controller{workbench, view};
};

void find_no_overlap(pipeline::PipelineOutput& output) { output.map_check = pipeline::MapCheck::NoOverlap; }

TEST(map_check, is_made_while_the_result_is_there_already) {
  Checked checked(find_no_overlap);
  gui::Workbench& workbench = checked.workbench;
  ASSERT_TRUE(workbench.outcome().output());
  EXPECT_FALSE(checked.run_was_to_compare);
  EXPECT_TRUE(workbench.map_checks().checking());
  EXPECT_TRUE(workbench.outcome().input().settings.run.map_check) << "it was not switched off";
  EXPECT_FALSE(workbench.calibrations().out_of_date());
  EXPECT_EQ(gui::describe_steps(workbench)[static_cast<std::size_t>(Step::Check)].state, StepState::Running);
  EXPECT_TRUE(gui::export_warning(workbench).contains("still being compared"));
  EXPECT_TRUE(checked.says("being compared")) << verdict_on(*checked.view.sharpness()).toStdString();
  checked.go = true;
  EXPECT_TRUE(checked.says("stretch of eight scans")) << verdict_on(*checked.view.sharpness()).toStdString();
  EXPECT_FALSE(workbench.map_checks().checking());
  EXPECT_FALSE(gui::export_warning(workbench).contains("still being compared"));
}

TEST(map_check, that_speaks_against_the_result_takes_its_confirmation_back_and_says_so) {
  Checked checked([](pipeline::PipelineOutput& output) {
    output.map_check = pipeline::MapCheck::Made;
    output.findings.push_back({drive::Severity::Warning, pipeline::kMapLessSharp, std::string("map check"),
                               Message::verbatim("the map contradicts the result")});
  });
  checked.workbench.outcome().confirm(true);
  const QSignalSpy said(&checked.workbench.notices(), &gui::Notices::message);
  checked.go = true;
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !checked.workbench.map_checks().checking() && !said.isEmpty(); }, kPatience_ms));
  EXPECT_FALSE(checked.workbench.outcome().confirmed());
  EXPECT_TRUE(said.back().at(2).toString().contains("contradicts the result"));
}

TEST(map_check, that_fails_says_why) {
  Checked checked([](pipeline::PipelineOutput&) {
    throw Error(ErrorCode::Io, "/data/drive1/scan0.pcd", Message::verbatim("cannot be read any more"));
  });
  checked.go = true;
  EXPECT_TRUE(checked.says("cannot be read any more")) << verdict_on(*checked.view.sharpness()).toStdString();
  EXPECT_FALSE(checked.workbench.map_checks().checking());
}

TEST(map_check, that_was_made_before_the_last_decision_says_what_to_do) {
  gui::Engine engine = testing::sample_engine(2);
  engine.solve_again = [solve = engine.solve_again](const pipeline::PipelineInput& input,
                                                    pipeline::PipelineOutput& output, Progress& progress) {
    output.map_check = pipeline::MapCheck::Moved;
    return solve(input, output, progress);
  };
  gui::Workbench workbench(engine);
  QualityView view;
  const gui::QualityController controller(workbench, view);
  workbench.sessions().open({"/data/drive1"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  workbench.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().calibrating(); }, kPatience_ms));
  workbench.decisions().decide({motion::PairIndex{1}}, motion::PairState::Rejected);
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return verdict_on(*view.sharpness()).contains("Calibrate again (F5)"); }, kPatience_ms));
}

class waiting_report : public ::testing::Test {
 protected:
  waiting_report() { maker_.make(path_); }
  bool written() const { return QFileInfo::exists(path_); }

  Checked checked_{find_no_overlap};
  const QTemporaryDir folder_;
  const QString path_ = folder_.filePath("report.html");
  gui::ReportMaker maker_{checked_.workbench};
  QSignalSpy finished_{&maker_, &gui::ReportMaker::finished}, failed_{&maker_, &gui::ReportMaker::failed};
};

TEST_F(waiting_report, is_written_with_what_the_map_says) {
  EXPECT_TRUE(maker_.busy()) << "nobody closes over it, and no other is begun";
  QTest::qWait(50);
  EXPECT_FALSE(written());
  checked_.go = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished_.count() == 1; }, kPatience_ms));
  EXPECT_TRUE(written());
  EXPECT_TRUE(failed_.isEmpty());
}

TEST_F(waiting_report, is_not_written_of_another_result_than_it_was_asked_for) {
  checked_.workbench.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed_.count() == 1; }, kPatience_ms));
  EXPECT_FALSE(maker_.busy());
  checked_.go = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return !checked_.workbench.map_checks().checking(); }, kPatience_ms));
  EXPECT_FALSE(written());
}

TEST_F(waiting_report, is_not_written_of_another_project) {
  checked_.workbench.document().begin();
  EXPECT_EQ(failed_.count(), 1);
  EXPECT_FALSE(maker_.busy());
  EXPECT_FALSE(written());
}

}  // namespace
}  // namespace remount::widgets
