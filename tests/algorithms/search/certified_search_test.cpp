#include "algorithms/search/certified_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "algorithms/messages/render.h"
#include "algorithms/search/boxed_form.h"
#include "algorithms/search/candidates.h"
#include "tests/algorithms/support/random_motion.h"
#include "tests/support/sanitized.h"

namespace remount::search {
namespace {

struct SearchDrive {
  Eigen::Vector3d axes, travel;
};
const SearchDrive kGeneral{{1, 1, 1}, {1, 1, 1}}, kWeakTilt{{0.1, 0.1, 1}, {1, 1, 1}}, kPlanar{{0, 0, 1}, {1, 1, 0}},
    kStraight{{0, 0, 0}, {1, 0, 0}};

std::vector<MotionPair> pairs_of(std::mt19937_64& random, const RigidTransform& truth, const SearchDrive& drive,
                                 double noise, double outliers, int count = 60) {
  std::vector<MotionPair> pairs = testing::exact_pairs(random, truth, count, drive.axes, drive.travel);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    RigidTransform& measured = pairs[i].lidar_b_from_lidar_a;
    measured = perturb(measured, noise * testing::random_step(random, 0.01, 1e-3));
    if (static_cast<double>(i % 10) < 10.0 * outliers)
      measured = perturb(measured, testing::random_step(random, 1.0, 0.1));
  }
  return pairs;
}

struct Timed {
  SearchResult result;
  double seconds = 0.0;
};

Timed search(const QuadraticForm& form, const calibration::SearchRange& range,
             const RigidTransform& near = RigidTransform::Identity()) {
  const std::clock_t start = std::clock();
  Timed out;
  out.result = certified_search(form, range, near, {}, {});
  out.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return out;
}

struct Box {
  Vector6d low, high;
};
Box box_of(const calibration::SearchRange& range) {
  Box box;
  box.low << range.x_min_m, range.y_min_m, range.z_min_m, std::max(-kPi, range.yaw_min_rad),
      std::max(-kPi / 2, range.pitch_min_rad), std::max(-kPi, range.roll_min_rad);
  box.high << range.x_max_m, range.y_max_m, range.z_max_m, std::min(kPi, range.yaw_max_rad),
      std::min(kPi / 2, range.pitch_max_rad), std::min(kPi, range.roll_max_rad);
  return box;
}
RigidTransform at(const Vector6d& six) { return rigid_from_six({six[0], six[1], six[2], six[3], six[4], six[5]}); }

// Random descent inside the box: slow, and nothing in common with the search.
double descended(const QuadraticForm& form, const Box& box, Vector6d six, std::mt19937_64& random) {
  double best = form.value(at(six)), width = 0.2;
  for (int i = 0; i < 20000; ++i) {
    Vector6d next = six + testing::random_step(random, width, width);
    for (int k = 0; k < 6; ++k)
      if (random() % 2 == 0) next[k] = six[k];
    next = next.cwiseMax(box.low).cwiseMin(box.high);
    const double value = form.value(at(next));
    width = value < best ? width * 1.5 : std::max(width * 0.99, 1e-8);
    if (value < best) {
      best = value;
      six = next;
    }
    if (i % 4000 == 3999) width = 0.1;
  }
  return best;
}

// An exhaustive grid of the range, whose best points are followed down.
double exhaustive(const QuadraticForm& form, const calibration::SearchRange& range, std::mt19937_64& random) {
  const Box box = box_of(range);
  const BoxedForm boxed(form, range, Eigen::Vector3d::Zero());
  constexpr int kSteps = 18;
  std::vector<std::pair<double, Vector6d>> grid;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j)
      for (int k = 0; k <= kSteps; ++k) {
        Vector6d six = box.low;
        six.tail<3>() += Eigen::Vector3d(i, j, k).cwiseProduct((box.high - box.low).tail<3>()) / kSteps;
        const RigidTransform best = boxed.best_at(at(six).linear());
        six.head<3>() = best.translation();
        grid.emplace_back(form.value(best), six);
      }
  std::partial_sort(grid.begin(), grid.begin() + 8, grid.end(),
                    [](const auto& a, const auto& b) { return a.first < b.first; });
  double best = grid.front().first;
  for (int i = 0; i < 8; ++i)
    best = std::min(best, descended(form, box, grid[static_cast<std::size_t>(i)].second, random));
  return best;
}

