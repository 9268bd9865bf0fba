// The chart of pairs: the line that rejects, the pairs of the table, and what keys and wheel do there.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QSignalSpy>
#include <QTableView>
#include <QWheelEvent>

#include "tests/widgets/support/window_fixture.h"
#include "widgets/pairs/error_bar_chart.h"
#include "widgets/pairs/pairs_panel.h"

namespace remount::widgets {

using motion::PairIndex;

namespace {

using review_chart = testing::WindowFixture;

TEST_F(review_chart, dragging_the_line_counts_live_and_rejects_on_release_as_one_edit) {
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

TEST_F(review_chart, the_line_moves_with_keys_and_escape_lets_go) {
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

TEST_F(review_chart, a_drag_that_ends_where_it_began_or_above_the_chart_rejects_nothing) {
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

TEST_F(review_chart, the_line_stays_where_it_was_dropped_and_gives_back_what_it_rejected_when_it_is_pulled_back) {
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

TEST_F(review_chart, the_chart_shows_the_pairs_of_the_table_in_its_order) {
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

}  // namespace
}  // namespace remount::widgets
