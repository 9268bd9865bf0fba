// The quality page: what is free around the vehicle, the map's sharpness, sessions against each other.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabBar>
#include <QTableWidget>
#include <atomic>

#include "algorithms/core/error.h"
#include "app/gui/features/quality_controller.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/shrinking_area.h"
#include "widgets/map/map_view.h"
#include "widgets/quality/clearance_plot.h"
#include "widgets/quality/clearance_view.h"
#include "widgets/quality/quality_view.h"
#include "widgets/quality/sharpness_view.h"
#include "widgets/result/hold_out_view.h"
#include "widgets/result/result_panel.h"
#include "widgets/result/verdict_table.h"

namespace remount::widgets {

using motion::PairIndex;

namespace {

using testing::kPatience_ms;
using testing::sample_hold_out;

QString verdict_of(const QWidget& view) { return view.findChild<VerdictLabel*>()->text(); }

FigureTable& table_of(const QWidget& view, int which = 0) { return *view.findChildren<FigureTable*>().at(which); }

QString cell(const FigureTable& table, int row, int column) { return table.item(row, column)->text(); }

TEST(hold_out_view, says_in_words_whether_sessions_agree) {
  HoldOutView view;
  view.show_hold_out(sample_hold_out(2), {"monday", "friday"});
  EXPECT_TRUE(verdict_of(view).contains("monday and friday: agree in 5 of 6 parameters (at most 1.5 sigma, in yaw)"))
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
  EXPECT_EQ(cell(differences, 0, 1), "+2.0 ± 4.0");
  EXPECT_EQ(cell(differences, 0, 3), "–");
  EXPECT_TRUE(differences.item(0, 3)->toolTip().contains("tuesday does not observe z"));
  for (const FigureTable* table : {&scores, &differences})
    for (int row = 0; row < table->rowCount(); ++row)
      for (int column = 0; column < table->columnCount(); ++column)
        EXPECT_FALSE(cell(*table, row, column).contains("nan"));
}

TEST(sharpness_view, marks_the_better_of_nominal_and_result) {
  SharpnessView view;
  view.show_sharpness({{calibration::MountingSource::Result, {-4.0, 0.020, 900}},
                       {calibration::MountingSource::Nominal, {-3.5, 0.035, 900}},
                       {calibration::MountingSource::pair(PairIndex{4}), {-4.1, 0.019, 900}}});
  EXPECT_TRUE(verdict_of(view).contains("became sharper")) << verdict_of(view).toStdString();
  EXPECT_EQ(cell(table_of(view), 0, 1), "✓ 20.0");
  EXPECT_EQ(cell(table_of(view), 1, 1), "35.0");
  EXPECT_EQ(cell(table_of(view), 2, 1), "19.0") << "the question is about nominal and result";
  view.show_sharpness({{calibration::MountingSource::Result, {-4.0, 0.040, 900}},
                       {calibration::MountingSource::Nominal, {-3.5, 0.035, 900}}});
  EXPECT_TRUE(verdict_of(view).contains("became blunter"));
  view.show_sharpness({{calibration::MountingSource::Result, {-4.0, 0.035, 900}},
                       {calibration::MountingSource::Nominal, {-3.5, 0.0352, 900}}});
  EXPECT_TRUE(verdict_of(view).contains("No clear difference"));
  EXPECT_EQ(cell(table_of(view), 0, 1), "35.0") << "a smaller number is no better by chance";
  EXPECT_EQ(cell(table_of(view), 0, 2), "-4.000");
  view.show_sharpness({{calibration::MountingSource::Result, {-4.0, 0.020, 3}},
                       {calibration::MountingSource::Nominal, {-3.5, 0.035, 3}}});
  EXPECT_TRUE(verdict_of(view).contains("Too few places")) << verdict_of(view).toStdString();
}

/// A wall ahead that the mounting before saw 0.3 m too far away, a pole at the left, the bonnet.
std::shared_ptr<const VehicleScan> courtyard() {
  VehicleScan scan;
  for (int i = -20; i <= 20; ++i) scan.after.emplace_back(8.0F, 0.2F * static_cast<float>(i), 0.5F);
  scan.after.emplace_back(1.0F, 3.5F, 0.0F);
  scan.after.emplace_back(3.0F, 0.0F, 0.0F);
  scan.after.emplace_back(5.0F, 0.0F, -1.2F);  // ground
  for (const Eigen::Vector3f& point : scan.after) scan.before.emplace_back(point.x() + 0.3F, point.y(), point.z());
  return std::make_shared<const VehicleScan>(std::move(scan));
}

MeasuredScanPtr measured(const quality::VehicleBox& box) {
  return std::make_shared<const MeasuredScan>(measure_scan(*courtyard(), box));
}

TEST(sharpness_view, needs_no_more_room_than_its_words_though_they_came_while_it_was_hidden) {
  auto* tabs = new QTabWidget;
  auto* view = new SharpnessView;
  tabs->addTab(new QLabel("another page"), "one");
  tabs->addTab(view, "two");
  ShrinkingArea area(tabs);
  area.resize(700, 260);
  area.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&area));
  std::vector<quality::NamedSharpness> mountings;
  mountings.push_back({calibration::MountingSource::Result, {-3.6, 0.0096, 20000}});
  for (int pair = 1; pair <= 5; ++pair)
    mountings.push_back({calibration::MountingSource::pair(index_at<PairIndex>(pair)), {-3.6, 0.0096, 20000}});
  view->show_sharpness(mountings);
  tabs->setCurrentIndex(1);
  const auto& note = *view->findChild<NoteLabel*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return note.isVisible() && tabs->height() <= area.viewport()->height(); }));
  EXPECT_GE(note.height(), note.heightForWidth(note.width()));
  EXPECT_LE(note.minimumHeight(), note.heightForWidth(note.width()));
  EXPECT_LE(tabs->height(), area.viewport()->height()) << "nothing to be scrolled to";
}

