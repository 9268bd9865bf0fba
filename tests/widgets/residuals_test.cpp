// The residuals plot: the values of its points, what is hit, what a lasso marks, and how long a picture takes.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QWheelEvent>

#include "algorithms/calibration/joint/pair_equation.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/turn_profile.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/residuals/residuals_panel.h"
#include "widgets/text/pair_reasons.h"

namespace remount::widgets {

using motion::PairIndex;

namespace {

std::shared_ptr<pipeline::PipelineOutput> plotted_output(int pairs) {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  return std::make_shared<pipeline::PipelineOutput>(testing::sample_output(input, pairs));
}

/// Registered so that pair i is off by (i + 1) times `step`, in cm and degrees on the screen.
std::shared_ptr<pipeline::PipelineOutput> output_off_by(const Vector6d& step, int pairs) {
  auto output = plotted_output(pairs);
  const RigidTransform& x = output->result.mounting.ins_from_lidar();
  for (std::size_t i = 0; i < output->pairs.size(); ++i) {
    motion::Pair& pair = output->pairs[i];
    const RigidTransform predicted = calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, x);
    const Vector6d off = static_cast<double>(i + 1) * step;
    pair.lidar_b_from_lidar_a = make_rigid(so3_exp(Eigen::Vector3d(-off.tail<3>())) * predicted.linear(),
                                           predicted.translation() - off.head<3>());
    pair.residual_translation_m = off.head<3>().norm();
    pair.residual_rotation_rad = off.tail<3>().norm();
  }
  return output;
}

TEST(residual_values, have_the_six_components_of_each_pair_and_their_norms) {
  Vector6d step;
  step << 0.01, -0.02, 0.03, 1e-4, 2e-4, -3e-4;
  const auto output = output_off_by(step, 20);
  const std::array components{ResidualMeasure::X,    ResidualMeasure::Y,     ResidualMeasure::Z,
                              ResidualMeasure::Roll, ResidualMeasure::Pitch, ResidualMeasure::Yaw};
  double worst = 0.0;
  for (int row = 0; row < 6; ++row) {
    const std::vector<double> values = values_of(*output, components.at(index_at(row)));
    ASSERT_EQ(values.size(), 20U);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double expected = static_cast<double>(i + 1) * step[row] * (row < 3 ? 100.0 : radians_to_degrees(1.0));
      worst = std::max(worst, std::abs(values[i] - expected));
    }
  }
  std::printf("components off by %.1e cm or degrees at most\n", worst);
  EXPECT_LT(worst, 1e-9);
  EXPECT_NEAR(values_of(*output, ResidualMeasure::Translation)[4], 500.0 * step.head<3>().norm(), 1e-9);
  EXPECT_NEAR(values_of(*output, ResidualMeasure::Rotation)[4], radians_to_degrees(5.0 * step.tail<3>().norm()), 1e-9);
  EXPECT_NEAR(values_of(*output, ResidualMeasure::Overlap)[4], 100.0 * output->pairs[4].registration.overlap, 1e-9);
}

TEST(residual_values, tell_nothing_where_nothing_is_known) {
  auto output = plotted_output(10);
  output->pairs[3].registration = {};
  for (const ResidualMeasure measure : kResidualMeasures) {
    const std::vector<double> values = values_of(*output, measure);
    EXPECT_TRUE(std::isnan(values[3])) << name_of(measure).toStdString();
    EXPECT_TRUE(std::isfinite(values[2])) << name_of(measure).toStdString();
  }
  output->result.conclude(calibration::Status::TooFewPairs, Message::verbatim("too few"));
  EXPECT_TRUE(std::isnan(values_of(*output, ResidualMeasure::X)[2])) << "there is no X to compare with";
  output->pairs[1].gap_s = 0.0;
  EXPECT_TRUE(std::isnan(values_of(*output, PairCircumstance::Speed)[1]));
}

