// The accumulated map. What is drawn needs a display with OpenGL and is skipped without.
#include "widgets/map/map_view.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "messages/stages.h"
#include "tests/support/draws.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/gl_support.h"
#include "widgets/scene/frame_budget.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

/// Scans along a road: ground, facades and a tower that is to be found by a click.
quality::MapScans road(std::size_t points_in_all) {
  constexpr std::size_t kScans = 20;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  quality::MapScans scans;
  for (std::size_t scan = 0; scan < kScans; ++scan) {
    std::vector<Eigen::Vector3f> points(points_in_all / kScans);
    for (Eigen::Vector3f& point : points) {
      const float along = 60.0F * (unit(random) - 0.5F), kind = unit(random);
      point = kind < 0.5F ? Eigen::Vector3f(along, 20.0F * (unit(random) - 0.5F), -1.8F)
                          : Eigen::Vector3f(along, kind < 0.75F ? 10.0F : -10.0F, -1.8F + 8.0F * unit(random));
    }
    scans.points_in_lidar.push_back(std::move(points));
    scans.local_from_ins.push_back(rigid_from_six({5.0 * static_cast<double>(scan), 0.0, 0.0, 0.0, 0.0, 0.0}));
  }
  scans.points_in_lidar[0].emplace_back(50.0F, 0.0F, 30.0F);
  scans.points_in_lidar[0].emplace_back(1e30F, 0.0F, 0.0F);
  scans.points_in_lidar[0].emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F);
  return scans;
}

class map_view : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!missing_gl_reason().isEmpty())
      GTEST_SKIP() << "needs a display with OpenGL: " << missing_gl_reason().toStdString();
    view_.resize(760, 560);
    view_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_, kPatience_ms));
  }
  void show(std::size_t points) {
    data_ = scene::prepare_map_scene(road(points), RigidTransform::Identity(), {});
    view_.show_map("a road", data_);
    ASSERT_TRUE(come_to_rest());
  }
  bool come_to_rest() {
    return QTest::qWaitFor([&] { return view_.rests(); }, 10 * kPatience_ms);
  }
  /// Without the corner of the axes, which clear the depth there.
  QImage picture() {
    const QImage image = view_.canvas()->grab().toImage();
    return image.copy(0, 0, image.width(), 7 * image.height() / 10);
  }
  /// Drags the mouse over the view and returns how long the frames took, ms.
  std::vector<double> orbit(int frames) {
    std::vector<double> times_ms;
    QPoint at = view_.canvas()->rect().center();
    QTest::mousePress(view_.canvas(), Qt::LeftButton, Qt::NoModifier, at);
    for (int i = 0; i < frames; ++i) {
      at += QPoint(5, i % 2);
      QElapsedTimer timer;
      timer.start();
      QTest::mouseMove(view_.canvas(), at);
      QApplication::processEvents();
      times_ms.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
      EXPECT_LE(view_.scene().points_shown(), std::max(view_.scene().moving_budget(), scene::FrameBudget::kFewest));
      most_shown_ = std::max(most_shown_, view_.scene().points_shown());
      budget_ = std::max(budget_, view_.scene().moving_budget());
    }
    EXPECT_FALSE(view_.rests());
    QTest::mouseRelease(view_.canvas(), Qt::LeftButton, Qt::NoModifier, at);
    QTest::qWait(250);
    return times_ms;
  }

  MapView view_;
  std::size_t most_shown_ = 0, budget_ = 0;  // of the frames of an orbit
  scene::MapSceneDataPtr data_;
};

TEST_F(map_view, draws_few_points_while_it_is_turned_and_all_at_rest) {
  const QByteArray wanted = qgetenv("REMOUNT_MAP_POINTS");  // 10000000: as many as the map holds at most
  const std::size_t points = wanted.isEmpty() ? 500000 : wanted.toULongLong();
  show(points);
  EXPECT_EQ(scene::facts_of(*data_).points, points + 1);
  EXPECT_EQ(scene::facts_of(*data_).left_out, 2U);
  EXPECT_EQ(view_.scene().points_shown(), points + 1) << "at rest the whole cloud";
  std::vector<double> times_ms = orbit(40);
  std::sort(times_ms.begin() + 10, times_ms.end());  // the first find out how fast the machine is
  std::printf("%zu points: %zu drawn while turning, %.0f ms a frame (median), %.0f ms the longest of thirty\n", points,
              view_.scene().moving_budget(), times_ms[25], times_ms.back());
  const std::size_t budget = view_.scene().moving_budget();
  EXPECT_LE(most_shown_, std::max(budget_, scene::FrameBudget::kFewest)) << "no frame drew more than it had time for";
  EXPECT_TRUE(most_shown_ < points || budget > points) << "all of it only where a frame has time for all of it";
  ASSERT_TRUE(come_to_rest());
  EXPECT_EQ(view_.scene().points_shown(), points + 1);
}

