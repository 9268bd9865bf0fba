// The method on three recordings of a simulated excavator.
#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/core/error.h"
#include "model/methods/builtin.h"
#include "model/simulator/road.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"

namespace remount {
namespace {

struct Yard {
  std::vector<std::shared_ptr<const Session>> sessions;
  RigidTransform machine_from_lidar;  // origin on the ground
};

SimulatedDrive recording(SlewRecording kind, const SlewYardOptions& yard) {
  SimulationOptions options;
  options.scenario = ScenarioKind::SlewYard;
  options.slew_yard = yard;
  options.slew_yard.recording = kind;
  options.beams = 32;
  options.azimuth_steps = 500;
  options.range_noise_m = 0.01;
  options.duration_s = kind == SlewRecording::Ground ? 0.5 : kind == SlewRecording::ArmSweep ? 4.0 : 24.0;
  options.scan_rate_hz = kind == SlewRecording::FullTurn ? 5.0 : 10.0;
  options.seed = 3;
  return simulate_drive(options);
}

/// @param by_poses the turn is given by true poses of the LiDAR instead of its scans: quicker
Yard yard_of(const SlewYardOptions& options, bool by_poses) {
  Yard yard;
  const std::pair<SlewRecording, const char*> kinds[] = {{SlewRecording::FullTurn, "full turn"},
                                                         {SlewRecording::Ground, "the ground"},
                                                         {SlewRecording::ArmSweep, "arm swept"}};
  for (const auto& [kind, name] : kinds) {  // in any order: their names say which they are
    SimulatedDrive drive = recording(kind, options);
    drive.session.name = name;
    yard.machine_from_lidar = vehicle_from_ins(ScenarioKind::SlewYard) * drive.ins_from_lidar;
    if (by_poses && kind == SlewRecording::FullTurn) {
      drive.session.scans = nullptr;
      for (const StampedPose& pose : drive.enu_from_ins)
        drive.session.odometry_from_lidar.push_back({pose.stamp_ns, pose.pose * drive.ins_from_lidar});
    }
    yard.sessions.push_back(std::make_shared<const Session>(std::move(drive.session)));
  }
  return yard;
}

PipelineOutput run(const Yard& yard, const Settings& settings) {
  PipelineInput input;
  input.sessions = yard.sessions;
  input.settings = settings;
  Progress progress;
  return run_slew(input, progress);
}

Settings settings_with(FirstPlane first) {
  Settings settings;
  settings.slew.first_plane = first;
  settings.slew.origin = MachineOrigin::Ground;
  return settings;
}

void expect_right(const Yard& yard, FirstPlane first) {
  const PipelineOutput output = run(yard, settings_with(first));
  const CalibrationError error = error_of(output.result, yard.machine_from_lidar);
  for (const Finding& finding : output.findings)
    std::printf("  %s: %s\n", finding.where.c_str(), finding.explanation.c_str());
  EXPECT_EQ(output.result.status, Status::Ok) << output.result.message;
  EXPECT_EQ(output.result.reference_frame, "machine");
  EXPECT_LT(error.rotation_deg, 0.05);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.01);
  ASSERT_EQ(output.plots.size(), 2u);
  const Curve &poses = output.plots[0].curves[0], &circle = output.plots[0].curves[1];
  ASSERT_EQ(poses.z.size(), poses.x.size());
  ASSERT_EQ(circle.z.size(), circle.x.size());
  const auto [low, high] = std::minmax_element(circle.z.begin(), circle.z.end());
  for (const double z_m : poses.z) EXPECT_TRUE(z_m > *low - 0.05 && z_m < *high + 0.05) << "off the circle in space";
}

TEST(slew_method, three_recordings_on_a_slope_give_rotation_and_slew_centre) {
  SlewYardOptions options;
  options.slope_deg = 2.0;
  expect_right(yard_of(options, false), FirstPlane::Turn);
}

TEST(slew_method, poses_of_an_odometry_stand_in_for_the_scans_of_the_turn) {
  expect_right(yard_of({}, true), FirstPlane::Ground);
}

TEST(slew_method, a_quarter_turn_is_refused_with_the_reason) {
  SlewYardOptions options;
  options.arc_deg = 90.0;
  const PipelineOutput output = run(yard_of(options, true), settings_with(FirstPlane::Ground));
  EXPECT_NE(output.result.message.find("arc"), std::string::npos) << output.result.message;
  for (const bool observed : output.result.observed) EXPECT_FALSE(observed);
}

TEST(slew_method, a_missing_arm_and_a_tilted_ground_are_refused_with_the_reason) {
  SlewYardOptions options;
  options.arm = false;
  PipelineOutput output = run(yard_of(options, true), settings_with(FirstPlane::Ground));
  EXPECT_NE(output.result.message.find("plane of the arm is missing"), std::string::npos) << output.result.message;
  options = {};
  options.uneven_deg = 2.0;
  output = run(yard_of(options, true), settings_with(FirstPlane::Ground));
  EXPECT_NE(output.result.message.find("tilted"), std::string::npos) << output.result.message;
}

TEST(slew_method, recordings_are_known_by_whole_words_of_their_names) {
  Yard yard = yard_of({}, true);
  std::swap(yard.sessions[1], yard.sessions[2]);
  const char* names[] = {"FullTurn", "the_arm", "first alarm, return"};
  for (std::size_t i = 0; i < 3; ++i) {
    Session session = *yard.sessions[i];
    session.name = names[i];
    yard.sessions[i] = std::make_shared<const Session>(std::move(session));
  }
  EXPECT_EQ(run(yard, settings_with(FirstPlane::Ground)).result.status, Status::Ok);
}

TEST(slew_method, without_a_turn_it_says_so) {
  Yard yard;
  yard.sessions.push_back(std::make_shared<const Session>());
  EXPECT_THROW(run(yard, {}), Error);
}

}  // namespace
}  // namespace remount
