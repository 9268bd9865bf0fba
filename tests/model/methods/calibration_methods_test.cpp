#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/core/error.h"
#include "model/methods/calibration_method.h"
#include "model/simulator/simulator.h"

namespace remount {
namespace {

TEST(calibration_methods, are_listed_as_the_settings_choose_them) {
  const std::vector<CalibrationMethod>& methods = calibration_methods();
  ASSERT_EQ(methods.size(), kMethodIds.size());
  for (std::size_t i = 0; i < methods.size(); ++i) {
    EXPECT_EQ(methods[i].id, kMethodIds[i]);
    EXPECT_FALSE(methods[i].title.empty() || methods[i].needs.empty()) << methods[i].id;
    EXPECT_EQ(&calibration_method(kMethodIds[i]), &methods[i]);
  }
}

TEST(calibration_methods, have_sections_that_the_settings_know) {
  std::vector<std::string_view> sections;
  const Settings settings;
  Settings::visit_sections(settings, [&](std::string_view name, const auto&) { sections.push_back(name); });
  for (const CalibrationMethod& method : calibration_methods()) {
    if (method.settings_section.empty()) continue;
    EXPECT_EQ(std::count(sections.begin(), sections.end(), method.settings_section), 1) << method.id;
  }
}

TEST(calibration_methods, that_do_not_find_the_lidar_in_the_ins_frame_refuse_what_was_measured_there) {
  PipelineInput input;
  input.sessions.push_back(std::make_shared<Session>());
  input.settings.measured.z_m = 1.7;
  input.settings.measured.z_sigma_m = 0.01;
  for (const char* id : {"vehicle-frame", "slew"}) {
    Progress progress;
    try {
      calibration_method(id).run(input, progress);
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
    calibration_method("trajectory").run(input, progress);
    FAIL() << "trajectory took the height of the INS";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("ins_height"), std::string::npos) << error.what();
  }
}

TEST(calibration_methods, say_that_a_value_without_a_sigma_is_not_used) {
  SimulationOptions options;
  options.duration_s = 1.0;
  options.beams = 16;
  options.azimuth_steps = 300;
  PipelineInput input;
  input.sessions.push_back(std::make_shared<Session>(simulate_drive(options).session));
  input.settings.measured.z_m = 0.8;
  input.settings.measured.yaw_deg = 1.5;
  input.settings.measured.yaw_sigma_deg = 0.5;
  Progress progress;
  std::string said;
  for (const Finding& finding : calibrate(input, progress).findings)
    if (finding.code == "measured-unused") said += finding.explanation;
  EXPECT_EQ(said, "z was given as measured, 0.8 m, without a sigma and is not used: give its sigma, too.");
}

TEST(calibration_methods, ask_for_no_sigma_of_a_height_that_they_do_not_take) {
  SimulationOptions options;
  options.duration_s = 1.0;
  options.beams = 16;
  options.azimuth_steps = 300;
  PipelineInput input;
  input.sessions.push_back(std::make_shared<Session>(simulate_drive(options).session));
  input.settings.measured.ins_height_m = 0.6;
  for (const MethodChoice method : {MethodChoice::Pairwise, MethodChoice::Trajectory}) {
    input.settings.run.method = method;
    Progress progress;
    std::string said;
    for (const Finding& finding : calibrate(input, progress).findings)
      if (finding.code == "measured-unused") said += finding.explanation;
    EXPECT_EQ(said,
              method == MethodChoice::Pairwise
                  ? "INS height was given as measured, 0.6 m, without a sigma and is not used: give its sigma, too."
                  : "INS height was given as measured, 0.6 m, and is not used: this method takes no height of "
                    "the INS. Leave it out.");
  }
}

TEST(calibration_methods, that_are_unknown_are_answered_with_the_known_ones) {
  try {
    calibration_method("guess");
    FAIL() << "no method is called so";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("pairwise"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace remount
