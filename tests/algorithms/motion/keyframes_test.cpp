#include "algorithms/motion/keyframes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace remount::motion {
namespace {

constexpr double kRate_hz = 10.0;

// Straight on at one metre a scan.
MotionTrack straight(int scans, double from_s = 0.0) {
  std::vector<StampedPose> samples;
  for (int i = 0; i < 10 * scans; ++i) {
    const double t = from_s + i / (10.0 * kRate_hz);
    samples.push_back({std::llround(t * 1e9), make_rigid(Eigen::Matrix3d::Identity(), {10.0 * t, 0, 0})});
  }
  return MotionTrack(samples);
}

std::vector<std::int64_t> stamps(int scans) {
  std::vector<std::int64_t> out;
  for (int i = 0; i < scans; ++i) out.push_back(std::llround(i / kRate_hz * 1e9));
  return out;
}

KeyframeOptions options_of(KeyframeMode mode) {
  KeyframeOptions options;
  options.mode = mode;
  options.minimum = 2;
  return options;
}

std::vector<std::size_t> scans_of(const std::vector<Keyframe>& keyframes) {
  std::vector<std::size_t> scans;
  for (const Keyframe& keyframe : keyframes) scans.push_back(keyframe.scan);
  return scans;
}

TEST(keyframes, distance_mode_takes_one_every_preset_distance) {
  KeyframeOptions options = options_of(KeyframeMode::Distance);
  options.distance_m = 4.9999;
  const std::vector<Keyframe> keyframes = select_keyframes(SessionIndex{3}, stamps(31), straight(40), 0.0, options);
  EXPECT_EQ(scans_of(keyframes), (std::vector<std::size_t>{0, 5, 10, 15, 20, 25, 30}));
  for (const Keyframe& keyframe : keyframes) {
    EXPECT_EQ(keyframe.session, SessionIndex{3});
    EXPECT_EQ(keyframe.stamp_ns, stamps(31)[keyframe.scan]);
    EXPECT_NEAR(keyframe.travelled_m, keyframe.scan, 1e-6);
  }
}

TEST(keyframes, time_mode_takes_one_every_preset_time_also_where_stamps_jitter) {
  KeyframeOptions options = options_of(KeyframeMode::Time);
  options.interval_s = 0.5;
  std::vector<std::int64_t> jittered = stamps(31);
  for (std::size_t i = 0; i < jittered.size(); ++i) jittered[i] += (i % 2 == 0 ? 1 : -1) * 200'000;
  jittered[0] = 200'000;
  for (const auto& scans : {stamps(31), jittered})
    EXPECT_EQ(scans_of(select_keyframes(SessionIndex{0}, scans, straight(40), 0.0, options)),
              (std::vector<std::size_t>{0, 5, 10, 15, 20, 25, 30}));
}

TEST(keyframes, turning_on_the_spot_takes_keyframes_by_the_turn) {
  std::vector<StampedPose> samples;
  for (int i = 0; i < 100; ++i)
    samples.push_back({i * 100'000'000LL, make_rigid(so3_exp({0, 0, degrees_to_radians(2.001 * i)}), {0, 0, 0})});
  KeyframeOptions options = options_of(KeyframeMode::Distance);
  options.rotation_deg = 10.0;
  EXPECT_EQ(scans_of(select_keyframes(SessionIndex{0}, stamps(16), MotionTrack(samples), 0.0, options)),
            (std::vector<std::size_t>{0, 5, 10, 15}));
}

TEST(keyframes, a_short_drive_takes_them_closer_until_there_are_enough) {
  for (const KeyframeMode mode : {KeyframeMode::Distance, KeyframeMode::Time}) {
    KeyframeOptions options = options_of(mode);
    options.distance_m = 30.0;
    options.interval_s = 3.0;
    options.minimum = 12;
    const std::size_t found = select_keyframes(SessionIndex{0}, stamps(31), straight(40), 0.0, options).size();
    EXPECT_GE(found, 12U);
    EXPECT_LT(found, 31U);
    options.minimum = 100;
    EXPECT_EQ(select_keyframes(SessionIndex{0}, stamps(31), straight(40), 0.0, options).size(), 31U)
        << "all scans at most";
  }
}

// At one metre a scan, turning by two degrees a scan from scan 120 to 139 and from 260 to 279.
MotionTrack with_two_turns(int scans) {
  std::vector<StampedPose> samples;
  double heading_rad = 0.0;
  for (int i = 0; i < scans; ++i) {
    if ((i > 120 && i < 140) || (i > 260 && i < 280)) heading_rad += degrees_to_radians(2.0);
    samples.push_back({std::llround(i / kRate_hz * 1e9), rigid_from_six({1.0 * i, 0, 0, heading_rad, 0, 0})});
  }
  return MotionTrack(samples);
}

TEST(keyframes, of_too_many_a_stretch_of_neighbours_stays_of_each_part_where_it_turns_most) {
  KeyframeOptions options = options_of(KeyframeMode::Distance);
  options.distance_m = 0.5;
  options.maximum = 60;
  const std::vector<std::size_t> chosen =
      scans_of(select_keyframes(SessionIndex{0}, stamps(300), with_two_turns(310), 0.0, options));
  ASSERT_EQ(chosen.size(), 60U);
  for (const auto& [place, scan] : {std::pair{20, 120}, std::pair{40, 260}})
    for (int i = 0; i < 20; ++i)
      EXPECT_NEAR(static_cast<double>(chosen[static_cast<std::size_t>(place + i)]), scan + i, 1.0) << place + i;
  EXPECT_LT(chosen[19], 100U) << "of the first part, which is straight";
  for (std::size_t i = 1; i < chosen.size(); ++i) EXPECT_LT(chosen[i - 1], chosen[i]);
}

TEST(keyframes, are_never_taken_twice_however_many_are_too_many) {
  for (const int maximum : {2, 19, 20, 21, 59, 121, 290, 299})
    for (const int scans : {130, 300}) {
      KeyframeOptions options = options_of(KeyframeMode::Distance);
      options.distance_m = 0.5;
      options.maximum = maximum;
      const std::vector<std::size_t> chosen =
          scans_of(select_keyframes(SessionIndex{0}, stamps(scans), straight(scans + 10), 0.0, options));
      EXPECT_LE(chosen.size(), static_cast<std::size_t>(maximum));
      EXPECT_GE(static_cast<double>(chosen.size()), 0.9 * std::min(maximum, scans)) << maximum << " of " << scans;
      for (std::size_t i = 1; i < chosen.size(); ++i) EXPECT_LT(chosen[i - 1], chosen[i]);
    }
}

TEST(keyframes, those_that_are_gathered_of_several_scans_have_all_of_them_and_none_in_common) {
  for (const int minimum : {2, 40}) {
    KeyframeOptions options = options_of(KeyframeMode::Distance);
    options.distance_m = 0.5;
    options.minimum = minimum;
    EXPECT_EQ(scans_of(select_keyframes(SessionIndex{0}, stamps(31), straight(40), 0.0, options, GatheredFrames{5})),
              (std::vector<std::size_t>{2, 7, 12, 17, 22, 27}));
    EXPECT_EQ(scans_of(select_keyframes(SessionIndex{0}, stamps(9), straight(40), 0.0, options, GatheredFrames{4})),
              (std::vector<std::size_t>{1, 5}))
        << "one before and two after";
  }
}

TEST(keyframes, scans_that_the_trajectory_does_not_cover_are_left_out) {
  KeyframeOptions options = options_of(KeyframeMode::Distance);
  options.distance_m = 0.5;
  const std::vector<Keyframe> late = select_keyframes(SessionIndex{0}, stamps(20), straight(40, 1.0), 0.0, options);
  ASSERT_FALSE(late.empty());
  EXPECT_EQ(late.front().scan, ScanIndex{10});
  // The clock offset moves the scans into the trajectory: t_ins = t_lidar + offset.
  EXPECT_EQ(select_keyframes(SessionIndex{0}, stamps(20), straight(40, 1.0), 0.5, options).front().scan, 5);
  EXPECT_TRUE(select_keyframes(SessionIndex{0}, stamps(20), MotionTrack(), 0.0, options).empty());
  EXPECT_TRUE(select_keyframes(SessionIndex{0}, {}, straight(40), 0.0, options).empty());
}

}  // namespace
}  // namespace remount::motion
