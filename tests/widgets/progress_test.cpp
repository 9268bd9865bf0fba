// What is said while work is under way, and that all panels count the same.
#include <gtest/gtest.h>

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>
#include <algorithm>
#include <chrono>
#include <thread>

#include "app/gui/workbench/steps.h"
#include "messages/stages.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/gl_support.h"
#include "widgets/pairs/pair_table_model.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/result/export_dialog.h"
#include "widgets/result/result_panel.h"
#include "widgets/shell/progress_strip.h"
#include "widgets/text/pair_counts.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

constexpr int kHoldSolution = 1000;  // of hold_at: no stage of a run

/// Solutions wait as long as hold_at says so.
gui::Engine engine_that_holds_solutions(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = testing::sample_engine(10, hold_at);
  engine.solve_again = [hold_at, solve = engine.solve_again](const pipeline::PipelineInput& input,
                                                             pipeline::PipelineOutput& output, Progress& progress) {
    while (*hold_at == kHoldSolution && !progress.cancelled())
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return !progress.cancelled() && solve(input, output, progress);
  };
  return engine;
}

class progress : public testing::WindowFixture {
 protected:
  progress() : WindowFixture(&engine_that_holds_solutions) {}
  ~progress() override { *hold_at_ = -1; }
  QString words() {
    for (const QLabel* label : child<ResultPanel>().findChildren<QLabel*>())
      if (label->text().contains("pairs: ")) return label->text();
    return {};
  }
  /// Of the step bar: "12 accepted, 3 rejected".
  QString counted() { return gui::describe_steps(workbench_)[static_cast<std::size_t>(Step::Review)].detail; }
};

QString said(const ProgressStrip& strip) {
  QStringList texts;
  for (const QLabel* label : strip.findChildren<QLabel*>())
    if (label->isVisible()) texts << label->text();
  return texts.join(QStringLiteral(" | "));
}

TEST(progress_strip, a_stage_without_a_count_moves_and_says_how_long_it_has_taken) {
  ProgressStrip strip;
  strip.resize(800, 30);
  strip.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&strip, kPatience_ms));
  strip.start("Calibrating…");
  strip.show_progress(say::stage_registering_pairs(), 10, 10);
  EXPECT_EQ(strip.findChild<QProgressBar*>()->maximum(), 1000);
  strip.show_progress(say::stage_solving(), 0, 0);
  auto& bar = *strip.findChild<QProgressBar*>();
  EXPECT_TRUE(bar.isVisible() && bar.minimum() == bar.maximum()) << "nobody knows how far it is";
  const QImage first = bar.grab().toImage();
  EXPECT_TRUE(QTest::qWaitFor([&] { return bar.grab().toImage() != first; }, 2000)) << "it moves";
  EXPECT_TRUE(QTest::qWaitFor([&] { return said(strip) == "solving | 1 s"; }, 3000)) << said(strip).toStdString();
  strip.stop("Ready");
  EXPECT_EQ(said(strip), "Ready");
  EXPECT_FALSE(bar.isVisible());
}

TEST(progress_strip, says_times_as_people_do) {
  EXPECT_EQ(elapsed_text(59999), "59 s");
  EXPECT_EQ(elapsed_text(125000), "2 min 5 s");
}

TEST_F(progress, a_solution_after_an_edit_shows_that_it_goes_on) {
  show();
  calibrate_drive();
  auto& strip = child<ProgressStrip>();
  const auto& bar = *strip.findChild<QProgressBar*>();
  *hold_at_ = kHoldSolution;
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  EXPECT_FALSE(bar.isVisible()) << "what is done at once flashes nothing";
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar.isVisible(); }, kPatience_ms)) << said(strip).toStdString();
  EXPECT_TRUE(said(strip).startsWith("Solving again… | ") && said(strip).endsWith(" s")) << said(strip).toStdString();
  for (const QToolButton* cancel : strip.findChildren<QToolButton*>())
    EXPECT_FALSE(cancel->isVisible()) << "nobody waits for it";
  photograph(window_, "44-solving-again");
  *hold_at_ = -1;
  ASSERT_TRUE(settle());
  EXPECT_TRUE(QTest::qWaitFor([&] { return said(strip) == "Ready"; }, kPatience_ms)) << said(strip).toStdString();
  EXPECT_FALSE(bar.isVisible());
}

TEST_F(progress, nothing_is_exported_or_confirmed_before_a_solution_is_whole) {
  show();
  calibrate_drive();
  trigger("Ctrl+E");
  auto& dialog = child<ExportDialog>();
  const auto may_save = [&] {
    for (const auto* button : dialog.findChildren<QPushButton*>())
      if (button->text() == "Save…") return button->isEnabled();
    return false;
  };
  EXPECT_TRUE(may_save());
  *hold_at_ = kHoldSolution;
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  EXPECT_FALSE(may_save());
  EXPECT_EQ(gui::describe_steps(workbench_)[static_cast<std::size_t>(Step::Export)].state, StepState::Waiting);
  *hold_at_ = -1;
  ASSERT_TRUE(settle());
  EXPECT_TRUE(may_save());
  dialog.reject();
}

TEST_F(progress, all_panels_count_the_same_pairs_before_a_cancelled_calibration_is_solved) {
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  *hold_at_ = 3;  // 15 of 50 pairs are aligned
  QSignalSpy reports(&workbench_.activity(), &gui::Activity::progressed);
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return std::any_of(reports.begin(), reports.end(),
                           [](const QList<QVariant>& report) { return report[1].toInt() == 3; });
      },
      kPatience_ms));
  workbench_.cancel();
  *hold_at_ = kHoldSolution;
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.outcome().output() != nullptr; }, kPatience_ms));
  window_.show_everything();
  ASSERT_TRUE(workbench_.activity().solving());
  const PairCounts counts = count_pairs(*workbench_.outcome().output());
  EXPECT_EQ(counts.all, 50);
  EXPECT_EQ(counts.rejected, 35);
  EXPECT_EQ(counted(), "0 accepted, 35 rejected");
  EXPECT_TRUE(words().contains("50 pairs: 0 accepted, 35 rejected")) << words().toStdString();
  int in_table = 0;
  const auto& table = *child<PairsPanel>().table()->model();
  for (int row = 0; row < table.rowCount(); ++row)
    in_table += table.index(row, PairTableModel::State).data().toString().contains("rejected");
  EXPECT_EQ(in_table, 35);
  *hold_at_ = -1;
  ASSERT_TRUE(settle());
  EXPECT_TRUE(words().contains(counted())) << words().toStdString();
}

TEST_F(progress, all_panels_count_a_decision_before_it_is_solved) {
  show();
  calibrate_drive();
  *hold_at_ = kHoldSolution;
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  window_.show_everything();
  EXPECT_TRUE(words().contains(counted())) << words().toStdString();
  *hold_at_ = -1;
  ASSERT_TRUE(settle());
}

}  // namespace
}  // namespace remount::widgets
