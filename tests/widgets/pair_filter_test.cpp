// What the table of pairs shows, and how much work that is with a hundred thousand of them.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <random>

#include "algorithms/messages/render.h"
#include "app/gui/basics/language.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/sample_world.h"
#include "widgets/basics/text_ranks.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {
namespace {

std::shared_ptr<pipeline::PipelineOutput> output_of(int pairs) {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  return std::make_shared<pipeline::PipelineOutput>(testing::sample_output(input, pairs));
}

void never_align(motion::Pair& pair) {
  pair.registration = {};
  pair.screw = {};
  pair.residual_translation_m = pair.residual_rotation_rad = 0.0;
  pair.state = motion::PairState::Rejected;
  pair.reason = Message::verbatim("2 static objects in common, 3 needed");
  pair.shared_objects = 2;
}

std::vector<motion::PairIndex> places(const std::vector<std::size_t>& numbers) {
  std::vector<motion::PairIndex> pairs;
  for (const std::size_t number : numbers) pairs.emplace_back(number);
  return pairs;
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
      const int last =
          column == PairTableModel::Weight ? filter.row_of(motion::PairIndex{2}) : 5;  // others have none either
      EXPECT_EQ(filter.row_of(motion::PairIndex{2}), last) << column;
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
  criteria.state = motion::PairState::Accepted;
  filter.set_criteria(criteria);
  EXPECT_EQ(filter.mapToSource(kept).row(), 7);
  auto other = std::make_shared<pipeline::PipelineOutput>(*output);
  other->pairs[7].state = motion::PairState::Rejected;
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
  output->pairs[32].decided_by = motion::DecidedBy::User;
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
  const auto has = [](const std::vector<motion::PairIndex>& pairs, motion::PairIndex pair) {
    return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
  };
  const std::vector<motion::PairIndex> worst = group(PairGroup::Worst10);
  EXPECT_EQ(worst.size(), 10U);
  EXPECT_TRUE(has(worst, motion::PairIndex{30}));
  EXPECT_TRUE(std::is_sorted(worst.begin(), worst.end())) << "in the order of the table, not of their error";
  EXPECT_TRUE(has(group(PairGroup::Worst10, PairMeasure::ResidualRotation), motion::PairIndex{31}));
  for (const motion::PairIndex pair : group(PairGroup::ScrewFailed)) EXPECT_FALSE(output->pairs[pair].screw.passed);
  EXPECT_EQ(group(PairGroup::ScrewFailed).size(), 7U) << "the one that was never aligned has not failed";
  EXPECT_EQ(group(PairGroup::NotAligned), places({20}));
  EXPECT_TRUE(has(group(PairGroup::FewShared), motion::PairIndex{20}));
  EXPECT_FALSE(has(group(PairGroup::Undecided), motion::PairIndex{32}));
  EXPECT_EQ(group(PairGroup::Undecided).size(), 49U);
}

TEST(pair_table_model, pairs_of_poses_have_no_scans_to_say_anything_of) {
  auto output = output_of(3);
  motion::Pair& of_poses = output->pairs[1];
  of_poses.registration = {};
  of_poses.registration.attempted = of_poses.registration.converged = true;
  of_poses.registration.overlap = 1.0;
  of_poses.shared_objects = 0;
  PairTableModel model;
  model.show_output(output, {"drive1"});
  for (const int column : {PairTableModel::Rmse, PairTableModel::Overlap, PairTableModel::Shared}) {
    EXPECT_EQ(model.data(model.index(1, column), Qt::DisplayRole).toString(), "–") << column;
    EXPECT_NE(model.data(model.index(0, column), Qt::DisplayRole).toString(), "–") << column;
  }
}

TEST(pair_filter, keeps_the_place_of_pairs_that_change_until_it_is_told_to_sort_again) {
  auto output = output_of(4);
  const auto say = [&](const std::vector<double>& residuals_m, const std::vector<const char*>& reasons) {
    auto changed = std::make_shared<pipeline::PipelineOutput>(*output);
    for (std::size_t i = 0; i < 4; ++i) {
      changed->pairs[i].residual_translation_m = residuals_m[i];
      changed->pairs[i].reason = Message::verbatim(reasons[i]);
    }
    return output = changed;
  };
  PairTableModel model;
  PairFilter filter;
  filter.setSourceModel(&model);
  for (const int column : {PairTableModel::ResidualTranslation, PairTableModel::Reason}) {
    model.show_output(nullptr, {});
    model.show_output(say({0.1, 0.2, 0.3, 0.4}, {"a", "b", "c", "d"}), {"drive1"});
    filter.sort(column);
    EXPECT_EQ(filter.pairs(), places({0, 1, 2, 3})) << column;
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset), changed(&model, &QAbstractItemModel::dataChanged);
    model.show_output(say({0.4, 0.3, 0.1, 0.2}, {"d", "c", "a", "b"}), {"drive1"});
    EXPECT_EQ(reset.count(), 0);
    EXPECT_EQ(changed.count(), 1);
    EXPECT_EQ(filter.pairs(), places({0, 1, 2, 3})) << column << ": no row moves under the eye";
    EXPECT_FALSE(filter.in_order());
    filter.sort_again();
    EXPECT_TRUE(filter.in_order());
    EXPECT_EQ(filter.pairs(), places({2, 3, 1, 0})) << column << ": other values of the same pairs";
    auto fewer = std::make_shared<pipeline::PipelineOutput>(*say({0.2, 0.1, 0.3, 0.4}, {"b", "a", "c", "d"}));
    fewer->pairs.pop_back();
    model.show_output(fewer, {"drive1"});
    EXPECT_EQ(reset.count(), 1);
    EXPECT_EQ(filter.pairs(), places({1, 0, 2})) << column << ": other pairs";
  }
}

