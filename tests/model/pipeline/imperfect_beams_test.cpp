// LiDARs whose beams look elsewhere than they say, or whose ranges are wrong. docs/maths/beams.md
#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/pipeline/pair_clouds.h"
#include "model/results/deciding_notes.h"
#include "model/simulator/patterns/lidar_models.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/draws.h"
#include "tests/support/findings.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

struct WithBeams {
  simulator::SimulatedDrive drive;
  PipelineInput input;
  PipelineOutput output;
};

simulator::SimulationOptions short_street(int seed) {
  simulator::SimulationOptions options;
  options.beams = 32;
  options.azimuth_steps = 600;
  options.seed = seed;
  return options;
}

WithBeams calibrate_beams(const simulator::SimulatedDrive& drive, cloud::LidarKind lidar = cloud::LidarKind::Auto) {
  WithBeams run{drive, {}, {}};
  run.input.sessions.push_back(std::make_shared<drive::Session>(run.drive.session));
  run.input.settings.beams.lidar = lidar;
  Progress progress;
  run.output = run_pipeline(run.input, progress);
  return run;
}

TEST(imperfect_beams, that_look_up_are_found_mended_and_leave_x_right) {
  simulator::SimulationOptions options = short_street(3);
  options.lidar_errors.elevation_offset_deg = 0.2;
  const WithBeams run = calibrate_beams(testing::simulate_drive(options));
  testing::expect_within_sigma(run.output.result, run.drive.ins_from_lidar, 3.5);
  const cloud::BeamMean& found = run.output.result.beams.elevation;
  std::printf("  elevation %.4f +- %.4f deg\n", radians_to_degrees(found.error), radians_to_degrees(found.sigma));
  EXPECT_NEAR(radians_to_degrees(found.error), 0.2, 0.02);
  EXPECT_LT(std::abs(found.error - degrees_to_radians(0.2)), 3.5 * found.sigma);
  const calibration::Estimate z = run.output.result.estimate(calibration::Parameter::Z);
  EXPECT_LT(z.sigma.value_or(1.0), 0.04) << "the drive tells elevation and height apart";
  ASSERT_TRUE(testing::has_code(run.output.findings, results::kMendedBeams));
  EXPECT_FALSE(run.output.mended_beams.none());
  char mended_mm[32];
  std::snprintf(mended_mm, sizeof mended_mm, "are %.1f mm thick, and ",
                1e3 * run.output.sharpness.front().sharpness.plane_thickness_m);
  const std::string said = testing::said_of(run.output.findings, results::kMendedBeams);
  EXPECT_NE(said.find(mended_mm), std::string::npos) << said << " | " << mended_mm;
  EXPECT_EQ(run.output.quantities.size(), 3U);
  EXPECT_FALSE(run.output.plots.empty());
  // The same when it is solved again from what is kept, and the clouds that are shown are the mended ones.
  PipelineOutput again = run.output;
  Progress progress;
  ASSERT_TRUE(solve_again(run.input, again, progress));
  testing::expect_within_sigma(again.result, run.drive.ins_from_lidar, 3.5);
  EXPECT_NEAR(again.result.beams.elevation.error, found.error, found.sigma);
  EXPECT_EQ(testing::said_of(again.findings, results::kMendedBeams).find("thick"), std::string::npos);
  check_map(run.input, again, progress);
  EXPECT_NE(testing::said_of(again.findings, results::kMendedBeams).find("thick"), std::string::npos);
  // The scans were mended: that their LiDAR is called perfect afterwards does not make the mending exact.
  PipelineInput called_perfect = run.input;
  called_perfect.settings.beams.lidar = cloud::LidarKind::Perfect;
  PipelineOutput doubted = run.output;
  ASSERT_TRUE(solve_again(called_perfect, doubted, progress));
  EXPECT_GT(doubted.result.estimate(calibration::Parameter::Z).sigma.value_or(0.0), 0.8 * z.sigma.value_or(1.0));
  const cloud::PointCloud recorded =
      run.drive.session.scans->load(static_cast<std::size_t>(run.output.keyframes[motion::KeyframeIndex(0)].scan));
  const PairClouds shown =
      SolvedPairs(run.input, std::make_shared<PipelineOutput>(run.output)).load(motion::PairIndex(0), {});
  ASSERT_EQ(shown.cloud_a().size(), recorded.size());
  double raised_rad = 0.0;
  const auto elevation = [](const Eigen::Vector3f& point) {
    return std::atan2(point.z(), std::hypot(point.x(), point.y()));
  };
  for (std::size_t i = 0; i < recorded.size(); ++i)
    raised_rad += elevation(shown.cloud_a().points[i]) - elevation(recorded.points[i]);
  EXPECT_NEAR(radians_to_degrees(raised_rad / static_cast<double>(recorded.size())), 0.2, 0.1);
}