void expect_certified(const QuadraticForm& form, const calibration::SearchRange& range, const Timed& timed) {
  const SearchResult& result = timed.result;
  EXPECT_EQ(result.outcome, SearchOutcome::Certified) << english(result.message);
  EXPECT_LE(result.gap(), result.allowed_gap) << english(result.message);
  const double scale = form.matrix().topLeftCorner<9, 9>().trace() + form.matrix()(12, 12);
  EXPECT_LE(result.allowed_gap, std::max(1e-6 * result.value, 1e-12 * scale));
  EXPECT_EQ(calibration::outside_range(result.ins_from_lidar, range), Message());
  EXPECT_NEAR(form.value(result.ins_from_lidar), result.value, 1e-12 * scale);
  EXPECT_LT(timed.seconds, 1.0 * testing::kSanitizerSlowdown);
}

// No X of the range may score less than the bound: random ones, and ones near the optimum.
void expect_bound_holds(const QuadraticForm& form, const calibration::SearchRange& range, const SearchResult& result,
                        std::mt19937_64& random) {
  const Box box = box_of(range);
  const BoxedForm boxed(form, range, result.ins_from_lidar.translation());
  const SixParameters found = six_from_rigid(result.ins_from_lidar);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 6000; ++i) {
    Vector6d six;
    for (int k = 0; k < 6; ++k) six[k] = box.low[k] + share(random) * (box.high[k] - box.low[k]);
    if (i % 2 == 0) {
      const double width = std::pow(10.0, -6.0 * share(random));
      six.tail<3>() =
          Eigen::Vector3d(found.yaw_rad, found.pitch_rad, found.roll_rad) + testing::random_vector(random, width);
      six = six.cwiseMax(box.low).cwiseMin(box.high);
    }
    least = std::min(least, form.value(boxed.best_at(at(six).linear())));
  }
  const double rounding = 1e-14 * (form.matrix().topLeftCorner<9, 9>().trace() + form.matrix()(12, 12));
  EXPECT_GE(least, result.lower_bound - rounding) << english(result.message);
}

TEST(certified_search, finds_the_truth_anywhere_in_the_default_range) {
  std::mt19937_64 random(1);
  const calibration::SearchRange range;
  double slowest = 0.0;
  for (const double noise : {0.0, 1.0})
    for (int trial = 0; trial < 20; ++trial) {
      const RigidTransform truth = testing::random_rigid(random, 1.0);
      const QuadraticForm form(pairs_of(random, truth, trial % 2 == 0 ? kGeneral : kWeakTilt, noise, 0.0), 1.0);
      const Timed timed = search(form, range);
      expect_certified(form, range, timed);
      EXPECT_LT(rotation_angle_between_rad(timed.result.ins_from_lidar, truth), noise > 0.0 ? 5e-3 : 1e-6);
      EXPECT_TRUE(timed.result.unique) << english(timed.result.message);
      slowest = std::max(slowest, timed.seconds);
    }
  std::printf("  slowest %.1f ms\n", 1e3 * slowest);
}

TEST(certified_search, near_half_turns_of_yaw_and_near_vertical_pitch) {
  std::mt19937_64 random(2);
  const calibration::SearchRange range;
  for (const double yaw_deg : {180.0, -179.99, 179.99, 90.0})
    for (const double pitch_deg : {0.0, 89.0, 89.999, 90.0, -89.99, -90.0}) {
      const Eigen::Matrix3d rotation =
          rotation_from_yaw_pitch_roll({degrees_to_radians(yaw_deg), degrees_to_radians(pitch_deg), 0.3});
      const RigidTransform truth = make_rigid(rotation, {1.0, -2.0, 1.5});
      const QuadraticForm form(pairs_of(random, truth, kGeneral, 1.0, 0.0), 1.0);
      const Timed timed = search(form, range);
      expect_certified(form, range, timed);
      EXPECT_LT(rotation_angle_between_rad(timed.result.ins_from_lidar, truth), 5e-3) << yaw_deg << " " << pitch_deg;
    }
}