TEST_F(map_view, piece_by_piece_makes_the_same_picture_as_at_once) {
  show(150000);
  view_.look(scene::StandardView::Top);
  ASSERT_TRUE(come_to_rest());
  const QImage pieces = picture();
  view_.look(scene::StandardView::Top);
  ASSERT_TRUE(come_to_rest());
  EXPECT_EQ(pieces, picture());
  int filled = 0;
  for (int y = 0; y < pieces.height(); ++y)
    for (int x = 0; x < pieces.width(); ++x) filled += QColor(pieces.pixel(x, y)).saturation() > 100;
  EXPECT_GT(filled, pieces.width() * pieces.height() / 20);
  view_.look(scene::StandardView::Left);
  ASSERT_TRUE(come_to_rest());
  EXPECT_NE(pieces, picture()) << "the picture before does not shine through";
  view_.look(scene::StandardView::Top);
  ASSERT_TRUE(come_to_rest());
  EXPECT_EQ(pieces, picture());
}

TEST_F(map_view, a_click_tells_where_a_point_of_the_map_is) {
  show(100000);
  view_.look(scene::StandardView::Top);
  ASSERT_TRUE(come_to_rest());
  QTest::mouseClick(view_.canvas(), Qt::LeftButton, Qt::NoModifier, view_.place_of({50.0, 0.0, 30.0}).toPoint());
  EXPECT_TRUE(view_.readout().contains("x 50.000, y 0.000, z 30.000 m")) << view_.readout().toStdString();
  ASSERT_TRUE(come_to_rest());
  EXPECT_EQ(view_.scene().points_shown(), scene::facts_of(*data_).points) << "the mark is drawn with the whole map";
}

TEST_F(map_view, shading_draws_what_there_is_time_for) {
  show(200000);
  const QImage plain = picture();
  view_.set_eye_dome(true);
  ASSERT_TRUE(come_to_rest());
  EXPECT_NE(plain, picture());
  EXPECT_GT(view_.scene().points_shown(), 50000U);
  view_.set_eye_dome(false);
  ASSERT_TRUE(come_to_rest());
  EXPECT_EQ(plain, picture());
}

class map_page : public testing::WindowFixture {
 protected:
  void SetUp() override {
    if (!missing_gl_reason().isEmpty())
      GTEST_SKIP() << "needs a display with OpenGL: " << missing_gl_reason().toStdString();
    show();
    calibrate_drive();
  }
  bool shown() {
    return QTest::qWaitFor([&] { return view().shows_scene(); }, kPatience_ms);
  }
  MapView& view() { return child<MapView>("map"); }
  QString words() {
    QString words;
    for (const QLabel* label : view().findChildren<QLabel*>())
      if (label->isVisible()) words += label->text() + '\n';
    return words;
  }
  bool says(const QString& text) {
    return QTest::qWaitFor([&] { return words().contains(text); }, kPatience_ms);
  }
  QToolButton& button(const QString& text) {
    for (auto* candidate : view().findChildren<QToolButton*>())
      if (candidate->text() == text) return *candidate;
    throw std::runtime_error("no button " + text.toStdString());
  }
};

TEST_F(map_page, is_made_when_it_is_looked_at_under_the_mounting_that_is_chosen) {
  QTest::qWait(100);
  EXPECT_FALSE(view().shows_scene()) << "nobody has asked for it";
  trigger("Ctrl+M");
  ASSERT_TRUE(shown());
  ASSERT_TRUE(says("drive1: 10 scans under the result"));
  photograph(window_, "14-map");
  QTest::mouseClick(&button("Start"), Qt::LeftButton);
  ASSERT_TRUE(says("under the mounting that the calibration started from"));
  EXPECT_FALSE(button("Candidate").isEnabled());
  for (auto* table : window_.findChildren<QTableView*>())
    if (table->accessibleName() == "Candidates") table->selectRow(3);
  QTest::mouseClick(&button("Candidate 4"), Qt::LeftButton);
  ASSERT_TRUE(says("under candidate 4"));
  workbench_.decisions().decide({motion::PairIndex{3}},
                                motion::PairState::Rejected);  // a new result has new candidates
  ASSERT_TRUE(settle());
  ASSERT_TRUE(says("under the result"));
  EXPECT_FALSE(button("Candidate").isEnabled());
}