TEST(residual_values, know_how_the_vehicle_moved) {
  const auto output = plotted_output(20);
  const motion::Pair& pair = output->pairs[6];  // scans 6 and 9, a metre and 0.1 s apart each
  ASSERT_NEAR(pair.gap_s, 0.3, 1e-12);
  EXPECT_NEAR(values_of(*output, PairCircumstance::Time)[6], 0.75, 1e-9);
  EXPECT_NEAR(values_of(*output, PairCircumstance::Speed)[6], 10.0, 1e-9);
  EXPECT_NEAR(values_of(*output, PairCircumstance::TurnRate)[6], radians_to_degrees(pair.rotation_rad) / 0.3, 1e-9);
  EXPECT_NEAR(values_of(*output, PairCircumstance::Gap)[6], 0.3, 1e-12);
  EXPECT_NEAR(values_of(*output, PairCircumstance::Baseline)[6], pair.baseline_m, 1e-12);
  EXPECT_NEAR(values_of(*output, PairCircumstance::Rotation)[6], radians_to_degrees(pair.rotation_rad), 1e-12);
  output->keyframes[6].session = motion::SessionIndex{1};
  const std::vector<double> sessions = values_of(*output, PairCircumstance::Session);
  EXPECT_NEAR(sessions[6], 2.0, 1e-12) << "alone in its strip";
  EXPECT_GE(sessions[0], 0.7);
  EXPECT_LE(sessions[19], 1.3);
  EXPECT_LT(sessions[0], sessions[19]) << "in the order of the list";
}

TEST(plot_frame, zooms_about_what_stays_and_pans_with_the_hand) {
  PlotFrame frame{{50, 10, 400, 200}, {0.0, 8.0}, {-2.0, 2.0}};
  EXPECT_EQ(frame.place_of(2.0, 1.0), QPointF(150, 60));
  EXPECT_NEAR(frame.x_at(150), 2.0, 1e-12);
  EXPECT_NEAR(frame.y_at(60), 1.0, 1e-12);
  frame.across = zoomed(frame.across, 2.0, 0.5, {0.0, 8.0});
  EXPECT_NEAR(frame.x_of(2.0), 150.0, 1e-9);
  EXPECT_NEAR(frame.across.length(), 4.0, 1e-12);
  frame.pan({30, -20});
  EXPECT_NEAR(frame.x_of(2.0), 180.0, 1e-9);
  EXPECT_NEAR(frame.y_of(1.0), 40.0, 1e-9);
  for (int i = 0; i < 200; ++i) frame.across = zoomed(frame.across, 2.0, 0.5, {0.0, 8.0});
  EXPECT_NEAR(frame.across.length(), 8e-5, 1e-12) << "no nearer";
  EXPECT_TRUE(frame.across.holds(2.0));
  for (const auto& [low, high] : {std::pair{3.0, 3.0}, {0.0, 0.0}, {INFINITY, -INFINITY}})
    EXPECT_GT(span_with_room(low, high, 0.05).length(), 0.0);
  EXPECT_NEAR(wheel_factor(120) * wheel_factor(-120), 1.0, 1e-12);
}

class residual_plot : public ::testing::Test {
 protected:
  residual_plot() {
    plot_.resize(700, 320);
    plot_.show();
    plot_.show_output(plotted_output(300));
    plot_.show_all();
  }
  void draw(const QPolygonF& line, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&plot_, Qt::LeftButton, modifiers, line.front().toPoint());
    for (const QPointF& place : line) QTest::mouseMove(&plot_, place.toPoint());
    QTest::mouseRelease(&plot_, Qt::LeftButton, modifiers, line.back().toPoint());
  }
  std::vector<PairIndex> inside(const QPolygonF& line) const {
    std::vector<PairIndex> pairs;
    for (PairIndex i; i < 300U; ++i)
      if (const auto place = plot_.place_of(i); place && line.containsPoint(*place, Qt::OddEvenFill))
        pairs.push_back(i);
    return pairs;
  }
  const testing::LanguageFor english_{"en"};
  ResidualPlot plot_;
};

