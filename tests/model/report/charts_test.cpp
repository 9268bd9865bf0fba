#include "model/report/charts.h"

#include <gtest/gtest.h>

namespace remount::report {
namespace {

template <class Shape>
std::vector<Shape> shapes_of(const Drawing& drawing) {
  std::vector<Shape> found;
  for (const auto& shape : drawing.shapes)
    if (const auto* wanted = std::get_if<Shape>(&shape)) found.push_back(*wanted);
  return found;
}

std::string words_of(const Drawing& drawing) {
  std::string words = drawing.description;
  for (const DrawnText& text : shapes_of<DrawnText>(drawing)) words.append("\n").append(text.text);
  return words;
}

/// Ten metres east, then five north, at 45 degrees of latitude.
drive::Session geographic_drive() {
  constexpr double kMetre_rad = 1.0 / 6378137.0;
  drive::Session session;
  session.name = "geographic";
  for (const auto& [east, north] : {std::pair{0.0, 0.0}, {10.0, 0.0}, {10.0, 5.0}}) {
    motion::InsSample sample;
    sample.stamp_ns = 1'700'000'000'000'000'000 + static_cast<std::int64_t>(session.ins.size()) * 1'000'000'000;
    sample.latitude_rad = 0.25 * kPi + north * kMetre_rad;
    sample.longitude_rad = 0.157 + east * kMetre_rad / std::cos(0.25 * kPi);  // 9 degrees: the middle of zone 32
    session.ins.push_back(sample);
  }
  return session;
}

drive::Session posed_drive() {
  drive::Session session;
  session.name = "poses";
  for (const double x : {100.0, 110.0, 130.0}) {
    motion::StampedPose pose;
    pose.pose.translation() << x, 7.0, 0.0;
    session.world_from_ins.push_back(pose);
  }
  return session;
}

TEST(report_charts, a_geographic_track_is_east_and_north_in_metres) {
  const ReportTrack track = track_of(geographic_drive());
  EXPECT_TRUE(track.geographic);
  ASSERT_EQ(track.points_m.size(), 3U);
  EXPECT_LT((track.points_m[2] - Eigen::Vector2d(10.0, 5.0)).norm(), 0.1) << track.points_m[2].transpose();
  const std::string words = words_of(track_chart(track, Language::English));
  EXPECT_NE(words.find("east to the right, north up"), std::string::npos) << words;
}

TEST(report_charts, poses_alone_have_neither_east_nor_north) {
  const ReportTrack track = track_of(posed_drive());
  EXPECT_FALSE(track.geographic);
  const std::string words = words_of(track_chart(track, Language::English));
  EXPECT_EQ(words.find("north"), std::string::npos) << words;
  EXPECT_EQ(words.find("east"), std::string::npos) << words;
  EXPECT_EQ(words.find("above"), std::string::npos) << "which way z points is not said: " << words;
  EXPECT_NE(words.find("x to the right, y up"), std::string::npos) << words;
}

TEST(report_charts, a_track_is_drawn_to_scale_and_says_whose_it_is) {
  const Drawing drawing =
      track_chart({"drive <1>", true, {{0, 0}, {40, 0}, {40, 10}, {std::nan(""), 0}}}, Language::English);
  const auto lines = shapes_of<DrawnLine>(drawing);
  ASSERT_EQ(lines.size(), 2U) << "track and scale bar";
  ASSERT_EQ(lines[0].points.size(), 3U) << "what is no number is left out";
  const Eigen::Vector2d east = lines[0].points[1] - lines[0].points[0], north = lines[0].points[2] - lines[0].points[1];
  EXPECT_GT(east.x(), 0.0);
  EXPECT_NEAR(east.y(), 0.0, 1e-9);
  EXPECT_LT(north.y(), 0.0) << "a drawing's y goes downwards";
  EXPECT_NEAR(-north.y() / east.x(), 10.0 / 40.0, 1e-9) << "equal scales";
  EXPECT_NE(words_of(drawing).find("5 m"), std::string::npos) << words_of(drawing);
  EXPECT_NEAR((lines[1].points[1] - lines[1].points[0]).norm(), east.x() / 8.0, 1e-9) << "5 m of 40 m";
  for (const DrawnLine& line : lines)
    for (const Eigen::Vector2d& point : line.points)
      EXPECT_TRUE(point.x() >= 0 && point.x() <= drawing.width && point.y() >= 0 && point.y() <= drawing.height);
  EXPECT_NE(words_of(drawing).find("drive <1>"), std::string::npos);
}

TEST(report_charts, a_session_without_positions_says_so) {
  const Drawing drawing = track_chart({"drive1", false, {}}, Language::English);
  EXPECT_TRUE(shapes_of<DrawnLine>(drawing).empty());
  EXPECT_NE(words_of(drawing).find("No positions"), std::string::npos);
}

TEST(report_charts, bars_are_as_high_as_the_residuals) {
  std::vector<results::PairRecord> pairs(3);
  pairs[0].residual_translation_m = 0.10;
  pairs[1].residual_translation_m = 0.05;
  pairs[2].residual_translation_m = std::nan("");
  pairs[1].state = motion::PairState::Rejected;
  const auto bars = shapes_of<DrawnBox>(residual_chart(pairs, ChartedResidual::Translation, Language::English));
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_NEAR(bars[1].size.y() / bars[0].size.y(), 0.5, 1e-9);
  EXPECT_NE(bars[0].color, bars[1].color) << "rejected ones are told apart";
}

TEST(report_charts, a_wild_pair_that_was_rejected_leaves_the_others_their_height) {
  std::vector<results::PairRecord> pairs(3);
  pairs[0].residual_translation_m = pairs[1].residual_translation_m = 0.01;
  pairs[0].state = pairs[1].state = motion::PairState::Accepted;
  pairs[2].residual_translation_m = 2.0;
  pairs[2].state = motion::PairState::Rejected;
  const Drawing drawing = residual_chart(pairs, ChartedResidual::Translation, Language::English);
  const auto bars = shapes_of<DrawnBox>(drawing);
  ASSERT_EQ(bars.size(), 3U);
  EXPECT_NEAR(bars[0].size.y() / bars[2].size.y(), 0.5, 1e-9) << "the axis ends at 2 cm";
  EXPECT_NE(words_of(drawing).find("higher bars are cut"), std::string::npos);
  pairs.pop_back();
  EXPECT_EQ(words_of(residual_chart(pairs, ChartedResidual::Translation, Language::English)).find("are cut"),
            std::string::npos);
}

}  // namespace
}  // namespace remount::report
