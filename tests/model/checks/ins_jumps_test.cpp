#include <gtest/gtest.h>

#include <random>

#include "algorithms/messages/render.h"
#include "model/checks/builtin.h"
#include "model/formats/files/time_stamp.h"
#include "model/overview/session_report.h"
#include "model/simulator/simulator.h"
#include "tests/model/checks/check_fixture.h"

namespace remount::checks {
namespace {

constexpr double kEarthRadius_m = 6.37e6;

TEST(ins_jump_check, a_step_of_half_a_metre_is_named_with_its_size_and_time) {
  drive::Session jump = good_drive();
  for (std::size_t i = 250; i < jump.ins.size(); ++i) jump.ins[i].latitude_rad += 0.5 / kEarthRadius_m;
  for (std::size_t i = 350; i < jump.ins.size(); ++i) jump.ins[i].height_m -= 1.25;
  const std::string said = testing::said_of(found_by(ins_jump_check(), jump), "ins-jump");
  EXPECT_EQ(said, "The position jumps 2 times, the farthest by 1.25 m at 2020-09-13 12:26:47.000 UTC.");
}

TEST(ins_jump_check, a_jump_far_away_is_named) {
  drive::Session jump = good_drive();
  for (std::size_t i = 250; i < 500; ++i) jump.ins[i].latitude_rad += 1e-4;
  EXPECT_TRUE(testing::has_code(found_by(ins_jump_check(), jump), "ins-jump"));
}

TEST(ins_jump_check, one_bad_position_is_one_jump_of_its_size_at_its_time) {
  for (const std::size_t bad : {0, 1, 20, 250, 480, 498, 499}) {
    drive::Session spike = good_drive();
    spike.ins[bad].height_m -= 248.0;
    const std::string said = testing::said_of(found_by(ins_jump_check(), spike), "ins-jump");
    // Where one side alone is long enough to tell the speed, the way back makes it a little wrong.
    const bool at_end = bad == 1 || bad == 498;
    EXPECT_EQ(said.find(at_end ? "The position jumps once, by 26" : "The position jumps once, by 248.0"), 0U)
        << bad << ": " << said;
    const std::size_t last = std::min<std::size_t>(bad + 1, 499);
    EXPECT_TRUE(said.find(formats::utc_text(spike.ins[bad].stamp_ns)) != std::string::npos ||
                said.find(formats::utc_text(spike.ins[last].stamp_ns)) != std::string::npos)
        << bad << ": " << said;
  }
}

TEST(ins_jump_check, one_bad_position_is_one_jump_at_every_rate) {
  for (const double rate_hz : {2.1, 2.5, 4.0, 5.0, 10.0, 50.0, 100.0}) {
    drive::Session spike = good_drive();
    for (std::size_t i = 0; i < spike.ins.size(); ++i) {  // 5 m/s
      spike.ins[i].stamp_ns = 1'600'000'000'000'000'000 + std::llround(1e9 * static_cast<double>(i) / rate_hz);
      spike.ins[i].latitude_rad = 0.85 + 5.0 * static_cast<double>(i) / rate_hz / kEarthRadius_m;
      spike.ins[i].enu_from_ins.setIdentity();
    }
    spike.ins[250].height_m -= 50.0;
    const std::vector<drive::Finding> findings = found_by(ins_jump_check(), spike);
    ASSERT_EQ(findings.size(), 1U) << rate_hz;
    EXPECT_EQ(english(findings[0].explanation).find("The position jumps once, by 50.0"), 0U)
        << rate_hz << ": " << english(findings[0].explanation);
  }
}

TEST(ins_jump_check, what_lies_beyond_a_gap_tells_no_speed) {
  drive::Session gap;
  for (int i = 0; i < 100; ++i) {  // at 10 Hz, half a second of it missing, 20 m farther behind
    if (i > 50 && i < 55) continue;
    motion::InsSample sample = good_drive().ins[0];
    sample.stamp_ns += i * std::int64_t{100'000'000};
    sample.latitude_rad += (0.5 * i + (i > 50 ? 20.0 : 0.0)) / kEarthRadius_m;
    gap.ins.push_back(sample);
  }
  EXPECT_TRUE(printed(found_by(ins_jump_check(), gap)).empty());
}

TEST(ins_jump_check, turns_that_begin_as_hard_as_vehicles_can_are_no_jumps) {
  for (const double rate_hz : {5.0, 10.0, 100.0}) {
    drive::Session slalom = good_drive(0.0, 0.0);
    double yaw_rad = 0.0;
    for (std::size_t i = 0; i < slalom.ins.size(); ++i) {
      const double time_s = static_cast<double>(i) / rate_hz;
      yaw_rad += 1.9 / rate_hz * std::asin(std::sin(kPi * time_s)) / kPi;  // +-1.9 rad/s^2 by turns of a second
      slalom.ins[i].stamp_ns = 1'600'000'000'000'000'000 + std::llround(1e9 * time_s);
      slalom.ins[i].enu_from_ins = Eigen::Quaterniond(rotation_from_yaw_pitch_roll({yaw_rad, 0.0, 0.0}));
    }
    EXPECT_EQ(testing::said_of(printed(found_by(ins_jump_check(), slalom)), "ins-attitude-jump"), "") << rate_hz;
  }
}

TEST(ins_jump_check, what_is_held_is_said_to_jump_only_where_it_goes_far_beyond) {
  drive::Session held = good_drive(180.0);
  for (std::size_t i = 0; i < held.ins.size(); ++i) {
    const motion::InsSample& from = held.ins[i - i % 25];
    held.ins[i].enu_from_ins = from.enu_from_ins;
    held.ins[i].latitude_rad = from.latitude_rad;
  }
  const auto said = [&](const std::string& code) {
    return testing::said_of(data_findings(held, LookAt::Streams, Progress()), code);
  };
  EXPECT_NE(said("ins-attitude-held"), "");
  EXPECT_NE(said("ins-position-held"), "");
  EXPECT_EQ(said("ins-attitude-jump"), "");
  EXPECT_EQ(said("ins-jump"), "");
  const Eigen::Quaterniond turn(rotation_from_yaw_pitch_roll({1.5, 0.0, 0.0}));
  for (std::size_t i = 250; i < held.ins.size(); ++i) {
    held.ins[i].latitude_rad += 20.0 / kEarthRadius_m;
    held.ins[i].enu_from_ins = turn * held.ins[i].enu_from_ins;
  }
  EXPECT_NE(said("ins-position-held"), "");
  EXPECT_EQ(said("ins-jump").find("The position jumps once, by 2"), 0U) << said("ins-jump");
  EXPECT_EQ(said("ins-attitude-jump").find("The attitude jumps once, by "), 0U) << said("ins-attitude-jump");
}

TEST(ins_jump_check, small_jumps_of_slow_logs_are_named) {
  for (const double rate_hz : {5.0, 10.0}) {
    drive::Session slow = good_drive();
    for (std::size_t i = 0; i < slow.ins.size(); ++i) {
      slow.ins[i].stamp_ns = 1'600'000'000'000'000'000 + std::llround(1e9 * static_cast<double>(i) / rate_hz);
      slow.ins[i].height_m += i >= 250 ? 0.35 : 0.0;
    }
    EXPECT_EQ(testing::said_of(found_by(ins_jump_check(), slow), "ins-jump").find("The position jumps once, by 0.35 m"),
              0U)
        << rate_hz;
  }
}

TEST(ins_jump_check, an_attitude_that_jumps_is_named) {
  for (const std::size_t bad : {0, 100, 499}) {
    drive::Session spike = good_drive();
    spike.ins[bad].enu_from_ins =
        Eigen::Quaterniond(rotation_from_yaw_pitch_roll({2.4, 0.0, 0.0})) * spike.ins[bad].enu_from_ins;
    const std::vector<drive::Finding> findings = found_by(ins_jump_check(), spike);
    EXPECT_EQ(testing::said_of(findings, "ins-attitude-jump").find("The attitude jumps once, by 137."), 0U)
        << bad << ": " << testing::said_of(findings, "ins-attitude-jump");
    EXPECT_FALSE(testing::has_code(findings, "ins-jump"));
  }
  drive::Session aligned = good_drive();
  const Eigen::Quaterniond turn(rotation_from_yaw_pitch_roll({0.2, 0.0, 0.0}));
  for (std::size_t i = 300; i < aligned.ins.size(); ++i)
    aligned.ins[i].enu_from_ins = turn * aligned.ins[i].enu_from_ins;
  EXPECT_EQ(testing::said_of(found_by(ins_jump_check(), aligned), "ins-attitude-jump"),
            "The attitude jumps once, by 11.5 deg at 2020-09-13 12:26:46.000 UTC.");
}

TEST(ins_jump_check, noise_braking_and_gaps_are_no_jumps) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.05);
  drive::Session noisy = good_drive();
  for (motion::InsSample& sample : noisy.ins) sample.latitude_rad += noise(random) / kEarthRadius_m;
  EXPECT_EQ(testing::said_of(found_by(ins_jump_check(), noisy), "ins-jump"), "") << "0.05 m of white noise";
  drive::Session braking = good_drive();
  for (std::size_t i = 0; i < braking.ins.size(); ++i) {
    const double time_s = 0.02 * static_cast<double>(i), stop_s = 5.0;
    const double travelled_m = time_s < stop_s ? 20.0 * time_s
                                               : 20.0 * stop_s + 20.0 * std::min(time_s - stop_s, 2.0) -
                                                     5.0 * std::pow(std::min(time_s - stop_s, 2.0), 2);
    braking.ins[i].latitude_rad = 0.85 + travelled_m / kEarthRadius_m;
  }
  EXPECT_EQ(testing::said_of(found_by(ins_jump_check(), braking), "ins-jump"), "") << "at 10 m/s^2";
  drive::Session gap = good_drive();
  gap.ins.erase(gap.ins.begin() + 100, gap.ins.begin() + 200);
  EXPECT_EQ(testing::said_of(found_by(ins_jump_check(), gap), "ins-jump"), "") << "which ins-gaps names";
}

TEST(ins_jump_check, simulated_drives_do_not_jump) {
  for (const simulator::ScenarioKind scenario :
       {simulator::ScenarioKind::Street, simulator::ScenarioKind::ParkingRamp, simulator::ScenarioKind::FigureEight,
        simulator::ScenarioKind::Hill, simulator::ScenarioKind::Highway, simulator::ScenarioKind::SlewYard})
    for (const double rate_hz : {2.5, 10.0, 100.0}) {
      simulator::SimulationOptions options;
      options.scenario = scenario;
      options.duration_s = 10.0;
      options.ins_rate_hz = rate_hz;
      options.beams = 2;
      options.azimuth_steps = 20;
      EXPECT_TRUE(printed(found_by(ins_jump_check(), simulator::simulate_drive(options).session)).empty())
          << static_cast<int>(scenario) << " " << rate_hz;
    }
}

}  // namespace
}  // namespace remount::checks
