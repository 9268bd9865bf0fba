// The map of a drive and its timeline: what they show, and what clicks select.
#include "widgets/sessions/drive_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QWheelEvent>

#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/sessions/drive_map.h"
#include "widgets/sessions/drive_timeline.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

TEST(drive_overview, tells_gaps_and_the_worst_fix_of_each_stretch) {
  const testing::LanguageFor english{"en"};  // of one thing there is no plural
  drive::Session session = testing::sample_session("drive1");
  session.ins.erase(session.ins.begin() + 200, session.ins.begin() + 260);
  const overview::DriveOverview drive = overview::drive_overview(session, 50);
  EXPECT_TRUE(drive.north_up);
  EXPECT_EQ(drive.lidar.count, 60U);
  ASSERT_EQ(drive.ins_gaps.size(), 1U);
  EXPECT_NEAR(drive.ins_gaps[0].from_s, 1.99, 1e-9);
  EXPECT_NEAR(drive.ins_gaps[0].to_s, 2.60, 1e-9);
  EXPECT_EQ(drive.breaks.size(), 1U);
  EXPECT_TRUE(drive.lidar_gaps.empty());
  EXPECT_LE(drive.stretches.size(), 50U);
  double worst_m = 0.0;
  int degraded = 0;
  for (const overview::InsStretch& stretch : drive.stretches) {
    worst_m = std::max(worst_m, stretch.position_sigma_m);
    degraded += stretch.quality == motion::InsQuality::Degraded;
  }
  EXPECT_DOUBLE_EQ(worst_m, 0.2) << "thinning does not hide it";
  EXPECT_GE(degraded, 1);
  EXPECT_NEAR((drive.scans_m[50] - drive.scans_m[0]).x(), 50.0, 0.5) << "one metre east with every scan";
  EXPECT_TRUE(drive_figures(drive).contains("1 gap,")) << drive_figures(drive).toStdString();
  ASSERT_TRUE(drive.outlook.judged);
  EXPECT_FALSE(drive.outlook.determinable.contains(calibration::Parameter::Z)) << "the ground is level";
  EXPECT_TRUE(drive_figures(drive).contains(QRegularExpression("motion can tell x, y, .*not z")))
      << drive_figures(drive).toStdString();
}

TEST(drive_overview, of_poses_has_no_north_and_no_scan_is_placed_outside_the_data) {
  drive::Session session;
  for (int i = 0; i < 10; ++i)
    session.world_from_ins.push_back({1000000000LL * (i + 5), rigid_from_six({1.0 * i, 0, 0, 0, 0, 0})});
  for (int i = 0; i < 8; ++i)
    session.odometry_from_lidar.push_back({1000000000LL * (i + 1) + 500000000, RigidTransform::Identity()});
  const overview::DriveOverview drive = overview::drive_overview(session);
  EXPECT_FALSE(drive.north_up);
  EXPECT_FALSE(drive.scans_m[0].allFinite());
  EXPECT_NEAR(drive.scans_m[4].x(), 0.5, 1e-12);
  EXPECT_EQ(overview::drive_overview({}).duration_s, 0.0) << "nothing at all";
}

class drive_panel : public testing::WindowFixture {
 protected:
  DriveMap& map() { return child<DriveMap>(); }
  void show_map() {
    show();
    calibrate_drive();
    ASSERT_TRUE(QTest::qWaitFor([&] { return map().place_of(motion::PairIndex{5}).has_value(); }, kPatience_ms));
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>("drive")) dock->raise();
    QTest::qWait(50);
  }
};

TEST_F(drive_panel, a_click_on_the_map_selects_the_pair_everywhere) {
  show_map();
  for (const motion::PairIndex pair : {motion::PairIndex{3}, motion::PairIndex{17}, motion::PairIndex{30}}) {
    const auto place = map().place_of(pair);
    ASSERT_TRUE(place);
    ASSERT_TRUE(map().rect().contains(place->toPoint())) << "all is seen at first";
    const auto there = map().pair_at(*place);
    ASSERT_TRUE(there);
    QTest::mouseClick(&map(), Qt::LeftButton, {}, place->toPoint());
    EXPECT_EQ(workbench_.selection().pair(), there);
    EXPECT_EQ(child<PairsPanel>().marked_pairs(), std::vector{*there});
  }
  photograph(window_, "30-map");
}

TEST_F(drive_panel, the_wheel_zooms_about_the_cursor_and_dragging_pans_without_selecting) {
  show_map();
  const QPointF place = *map().place_of(motion::PairIndex{20});
  const double before = map().pixels_per_m();
  QWheelEvent wheel(place, map().mapToGlobal(place), {}, {0, 480}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&map(), &wheel);
  EXPECT_GT(map().pixels_per_m(), 2.0 * before);
  EXPECT_LT((*map().place_of(motion::PairIndex{20}) - place).manhattanLength(), 60)
      << "what is under the cursor stays near it";
  photograph(window_, "31-map-near");
  const auto selected = workbench_.selection().pair();
  const QPointF from = *map().place_of(motion::PairIndex{20});
  QTest::mousePress(&map(), Qt::LeftButton, {}, {100, 100});
  QTest::mouseMove(&map(), {130, 90});
  QTest::mouseRelease(&map(), Qt::LeftButton, {}, {130, 90});
  const QPointF moved = *map().place_of(motion::PairIndex{20}) - from;
  EXPECT_NEAR(moved.x(), 30.0, 1.0);
  EXPECT_NEAR(moved.y(), -10.0, 1.0);
  EXPECT_EQ(workbench_.selection().pair(), selected);
  workbench_.selection().select(motion::PairIndex{40});
  EXPECT_TRUE(map().rect().contains(map().place_of(motion::PairIndex{40})->toPoint()))
      << "what is selected elsewhere comes into view";
  QTest::keyClick(&map(), Qt::Key_Home);
  EXPECT_NEAR(map().pixels_per_m(), before, 1e-9);
}

TEST_F(drive_panel, a_time_selects_the_pair_recorded_then) {
  show_map();
  auto& timeline = child<DriveTimeline>();
  EXPECT_TRUE(timeline.shows_sigma());
  QTest::mouseClick(&timeline, Qt::LeftButton, {}, {timeline.x_of(2.0), 20});
  const motion::Pair& chosen = pair(workbench_.selection().pair().value());
  EXPECT_NEAR(0.05 * static_cast<double>(signed_of(chosen.keyframe_a) + signed_of(chosen.keyframe_b)), 2.0, 0.15);
  const auto before = workbench_.selection().pair();
  QTest::keyClick(&timeline, Qt::Key_Right);
  EXPECT_NE(workbench_.selection().pair(), before);
}

TEST_F(drive_panel, a_pair_of_another_drive_brings_its_map) {
  show();
  window_.open_paths({"/data/drive1", "/data/drive2"});
  ASSERT_TRUE(settle());
  auto* combo = child<DrivePanel>().findChild<QComboBox*>();
  EXPECT_EQ(combo->count(), 2);
  EXPECT_TRUE(combo->isVisibleTo(&child<DrivePanel>()));
  combo->setCurrentIndex(1);
  workbench_.calibrations().calibrate();  // the sample world's pairs are all of the first drive
  ASSERT_TRUE(settle());
  workbench_.selection().select(motion::PairIndex{7});
  EXPECT_EQ(combo->currentIndex(), 0);
  workbench_.session_edits().remove(motion::SessionIndex{0});
  EXPECT_EQ(combo->count(), 1);
}

}  // namespace
}  // namespace remount::widgets
