// The 3-D view of a pair, with known geometry. Needs a display with OpenGL and is skipped without.
#include "widgets/pairs/pair_view.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <limits>

#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/distance_legend.h"
#include "widgets/basics/gl_support.h"
#include "widgets/basics/swatch.h"
#include "widgets/scene/pair_colors.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// Two walls and a ground; scan a is the same world seen from 1 m behind, so that 1 m forward aligns it.
cloud::PointCloud corridor(double shift_m) {
  cloud::PointCloud cloud;
  for (int i = 0; i < 120; ++i)
    for (int j = 0; j < 30; ++j) {
      const auto x = static_cast<float>(-15.0 + 0.25 * i - shift_m);
      cloud.points.emplace_back(x, 6.0F, -1.5F + 0.2F * static_cast<float>(j));
      cloud.points.emplace_back(x, -6.0F, -1.5F + 0.2F * static_cast<float>(j));
      cloud.points.emplace_back(x, -6.0F + 0.4F * static_cast<float>(j), -1.5F);
    }
  return cloud;
}

struct TwoScans {
  pipeline::KeyframeScan a, b;
  std::vector<cloud::ObjectMatch> matches;
};

TwoScans known_scans() {
  TwoScans scans;
  scans.a.cloud = corridor(-1.0);
  scans.b.cloud = corridor(0.0);
  // Alone above everything, to be clicked on.
  scans.a.cloud.points.emplace_back(1.0F, 0.0F, 8.0F);
  scans.b.cloud.points.emplace_back(2.0F, 3.0F, 8.0F);
  return scans;
}

std::shared_ptr<const pipeline::PairClouds> clouds_of(const TwoScans& scans) {
  return std::make_shared<const pipeline::PairClouds>(
      pipeline::PairClouds{std::make_shared<const pipeline::KeyframeScan>(scans.a),
                           std::make_shared<const pipeline::KeyframeScan>(scans.b), scans.matches});
}

std::shared_ptr<const pipeline::PairClouds> known_clouds() { return clouds_of(known_scans()); }

scene::PairTransforms known_transforms() {
  scene::PairTransforms transforms;
  transforms.before_lidar_b_from_lidar_a = rigid_from_six({-1.0, 0.2, 0.0, 0.0, 0.0, 0.0});
  transforms.registered_lidar_b_from_lidar_a = rigid_from_six({-1.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  transforms.current_lidar_b_from_lidar_a = rigid_from_six({-1.0, 0.05, 0.0, 0.0, 0.0, 0.0});
  transforms.view_from_lidar_b = rigid_from_six({0.5, 0.0, 1.5, 0.0, 0.0, 0.0});
  return transforms;
}

class pair_view : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!missing_gl_reason().isEmpty())
      GTEST_SKIP() << "needs a display with OpenGL: " << missing_gl_reason().toStdString();
    view_.resize(760, 560);
    // As the window does, but at once.
    QObject::connect(&view_, &PairView::distances_wanted, &view_, [this](const DistanceRequest& request) {
      ++requests_;
      std::vector<std::vector<float>> distances_m;
      for (const RigidTransform& transform : request.lidar_b_from_lidar_a)
        distances_m.push_back(scene::distances_to_target(*request.data, transform, {}));
      view_.show_distances(request, std::move(distances_m));
    });
    view_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_, kPatience_ms));
    show(known_clouds());
  }
  void show(std::shared_ptr<const pipeline::PairClouds> clouds) {
    view_.show_pair("Pair 0", scene::prepare_pair_scene(std::move(clouds), {}), known_transforms());
    view_.look(scene::StandardView::Top);
  }
  QImage picture() { return view_.canvas()->grab().toImage(); }
  void click_on(const Eigen::Vector3d& point_in_view) {
    QTest::mouseClick(view_.canvas(), Qt::LeftButton, Qt::NoModifier, view_.place_of(point_in_view).toPoint());
  }
  QToolButton& button(const QString& text) {
    for (auto* candidate : view_.findChildren<QToolButton*>())
      if (candidate->text() == text) return *candidate;
    throw std::runtime_error("no button " + text.toStdString());
  }
  static int colorful(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = image.width() / 5; x < image.width(); ++x)  // not the axes
        count += QColor(image.pixel(x, y)).saturation() > 120;
    return count;
  }

  PairView view_;
  int requests_ = 0;
};

