// Search range and candidates: drawn, linked, and ranked again at once.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTableView>

#include "model/pipeline/first_answer.h"
#include "model/report/report.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/result/candidate_table_model.h"
#include "widgets/result/candidates_panel.h"
#include "widgets/result/correlation_chart.h"
#include "widgets/result/range_bar.h"
#include "widgets/result/range_panel.h"
#include "widgets/result/result_panel.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;
using range_and_candidates = testing::WindowFixture;

TEST_F(range_and_candidates, what_is_pointed_at_in_one_plot_is_selected_in_the_other_and_in_the_table) {
  show();
  calibrate_drive();
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>("candidates")) dock->raise();
  auto& panel = child<CandidatesPanel>();
  QTest::qWait(50);
  QSignalSpy selected(&panel, &CandidatesPanel::candidate_selected);
  const auto wanted = panel.position()->candidate_at(panel.position()->place_of(calibration::CandidateIndex{5}, 1));
  ASSERT_TRUE(wanted);
  // Sent to the plot itself: where the display's own pointer rests is not for this test to say.
  const QPointF place = panel.position()->place_of(calibration::CandidateIndex{5}, 1);
  QMouseEvent move(QEvent::MouseMove, place, panel.position()->mapToGlobal(place), Qt::NoButton, Qt::NoButton, {});
  QApplication::sendEvent(panel.position(), &move);
  EXPECT_EQ(panel.selected(), wanted);
  EXPECT_EQ(panel.attitude()->selected(), wanted);
  ASSERT_EQ(selected.count(), 1);
  const auto row_candidate = [&] {
    return panel.table()->currentIndex().siblingAtColumn(CandidateTableModel::Rank).data().toString();
  };
  EXPECT_EQ(row_candidate(), QString::number(*wanted + 1));
  QTest::keyClick(panel.attitude(), Qt::Key_Right);
  EXPECT_EQ(panel.position()->selected(), calibration::CandidateIndex(*wanted + 1));
  panel.table()->selectRow(0);
  EXPECT_EQ(panel.position()->selected(), calibration::CandidateIndex{0});
  photograph(window_, "40-candidates");
}

TEST_F(range_and_candidates, candidates_are_drawn_where_they_are) {
  show();
  calibrate_drive();
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>("candidates")) dock->raise();
  auto& plot = *child<CandidatesPanel>().position();
  QTest::qWait(50);
  // In the sample world x grows by 1 cm from candidate to candidate, y and z stay.
  for (const int view : {0, 1}) {
    EXPECT_LT(plot.place_of(calibration::CandidateIndex{2}, view).x(),
              plot.place_of(calibration::CandidateIndex{5}, view).x());
    EXPECT_NEAR(plot.place_of(calibration::CandidateIndex{2}, view).y(),
                plot.place_of(calibration::CandidateIndex{5}, view).y(), 1e-6);
  }
  EXPECT_EQ(plot.candidate_at({2.0, 2.0}), std::nullopt);
}

TEST_F(range_and_candidates, dragging_an_end_of_the_range_is_one_edit_and_ranks_again) {
  show();
  calibrate_drive();
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>("setup")) dock->raise();
  QTest::qWait(50);
  auto& panel = child<RangePanel>();
  RangeBar* bar = nullptr;
  for (RangeBar* one : panel.findChildren<RangeBar*>())
    if (one->accessibleName().endsWith(" x")) bar = one;
  ASSERT_TRUE(bar);
  const int y = bar->height() / 2;
  QTest::mousePress(bar, Qt::LeftButton, {}, {static_cast<int>(bar->x_of(5.0)), y});
  for (const double x_m : {4.0, 3.0, 2.0}) QTest::mouseMove(bar, {static_cast<int>(bar->x_of(x_m)), y});
  QTest::mouseRelease(bar, Qt::LeftButton, {}, {static_cast<int>(bar->x_of(2.0)), y});
  EXPECT_NEAR(workbench_.setup().settings().range.x_max_m, 2.0, 0.1);
  EXPECT_NEAR(panel.findChild<QDoubleSpinBox*>("range.x_max_m")->value(), workbench_.setup().settings().range.x_max_m,
              1e-9);
  EXPECT_EQ(edits_since_calibration(), 1);
  EXPECT_TRUE(workbench_.activity().solving());
  ASSERT_TRUE(settle());
  photograph(window_, "41-range");
}

TEST_F(range_and_candidates, another_range_ranks_the_candidates_before_it_is_solved) {
  calibrate_drive();
  pipeline::PipelineInput input = workbench_.outcome().input();
  pipeline::PipelineOutput output = *workbench_.outcome().output();
  input.settings.range.x_max_m = testing::kTruth.x_m + 0.035;
  pipeline::rank_again(input, output);
  int in_range = 0;
  for (std::size_t i = 0; i < output.result.candidates.size(); ++i) {
    const calibration::Candidate& candidate = output.result.candidates[i];
    EXPECT_EQ(candidate.in_range, candidate.ins_from_lidar.translation().x() <= testing::kTruth.x_m + 0.035);
    EXPECT_TRUE(candidate.in_range || i >= static_cast<std::size_t>(in_range)) << "those out of range are last";
    in_range += candidate.in_range;
  }
  EXPECT_GE(in_range, 3);
  EXPECT_LT(in_range, 6);
}

TEST_F(range_and_candidates, the_result_shows_nominal_and_new_and_correlations) {
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  workbench_.setup().edit_nominal(rigid_from_six({0.7, -0.1, 0.75, 0.06, -0.02, 0.015}));
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  QString texts;
  for (const QLabel* label : child<ResultPanel>().findChildren<QLabel*>()) texts += label->text() + '\n';
  EXPECT_TRUE(texts.contains("Nominal and new") && texts.contains("0.700 m")) << texts.toStdString();
  auto& chart = child<CorrelationChart>();
  EXPECT_TRUE(chart.isVisibleTo(&child<ResultPanel>()));
  window_.resize(1280, 1020);
  photograph(window_, "42-result");
  photograph(*child<ResultPanel>().widget(), "43-result-whole");
}

TEST(correlation, is_that_of_the_covariance_and_unknown_where_not_observed) {
  calibration::CalibrationResult result;
  result.set_observed(~calibration::ParameterSet{calibration::Parameter::Z},
                      Message::verbatim("not shown by this drive"));
  result.covariance.setIdentity();
  result.covariance.diagonal() << 4.0, 9.0, 1.0, 1.0, 1.0, 1.0;
  result.covariance(0, 1) = result.covariance(1, 0) = -3.0;
  EXPECT_DOUBLE_EQ(report::correlation(result, calibration::Parameter::X, calibration::Parameter::Y), -0.5);
  EXPECT_DOUBLE_EQ(report::correlation(result, calibration::Parameter::Yaw, calibration::Parameter::Yaw), 1.0);
  EXPECT_TRUE(std::isnan(report::correlation(result, calibration::Parameter::X, calibration::Parameter::Z)));
  CorrelationChart chart;
  chart.show_result(result);
  EXPECT_TRUE(chart.accessibleDescription().contains("x with y"));
}

}  // namespace
}  // namespace remount::widgets
