#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/method_registry/calibration_method.h"
#include "model/methods/calibrate.h"
#include "model/simulator/simulator.h"
#include "tests/support/draws.h"
#include "tests/support/kept_scans.h"

namespace remount::methods {
namespace {

TEST(calibration_methods, have_sections_that_the_settings_know) {
  std::vector<std::string_view> sections;
  const settings::Settings settings;
  settings::Settings::visit_sections(settings, [&](std::string_view name, const auto&) { sections.push_back(name); });
  for (const method_registry::CalibrationMethod* method : method_registry::calibration_methods()) {
    if (method->settings_section.empty()) continue;
    EXPECT_EQ(std::count(sections.begin(), sections.end(), method->settings_section), 1) << method->id;
  }
}

TEST(calibration_methods, that_do_not_find_the_lidar_in_the_ins_frame_refuse_what_was_measured_there) {
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>());
  input.settings.measured.z_m = 1.7;
  input.settings.measured.z_sigma_m = 0.01;
  for (const char* id : {"vehicle-frame", "slew"}) {
    Progress progress;
    try {
      method_registry::calibration_method(id).run(input, progress);
      FAIL() << id << " took it";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("measured"), std::string::npos) << error.what();
    }
  }
  input.settings.measured = {};
  input.settings.measured.ins_height_m = 0.6;
  input.settings.measured.ins_height_sigma_m = 0.02;
  Progress progress;
  try {
    method_registry::calibration_method("trajectory").run(input, progress);
    FAIL() << "trajectory took the height of the INS";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("ins_height"), std::string::npos) << error.what();
  }
}

TEST(calibration_methods, say_that_a_value_without_a_sigma_is_not_used) {
  simulator::SimulationOptions options;
  options.duration_s = 1.0;
  options.beams = 16;
  options.azimuth_steps = 300;
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(testing::simulate_drive(options).session));
  input.settings.measured.z_m = 0.8;
  input.settings.measured.yaw_deg = 1.5;
  input.settings.measured.yaw_sigma_deg = 0.5;
  Progress progress;
  std::string said;
  for (const drive::Finding& finding : calibrate(input, progress).findings)
    if (finding.code == "measured-unused") said += english(finding.explanation);
  EXPECT_EQ(said, "z was given as measured, 0.8 m, without a sigma and is not used: give its sigma, too.");
}

TEST(calibration_methods, ask_for_no_sigma_of_a_height_that_they_do_not_take) {
  simulator::SimulationOptions options;
  options.duration_s = 1.0;
  options.beams = 16;
  options.azimuth_steps = 300;
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>(testing::simulate_drive(options).session));
  input.settings.measured.ins_height_m = 0.6;
  for (const method_registry::MethodChoice& method :
       {method_registry::MethodChoice("pairwise"), method_registry::MethodChoice("trajectory")}) {
    input.settings.run.method = method;
    Progress progress;
    std::string said;
    for (const drive::Finding& finding : calibrate(input, progress).findings)
      if (finding.code == "measured-unused") said += english(finding.explanation);
    EXPECT_EQ(said,
              method == method_registry::MethodChoice("pairwise")
                  ? "INS height was given as measured, 0.6 m, without a sigma and is not used: give its sigma, too."
                  : "INS height was given as measured, 0.6 m, and is not used: this method takes no height of "
                    "the INS. Leave it out.");
  }
}

/// A drive whose LiDAR's poses are exact, for methods that need no scans; flat ground does not show the height.
std::shared_ptr<drive::Session> flat_drive(const simulator::SimulatedDrive& drive) {
  auto session = std::make_shared<drive::Session>(drive.session);
  session->scans = nullptr;
  for (const motion::StampedPose& pose : drive.enu_from_ins)
    session->odometry_from_lidar.push_back({pose.stamp_ns, pose.pose * drive.ins_from_lidar});
  return session;
}

simulator::SimulatedDrive flat_figure() {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Flat;
  options.duration_s = 60.0;
  return testing::simulate_drive(options);
}

