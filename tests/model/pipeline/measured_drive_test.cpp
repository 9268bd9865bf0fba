// What is known beside the pairs, and the map check, in whole calibrations of simulated drives.
#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/drive/attitude_convention.h"
#include "model/overview/session_report.h"
#include "model/simulator/simulator.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/kept_scans.h"

namespace remount::pipeline {
namespace {

simulator::SimulationOptions flat() {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Flat;
  options.beams = 32;
  options.azimuth_steps = 600;
  return options;
}

PipelineOutput calibrate(const simulator::SimulatedDrive& drive, const settings::Settings& settings,
                         const std::optional<RigidTransform>& nominal) {
  PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(drive.session));
  input.settings = settings;
  input.nominal_ins_from_lidar = nominal;
  Progress progress;
  return run_pipeline(input, progress);
}

TEST(measured_drive, ground_below_an_ins_of_known_height_gives_z_on_a_flat_road) {
  const simulator::SimulatedDrive drive = testing::simulate_drive(flat());
  settings::Settings settings;
  settings.measured.ins_height_m = 0.8;  // of the simulated vehicle
  settings.measured.ins_height_sigma_m = 0.01;
  const PipelineOutput output = calibrate(drive, settings, {});
  ASSERT_TRUE(output.ground);
  std::printf("  lidar %.3f m above the ground, sigma %.4f m\n", output.ground->lidar_height_m,
              output.ground->height_sigma_m);
  const testing::CalibrationError error = testing::error_of(output.result, drive.ins_from_lidar);
  ASSERT_TRUE(output.result.known[calibration::Parameter::Z].observed) << english(output.result.message);
  EXPECT_LE(std::abs(error.z_m), 0.03);
  EXPECT_LE(*output.result.estimate(calibration::Parameter::Z).sigma, 0.03);
  testing::expect_within_sigma(output.result, drive.ins_from_lidar, 3.5);
  const auto words_of_z = [](const calibration::CalibrationResult& result) {
    for (const calibration::ObservabilityDirection& direction : result.directions)
      if (english(direction.words).starts_with("z (height)")) return english(direction.words);
    return std::string("nothing");
  };
  EXPECT_EQ(words_of_z(output.result), "z (height): known by what was measured") << "the drive does not tell it";
  EXPECT_EQ(words_of_z(calibrate(drive, {}, {}).result), "z (height): not observable, flat driving");
}

TEST(measured_drive, inspection_and_calibration_advise_the_same_where_the_height_is_not_told) {
  const simulator::SimulatedDrive drive = testing::simulate_drive(flat());
  Progress progress;
  const std::string inspected = overview::describe(drive.session, overview::report_session(drive.session, progress));
  std::string advised;
  for (const std::string& advice : english(calibrate(drive, {}, {}).result.advice)) advised += advice + "\n";
  constexpr const char* kDrive = "a ramp, a kerb with one wheel or a bumpy road while turning";
  constexpr const char* kMeasure = "where it matters, measure it by tape and give it with --measured.";
  for (const std::string& text : {inspected, advised}) {
    EXPECT_NE(text.find(kDrive), std::string::npos) << text;
    EXPECT_NE(text.find(kMeasure), std::string::npos) << text;
    EXPECT_EQ(text.find("measured.z"), std::string::npos) << text;
  }
}

TEST(measured_drive, map_is_sharper_under_the_result_than_under_a_wrong_nominal) {
  const simulator::SimulatedDrive drive = testing::simulate_drive(flat());
  SixParameters six = six_from_rigid(drive.ins_from_lidar);
  six.yaw_rad += 0.03;
  six.x_m += 0.15;
  const PipelineOutput output = calibrate(drive, {}, rigid_from_six(six));
  ASSERT_GE(output.sharpness.size(), 3U);
  EXPECT_EQ(output.sharpness[0].source, calibration::MountingSource::Result);
  EXPECT_EQ(output.sharpness[1].source, calibration::MountingSource::Nominal);
  const quality::MapSharpness &result = output.sharpness[0].sharpness, &nominal = output.sharpness[1].sharpness;
  std::printf("  surfaces %.1f mm under the result, %.1f mm under the nominal; entropy %.3f, %.3f; %zu points\n",
              1e3 * result.plane_thickness_m, 1e3 * nominal.plane_thickness_m, result.mean_map_entropy,
              nominal.mean_map_entropy, result.points);
  EXPECT_LT(result.plane_thickness_m, 0.8 * nominal.plane_thickness_m);
  EXPECT_LT(result.mean_map_entropy, nominal.mean_map_entropy - 0.1);
  for (const drive::Finding& finding : output.findings) {
    EXPECT_NE(finding.code, "map-less-sharp") << english(finding.explanation);
    EXPECT_NE(finding.code, "motions-differ") << english(finding.explanation);
  }
}

// As where a column of velocities is read as roll.
TEST(measured_drive, a_roll_that_is_something_else_is_told) {
  simulator::SimulatedDrive drive = testing::simulate_drive(flat());
  for (motion::InsSample& sample : drive.session.ins) {
    drive::AttitudeAngles angles = drive::angles_from(sample.enu_from_ins, drive::AttitudeConvention::EnuYaw);
    angles.roll_rad = degrees_to_radians(6.0) * std::cos(angles.yaw_rad);
    sample.enu_from_ins = drive::enu_from_ins(angles, drive::AttitudeConvention::EnuYaw);
  }
  const PipelineOutput output = calibrate(drive, {}, {});
  testing::error_of(output.result, drive.ins_from_lidar);
  const bool told = std::ranges::any_of(output.findings, [](const auto& one) { return one.code == "motions-differ"; });
  EXPECT_TRUE(told || !calibration::is_usable(output.result))
      << radians_to_degrees(output.result.rotation_rms_rad) << " deg rms, " << english(output.result.message);
}

}  // namespace
}  // namespace remount::pipeline
