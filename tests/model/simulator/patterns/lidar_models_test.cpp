#include "model/simulator/patterns/lidar_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "model/simulator/patterns/woven_patterns.h"

namespace remount::simulator {
namespace {

constexpr std::size_t kFramesOfAnHour = 36'000;

struct SeenField {
  double left_deg = -1e3, right_deg = 1e3, low_deg = 1e3, high_deg = -1e3;

  void add(const std::vector<Firing>& firings) {
    for (const Firing& firing : firings) {
      left_deg = std::max(left_deg, radians_to_degrees(firing.azimuth_rad));
      right_deg = std::min(right_deg, radians_to_degrees(firing.azimuth_rad));
      low_deg = std::min(low_deg, radians_to_degrees(firing.elevation_rad));
      high_deg = std::max(high_deg, radians_to_degrees(firing.elevation_rad));
    }
  }
};

/// Mean angle from the directions of one frame to those of the same shots of another, degrees.
double apart_deg(const std::vector<Firing>& a, const std::vector<Firing>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += std::abs(a[i].azimuth_rad - b[i].azimuth_rad) + std::abs(a[i].elevation_rad - b[i].elevation_rad);
  return radians_to_degrees(sum / static_cast<double>(a.size()));
}

bool repeats(const LidarModel& model) {
  return model.id == "spinning" || model.id == "m1" || model.id == "e1" || model.id == "at128" || model.id == "qt128" ||
         model.id == "falcon-k";
}

TEST(lidar_models, have_the_field_and_the_points_of_their_data_sheets) {
  for (const LidarModel& model : lidar_models()) {
    const LidarFigures& sheet = model.figures;
    if (sheet.points_per_s == 0) continue;
    const auto pattern = model.make({.frame_rate_hz = sheet.frame_rate_hz});
    SeenField seen;
    for (const std::size_t frame : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}) seen.add(pattern->firings(frame));
    const double points_per_s = static_cast<double>(pattern->firings(0).size()) * sheet.frame_rate_hz;
    std::printf("  %-10s %8.0f points/s, %6.1f to %5.1f deg across, %5.1f to %4.1f deg up\n", model.id.data(),
                points_per_s, seen.right_deg, seen.left_deg, seen.low_deg, seen.high_deg);
    EXPECT_NEAR(points_per_s / sheet.points_per_s, 1.0, 0.005) << model.id;
    const double near_deg = 0.01 * sheet.width_deg;
    EXPECT_NEAR(seen.left_deg, 0.5 * sheet.width_deg, near_deg) << model.id;
    EXPECT_NEAR(seen.right_deg, -0.5 * sheet.width_deg, near_deg) << model.id;
    EXPECT_NEAR(seen.low_deg, sheet.low_deg, near_deg) << model.id;
    EXPECT_NEAR(seen.high_deg, sheet.high_deg, near_deg) << model.id;
  }
}

TEST(lidar_models, fire_in_the_order_of_time_within_the_frame_by_channels_that_they_have) {
  for (const LidarModel& model : lidar_models()) {
    const auto pattern = model.make({.points_per_frame = 3000});
    const std::vector<Firing> firings = pattern->firings(7);
    EXPECT_NEAR(static_cast<double>(firings.size()), 3000.0, 400.0) << model.id;
    double last = 0.0;
    std::vector<bool> used(static_cast<std::size_t>(pattern->channels()), false);
    for (const Firing& firing : firings) {
      ASSERT_GE(firing.share, last) << model.id;
      ASSERT_LT(firing.share, 1.0) << model.id;
      ASSERT_LT(firing.channel, pattern->channels()) << model.id;
      last = firing.share;
      used[firing.channel] = true;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << model.id;
  }
}

TEST(lidar_models, rings_are_of_one_elevation_each_the_lowest_first) {
  for (const LidarModel& model : lidar_models()) {
    if (!model.has_rings) continue;
    const auto pattern = model.make({.points_per_frame = 4000});
    std::vector<double> elevation_rad(static_cast<std::size_t>(pattern->channels()), std::nan(""));
    for (const Firing& firing : pattern->firings(0)) {
      double& known = elevation_rad[firing.channel];
      ASSERT_TRUE(std::isnan(known) || known == firing.elevation_rad) << model.id;
      known = firing.elevation_rad;
    }
    for (std::size_t i = 1; i < elevation_rad.size(); ++i) ASSERT_GT(elevation_rad[i], elevation_rad[i - 1]);
  }
}

TEST(lidar_models, repeat_their_frames_or_never_do_in_an_hour) {
  for (const LidarModel& model : lidar_models()) {
    const auto pattern = model.make({.points_per_frame = 96});
    const std::vector<Firing> first = pattern->firings(0);
    if (repeats(model)) {
      EXPECT_EQ(apart_deg(first, pattern->firings(kFramesOfAnHour)), 0.0) << model.id;
      continue;
    }
    double nearest_deg = 1e3;
    std::size_t which = 0;
    for (std::size_t frame = 1; frame <= kFramesOfAnHour; ++frame) {
      const double apart = apart_deg(first, pattern->firings(frame));
      if (apart < nearest_deg) nearest_deg = apart, which = frame;
    }
    std::printf("  %-10s the frame of an hour that is most like the first is number %zu, %.3f deg from it\n",
                model.id.data(), which, nearest_deg);
    EXPECT_GT(nearest_deg, 0.02) << model.id;
  }
}

TEST(lidar_models, cover_more_of_their_field_from_frame_to_frame_where_they_do_not_repeat) {
  constexpr int kCells = 40;
  for (const LidarModel& model : lidar_models()) {
    if (model.figures.points_per_s == 0) continue;
    const auto pattern = model.make({.points_per_frame = 1500});
    std::vector<bool> seen(kCells * kCells, false);
    std::vector<std::ptrdiff_t> cells;
    for (std::size_t frame = 0; frame < 10; ++frame) {
      for (const Firing& firing : pattern->firings(frame)) {
        const auto cell = [](double angle_deg, double low_deg, double high_deg) {
          return std::clamp(static_cast<int>((angle_deg - low_deg) / (high_deg - low_deg) * kCells), 0, kCells - 1);
        };
        const int x =
            cell(radians_to_degrees(firing.azimuth_rad), -0.5 * model.figures.width_deg, 0.5 * model.figures.width_deg);
        const int y = cell(radians_to_degrees(firing.elevation_rad), model.figures.low_deg, model.figures.high_deg);
        seen[static_cast<std::size_t>(y * kCells + x)] = true;
      }
      cells.push_back(std::count(seen.begin(), seen.end(), true));
    }
    EXPECT_EQ(cells.back() == cells.front(), repeats(model)) << model.id;
    EXPECT_TRUE(repeats(model) || cells.back() > 5 * cells.front() / 4) << model.id;
  }
}

TEST(lidar_models, a_rosette_runs_backwards_through_the_places_where_it_would_have_been_before) {
  const PatternSettings forwards{.points_per_frame = 1000, .field_deg = 60.0};
  PatternSettings backwards = forwards;
  backwards.backwards = true;
  const auto there = lidar_model(lidar_named("rosette")).make(forwards)->firings(0);
  const auto back = lidar_model(lidar_named("rosette")).make(backwards)->firings(0);
  // Both prisms begin at the same place: what was before it is what comes after it, mirrored.
  for (std::size_t i = 0; i < there.size(); ++i) {
    ASSERT_NEAR(there[i].azimuth_rad, back[i].azimuth_rad, 1e-9);
    ASSERT_NEAR(there[i].elevation_rad, -back[i].elevation_rad, 1e-9);
  }
  EXPECT_GT(apart_deg(there, back), 1.0);
}

TEST(lidar_models, a_turn_is_as_exact_after_a_day_as_at_first) {
  const double turns_per_shot = 121.5663 / 452'000.0;
  const Turning turning(turns_per_shot), other_way(-turns_per_shot);
  for (const std::uint64_t shot : {std::uint64_t{1}, std::uint64_t{45'200}, std::uint64_t{452'000} * 86'400}) {
    const long double exact =
        std::fmod(static_cast<long double>(turns_per_shot) * static_cast<long double>(shot), 1.0L);
    EXPECT_NEAR(turning.phase(shot), static_cast<double>(exact), 1e-8) << shot;
    EXPECT_NEAR(turning.phase(shot) + other_way.phase(shot), 1.0, 1e-15) << shot;
  }
}

TEST(lidar_models, are_known_by_their_names_and_no_other) {
  for (std::size_t i = 0; i < lidar_models().size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(lidar_named(lidar_models()[i].id)), i);
    EXPECT_EQ(std::count(lidar_model_names().begin(), lidar_model_names().end(), lidar_models()[i].id), 1);
  }
  EXPECT_EQ(lidar_model(LidarChoice{}).id, "spinning");
  EXPECT_THROW(lidar_named("mid-41"), Error);
}

}  // namespace
}  // namespace remount::simulator