TEST_F(map_page, follows_a_new_result_and_the_keys_of_the_views) {
  trigger("Ctrl+M");
  ASSERT_TRUE(says("under the result"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().rests(); }, kPatience_ms));
  const QImage before = view().canvas()->grab().toImage();
  workbench_.decisions().decide({motion::PairIndex{1}, motion::PairIndex{2}, motion::PairIndex{4}, motion::PairIndex{5},
                                 motion::PairIndex{6}, motion::PairIndex{7}, motion::PairIndex{8}},
                                motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return view().rests() && view().canvas()->grab().toImage() != before; }, kPatience_ms))
      << "x has moved by some millimetres, and the map with it";
  trigger("Ctrl+2");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().rests(); }, kPatience_ms));
  const QImage top = view().canvas()->grab().toImage();
  trigger("Ctrl+3");
  ASSERT_TRUE(QTest::qWaitFor([&] { return view().rests(); }, kPatience_ms));
  EXPECT_NE(top, view().canvas()->grab().toImage());
}

/// Its scans take so long that cancelling finds them being read.
class slow_map_page : public testing::WindowFixture {
 protected:
  static gui::Engine slow_engine() {
    gui::Engine engine = testing::sample_engine(2);
    engine.load_map_scans = [](const pipeline::PipelineInput&, const pipeline::PipelineOutput&, motion::SessionIndex,
                               std::size_t, Progress& progress) {
      for (std::size_t i = 0; i < 2000 && !progress.cancelled(); ++i) {
        progress.report(say::stage_reading_scans_for_the_map, i, 2000);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
      return pipeline::SessionScans{};
    };
    return engine;
  }
};

TEST_F(slow_map_page, can_be_cancelled_and_asked_for_again) {
  if (!missing_gl_reason().isEmpty()) GTEST_SKIP() << "needs a display with OpenGL";
  gui::Workbench workbench(slow_engine());
  gui::MainWindow window(workbench, gui::all_features());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience_ms));
  window.open_paths({"/data/drive1"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  workbench.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().calibrating(); }, kPatience_ms));
  auto& view = *window.findChild<MapView*>("map");
  for (auto* tabs : window.findChildren<QTabWidget*>())
    if (tabs->indexOf(&view) >= 0) tabs->setCurrentWidget(&view);
  const auto visible = [&](const QString& text) -> QPushButton* {
    for (auto* button : view.findChildren<QPushButton*>())
      if (button->text() == text && button->isVisible()) return button;
    return nullptr;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.findChild<QProgressBar*>()->value() > 2; }, kPatience_ms));
  photograph(window, "15-map-in-work");
  QTest::mouseClick(visible("Cancel"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return visible("Make the map") != nullptr; }, kPatience_ms));
  EXPECT_FALSE(visible("Cancel"));
  QTest::mouseClick(visible("Make the map"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return visible("Cancel") != nullptr; }, kPatience_ms));
  workbench.session_edits().remove(motion::SessionIndex{0});  // no output, and so no map
  QTest::qWait(50);
  EXPECT_FALSE(view.shows_scene());
  window.open_paths({"/data/drive2"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  workbench.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return visible("Cancel") != nullptr; }, kPatience_ms));
  // The window ends while it works, in time.
}

TEST_F(map_page, offers_no_session_that_was_opened_after_the_calibration) {
  ONLY_IN_LONG_TESTS();
  trigger("Ctrl+M");
  ASSERT_TRUE(shown());
  window_.open_paths({"/data/drive2"});
  ASSERT_TRUE(settle());
  ASSERT_EQ(workbench_.sessions().all().size(), 2U);
  workbench_.decisions().decide({motion::PairIndex{3}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  for (const auto* box : view().findChildren<QComboBox*>()) EXPECT_LT(box->findText("drive2"), 0);
  ASSERT_TRUE(says("under the result"));
}

}  // namespace
}  // namespace remount::widgets
