// Attitudes that are logged in coarse steps.
#include "model/conventions/attitude_rounding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"

namespace remount::conventions {
namespace {

drive::Session rounded(drive::Session session, double step_deg) {
  for (motion::InsSample& sample : session.ins) {
    YawPitchRoll angles = yaw_pitch_roll_from_rotation(sample.enu_from_ins.toRotationMatrix());
    for (double* angle : {&angles.yaw_rad, &angles.pitch_rad, &angles.roll_rad})
      *angle = degrees_to_radians(step_deg * std::round(radians_to_degrees(*angle) / step_deg));
    sample.enu_from_ins = Eigen::Quaterniond(rotation_from_yaw_pitch_roll(angles));
  }
  return session;
}

simulator::SimulatedDrive eight(int seed) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::FigureEight;
  options.duration_s = 40.0;
  options.beams = 1;
  options.azimuth_steps = 16;
  options.seed = seed;
  return simulator::simulate_drive(options);
}

TEST(attitude_rounding, is_the_step_of_the_log_and_nothing_of_one_with_all_digits) {
  const simulator::SimulatedDrive drive = eight(41);
  EXPECT_EQ(attitude_rounding(drive.session.ins).sigma_rad, 0.0);
  for (const double step_deg : {1.0, 0.5, 0.1}) {
    const AttitudeRounding found = attitude_rounding(rounded(drive.session, step_deg).ins);
    std::printf("  step %.1f deg: sigma %.4f, of which lasts %.4f deg\n", step_deg, radians_to_degrees(found.sigma_rad),
                radians_to_degrees(found.lasting_rad));
    EXPECT_NEAR(radians_to_degrees(found.step_rad), step_deg, 1e-6);
    EXPECT_NEAR(radians_to_degrees(found.sigma_rad), step_deg / std::sqrt(12.0), 1e-6);
  }
}

/// Without that z was off by 12 sigma.
TEST(attitude_rounding, to_a_degree_is_in_the_sigmas) {
  for (const int seed : {42, 43}) {
    const simulator::SimulatedDrive drive = eight(seed);
    pipeline::PipelineInput input;
    drive::Session session = rounded(drive.session, 1.0);
    session.scans.reset();
    for (std::size_t i = 0; i < drive.enu_from_ins.size(); ++i)
      session.odometry_from_lidar.push_back(
          {drive.session.scans->stamp_ns(i), drive.enu_from_ins[i].pose * drive.ins_from_lidar});
    input.sessions = {std::make_shared<drive::Session>(session)};
    Progress progress;
    const calibration::CalibrationResult result = pipeline::run_pipeline(input, progress).result;
    testing::error_of(result, drive.ins_from_lidar);
    testing::expect_within_sigma(result, drive.ins_from_lidar, 4.0);
  }
}

}  // namespace
}  // namespace remount::conventions