TEST(calibration_methods, give_no_result_outside_the_search_range) {
  const simulator::SimulatedDrive drive = flat_figure();
  pipeline::PipelineInput input;
  input.sessions = {flat_drive(drive)};
  for (const method_registry::MethodChoice& method :
       {method_registry::MethodChoice("trajectory"), method_registry::MethodChoice("vehicle-frame")}) {
    const double x_m = method == method_registry::MethodChoice("trajectory") ? 0.9 : 1.3;
    input.settings = {};
    input.settings.run.method = method;
    Progress progress;
    const calibration::CalibrationResult free = calibrate(input, progress).result;
    ASSERT_TRUE(calibration::is_usable(free)) << english(free.message);
    EXPECT_NEAR(free.mounting.reference_from_sensor.translation().x(), x_m, 0.05);
    ASSERT_FALSE(free.known[calibration::Parameter::Z].observed);
    input.settings.range.x_min_m = 2.0;
    const calibration::CalibrationResult outside = calibrate(input, progress).result;
    EXPECT_EQ(outside.status, calibration::Status::OutOfRange) << english(outside.message);
    EXPECT_NE(english(outside.message).find("at least 2.00 m"), std::string::npos) << english(outside.message);
    // What nobody knows lies in the range: that says nothing against the drive.
    input.settings.range.x_min_m = 0.0;
    input.settings.range.z_min_m = 1.5;
    const calibration::CalibrationResult high = calibrate(input, progress).result;
    EXPECT_TRUE(calibration::is_usable(high)) << english(high.message);
    EXPECT_NEAR(high.mounting.reference_from_sensor.translation().z(), 1.5, 1e-9);
    EXPECT_NEAR(high.mounting.reference_from_sensor.translation().x(), x_m, 0.05);
  }
}

TEST(calibration_methods, refuse_a_nominal_outside_the_range_or_in_another_frame) {
  pipeline::PipelineInput input;
  input.sessions.push_back(std::make_shared<drive::Session>());
  input.settings.range.z_min_m = 1.0;
  const auto refusal = [&](std::string_view method, const RigidTransform& nominal,
                           const calibration::MountingFrames& frames) {
    input.settings.run.method = method_registry::MethodChoice(method);
    input.nominal_ins_from_lidar = nominal;
    input.nominal_frames = frames;
    Progress progress;
    try {
      calibrate(input, progress);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const calibration::MountingFrames ins, vehicle{calibration::BodyFrame::Vehicle, std::nullopt},
      machine{calibration::BodyFrame::Machine, std::nullopt};
  const RigidTransform low = rigid_from_six({}), high = rigid_from_six({0.0, 0.0, 2.0, 0.0, 0.0, 0.0});
  const std::string outside = "lies outside the search range", other = "are wrong in the other";
  EXPECT_NE(refusal("trajectory", low, ins).find(outside), std::string::npos);
  EXPECT_NE(refusal("vehicle-frame", low, vehicle).find(outside), std::string::npos);
  EXPECT_NE(refusal("slew", low, machine).find(outside), std::string::npos);
  EXPECT_NE(refusal("vehicle-frame", high, ins).find(other), std::string::npos);
  EXPECT_NE(refusal("slew", high, ins).find(other), std::string::npos);
  EXPECT_NE(refusal("slew", high, vehicle).find(other), std::string::npos);
  EXPECT_NE(refusal("pairwise", high, vehicle).find(other), std::string::npos);
  EXPECT_NE(refusal("trajectory", high, machine).find(other), std::string::npos);
}

TEST(calibration_methods, do_not_take_a_declared_mounting_for_one_in_another_frame) {
  const simulator::SimulatedDrive drive = flat_figure();
  pipeline::PipelineInput input;
  const std::shared_ptr<drive::Session> session = flat_drive(drive);
  session->nominal_ins_from_lidar = drive.ins_from_lidar;
  input.sessions = {session};
  input.settings.run.method = method_registry::MethodChoice("vehicle-frame");
  Progress progress;
  const pipeline::PipelineOutput output = calibrate(input, progress);
  EXPECT_NEAR(output.result.mounting.reference_from_sensor.translation().z(), 0.0, 1e-12)
      << "not where it is in the INS frame";
  EXPECT_EQ(std::count_if(output.findings.begin(), output.findings.end(),
                          [](const drive::Finding& finding) { return finding.code == "nominal-unused"; }),
            1);
}

TEST(calibration_methods, say_which_registrations_no_sigma_contains) {
  ONLY_IN_LONG_TESTS();
  const simulator::SimulatedDrive drive = flat_figure();
  pipeline::PipelineInput input;
  input.sessions = {flat_drive(drive)};
  input.settings.run.method = method_registry::MethodChoice("trajectory");
  for (const registration::RegistrationAlgorithm algorithm :
       {registration::RegistrationAlgorithm::PlaneToPlane, registration::RegistrationAlgorithm::PclIcp,
        registration::RegistrationAlgorithm::PclGicp, registration::RegistrationAlgorithm::PclNdt}) {
    input.settings.registration.algorithm = algorithm;
    Progress progress;
    const std::vector<drive::Finding> findings = calibrate(input, progress).findings;
    const bool told = std::any_of(findings.begin(), findings.end(),
                                  [](const drive::Finding& finding) { return finding.code == "registration-sigma"; });
    EXPECT_EQ(told, algorithm == registration::RegistrationAlgorithm::PclIcp ||
                        algorithm == registration::RegistrationAlgorithm::PclNdt);
  }
}

}  // namespace
}  // namespace remount::methods
