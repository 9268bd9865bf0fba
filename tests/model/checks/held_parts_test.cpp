#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/checks/builtin.h"
#include "model/drive/session_frames.h"
#include "model/formats/session_readers.h"
#include "model/overview/session_report.h"
#include "model/simulator/simulator.h"
#include "tests/model/checks/check_fixture.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::checks {
namespace {

drive::Session simulated(simulator::ScenarioKind scenario = simulator::ScenarioKind::Street, double duration_s = 20.0,
                         double ins_rate_hz = 100.0) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = duration_s;
  options.ins_rate_hz = ins_rate_hz;
  options.beams = 4;
  options.azimuth_steps = 20;
  return simulator::simulate_drive(options).session;
}

enum class Part { Attitude, Heading, Position, Latitude };

/// Every `samples`-th value of that part stays until the next.
drive::Session held(drive::Session session, std::size_t samples, Part part) {
  for (std::size_t i = 0; i < session.ins.size(); ++i) {
    const motion::InsSample from = session.ins[i - i % samples];
    motion::InsSample& sample = session.ins[i];
    if (part == Part::Attitude) sample.enu_from_ins = from.enu_from_ins;
    if (part == Part::Heading) {
      YawPitchRoll angles = yaw_pitch_roll_from_rotation(sample.enu_from_ins.toRotationMatrix());
      angles.yaw_rad = yaw_pitch_roll_from_rotation(from.enu_from_ins.toRotationMatrix()).yaw_rad;
      sample.enu_from_ins = Eigen::Quaterniond(rotation_from_yaw_pitch_roll(angles));
    }
    if (part == Part::Latitude) sample.latitude_rad = from.latitude_rad;
    if (part == Part::Position)
      sample.latitude_rad = from.latitude_rad, sample.longitude_rad = from.longitude_rad,
      sample.height_m = from.height_m;
  }
  return session;
}

std::vector<drive::Finding> found_held(const drive::Session& session) {
  return printed(found_by(held_part_check(), session));
}

TEST(held_part_check, attitudes_that_are_held_are_named_with_the_step) {
  const std::vector<drive::Finding> findings = found_held(held(simulated(), 20, Part::Attitude));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "ins-attitude-held");
  EXPECT_NE(english(findings[0].explanation).find("for 0.200 s at a time (20 samples)"), std::string::npos);
  EXPECT_TRUE(testing::has_code(found_held(held(simulated(), 5, Part::Attitude)), "ins-attitude-held"));
  EXPECT_TRUE(testing::has_code(found_held(held(simulated(simulator::ScenarioKind::FigureEight), 10, Part::Attitude)),
                                "ins-attitude-held"));
}

TEST(held_part_check, positions_that_are_held_are_named_with_the_step) {
  const std::vector<drive::Finding> findings = found_held(held(simulated(), 20, Part::Position));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "ins-position-held");
  EXPECT_NE(english(findings[0].explanation).find("for 0.200 s at a time (20 samples)"), std::string::npos);
  EXPECT_EQ(found_held(held(held(simulated(), 10, Part::Position), 10, Part::Attitude)).size(), 2U) << "both";
}

TEST(held_part_check, one_number_that_is_held_is_named) {
  for (const std::size_t samples : {5, 10, 50}) {
    const std::vector<drive::Finding> headings =
        found_held(held(simulated(simulator::ScenarioKind::FigureEight), samples, Part::Heading));
    ASSERT_EQ(headings.size(), 1U) << samples;
    EXPECT_EQ(headings[0].code, "ins-attitude-held");
    EXPECT_EQ(english(headings[0].explanation).find("The heading alone stands still"), 0U)
        << english(headings[0].explanation);
  }
  const std::vector<drive::Finding> latitudes = found_held(held(simulated(), 10, Part::Latitude));
  ASSERT_EQ(latitudes.size(), 1U);
  EXPECT_EQ(latitudes[0].code, "ins-position-held");
  EXPECT_EQ(english(latitudes[0].explanation).find("One number of the position, latitude, stands still for 0.100 s"),
            0U);
  drive::Session poses;
  poses.world_from_ins = drive::metric_poses(simulated());
  for (std::size_t i = 0; i < poses.world_from_ins.size(); ++i)
    poses.world_from_ins[i].pose.translation().x() = poses.world_from_ins[i - i % 10].pose.translation().x();
  EXPECT_EQ(
      testing::said_of(found_held(poses), "ins-position-held").find("One number of the position, x, stands still"), 0U);
}

TEST(held_part_check, poses_are_judged_as_samples_are) {
  const drive::Session samples = held(simulated(), 20, Part::Attitude);
  drive::Session poses;
  poses.world_from_ins = drive::metric_poses(samples);
  for (std::size_t i = 0; i < poses.world_from_ins.size(); ++i)
    poses.world_from_ins[i].pose.linear() = samples.ins[i].enu_from_ins.toRotationMatrix();
  EXPECT_TRUE(testing::has_code(found_held(poses), "ins-attitude-held"));
}