TEST(clearance_view, tells_what_is_free_on_each_side_before_and_after) {
  ClearanceView view;
  view.show_scan("scan7.pcd", measured({}));
  const FigureTable& table = table_of(view);
  EXPECT_EQ(cell(table, 0, 1), "4.80");
  EXPECT_EQ(cell(table, 1, 1), "4.50");
  EXPECT_EQ(cell(table, 2, 1), "-0.300");
  EXPECT_EQ(cell(table, 1, 2), "–") << "nothing is behind";
  EXPECT_EQ(cell(table, 1, 3), "2.50");
  EXPECT_EQ(cell(table, 1, 5), "2.50") << "the nearest in any direction";
  EXPECT_TRUE(view.plot()->message().isEmpty());
}

TEST(clearance_view, follows_the_outline_and_the_heights) {
  ClearanceView view;
  QSignalSpy edited(&view, &ClearanceView::box_edited);
  QObject::connect(&view, &ClearanceView::box_edited,
                   [&](const quality::VehicleBox& box) { view.show_scan("scan7.pcd", measured(box)); });
  view.show_scan("scan7.pcd", measured(view.box()));
  for (auto* spin : view.findChildren<QDoubleSpinBox*>()) {
    EXPECT_FALSE(spin->accessibleName().isEmpty());
    if (spin->accessibleName() == "Front") spin->setValue(2.5);
    if (spin->accessibleName() == "Lowest") spin->setValue(-2.0);
  }
  EXPECT_EQ(edited.count(), 2);
  EXPECT_EQ(cell(table_of(view), 1, 1), "0.50") << "the bonnet sticks out";
  EXPECT_NEAR(view.box().height_min_m, -2.0, 1e-9);
  view.set_box({});
  EXPECT_EQ(edited.count(), 2) << "what the program sets is no edit";
  view.show_scan("scan7.pcd", measured({3.5, 1.5, 1.0, 10.0, 12.0}));
  EXPECT_TRUE(view.plot()->message().contains("No points within the heights"));
}

TEST(clearance_view, names_what_the_result_is_compared_with) {
  ClearanceView view;
  const auto note = [&] {
    for (const QLabel* label : view.findChildren<QLabel*>())
      if (label->text().contains("not where the LiDAR was")) return !label->isHidden();
    return false;
  };
  view.show_scan("scan7.pcd", measured({}));
  EXPECT_EQ(cell(table_of(view), 0, 0), "Nominal");
  EXPECT_EQ(table_of(view).rowCount(), 3);
  EXPECT_FALSE(note());
  view.show_nominal_known(false, "not where the LiDAR was");
  view.show_scan("scan7.pcd", measured({}));
  EXPECT_EQ(cell(table_of(view), 0, 0), "Start") << "where the LiDAR was before is not known";
  EXPECT_EQ(table_of(view).rowCount(), 2) << "how far a guess is from the result is no figure";
  EXPECT_TRUE(note());
}