TEST(pair_filter, sorted_by_reasons_it_outlives_the_output) {
  PairTableModel model;
  PairFilter filter;
  filter.setSourceModel(&model);
  filter.sort(PairTableModel::Reason);
  model.show_output(output_of(4), {"drive1"});
  model.show_output(nullptr, {});
  EXPECT_TRUE(filter.pairs().empty());
}

TEST(pair_filter, the_pair_that_is_looked_at_stays_until_it_is_left) {
  auto output = output_of(50);
  PairTableModel model;
  PairsPanel panel(model);
  model.show_output(output, {"drive1"});
  PairCriteria criteria;
  criteria.state = motion::PairState::Accepted;
  panel.filter()->set_criteria(criteria);
  panel.show_selected(motion::PairIndex{12});
  const auto next = panel.neighbour(1, false), previous = panel.neighbour(-1, false);
  auto decided = std::make_shared<pipeline::PipelineOutput>(*output);
  decided->pairs[12].state = motion::PairState::Rejected;
  decided->pairs[12].decided_by = motion::DecidedBy::User;
  model.show_output(decided, {"drive1"});
  const auto shown = [&](std::size_t pair) { return panel.filter()->row_of(motion::PairIndex{pair}) >= 0; };
  EXPECT_TRUE(shown(12)) << "its state is another, and it is still looked at";
  EXPECT_EQ(panel.neighbour(1, false), next);
  EXPECT_EQ(panel.neighbour(-1, false), previous);
  panel.show_selected(next);
  EXPECT_FALSE(shown(12)) << "it was left";
  PairCriteria rejected;
  rejected.state = motion::PairState::Rejected;
  panel.filter()->set_criteria(rejected);
  EXPECT_TRUE(panel.filter()->row_of(next) >= 0) << "a filter that hides it keeps it until it is left";
  EXPECT_EQ(panel.filter()->matching() + 1, panel.filter()->pairs().size());
}

