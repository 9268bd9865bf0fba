// The quality page: sessions against each other, the map's sharpness.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTableWidget>

#include "tests/widgets/support/window_fixture.h"
#include "widgets/panels/hold_out_view.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/quality_view.h"
#include "widgets/panels/sharpness_view.h"
#include "widgets/panels/verdict_table.h"

namespace remount {
namespace {

using testing::kPatience_ms;
using testing::sample_hold_out;

QString verdict_of(const QWidget& view) { return view.findChild<VerdictLabel*>()->text(); }

FigureTable& table_of(const QWidget& view, int which = 0) { return *view.findChildren<FigureTable*>().at(which); }

QString cell(const FigureTable& table, int row, int column) { return table.item(row, column)->text(); }

TEST(hold_out_view, says_in_words_whether_sessions_agree) {
  HoldOutView view;
  view.show_hold_out(sample_hold_out(2), {"monday", "friday"});
  EXPECT_TRUE(verdict_of(view).contains("monday and friday: agree (at most 1.5 sigma, in yaw)"))
      << verdict_of(view).toStdString();
  view.show_hold_out(sample_hold_out(2, 8.0), {"monday", "friday"});
  EXPECT_TRUE(verdict_of(view).contains("differ by 8.0 sigma in yaw")) << verdict_of(view).toStdString();
  EXPECT_TRUE(verdict_of(view).startsWith("✕"));
}

TEST(hold_out_view, shows_every_choice_and_no_number_for_what_is_not_observed) {
  HoldOutView view;
  view.show_hold_out(sample_hold_out(3), {"monday", "tuesday", "friday"});
  const FigureTable &scores = table_of(view, 0), &differences = table_of(view, 1);
  EXPECT_EQ(scores.rowCount(), 6);
  EXPECT_EQ(cell(scores, 0, 0), "monday");
  EXPECT_EQ(cell(scores, 0, 1), "tuesday");
  EXPECT_EQ(cell(scores, 0, 3), "0.023°, 13.0 mm");
  EXPECT_TRUE(scores.item(2, 3)->toolTip().contains("tuesday does not observe z: taken from monday's own X"));
  ASSERT_EQ(differences.rowCount(), 3);
  EXPECT_EQ(cell(differences, 0, 2), "+2.0 ± 4.0 mm");
  EXPECT_EQ(cell(differences, 0, 4), "–");
  EXPECT_TRUE(differences.item(0, 4)->toolTip().contains("tuesday does not observe z"));
  for (const FigureTable* table : {&scores, &differences})
    for (int row = 0; row < table->rowCount(); ++row)
      for (int column = 0; column < table->columnCount(); ++column)
        EXPECT_FALSE(cell(*table, row, column).contains("nan"));
}

TEST(sharpness_view, marks_the_better_of_nominal_and_result) {
  SharpnessView view;
  view.show_sharpness(
      {{"result", {-4.0, 0.020, 900}}, {"nominal", {-3.5, 0.035, 900}}, {"pair 4", {-4.1, 0.019, 900}}});
  EXPECT_TRUE(verdict_of(view).contains("became sharper")) << verdict_of(view).toStdString();
  EXPECT_EQ(cell(table_of(view), 0, 1), "✓ 20.0");
  EXPECT_EQ(cell(table_of(view), 1, 1), "35.0");
  EXPECT_EQ(cell(table_of(view), 2, 1), "19.0") << "the question is about nominal and result";
  view.show_sharpness({{"result", {-4.0, 0.040, 900}}, {"nominal", {-3.5, 0.035, 900}}});
  EXPECT_TRUE(verdict_of(view).contains("became blunter"));
  view.show_sharpness({{"result", {-4.0, 0.035, 900}}, {"nominal", {-3.5, 0.0352, 900}}});
  EXPECT_TRUE(verdict_of(view).contains("No clear difference"));
}

class quality_page : public testing::WindowFixture {
 protected:
  quality_page() : testing::WindowFixture(2) {}
  QualityView& view() { return child<QualityView>(); }
  void look_at(QWidget* page) {
    trigger("Ctrl+Shift+B");
    view().setCurrentWidget(page);
  }
  bool says(const QWidget& page, const QString& text) {
    return QTest::qWaitFor([&] { return verdict_of(page).contains(text); }, kPatience_ms);
  }
  void calibrate_two() {
    window_.open_paths({"/data/drive1", "/data/drive2"});
    ASSERT_TRUE(settle());
    workbench_.calibrate();
    ASSERT_TRUE(settle());
  }
};

TEST_F(quality_page, one_session_needs_a_second) {
  show();
  calibrate_drive();
  look_at(view().hold_out());
  EXPECT_TRUE(says(*view().hold_out(), "Needs a second session"));
}

TEST_F(quality_page, sessions_are_compared_when_somebody_looks_and_again_after_a_decision) {
  show();
  calibrate_two();
  EXPECT_FALSE(verdict_of(*view().hold_out()).contains("sigma")) << "nobody has asked for it";
  look_at(view().hold_out());
  ASSERT_TRUE(says(*view().hold_out(), "drive1 and drive2: agree"));
  photograph(window_, "20-hold-out");
  workbench_.decide({1, 2}, PairState::Rejected);
  EXPECT_TRUE(says(*view().hold_out(), "Solving every session alone"));
  ASSERT_TRUE(settle());
  EXPECT_TRUE(says(*view().hold_out(), "drive1 and drive2: agree"));
}

TEST_F(quality_page, says_why_the_map_was_not_compared_and_leads_to_it) {
  show();
  calibrate_drive();
  look_at(view().sharpness());
  EXPECT_TRUE(says(*view().sharpness(), "Not compared"));
  for (auto* button : view().sharpness()->findChildren<QPushButton*>())
    if (button->text() == "Map under the start") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(child<MapView>().chosen_x(), MapX::Nominal);
  EXPECT_TRUE(child<MapView>().isVisible());
  workbench_.decide({1}, PairState::Rejected);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(says(*view().sharpness(), "Calibrate again (F5)"));
}

}  // namespace
}  // namespace remount
