#include "widgets/text/sentences.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTableWidget>
#include <QTest>
#include <stdexcept>

#include "tests/widgets/support/restored.h"
#include "widgets/quality/obstacle_dialog.h"

namespace remount::widgets {
namespace {

TEST(sentences, have_a_space_between_them_where_the_language_has_one) {
  EXPECT_EQ(one_text({"One.", "Two.", "Three!"}), "One. Two. Three!");
  EXPECT_EQ(one_text({QStringLiteral("一。"), QStringLiteral("二！"), QStringLiteral("三")}),
            QStringLiteral("一。二！三"));
  EXPECT_EQ(one_text({QStringLiteral("一。"), "Two, which nobody has translated.", QStringLiteral("三。")}),
            QStringLiteral("一。Two, which nobody has translated. 三。"));
  EXPECT_EQ(one_text({"", "One.", ""}), "One.");
  EXPECT_EQ(one_text({}), "");
}

/// Objects of which one is no longer an obstacle before; the mounting changes the decision.
quality::ObstacleComparison sample_comparison() {
  quality::ObstacleComparison found;
  found.nominal.nearest_m = 0.5;
  found.nominal.decision = quality::ObstacleDecision::Stop;
  found.calibrated.nearest_m = 4.0;
  found.calibrated.decision = quality::ObstacleDecision::Clear;
  for (int object = 0; object < 14; ++object) {
    quality::ObstacleDifference difference;
    difference.object = object;
    difference.shape = object % 2 ? cloud::ObjectShape::VehicleSized : cloud::ObjectShape::Pole;
    difference.nominal_distance_m = object == 0 ? 0.5 : 3.0 + object;
    difference.calibrated_distance_m = 4.0 + object;
    found.rows.push_back(difference);
  }
  return found;
}

const QLabel& verdict_of(const ObstacleDialog& dialog) {
  for (const QLabel* label : dialog.findChildren<QLabel*>())
    if (label->accessibleName() == ObstacleDialog::tr("Decision")) return *label;
  throw std::logic_error("no verdict");
}

TEST(obstacle_dialog, joins_its_sentences_as_the_language_does) {
  const testing::LanguageFor chinese("zh_CN");
  ObstacleDialog dialog("scan", true, {});
  dialog.show_comparison(sample_comparison(), {});
  EXPECT_FALSE(verdict_of(dialog).text().contains(QStringLiteral("。 "))) << verdict_of(dialog).text().toStdString();
  EXPECT_EQ(verdict_of(dialog).text().count(QStringLiteral("。")), 3) << verdict_of(dialog).text().toStdString();
}

TEST(obstacle_dialog, names_objects_in_full_or_in_a_tooltip) {
  const testing::LanguageFor english("en");
  ObstacleDialog dialog("scan", true, {});
  dialog.show_comparison(sample_comparison(), {});
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog, 20000));
  const auto& table = *dialog.findChild<QTableWidget*>();
  int widest = 0;
  for (int row = 0; row < table.rowCount(); ++row) {
    const QTableWidgetItem& item = *table.item(row, 0);
    widest = std::max(widest, table.fontMetrics().horizontalAdvance(item.text()));
    EXPECT_EQ(item.toolTip(), item.text());
  }
  ASSERT_GT(widest, 60);
  EXPECT_GT(table.columnWidth(0), widest) << "in a dialog of its usual size nothing is cut";
  EXPECT_EQ(table.textElideMode(), Qt::ElideMiddle);
  EXPECT_EQ(table.columnViewportPosition(3) + table.columnWidth(3), table.viewport()->width()) << "no gap at the right";
  dialog.resize(dialog.minimumSizeHint());
  EXPECT_TRUE(QTest::qWaitFor([&] { return table.columnWidth(0) < widest; }, 5000))
      << "in a small one names make room for the distances: " << table.columnWidth(0);
  EXPECT_GE(table.columnWidth(0), 60);
}

}  // namespace
}  // namespace remount::widgets