TEST(pair_filter, decisions_meet_only_what_is_shown) {
  PairTableModel model;
  PairsPanel panel(model);
  model.show_output(output_of(50), {"drive1"});
  QObject::connect(&panel, &PairsPanel::pair_selected, &panel, &PairsPanel::show_selected);
  panel.show();
  panel.table()->selectRow(7);
  EXPECT_EQ(panel.marked_pairs(), places({7}));
  QTest::keyClick(panel.table(), Qt::Key_Home, Qt::ControlModifier);
  EXPECT_EQ(panel.marked_pairs(), places({0})) << "no other row stays marked";
  QTest::keyClick(panel.table(), Qt::Key_Down, Qt::ShiftModifier);
  QTest::keyClick(panel.table(), Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_EQ(panel.marked_pairs(), places({0, 1, 2}));
  EXPECT_TRUE(panel.findChild<QPushButton*>()->text().contains('3')) << "the button says how many it meets";
  panel.show_selected(motion::PairIndex{30});
  EXPECT_EQ(panel.marked_pairs(), places({30})) << "of a chart";
}

TEST(pair_filter, the_field_is_left_by_enter_and_by_escape) {
  PairTableModel model;
  PairsPanel panel(model);
  model.show_output(output_of(50), {"drive1"});
  panel.show();
  panel.activateWindow();
  auto& field = *panel.findChild<QLineEdit*>();
  field.setFocus();
  QTest::keyClicks(&field, "31");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(panel.focusWidget(), panel.table());
  EXPECT_EQ(field.text(), "31");
  field.setFocus();
  QTest::keyClick(&field, Qt::Key_Escape);
  EXPECT_EQ(panel.focusWidget(), panel.table());
  EXPECT_EQ(field.text(), QString());
}

TEST(pair_filter, finds_what_was_noted) {
  PairTableModel model;
  PairFilter filter;
  filter.setSourceModel(&model);
  model.show_output(output_of(50), {"drive1"});
  auto marks = std::make_shared<std::vector<PairMark>>(50);
  for (std::size_t pair = 0; pair < 47; ++pair) (*marks)[pair].seen = true;
  (*marks)[4].flagged = true;
  (*marks)[9].comment = "a lorry in the way";
  model.show_marks(marks);
  PairCriteria criteria;
  criteria.group = PairGroup::NotSeen;
  filter.set_criteria(criteria);
  EXPECT_EQ(filter.pairs(), places({47, 48, 49}));
  criteria.group = PairGroup::Noted;
  filter.set_criteria(criteria);
  EXPECT_EQ(filter.pairs(), places({4, 9}));
  criteria = {};
  criteria.text = "LORRY";
  filter.set_criteria(criteria);
  EXPECT_EQ(filter.pairs(), places({9}));
}

TEST(pair_filter, text_is_found_in_number_state_session_and_reason) {
  auto output = output_of(50);
  output->pairs[30].reason = Message::verbatim("overlap too small: 0.31");
  output->pairs[31].reason = Message::verbatim("overlap too small: 0.28");
  output->pairs[32].reason = Message::verbatim("The Bus stood still");
  PairTableModel model;
  model.show_output(output, {"drive1"});
  PairFilter filter;
  filter.setSourceModel(&model);
  const auto found = [&](const QString& text) {
    PairCriteria criteria;
    criteria.text = text;
    filter.set_criteria(criteria);
    return filter.pairs();
  };
  EXPECT_EQ(found("OVERLAP"), places({30, 31}));
  EXPECT_EQ(found("overlap too small: 0.3"), places({30}));
  EXPECT_EQ(found("0.28"), places({31}));
  EXPECT_EQ(found("bus "), places({32}));
  EXPECT_EQ(found("40"), places({40}));
  EXPECT_EQ(found("proposed"), places({48, 49}));
  EXPECT_EQ(found("Drive1").size(), 50U);
  EXPECT_EQ(found("nothing of this").size(), 0U);
}

TEST(pair_filter, text_is_found_in_the_language_of_the_window_and_as_files_hold_it) {
  auto output = output_of(50);
  output->pairs[30].reason = quick_reasons()[0]();
  output->pairs[31].reason = Message::verbatim("Bus 12 fährt an");
  const testing::LanguageFor chinese("zh_CN");
  const QString shown = reason_words(output->pairs[30].reason);
  EXPECT_FALSE(shown.contains("moving")) << "it is in Chinese";
  PairTableModel model;
  model.show_output(output, {"drive1"});
  PairFilter filter;
  filter.setSourceModel(&model);
  const auto found = [&](const QString& text) {
    PairCriteria criteria;
    criteria.text = text;
    filter.set_criteria(criteria);
    return filter.pairs();
  };
  EXPECT_EQ(found(shown), places({30}));
  EXPECT_EQ(found(shown.mid(1, 2)), places({30}));
  EXPECT_EQ(found("MOVING obj"), places({30}));
  EXPECT_EQ(found("FÄHRT"), places({31}));
  EXPECT_TRUE(found(shown.left(1) + "moving").empty()) << "of two languages";
}

TEST(text_ranks, are_those_of_comparing_texts) {
  std::mt19937 random(4);
  std::vector<std::string> texts{"",     std::string(1, '\0'),    std::string(2, '\0'), "same",
                                 "same", std::string("same\0", 5)};
  for (int i = 0; i < 3000; ++i) {
    std::string text = i % 3 ? "screw test: translation along the axis differs by " : "";
    for (unsigned k = random() % 12; k > 0; --k) text += static_cast<char>(random() % (i % 2 ? 4U : 256U));
    texts.push_back(text);
  }
  const std::vector<std::string_view> views(texts.begin(), texts.end());
  const std::vector<int> ranks = text_ranks(views);
  for (int i = 0; i < 20000; ++i) {
    const std::size_t a = random() % views.size(), b = i % 5 ? random() % views.size() : i % 6U;
    EXPECT_EQ(views[a] < views[b], ranks[a] < ranks[b]) << a << ' ' << b;
    EXPECT_EQ(views[a] == views[b], ranks[a] == ranks[b]) << a << ' ' << b;
  }
  EXPECT_TRUE(text_ranks({}).empty());
}

/// Counts what is asked of it.
class CountedModel : public PairTableModel {
 public:
  QVariant data(const QModelIndex& index, int role) const override {
    ++asked;
    return PairTableModel::data(index, role);
  }
  mutable int asked = 0;
};

// Qt's own proxy asks for every cell. How long it takes is measured by watchdog.a_hundred_thousand_pairs_do_not_stall.
TEST(pair_filter, of_a_hundred_thousand_pairs_only_those_in_sight_are_asked_for) {
  auto output = output_of(100000);
  CountedModel model;
  PairsPanel panel(model);
  panel.resize(1000, 400);
  panel.show();
  const auto asked = [&](const auto& act) {
    model.asked = 0;
    act();
    for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
    return model.asked;
  };
  constexpr int kOnePicture = 40 * PairTableModel::ColumnCount * 12;  // rows, columns, roles
  EXPECT_LT(asked([&] {
              model.show_output(output, {"drive1"});
              panel.show_output(output);
            }),
            4 * kOnePicture)
      << "and what its columns are measured by";
  ASSERT_EQ(panel.filter()->rowCount(), 100000);
  QScrollBar& bar = *panel.table()->verticalScrollBar();
  EXPECT_LT(asked([&] { bar.setValue(bar.maximum() / 2); }), kOnePicture);
  EXPECT_LT(asked([&] { panel.table()->sortByColumn(PairTableModel::Reason, Qt::AscendingOrder); }), kOnePicture);
  QSignalSpy changed(panel.filter(), &QAbstractItemModel::layoutChanged);
  PairCriteria criteria;
  criteria.text = "screw";
  EXPECT_LT(asked([&] { panel.filter()->set_criteria(criteria); }), kOnePicture);
  EXPECT_EQ(changed.count(), 1) << "in one go";
  EXPECT_LT(asked([&] { panel.show_selected(panel.filter()->pairs().back()); }), 2 * kOnePicture);
}

}  // namespace
}  // namespace remount::widgets