TEST_F(pair_view, a_click_tells_the_point_its_frame_and_its_distance) {
  // In view: lidar a (1, 0, 8) -> lidar b (0, 0, 8) -> view (0.5, 0, 9.5).
  click_on({0.5, 0.0, 9.5});
  EXPECT_TRUE(view_.readout().contains("scan a: x 1.000, y 0.000, z 8.000 m in LiDAR axes of scan a"))
      << view_.readout().toStdString();
  EXPECT_TRUE(view_.readout().contains("x 0.500, y 0.000, z 9.500 m in INS axes at scan b"))
      << view_.readout().toStdString();
  EXPECT_TRUE(view_.readout().contains("Nothing of scan b within 1 m")) << view_.readout().toStdString();
  view_.show_alignment(scene::PairAlignment::Before);
  view_.look(scene::StandardView::Left);
  click_on({0.5, 6.2, 1.4});  // on the wall of scan a, 0.2 m off that of scan b
  EXPECT_TRUE(view_.readout().contains("scan a") && view_.readout().contains("0.200 m from the surfaces of scan b"))
      << view_.readout().toStdString();
  QTest::keyClick(view_.canvas(), Qt::Key_Escape);
  EXPECT_EQ(view_.readout(), "");
  EXPECT_FALSE(view_.measuring());
}