TEST(imperfect_beams, whose_ranges_are_too_long_are_no_lag_of_the_clock) {
  ONLY_IN_LONG_TESTS();
  simulator::SimulationOptions options = short_street(5);
  options.lidar_errors.range_scale = 0.002;
  const WithBeams run = calibrate_beams(testing::simulate_drive(options));
  testing::expect_within_sigma(run.output.result, run.drive.ins_from_lidar, 3.5);
  const cloud::BeamEstimate& beams = run.output.result.beams;
  EXPECT_NEAR(beams.range_scale(), -0.002, 2e-4) << beams.range_scale_sigma();
  EXPECT_TRUE(run.output.result.observed().contains(calibration::Parameter::X));
  EXPECT_FALSE(testing::has_code(run.output.findings, "ins-position-lag"));
}

// The mirror of a LiDAR that looks ahead bends its field by a few hundredths of a degree: pitch was 0.19 degrees off,
// at 14 sigma.
TEST(imperfect_beams, over_a_field_that_looks_ahead_are_in_sigma) {
  ONLY_IN_LONG_TESTS();
  simulator::SimulationOptions options;
  options.lidar.model = simulator::lidar_named("m1");
  options.lidar.points_per_scan = 12000;
  options.duration_s = 12.0;
  options.seed = 31;
  options.lidar_errors.field_angle_deg = 0.05;
  options.lidar_errors.field_range_m = 0.01;
  const WithBeams run = calibrate_beams(testing::simulate_drive(options), cloud::LidarKind::SolidState);
  ASSERT_TRUE(run.output.beam_nodes.by_azimuth());
  testing::expect_within_sigma(run.output.result, run.drive.ins_from_lidar, 3.5);
  const testing::CalibrationError error = testing::error_of(run.output.result, run.drive.ins_from_lidar);
  std::printf("  %.4f deg, z %.3f m\n", error.rotation_deg, error.z_m);
  EXPECT_LT(error.rotation_deg, 0.06);
  EXPECT_TRUE(run.output.result.observed().contains(calibration::Parameter::Pitch));
}

TEST(imperfect_beams, of_a_perfect_lidar_widen_sigma_by_little_and_are_not_mended) {
  ONLY_IN_LONG_TESTS();
  const simulator::SimulatedDrive drive = testing::simulate_drive(short_street(4));
  const WithBeams perfect = calibrate_beams(drive), unknown = calibrate_beams(drive, cloud::LidarKind::Unknown);
  EXPECT_TRUE(perfect.output.result.beams.empty());
  EXPECT_TRUE(perfect.output.quantities.empty());
  EXPECT_TRUE(unknown.output.mended_beams.none());
  EXPECT_FALSE(testing::has_code(unknown.output.findings, results::kMendedBeams));
  testing::expect_within_sigma(unknown.output.result, unknown.drive.ins_from_lidar, 3.5);
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const double ratio = unknown.output.result.estimate(parameter).sigma.value_or(1e3) /
                         perfect.output.result.estimate(parameter).sigma.value_or(1.0);
    std::printf("  %s: sigma times %.2f\n", std::string(to_string(parameter)).c_str(), ratio);
    EXPECT_LT(ratio, 3.0) << to_string(parameter);
  }
}

}  // namespace
}  // namespace remount::pipeline
