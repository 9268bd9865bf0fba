#include <gtest/gtest.h>

#include "model/checks/builtin.h"
#include "model/drive/session_frames.h"
#include "tests/model/checks/check_fixture.h"

namespace remount::checks {
namespace {

/// Forty seconds at 50 Hz and 5 m/s through two full circles, with the trembling of a vehicle in its attitude.
drive::Session circles(double mps = 5.0) {
  drive::Session session = good_drive();
  session.ins.clear();
  for (int i = 0; i < 2000; ++i) {
    motion::InsSample sample;
    const double time_s = 0.02 * i, heading = 4.0 * kPi * time_s / 40.0, radius_m = mps * 40.0 / (4.0 * kPi);
    sample.stamp_ns = std::int64_t{1'600'000'000'000'000'000} + i * std::int64_t{20'000'000};
    sample.latitude_rad = 0.85 + radius_m * (1.0 - std::cos(heading)) / 6.37e6;
    sample.longitude_rad = 0.15 + radius_m * std::sin(heading) / 6.37e6 / std::cos(0.85);
    sample.enu_from_ins = Eigen::Quaterniond(
        rotation_from_yaw_pitch_roll({heading, 0.001 * std::sin(11.0 * time_s), 0.001 * std::sin(7.0 * time_s)}));
    sample.quality = motion::InsQuality::Good;
    session.ins.push_back(sample);
  }
  return session;
}

/// From `first` to `last` the attitude of the first, or its position.
void freeze(drive::Session& session, std::size_t first, std::size_t last, bool attitude) {
  const motion::InsSample at = session.ins[first];
  for (std::size_t i = first; i < last; ++i) {
    motion::InsSample& sample = session.ins[i];
    if (attitude) sample.enu_from_ins = at.enu_from_ins;
    if (!attitude) sample.latitude_rad = at.latitude_rad, sample.longitude_rad = at.longitude_rad;
  }
}

std::vector<drive::Finding> found_frozen(const drive::Session& session) {
  return printed(found_by(frozen_part_check(), session));
}

TEST(frozen_part_check, an_attitude_that_stands_still_in_a_turn_is_named) {
  drive::Session session = circles();
  freeze(session, 500, 800, true);
  EXPECT_EQ(testing::said_of(found_frozen(session), "ins-attitude-frozen"),
            "The INS repeats one attitude for 6.0 s, while its positions run through a turn.");
  drive::Session all = circles();
  freeze(all, 0, all.ins.size(), true);
  EXPECT_TRUE(testing::has_code(found_frozen(all), "ins-attitude-frozen")) << "over all of the drive";
  EXPECT_FALSE(testing::has_code(found_frozen(all), "ins-position-frozen"));
  EXPECT_FALSE(testing::has_code(found_by(ins_solution_check(), session), "ins-frozen")) << "the pose as a whole moves";
}

TEST(frozen_part_check, a_position_that_stands_still_while_the_attitude_turns_is_named) {
  drive::Session session = circles();
  freeze(session, 500, 650, false);
  EXPECT_EQ(testing::said_of(found_frozen(session), "ins-position-frozen"),
            "The INS repeats one position for 3.0 s, while its attitude changes and the vehicle drives on.");
  drive::Session all = circles();
  freeze(all, 0, all.ins.size(), false);
  EXPECT_TRUE(testing::has_code(found_frozen(all), "ins-position-frozen")) << "over all of the drive";
  drive::Session end = circles();
  freeze(end, 1500, end.ins.size(), false);
  EXPECT_TRUE(testing::has_code(found_frozen(end), "ins-position-frozen")) << "to its end";
}

TEST(frozen_part_check, poses_are_judged_as_samples_are) {
  drive::Session samples = circles(), poses;
  freeze(samples, 500, 800, true);
  freeze(samples, 1000, 1150, false);
  poses.world_from_ins = drive::metric_poses(samples);
  for (std::size_t i = 0; i < poses.world_from_ins.size(); ++i)
    poses.world_from_ins[i].pose.linear() = samples.ins[i].enu_from_ins.toRotationMatrix();
  const std::vector<drive::Finding> findings = found_frozen(poses);
  EXPECT_TRUE(testing::has_code(findings, "ins-attitude-frozen"));
  EXPECT_TRUE(testing::has_code(findings, "ins-position-frozen"));
}

TEST(frozen_part_check, a_vehicle_that_stands_is_not_frozen) {
  drive::Session trembling = circles(), pinned = circles();
  // It stands for twenty seconds: its place is held, or it wanders by centimetres; its attitude is held, or trembles.
  for (drive::Session* session : {&trembling, &pinned}) {
    const motion::InsSample stop = session->ins[500];
    for (std::size_t i = 501; i < session->ins.size(); ++i) {
      motion::InsSample& sample = session->ins[i];
      const std::int64_t stamp_ns = sample.stamp_ns;
      if (i >= 1500) sample = circles().ins[i - 1000];
      if (i < 1500) sample = stop;
      sample.stamp_ns = stamp_ns;
      const double tremble = 1e-4 * std::sin(0.3 * static_cast<double>(i));
      if (session == &trembling && i < 1500)
        sample.enu_from_ins = stop.enu_from_ins * Eigen::Quaterniond(rotation_from_yaw_pitch_roll({tremble, 0, 0}));
      if (session == &pinned && i < 1500) sample.latitude_rad += 3.0 * tremble * 1e3 / 6.37e6;
    }
    EXPECT_TRUE(found_frozen(*session).empty());
  }
}

TEST(frozen_part_check, halves_that_are_logged_at_different_rates_are_not_frozen) {
  drive::Session slow_position = circles(), slow_attitude = circles();
  for (std::size_t i = 0; i < slow_position.ins.size(); ++i) {
    const std::size_t held = i - i % 75;  // 1.5 s
    slow_position.ins[i].latitude_rad = slow_position.ins[held].latitude_rad;
    slow_position.ins[i].longitude_rad = slow_position.ins[held].longitude_rad;
    slow_attitude.ins[i].enu_from_ins = slow_attitude.ins[held].enu_from_ins;
  }
  EXPECT_TRUE(found_frozen(slow_position).empty());
  EXPECT_TRUE(found_frozen(slow_attitude).empty());
}

TEST(frozen_part_check, a_rounded_attitude_on_a_straight_road_there_and_back_is_not_frozen) {
  drive::Session session = good_drive(0.0, 0.0);
  const std::size_t count = session.ins.size();
  for (std::size_t i = count / 2; i < count; ++i) {  // backwards, as it came
    session.ins[i].latitude_rad = session.ins[count - i].latitude_rad;
    session.ins[i].longitude_rad = session.ins[count - i].longitude_rad;
  }
  EXPECT_TRUE(found_frozen(session).empty());
  EXPECT_TRUE(found_frozen(good_drive(0.0, 0.0)).empty());
  EXPECT_TRUE(found_frozen(good_drive()).empty());
  EXPECT_TRUE(found_frozen(drive::Session{}).empty());
}

}  // namespace
}  // namespace remount::checks
