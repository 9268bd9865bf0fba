// What the table of pairs shows, and how long that takes with a hundred thousand of them.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QElapsedTimer>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include "tests/widgets/support/sample_world.h"
#include "widgets/charts/error_bar_chart.h"
#include "widgets/panels/pairs_panel.h"

namespace remount {
namespace {

std::shared_ptr<PipelineOutput> output_of(int pairs) {
  PipelineInput input;
  input.sessions = {std::make_shared<const Session>(testing::sample_session("drive1"))};
  return std::make_shared<PipelineOutput>(testing::sample_output(input, pairs));
}

void never_align(Pair& pair) {
  pair.registration = {};
  pair.screw = {};
  pair.residual_translation_m = pair.residual_rotation_rad = 0.0;
  pair.state = PairState::Rejected;
  pair.reason = "2 static objects in common, 3 needed";
  pair.shared_objects = 2;
}

TEST(pair_table_model, a_pair_that_was_never_aligned_has_dashes_and_sorts_last_both_ways) {
  auto output = output_of(6);
  never_align(output->pairs[2]);
  PairTableModel model;
  model.show_output(output, {"drive1"});
  PairFilter filter;
  filter.setSourceModel(&model);
  for (const int column : {PairTableModel::ResidualTranslation, PairTableModel::ResidualRotation, PairTableModel::Rmse,
                           PairTableModel::Overlap, PairTableModel::Screw, PairTableModel::Weight}) {
    EXPECT_EQ(model.index(2, column).data().toString(), "–") << column;
    EXPECT_NE(model.index(1, column).data().toString(), "–") << column;
    for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
      filter.sort(column, order);
      const int last = column == PairTableModel::Weight ? filter.row_of(2) : 5;  // others have none either
      EXPECT_EQ(filter.row_of(2), last) << column;
    }
  }
  EXPECT_TRUE(model.index(2, PairTableModel::Screw).data(Qt::ToolTipRole).toString().contains("3 needed"));
}

TEST(pair_filter, keeps_the_contract_of_item_models_while_everything_changes) {
  PairTableModel model;
  PairFilter filter;
  filter.setSourceModel(&model);
  const QAbstractItemModelTester tester(&filter, QAbstractItemModelTester::FailureReportingMode::Fatal);
  auto output = output_of(40);
  model.show_output(output, {"drive1"});
  const QPersistentModelIndex kept = filter.index(7, 3);
  filter.sort(PairTableModel::Screw, Qt::DescendingOrder);
  EXPECT_EQ(filter.mapToSource(kept).row(), 7);
  PairCriteria criteria;
  criteria.state = PairState::Accepted;
  filter.set_criteria(criteria);
  EXPECT_EQ(filter.mapToSource(kept).row(), 7);
  auto other = std::make_shared<PipelineOutput>(*output);
  other->pairs[7].state = PairState::Rejected;
  model.show_output(other, {"drive1"});
  EXPECT_FALSE(kept.isValid()) << "it is no longer shown";
  model.show_output(nullptr, {});
  EXPECT_EQ(filter.rowCount(), 0);
}

TEST(pair_filter, finds_what_an_engineer_looks_for) {
  auto output = output_of(50);
  never_align(output->pairs[20]);
  output->pairs[30].residual_translation_m = 9.0;
  output->pairs[31].residual_rotation_rad = 0.5;
  output->pairs[32].decided_by = DecidedBy::User;
  PairTableModel model;
  model.show_output(output, {"drive1"});
  PairFilter filter;
  filter.setSourceModel(&model);
  const auto group = [&](PairGroup wanted, PairMeasure measure = PairMeasure::ResidualTranslation) {
    PairCriteria criteria;
    criteria.group = wanted;
    criteria.measure = measure;
    filter.set_criteria(criteria);
    return filter.pairs();
  };
  const auto has = [](const std::vector<int>& pairs, int pair) {
    return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
  };
  const std::vector<int> worst = group(PairGroup::Worst10);
  EXPECT_EQ(worst.size(), 10U);
  EXPECT_TRUE(has(worst, 30));
  EXPECT_TRUE(std::is_sorted(worst.begin(), worst.end())) << "in the order of the table, not of their error";
  EXPECT_TRUE(has(group(PairGroup::Worst10, PairMeasure::ResidualRotation), 31));
  for (const int pair : group(PairGroup::ScrewFailed))
    EXPECT_FALSE(output->pairs[static_cast<std::size_t>(pair)].screw.passed);
  EXPECT_EQ(group(PairGroup::ScrewFailed).size(), 7U) << "the one that was never aligned has not failed";
  EXPECT_EQ(group(PairGroup::NotAligned), std::vector<int>{20});
  EXPECT_TRUE(has(group(PairGroup::FewShared), 20));
  EXPECT_FALSE(has(group(PairGroup::Undecided), 32));
  EXPECT_EQ(group(PairGroup::Undecided).size(), 49U);
}

TEST(pair_filter, the_next_pair_is_found_from_the_place_of_one_that_was_filtered_away) {
  auto output = output_of(50);
  PairTableModel model;
  PairsPanel panel(model);
  model.show_output(output, {"drive1"});
  PairCriteria criteria;
  criteria.state = PairState::Accepted;
  panel.filter()->set_criteria(criteria);
  panel.show_selected(12);
  const int next = panel.neighbour(1, false), previous = panel.neighbour(-1, false);
  auto decided = std::make_shared<PipelineOutput>(*output);
  decided->pairs[12].state = PairState::Rejected;
  decided->pairs[12].decided_by = DecidedBy::User;
  model.show_output(decided, {"drive1"});
  ASSERT_EQ(panel.filter()->row_of(12), -1);
  EXPECT_EQ(panel.neighbour(1, false), next);
  EXPECT_EQ(panel.neighbour(-1, false), previous);
}

/// The longest of `turns` turns of something, in ms.
template <class Turn>
qint64 longest_ms(int turns, const Turn& turn) {
  qint64 longest = 0;
  for (int i = 0; i < turns; ++i) {
    QElapsedTimer timer;
    timer.start();
    turn(i);
    QCoreApplication::processEvents();
    longest = std::max(longest, timer.elapsed());
  }
  return longest;
}

TEST(pair_filter, a_hundred_thousand_pairs_scroll_sort_and_filter_without_stalls) {
  auto output = output_of(100000);
  PairTableModel model;
  PairsPanel panel(model);
  ErrorBarChart chart;
  QObject::connect(&panel, &PairsPanel::shown_changed, &chart, [&] { chart.show_pairs(panel.filter()->pairs()); });
  panel.resize(1000, 400);
  chart.resize(600, 200);
  panel.show();
  chart.show();
  chart.show_output(output);
  const qint64 shown = longest_ms(1, [&](int) {
    model.show_output(output, {"drive1"});
    panel.show_output(output);
  });
  ASSERT_EQ(panel.filter()->rowCount(), 100000);
  QScrollBar& bar = *panel.table()->verticalScrollBar();
  const qint64 scroll = longest_ms(50, [&](int i) { bar.setValue(bar.maximum() * i / 49); });
  const qint64 sort = longest_ms(4, [&](int i) {
    panel.table()->sortByColumn(i < 2 ? PairTableModel::ResidualTranslation : PairTableModel::Reason,
                                i % 2 ? Qt::AscendingOrder : Qt::DescendingOrder);
  });
  PairCriteria criteria;
  const QString typed = QStringLiteral("screw");
  const qint64 text = longest_ms(6, [&](int i) {
    criteria.text = typed.first(i < 5 ? i + 1 : 0);
    panel.filter()->set_criteria(criteria);
  });
  const qint64 group = longest_ms(6, [&](int i) {
    criteria.group = static_cast<PairGroup>((i + 1) % 6);
    panel.filter()->set_criteria(criteria);
  });
  const qint64 select = longest_ms(20, [&](int i) { panel.show_selected(4999 * i); });
  std::printf("100,000 pairs, longest in ms: show %lld, scroll %lld, sort %lld, text %lld, kind %lld, select %lld\n",
              static_cast<long long>(shown), static_cast<long long>(scroll), static_cast<long long>(sort),
              static_cast<long long>(text), static_cast<long long>(group), static_cast<long long>(select));
  // Far above what was measured, for machines that are busy; Qt's proxy took seconds.
  for (const qint64 taken : {shown, scroll, sort, text, group, select}) EXPECT_LT(taken, 500);
}

}  // namespace
}  // namespace remount