TEST_F(residual_plot, finds_the_pair_at_its_point_and_none_beside) {
  for (PairIndex i; i < 300U; ++i) {
    const auto place = plot_.place_of(i);
    ASSERT_TRUE(place) << i;
    const auto found = plot_.pair_at(*place);
    ASSERT_TRUE(found) << i;
    EXPECT_LT((*plot_.place_of(*found) - *place).manhattanLength(), 1e-9) << "of points on one another either";
  }
  EXPECT_FALSE(plot_.pair_at({2, 2}));
  QSignalSpy clicked(&plot_, &ResidualPlot::pair_clicked);
  QTest::mouseClick(&plot_, Qt::LeftButton, {}, plot_.place_of(PairIndex{17})->toPoint());
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_TRUE(plot_.marked().empty()) << "a click is no lasso";
}

TEST_F(residual_plot, a_lasso_marks_exactly_what_it_encloses) {
  const QRectF area = plot_.frame().area;
  const auto at = [&](double right, double down) {
    return QPointF(QPointF(area.left() + right * area.width(), area.top() + down * area.height()).toPoint());
  };
  // Concave, so that a box or a hull about it would take others too.
  const QPolygonF first{at(0.05, 0.98), at(0.1, 0.3), at(0.4, 0.1), at(0.35, 0.8), at(0.7, 0.2), at(0.6, 0.99)};
  const std::vector<PairIndex> expected = inside(first);
  ASSERT_GT(expected.size(), 20U);
  ASSERT_LT(expected.size(), 280U);
  draw(first);
  EXPECT_EQ(plot_.marked(), expected);
  const QPolygonF second{at(0.75, 0.01), at(0.99, 0.01), at(0.99, 0.99), at(0.75, 0.99)};
  std::vector<PairIndex> both = expected;
  for (const PairIndex pair : inside(second)) both.push_back(pair);
  std::sort(both.begin(), both.end());
  both.erase(std::unique(both.begin(), both.end()), both.end());
  ASSERT_GT(both.size(), expected.size());
  draw(second, Qt::ShiftModifier);
  EXPECT_EQ(plot_.marked(), both) << "with Shift beside those before";
  draw(second);
  EXPECT_EQ(plot_.marked(), inside(second));
  std::printf("lassos marked %zu, %zu and %zu of 300\n", expected.size(), both.size(), inside(second).size());
  for (const PairIndex pair : plot_.marked_and_kept()) EXPECT_NE(pair % 7, 3U) << "these are rejected already";
  EXPECT_LT(plot_.marked_and_kept().size(), plot_.marked().size());
  plot_.show_state_of_pairs(motion::PairState::Rejected, false);
  draw(second);
  EXPECT_EQ(plot_.marked().size(), plot_.marked_and_kept().size()) << "what is hidden is not taken";
  QTest::keyClick(&plot_, Qt::Key_Escape);
  EXPECT_TRUE(plot_.marked().empty());
}

TEST_F(residual_plot, the_wheel_zooms_dragging_pans_and_a_double_click_shows_the_usual_again) {
  plot_.show_usual();
  const PlotFrame before = plot_.frame();
  const QPointF about = plot_.frame().area.center();
  QWheelEvent wheel(about, plot_.mapToGlobal(about), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&plot_, &wheel);
  EXPECT_NEAR(plot_.frame().across.length(), before.across.length() / 1.44, 1e-9);
  EXPECT_NEAR(plot_.frame().x_at(about.x()), before.x_at(about.x()), 1e-9);
  EXPECT_GT(plot_.summary().outside, 0);
  const PlotFrame near = plot_.frame();
  for (const auto button : {Qt::RightButton, Qt::MiddleButton}) {
    QTest::mousePress(&plot_, button, {}, {200, 150});
    QTest::mouseMove(&plot_, {240, 130});
    QTest::mouseRelease(&plot_, button, {}, {240, 130});
  }
  EXPECT_NEAR(plot_.frame().x_of(near.x_at(200)), 280.0, 1e-6);
  EXPECT_NEAR(plot_.frame().y_of(near.y_at(150)), 110.0, 1e-6);
  EXPECT_TRUE(plot_.marked().empty());
  QTest::mouseDClick(&plot_, Qt::LeftButton, {}, {300, 100});
  EXPECT_EQ(plot_.frame().across, before.across);
  EXPECT_EQ(plot_.frame().up, before.up);
  QTest::mouseDClick(&plot_, Qt::LeftButton, {}, {300, 100});
  EXPECT_EQ(plot_.summary().outside, 0) << "once more: all of them";
}