TEST(held_part_check, what_is_only_rounded_or_repeated_now_and_then_is_not_held) {
  drive::Session rounded = simulated(), dropped = simulated();
  const double unit = degrees_to_radians(0.01), place = degrees_to_radians(1e-8);
  for (motion::InsSample& sample : rounded.ins) {
    const YawPitchRoll angles = yaw_pitch_roll_from_rotation(sample.enu_from_ins.toRotationMatrix());
    sample.enu_from_ins = Eigen::Quaterniond(rotation_from_yaw_pitch_roll({unit * std::round(angles.yaw_rad / unit),
                                                                           unit * std::round(angles.pitch_rad / unit),
                                                                           unit * std::round(angles.roll_rad / unit)}));
    sample.latitude_rad = place * std::round(sample.latitude_rad / place);
    sample.longitude_rad = place * std::round(sample.longitude_rad / place);
  }
  EXPECT_TRUE(found_held(rounded).empty());
  for (std::size_t i = 1; i < dropped.ins.size(); ++i)
    if (i % 7 == 0) {
      const std::int64_t stamp_ns = dropped.ins[i].stamp_ns;
      dropped.ins[i] = dropped.ins[i - 1];
      dropped.ins[i].stamp_ns = stamp_ns;
    }
  EXPECT_TRUE(found_held(dropped).empty());
}

TEST(held_part_check, coordinates_and_headings_with_few_digits_are_not_held) {
  for (const double speed_mps : {3.0, 7.0, 20.0}) {
    simulator::SimulationOptions options;
    options.speed_mps = speed_mps;
    options.duration_s = 20.0;
    options.beams = 4;
    options.azimuth_steps = 20;
    for (const bool headings : {false, true}) {
      drive::Session rounded = simulator::simulate_drive(options).session;
      const double place = degrees_to_radians(1e-6), unit = degrees_to_radians(1.0);
      for (motion::InsSample& sample : rounded.ins) {
        if (!headings) {
          sample.latitude_rad = place * std::round(sample.latitude_rad / place);
          sample.longitude_rad = place * std::round(sample.longitude_rad / place);
          continue;
        }
        YawPitchRoll angles = yaw_pitch_roll_from_rotation(sample.enu_from_ins.toRotationMatrix());
        angles.yaw_rad = unit * std::round(angles.yaw_rad / unit);
        sample.enu_from_ins = Eigen::Quaterniond(rotation_from_yaw_pitch_roll(angles));
      }
      EXPECT_TRUE(found_held(rounded).empty()) << speed_mps << (headings ? " headings" : " places");
    }
  }
}

TEST(held_part_check, sound_drives_are_silent) {
  for (const simulator::ScenarioKind scenario :
       {simulator::ScenarioKind::Street, simulator::ScenarioKind::Flat, simulator::ScenarioKind::Straight,
        simulator::ScenarioKind::FigureEight, simulator::ScenarioKind::ParkingRamp, simulator::ScenarioKind::Hill,
        simulator::ScenarioKind::Highway, simulator::ScenarioKind::Tunnel, simulator::ScenarioKind::SlewYard})
    for (const double rate_hz : {1.0, 10.0, 200.0})
      EXPECT_TRUE(found_held(simulated(scenario, 15.0, rate_hz)).empty())
          << static_cast<int>(scenario) << " " << rate_hz;
  EXPECT_TRUE(found_held(held(simulated(simulator::ScenarioKind::Straight), 20, Part::Attitude)).empty())
      << "on a straight road a held attitude does no harm";
  EXPECT_TRUE(found_held(good_drive()).empty());
  EXPECT_TRUE(found_held(drive::Session{}).empty());
  simulator::SimulationOptions standing;
  standing.duration_s = 8.0;
  standing.standstill_s = 8.0;
  standing.ins_position_noise_m = 0.0;
  standing.ins_attitude_noise_deg = 0.0;
  EXPECT_TRUE(found_held(simulator::simulate_drive(standing).session).empty())
      << "a vehicle that stands repeats its pose";
}

TEST(held_part_check, inspect_names_an_attitude_that_is_held) {
  simulator::SimulationOptions options;
  options.beams = 4;
  options.azimuth_steps = 60;
  simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  drive.session = held(drive.session, 20, Part::Attitude);
  const formats::TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(drive, folder.path() / "drive", "native", 1, progress);
  const drive::Session session = formats::open_session(folder.path() / "drive", progress);
  const std::string inspected = overview::describe(session, overview::report_session(session, progress));
  EXPECT_NE(inspected.find("warning [ins-attitude-held] INS: The attitude stands still for 0.200 s"), std::string::npos)
      << inspected;
  EXPECT_EQ(inspected.find("ins-position-held"), std::string::npos);
}

}  // namespace
}  // namespace remount::checks