TEST_F(pair_view, a_drag_is_no_click) {
  const QPoint from = view_.place_of({0.5, 0.0, 9.5}).toPoint();
  QTest::mousePress(view_.canvas(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(view_.canvas(), from + QPoint(40, 10));
  QTest::mouseRelease(view_.canvas(), Qt::LeftButton, Qt::NoModifier, from + QPoint(40, 10));
  EXPECT_EQ(view_.readout(), "");
}

TEST_F(pair_view, two_clicks_measure_a_distance_and_escape_ends_it) {
  const QImage without = picture();
  QTest::mouseClick(&button("Measure"), Qt::LeftButton);
  EXPECT_TRUE(view_.measuring());
  click_on({0.5, 0.0, 9.5});
  click_on({2.5, 3.0, 9.5});
  EXPECT_TRUE(view_.readout().contains("3.606 m (x 2.000, y 3.000, z 0.000 m")) << view_.readout().toStdString();
  EXPECT_NE(picture(), without) << "the line must be seen";
  QTest::keyClick(view_.canvas(), Qt::Key_Escape);
  EXPECT_FALSE(view_.measuring());
  EXPECT_EQ(picture(), without);
}

TEST_F(pair_view, the_slider_moves_scan_a_from_before_to_after) {
  auto& slider = *view_.findChild<QSlider*>();
  const QImage after = picture();
  EXPECT_TRUE(button("Aligned").isChecked());
  slider.setValue(50);
  EXPECT_NEAR(view_.scene().lidar_b_from_lidar_a(0).translation().y(), 0.1, 1e-9);
  EXPECT_NE(picture(), after);
  EXPECT_FALSE(button("Aligned").isChecked() || button("Before").isChecked());
  QTest::keyClick(&slider, Qt::Key_Home);
  EXPECT_EQ(view_.alignment(), scene::PairAlignment::Before);
  EXPECT_TRUE(button("Before").isChecked());
  view_.flip();
  EXPECT_EQ(view_.alignment(), scene::PairAlignment::Registered);
  EXPECT_EQ(slider.value(), 100);
  QTest::mouseClick(&button("With result"), Qt::LeftButton);
  EXPECT_NEAR(view_.scene().lidar_b_from_lidar_a(0).translation().y(), 0.05, 1e-9);
  view_.flip();
  view_.flip();
  EXPECT_EQ(view_.alignment(), scene::PairAlignment::CurrentX) << "blinking compares before with what was chosen last";
}

TEST_F(pair_view, side_by_side_shows_before_and_after_with_one_camera) {
  QTest::mouseClick(&button("Side by side"), Qt::LeftButton);
  EXPECT_NEAR(view_.scene().lidar_b_from_lidar_a(0).translation().y(), 0.2, 1e-9);
  EXPECT_NEAR(view_.scene().lidar_b_from_lidar_a(1).translation().y(), 0.0, 1e-9);
  const QImage both = picture();
  const int half = both.width() / 2;
  EXPECT_NE(both.copy(0, 0, half, both.height()), both.copy(half, 0, half, both.height()));
  view_.look(scene::StandardView::Left);
  const QImage turned = picture();
  EXPECT_NE(turned.copy(0, 0, half, both.height()), both.copy(0, 0, half, both.height()));
  EXPECT_NE(turned.copy(half, 0, half, both.height()), both.copy(half, 0, half, both.height()));
}

TEST_F(pair_view, what_no_result_says_is_not_offered) {
  view_.show_alignment(scene::PairAlignment::CurrentX);
  ASSERT_EQ(view_.alignment(), scene::PairAlignment::CurrentX);
  scene::PairTransforms transforms = known_transforms();
  transforms.current_known = false;
  view_.show_transforms("Pair 0", transforms);
  EXPECT_FALSE(button("With result").isEnabled());
  EXPECT_EQ(view_.alignment(), scene::PairAlignment::Registered);
  EXPECT_NEAR(view_.scene().lidar_b_from_lidar_a(0).translation().y(), 0.0, 1e-9);
  view_.show_transforms("Pair 0", known_transforms());
  EXPECT_TRUE(button("With result").isEnabled());
  EXPECT_EQ(view_.alignment(), scene::PairAlignment::CurrentX) << "as it was chosen";
  EXPECT_NEAR(view_.scene().lidar_b_from_lidar_a(0).translation().y(), 0.05, 1e-9);
}

TEST_F(pair_view, buttons_leave_the_keys_to_the_review) {
  auto& before = button("Before");
  QTest::mouseClick(&before, Qt::LeftButton);
  EXPECT_FALSE(before.hasFocus());
  EXPECT_EQ(before.focusPolicy(), Qt::TabFocus) << "a click leaves the keys, and the keyboard reaches it all the same";
}

TEST_F(pair_view, the_legend_names_what_is_in_the_picture_in_its_colours) {
  const auto legend = [&] {
    for (const auto* label : view_.findChildren<QLabel*>())
      if (label->text().startsWith("Pair 0")) return label->text();
    return QString();
  };
  const auto names = [&](const scene::SceneColor& color) { return legend().contains(to_qt(color).name()); };
  const auto clouds_with = [](bool moving) {
    TwoScans scans = known_scans();
    scans.a.objects.resize(1);
    scans.b.objects.resize(1);
    scans.matches.push_back({0, 0, moving, 0.0});
    return clouds_of(scans);
  };
  EXPECT_TRUE(names(scene::scan_colors(false).orange) && names(scene::scan_colors(false).target))
      << legend().toStdString();
  EXPECT_FALSE(names(scene::kObjectA) || names(scene::kObjectB) || names(scene::kMoving))
      << "there are none: " << legend().toStdString();
  show(clouds_with(false));
  EXPECT_TRUE(names(scene::kObjectA) && names(scene::kObjectB)) << legend().toStdString();
  EXPECT_FALSE(names(scene::kMoving)) << legend().toStdString();
  show(clouds_with(true));
  EXPECT_FALSE(names(scene::kObjectA) || names(scene::kObjectB)) << legend().toStdString();
  EXPECT_TRUE(names(scene::kMoving)) << legend().toStdString();
  button("Objects").click();
  EXPECT_FALSE(names(scene::kMoving)) << "they are hidden";
}

TEST_F(pair_view, distance_colours_keep_their_scale_from_pair_to_pair) {
  view_.findChild<QComboBox*>()->setCurrentIndex(static_cast<int>(scene::PairColoring::Distance));
  auto& legend = *view_.findChild<DistanceLegend*>();
  EXPECT_TRUE(legend.isVisible());
  EXPECT_EQ(requests_, 1);
  const QImage aligned = picture();
  legend.findChild<QDoubleSpinBox*>()->setValue(0.15);
  EXPECT_EQ(view_.scale_m(), 0.15);
  view_.show_alignment(scene::PairAlignment::Before);  // 0.2 m to the side: beyond the scale's end
  EXPECT_EQ(requests_, 2);
  EXPECT_NE(picture(), aligned);
  view_.flip();
  view_.flip();
  EXPECT_EQ(requests_, 2) << "blinking computes nothing anew";
  show(known_clouds());
  EXPECT_EQ(requests_, 3);
  EXPECT_EQ(view_.scale_m(), 0.15);
}

TEST_F(pair_view, bad_coordinates_do_not_blank_the_view) {
  const QImage good = picture();
  TwoScans scans = known_scans();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (cloud::PointCloud* cloud : {&scans.a.cloud, &scans.b.cloud}) {
    cloud->points.emplace_back(nan, 0.0F, 0.0F);
    cloud->points.emplace_back(1e30F, 1e30F, 1e30F);
    cloud->points.emplace_back(5e4F, 0.0F, 0.0F);
    cloud->points.emplace_back(std::numeric_limits<float>::infinity(), 0.0F, 0.0F);
  }
  show(clouds_of(scans));
  const int before = colorful(good), now = colorful(picture());
  EXPECT_GT(before, 1000);
  EXPECT_NEAR(now, before, 0.1 * before);
  for (const scene::StandardView view : {scene::StandardView::Front, scene::StandardView::Left,
                                         scene::StandardView::Isometric, scene::StandardView::Fit}) {
    view_.look(view);
    view_.set_parallel(false);  // or walls that are seen along their length would be lines
    EXPECT_GT(colorful(picture()), 200);
  }
}

TEST_F(pair_view, shading_changes_the_picture_and_not_what_is_picked) {
  view_.look(scene::StandardView::Isometric);
  const QImage plain = picture();
  QTest::mouseClick(&button("Shading"), Qt::LeftButton);
  EXPECT_TRUE(view_.eye_dome());
  const QImage shaded = picture();
  EXPECT_NE(shaded, plain);
  EXPECT_GT(colorful(shaded), 200) << "not all black";
  click_on({0.5, 0.0, 9.5});
  EXPECT_TRUE(view_.readout().contains("x 1.000, y 0.000, z 8.000")) << view_.readout().toStdString();
  QTest::mouseClick(&button("Shading"), Qt::LeftButton);
  QTest::keyClick(view_.canvas(), Qt::Key_Escape);
  EXPECT_EQ(picture(), plain);
}

TEST_F(pair_view, shading_survives_a_new_size_and_side_by_side) {
  view_.set_eye_dome(true);
  EXPECT_GT(colorful(picture()), 200);
  view_.resize(620, 500);
  QTest::qWait(50);
  EXPECT_GT(colorful(picture()), 200);
  view_.set_side_by_side(true);
  const QImage both = picture();
  EXPECT_GT(colorful(both.copy(0, 0, both.width() / 2, both.height())), 100);
  EXPECT_GT(colorful(both.copy(both.width() / 2, 0, both.width() / 2, both.height())), 100);
  int light = 0;
  for (int x = 0; x < both.width() / 2; ++x) light += QColor(both.pixel(x, both.height() / 2)).lightness() > 200;
  EXPECT_GT(light, both.width() / 10) << "the background is not black";
  view_.set_side_by_side(false);
  EXPECT_GT(colorful(picture()), 200);
}

TEST(pair_view_without_gl, says_what_is_missing_and_takes_everything) {
  if (missing_gl_reason().isEmpty()) GTEST_SKIP() << "there is OpenGL here";
  PairView view;
  view.show_pair("Pair 0", nullptr, {});
  view.look(scene::StandardView::Top);
  view.flip();
  view.set_measuring(true);
  view.click({10, 10});
  view.set_side_by_side(true);
  view.set_coloring(scene::PairColoring::Distance);
  view.show_message("later");
  EXPECT_FALSE(view.shows_scene());
  QString said;
  for (const QLabel* label : view.findChildren<QLabel*>()) said += label->text();
  EXPECT_TRUE(said.contains("The 3-D view is not available")) << said.toStdString();
}

}  // namespace
}  // namespace remount::widgets