TEST_F(residual_plot, tells_what_it_holds_and_each_pair_in_words) {
  const auto output = plotted_output(300);
  double sum = 0.0, squares = 0.0;
  int accepted = 0;
  for (const motion::Pair& pair : output->pairs) {
    if (pair.state != motion::PairState::Accepted) continue;
    sum += 100.0 * pair.residual_translation_m;
    squares += 1e4 * pair.residual_translation_m * pair.residual_translation_m;
    ++accepted;
  }
  const ResidualSummary summary = plot_.summary();
  EXPECT_EQ(summary.drawn, 300);
  EXPECT_EQ(summary.outside, 0);
  EXPECT_EQ(summary.accepted, accepted);
  EXPECT_NEAR(summary.mean, sum / accepted, 1e-9);
  EXPECT_NEAR(summary.deviation, std::sqrt((squares - sum * sum / accepted) / (accepted - 1)), 1e-9);
  EXPECT_TRUE(plot_.words_of(PairIndex{3}).startsWith("pair 3: 12 cm at 0.")) << plot_.words_of({}).toStdString();
  EXPECT_TRUE(plot_.words_of(PairIndex{3}).contains("rejected"));
  plot_.show_session_names({"tuesday"});
  plot_.set_axes(ResidualMeasure::Yaw, PairCircumstance::Session);
  EXPECT_TRUE(plot_.words_of(PairIndex{3}).contains("tuesday")) << plot_.words_of(PairIndex{3}).toStdString();
}

TEST_F(residual_plot, the_keys_step_and_mark) {
  QSignalSpy clicked(&plot_, &ResidualPlot::pair_clicked);
  QTest::keyClick(&plot_, Qt::Key_Right);
  ASSERT_EQ(clicked.count(), 1);
  const PairIndex first = clicked[0][0].value<PairIndex>();
  plot_.show_selected(first);
  QTest::keyClick(&plot_, Qt::Key_Right);
  const PairIndex second = clicked.last()[0].value<PairIndex>();
  EXPECT_GE(plot_.place_of(second)->x(), plot_.place_of(first)->x());
  EXPECT_NE(first, second);
  QTest::keyClick(&plot_, Qt::Key_Space);
  EXPECT_EQ(plot_.marked(), std::vector{first});
  QTest::keyClick(&plot_, Qt::Key_Space);
  EXPECT_TRUE(plot_.marked().empty());
}