TEST(certified_search, the_bound_holds_and_an_exhaustive_grid_finds_nothing_better) {
  std::mt19937_64 random(3);
  const SearchDrive drives[] = {kGeneral, kPlanar, kWeakTilt, kStraight};
  double slowest = 0.0;
  int regions = 0;
  for (int trial = 0; trial < 16; ++trial) {
    const RigidTransform truth = testing::random_rigid(random, 1.0);
    const SixParameters six = six_from_rigid(truth);
    const QuadraticForm form(pairs_of(random, truth, drives[trial % 4], 1.0, trial % 3 == 0 ? 0.4 : 0.0), 1.0);
    calibration::SearchRange range;  // the truth inside, on the edge, outside by some parameters or by all
    const double off = trial / 4 == 0 ? -0.5 : trial / 4 == 1 ? 0.0 : 0.3;
    range.yaw_min_rad = std::clamp(six.yaw_rad + off, -3.15, 2.0);
    range.yaw_max_rad = range.yaw_min_rad + 1.1;
    range.pitch_max_rad = std::clamp(six.pitch_rad - off, -1.2, 3.15);
    if (trial / 4 == 3) range.roll_min_rad = std::min(2.0, six.roll_rad + 0.2);
    range.x_min_m = six.x_m + off;
    if (trial % 2 == 0) range.z_max_m = six.z_m - 0.5 * off;
    const Timed timed = search(form, range);
    expect_certified(form, range, timed);
    expect_bound_holds(form, range, timed.result, random);
    const double best = exhaustive(form, range, random);
    EXPECT_GE(best, timed.result.value - timed.result.allowed_gap) << trial << ": " << english(timed.result.message);
    EXPECT_LE(timed.result.value, best + timed.result.allowed_gap) << trial << ": " << english(timed.result.message);
    slowest = std::max(slowest, timed.seconds);
    regions = std::max(regions, timed.result.regions);
  }
  std::printf("  slowest %.1f ms, at most %d regions\n", 1e3 * slowest, regions);
}

TEST(certified_search, random_ranges_are_certified_too) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const SearchDrive drives[] = {kGeneral, kPlanar, kWeakTilt, kStraight};
  const auto interval = [&](double& low, double& high, double reach) {
    const double a = (2.0 * share(random) - 1.0) * reach, b = (2.0 * share(random) - 1.0) * reach;
    if (share(random) < 0.4) return;
    low = std::min(a, b);
    high = std::max(a, b);
  };
  double slowest = 0.0;
  for (int trial = 0; trial < 60; ++trial) {
    RigidTransform truth = testing::random_rigid(random, 1.0);
    if (trial % 3 == 1)
      truth.linear() =
          rotation_from_yaw_pitch_roll({6.0 * share(random) - 3.0, trial % 2 == 0 ? kPi / 2 : -1.569, 1.0});
    const QuadraticForm form(pairs_of(random, truth, drives[trial % 4], 1.0, trial % 2 == 0 ? 0.4 : 0.0, 30), 1.0);
    calibration::SearchRange range;
    interval(range.yaw_min_rad, range.yaw_max_rad, 3.15);
    interval(range.pitch_min_rad, range.pitch_max_rad, 1.55);
    interval(range.roll_min_rad, range.roll_max_rad, 3.15);
    interval(range.x_min_m, range.x_max_m, 3.0);
    interval(range.y_min_m, range.y_max_m, 3.0);
    interval(range.z_min_m, range.z_max_m, 3.0);
    const Timed timed = search(form, range);
    expect_certified(form, range, timed);
    expect_bound_holds(form, range, timed.result, random);
    slowest = std::max(slowest, timed.seconds);
  }
  std::printf("  slowest %.1f ms\n", 1e3 * slowest);
}

TEST(certified_search, forty_percent_outliers_still_give_the_global_optimum_of_the_squares) {
  std::mt19937_64 random(5);
  const calibration::SearchRange range;
  for (int trial = 0; trial < 5; ++trial) {
    const QuadraticForm form(pairs_of(random, testing::random_rigid(random, 1.0), kGeneral, 1.0, 0.4, 200), 1.0);
    const Timed timed = search(form, range);
    expect_certified(form, range, timed);
    expect_bound_holds(form, range, timed.result, random);
    EXPECT_GE(exhaustive(form, range, random), timed.result.value - timed.result.allowed_gap);
  }
}