TEST(clearance_plot, draws_the_scan_under_both_mountings_and_zooms) {
  ClearancePlot plot;
  plot.resize(500, 320);
  plot.show_scan("scan7.pcd", measured({}));
  const double before = plot.pixels_per_m();
  const QPointF wall = plot.to_screen(8.0, 2.0);
  const QImage picture = plot.grab().toImage();
  const auto has = [&](QColor color, QPointF place) {
    for (int dx = -2; dx <= 2; ++dx)
      if (picture.pixelColor(place.toPoint() + QPoint(dx, 0)) == color) return true;
    return false;
  };
  EXPECT_TRUE(has(after_color(plot.palette()), wall));
  EXPECT_TRUE(has(before_color(plot.palette()), plot.to_screen(8.3, 2.0)));
  QTest::keyClick(&plot, Qt::Key_Plus);
  EXPECT_GT(plot.pixels_per_m(), before);
  QTest::keyClick(&plot, Qt::Key_Home);
  EXPECT_NEAR(plot.pixels_per_m(), before, 1e-9);
  plot.show_message("no scan");
  EXPECT_NE(plot.grab().toImage(), picture);
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
    workbench_.calibrations().calibrate();
    ASSERT_TRUE(settle());
  }
};

TEST_F(quality_page, shows_the_vehicle_among_the_points_of_a_scan) {
  show();
  look_at(view().obstacles());
  const auto shows = [&](const QString& name) {
    return QTest::qWaitFor([&] { return view().obstacles()->plot()->name() == name; }, kPatience_ms);
  };
  EXPECT_TRUE(view().obstacles()->plot()->message().contains("After a calibration"));
  workbench_.setup().edit_nominal(RigidTransform::Identity());  // what the result is compared with
  calibrate_drive();
  ASSERT_TRUE(shows("scan0.pcd"));
  photograph(window_, "21-obstacles");
  auto& scan = *view().obstacles()->findChild<QSpinBox*>();
  EXPECT_EQ(scan.maximum(), 60);
  for (int step = 0; step < 5; ++step) scan.stepUp();
  EXPECT_TRUE(shows("scan5.pcd")) << "the last that was asked for";
  const auto figures = [&] {
    QStringList cells;
    const FigureTable& table = table_of(*view().obstacles());
    EXPECT_EQ(table.rowCount(), 3);
    for (int column = 1; column < table.columnCount(); ++column) cells << cell(table, 2, column);
    return cells;
  };
  const QStringList before = figures();
  workbench_.decisions().decide({PairIndex{1}, PairIndex{2}, PairIndex{4}, PairIndex{5}, PairIndex{6}, PairIndex{8},
                                 PairIndex{9}, PairIndex{11}, PairIndex{12}, PairIndex{13}},
                                motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(QTest::qWaitFor([&] { return figures() != before; }, kPatience_ms)) << "x has moved by a centimetre";
}

TEST_F(quality_page, measures_in_the_background_whatever_was_typed_last) {
  show();
  look_at(view().obstacles());
  calibrate_drive();
  ClearanceView& page = *view().obstacles();
  ASSERT_TRUE(QTest::qWaitFor([&] { return page.shows_scan(); }, kPatience_ms));
  const QString before = cell(table_of(page), 1, 3);
  QDoubleSpinBox* half_width = nullptr;
  for (auto* spin : page.findChildren<QDoubleSpinBox*>())
    if (spin->accessibleName() == "Half width") half_width = spin;
  ASSERT_TRUE(half_width);
  for (int step = 0; step < 5; ++step) half_width->stepUp();
  EXPECT_EQ(cell(table_of(page), 1, 3), before) << "not on the window's thread";
  const QString wider = QString::number(before.toDouble() - 0.5, 'f', 2);
  EXPECT_TRUE(QTest::qWaitFor([&] { return cell(table_of(page), 1, 3) == wider; }, kPatience_ms))
      << cell(table_of(page), 1, 3).toStdString() << " instead of " << wider.toStdString();
  EXPECT_EQ(cell(table_of(page), 0, 0), "Start") << "no nominal was given";
}

TEST(quality_failures, a_scan_that_cannot_be_read_is_said) {
  gui::Engine engine = testing::sample_engine(2);
  engine.load_keyframe_scan = [](const pipeline::PipelineInput&, const pipeline::PipelineOutput&, motion::KeyframeIndex,
                                 Progress&) -> cloud::PointCloud {
    throw Error(ErrorCode::Io, "scan0.pcd", Message::verbatim("cannot be read any more"));
  };
  gui::Workbench workbench(engine);
  QualityView view;
  gui::QualityController controller(workbench, view);
  view.show();
  workbench.sessions().open({"/data/drive1"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  workbench.calibrations().calibrate();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return view.obstacles()->plot()->message().contains("scan0.pcd: cannot be read any more"); },
      kPatience_ms));
  EXPECT_FALSE(controller.working());
}