TEST(residual_plot_time, a_hundred_thousand_points_stay_fluid) {
  ResidualPlot plot;
  plot.resize(900, 320);
  plot.show();
  const auto output = plotted_output(100000);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (motion::Pair& pair : output->pairs) pair.gap_s = 0.05 + unit(random);  // spread over the whole picture
  const auto longest_of = [&](int turns, const auto& turn) {
    double longest_ms = 0.0;
    for (int i = 0; i < turns; ++i) {
      const double start_ms = testing::thread_cpu_ms();
      turn(i);
      plot.grab();
      longest_ms = std::max(longest_ms, testing::thread_cpu_ms() - start_ms);
    }
    return longest_ms;
  };
  const double shown = longest_of(1, [&](int) { plot.show_output(output); });
  const double axes = longest_of(2, [&](int i) {
    plot.set_axes(i == 0 ? ResidualMeasure::Yaw : ResidualMeasure::Translation, PairCircumstance::TurnRate);
  });
  const double zoom = longest_of(6, [&](int i) { QTest::keyClick(&plot, i < 3 ? Qt::Key_Plus : Qt::Key_Minus); });
  const double hover = longest_of(10, [&](int i) { QTest::mouseMove(&plot, QPoint(200 + 20 * i, 150)); });
  QPolygonF circle;
  for (int i = 0; i < 200; ++i) circle << QPointF(400 + 250 * std::cos(0.0314 * i), 160 + 120 * std::sin(0.0314 * i));
  std::vector<PairIndex> within;
  const double lasso = longest_of(1, [&](int) { plot.mark(within = plot.pairs_within(circle)); });
  std::printf(
      "100,000 points, longest in ms of this thread with the picture: shown %.0f, other axes %.0f, zoom %.0f, hover "
      "%.0f, lasso of %zu pairs %.0f\n",
      shown, axes, zoom, hover, within.size(), lasso);
  EXPECT_GT(within.size(), 1000U);
  for (const double taken_ms : {shown, axes, zoom, hover, lasso})
    EXPECT_LT(taken_ms, 400.0 * testing::kSanitizerSlowdown);
}

class residuals_panel : public testing::WindowFixture {
 protected:
  ResidualsPanel& panel() { return child<ResidualsPanel>(); }
  void show_panel() {
    show();
    calibrate_drive();
    child<QDockWidget>("residuals").raise();
    QTest::qWait(50);
  }
  const testing::LanguageFor english_{"en"};
};

TEST_F(residuals_panel, a_click_selects_everywhere_and_what_is_selected_elsewhere_is_marked_here) {
  show_panel();
  ResidualPlot& plot = *panel().plot();
  const QPoint place = plot.place_of(PairIndex{12})->toPoint();
  const auto there = plot.pair_at(place);
  QTest::mouseClick(&plot, Qt::LeftButton, {}, place);
  EXPECT_EQ(workbench_.selection().pair(), there);
  photograph(window_, "50-residuals");
}

/// On a small screen the docks beside leave it little.
TEST(residuals_panel_layout, of_a_narrow_panel_gives_the_plot_all_of_its_width) {
  ResidualsPanel panel;
  for (const int width : {420, 900}) {
    panel.resize(width, 260);
    panel.show();
    QApplication::processEvents();
    std::cout << width << " px: the plot has " << panel.plot()->width() << " x " << panel.plot()->height() << "\n";
    EXPECT_GT(panel.plot()->width(), width < 500 ? width - 20 : width - 220);
    EXPECT_GT(panel.plot()->height(), 150);
    EXPECT_TRUE(
        panel.rect().contains(QRect(panel.reject_button()->mapTo(&panel, QPoint()), panel.reject_button()->size())));
  }
}

TEST_F(residuals_panel, rejects_what_is_marked_with_a_reason_in_one_step) {
  show_panel();
  ResidualPlot& plot = *panel().plot();
  panel().choose(ResidualMeasure::X, PairCircumstance::Speed);
  EXPECT_FALSE(panel().reject_button()->isEnabled());
  plot.mark({PairIndex{3}, PairIndex{5}, PairIndex{20}});  // the first is rejected already
  EXPECT_EQ(panel().reject_button()->text(), "Reject 2 marked");
  panel().reject_button()->click();
  EXPECT_EQ(edits_since_calibration(), 1);
  for (const std::size_t index : {5U, 20U}) {
    EXPECT_EQ(pair(index).state, motion::PairState::Rejected);
    EXPECT_EQ(pair(index).decided_by, motion::DecidedBy::User);
    EXPECT_EQ(reason_words(pair(index).reason), "marked in the plot: residual x over speed");
  }
  EXPECT_NE(pair(3).decided_by, motion::DecidedBy::User);
  EXPECT_TRUE(plot.marked().empty());
  ASSERT_TRUE(settle());
  workbench_.history().stack().undo();
  EXPECT_EQ(pair(5).state, motion::PairState::Accepted);
}

}  // namespace
}  // namespace remount::widgets