TEST(certified_search, planar_and_straight_driving_are_certified_and_said_not_to_be_unique) {
  std::mt19937_64 random(6);
  const calibration::SearchRange range;
  for (const SearchDrive& drive : {kPlanar, kStraight})
    for (const double noise : {0.0, 1.0}) {
      const RigidTransform truth = make_rigid(so3_exp({0.2, -0.1, 2.0}), {1.0, 0.5, 1.5});
      const QuadraticForm form(pairs_of(random, truth, drive, noise, 0.0), 1.0);
      const Timed timed = search(form, range, make_rigid(Eigen::Matrix3d::Identity(), {0.0, 0.0, 1.25}));
      expect_certified(form, range, timed);
      EXPECT_FALSE(timed.result.unique);
      EXPECT_NE(english(timed.result.message).find("others score the same"), std::string::npos)
          << english(timed.result.message);
      if (noise == 0.0) {
        EXPECT_NEAR(timed.result.ins_from_lidar.translation().z(), 1.25, 1e-6) << "nothing moves the height";
      }
    }
}

TEST(certified_search, limits_of_no_width_are_kept) {
  std::mt19937_64 random(7);
  const RigidTransform truth = make_rigid(so3_exp({0.2, -0.1, 0.7}), {1.0, 0.5, 1.5});
  const QuadraticForm form(pairs_of(random, truth, kGeneral, 1.0, 0.0), 1.0);
  calibration::SearchRange range;
  range.z_min_m = range.z_max_m = 1.8;
  const Timed held_z = search(form, range);
  expect_certified(form, range, held_z);
  EXPECT_EQ(held_z.result.ins_from_lidar.translation().z(), 1.8);
  range.roll_min_rad = range.roll_max_rad = 0.1;
  const SearchResult held_roll = search(form, range).result;
  EXPECT_NEAR(six_from_rigid(held_roll.ins_from_lidar).roll_rad, 0.1, 1e-9);
  EXPECT_LT(held_roll.gap(), 1e-4 * held_roll.value) << english(held_roll.message);
}

TEST(certified_search, time_does_not_depend_on_the_number_of_pairs) {
  std::mt19937_64 random(8);
  const RigidTransform truth = testing::random_rigid(random, 1.0);
  for (const int count : {10, 1000, 20000}) {
    const QuadraticForm form(pairs_of(random, truth, kGeneral, 1.0, 0.0, count), 1.0);
    const Timed timed = search(form, {});
    expect_certified(form, {}, timed);
    std::printf("  %d pairs: %.1f ms\n", count, 1e3 * timed.seconds);
  }
}

TEST(certified_search, says_why_not) {
  std::mt19937_64 random(9);
  const std::vector<MotionPair> pairs = pairs_of(random, testing::random_rigid(random, 1.0), kGeneral, 1.0, 0.0);
  const QuadraticForm form(pairs, 1.0);
  calibration::SearchRange range;
  range.x_min_m = 6.0;
  EXPECT_EQ(search(form, range).result.outcome, SearchOutcome::EmptyRange);
  range = {};
  range.pitch_min_rad = 2.0;  // canonical pitch never exceeds 90 deg
  EXPECT_EQ(search(form, range).result.outcome, SearchOutcome::EmptyRange);
  range = {};
  range.yaw_max_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(search(form, range).result.outcome, SearchOutcome::NotFinite);
  std::vector<MotionPair> broken = pairs;
  broken[3].ins_b_from_ins_a.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(search(QuadraticForm(broken, 1.0), {}).result.outcome, SearchOutcome::NotFinite);
  std::stop_source stop;
  stop.request_stop();
  const SearchResult cancelled = certified_search(form, {}, RigidTransform::Identity(), {}, Progress(stop.get_token()));
  EXPECT_EQ(cancelled.outcome, SearchOutcome::Cancelled);
  SearchOptions none;
  none.most_regions = 0;
  const SearchResult open = certified_search(form, {}, RigidTransform::Identity(), none, {});
  EXPECT_EQ(open.outcome, SearchOutcome::GapOpen);
  EXPECT_EQ(open.lower_bound, 0.0);
  EXPECT_FALSE(english(open.message).empty());
}

TEST(certified_search, nothing_to_go_by_is_not_unique) {
  const QuadraticForm form(std::vector<MotionPair>(5), 1.0);
  const SearchResult result = search(form, {}).result;
  EXPECT_EQ(result.outcome, SearchOutcome::Certified);
  EXPECT_FALSE(result.unique);
}

}  // namespace
}  // namespace remount::search