TEST(hold_out, is_worked_out_again_for_every_result_that_is_looked_at) {
  std::atomic<int> asked = 0;
  gui::Engine engine = testing::sample_engine(2);
  const auto check = engine.check_hold_out;
  engine.check_hold_out = [&asked, check](const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output,
                                          Progress& progress) {
    ++asked;
    return check(input, output, progress);
  };
  gui::Workbench workbench(engine);
  QualityView view;
  const gui::QualityController controller(workbench, view);
  view.show();
  view.setCurrentWidget(view.hold_out());
  workbench.sessions().open({"/data/drive1", "/data/drive2"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench.sessions().all().size() == 2; }, kPatience_ms));
  workbench.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return asked == 1 && !workbench.activity().calibrating(); }, kPatience_ms));
  workbench.decisions().decide({PairIndex{1}, PairIndex{2}}, motion::PairState::Rejected);
  EXPECT_TRUE(QTest::qWaitFor([&] { return asked == 2; }, kPatience_ms));
}

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
  workbench_.decisions().decide({PairIndex{1}, PairIndex{2}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(says(*view().hold_out(), "drive1 and drive2: agree"));
}

TEST_F(quality_page, says_why_the_map_was_not_compared_and_leads_to_it) {
  show();
  calibrate_drive();
  look_at(view().sharpness());
  EXPECT_TRUE(says(*view().sharpness(), "no stretch of eight scans"));
  for (auto* button : view().sharpness()->findChildren<QPushButton*>())
    if (button->text() == "Map under the start") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(child<MapView>("map").chosen_x(), MapX::Nominal);
  EXPECT_TRUE(child<MapView>("map").isVisible());
  workbench_.decisions().decide({PairIndex{1}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(says(*view().sharpness(), "no stretch of eight scans")) << "calibrating again would not help";
}

TEST(result_panel, says_that_the_map_is_to_be_compared_again_only_where_it_was_compared) {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  pipeline::PipelineOutput output = testing::sample_output(input, 20);
  output.sharpness.clear();
  ResultPanel panel;
  const auto says_so = [&](pipeline::MapCheck check) {
    output.map_check = check;
    panel.show_output(std::make_shared<const pipeline::PipelineOutput>(output), nullptr, "reject pair 3");
    const auto labels = panel.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [](const QLabel* label) { return label->text().contains("result has moved"); });
  };
  EXPECT_TRUE(says_so(pipeline::MapCheck::Moved));
  EXPECT_FALSE(says_so(pipeline::MapCheck::SwitchedOff)) << "it was never measured";
}

TEST(quality_sharpness, is_compared_again_in_the_background_after_a_decision) {
  gui::Engine engine = testing::sample_engine(2);
  std::atomic<int> checks = 0;
  engine.solve_again = [solve = engine.solve_again](const pipeline::PipelineInput& input,
                                                    pipeline::PipelineOutput& output, Progress& progress) {
    output.map_check = pipeline::MapCheck::Moved;
    output.sharpness.clear();
    return solve(input, output, progress);
  };
  engine.check_map = [&checks](const pipeline::PipelineInput&, pipeline::PipelineOutput& output, Progress&) {
    ++checks;
    output.map_check = pipeline::MapCheck::Made;
    output.sharpness = {{calibration::MountingSource::Result, {-4.0, 0.020, 900}},
                        {calibration::MountingSource::Nominal, {-3.5, 0.035, 900}}};
  };
  gui::Workbench workbench(engine);
  QualityView view;
  const gui::QualityController controller(workbench, view);
  workbench.sessions().open({"/data/drive1"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().opening(); }, kPatience_ms));
  workbench.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().calibrating(); }, kPatience_ms));
  for (int pair = 1; pair < 5; ++pair)
    workbench.decisions().decide({index_at<PairIndex>(pair)}, motion::PairState::Rejected);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workbench.activity().solving(); }, kPatience_ms));
  EXPECT_TRUE(workbench.map_checks().checking());
  const int solution = workbench.outcome().solution();
  EXPECT_TRUE(verdict_of(*view.sharpness()).contains("compared again")) << verdict_of(*view.sharpness()).toStdString();
  EXPECT_TRUE(QTest::qWaitFor([&] { return verdict_of(*view.sharpness()).contains("became sharper"); }, kPatience_ms))
      << verdict_of(*view.sharpness()).toStdString();
  EXPECT_EQ(checks, 1) << "once for all decisions";
  EXPECT_FALSE(workbench.map_checks().checking() || workbench.solutions().incomplete());
  EXPECT_EQ(workbench.outcome().solution(), solution) << "X is the same: sessions are not compared anew";
}

}  // namespace
}  // namespace remount::widgets
