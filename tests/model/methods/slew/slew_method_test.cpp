// The method on three recordings of a simulated excavator.
#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/project/project.h"
#include "model/results/deciding_notes.h"
#include "tests/support/draws.h"
#include "tests/support/findings.h"
#include "tests/support/slew_recordings.h"

namespace remount::methods {
namespace {

void expect_right(const testing::Yard& yard, calibration::FirstPlane first) {
  const pipeline::PipelineOutput output = testing::run(yard, testing::settings_with(first));
  const testing::CalibrationError error = testing::error_of(output.result, yard.machine_from_lidar);
  for (const drive::Finding& finding : output.findings)
    std::printf("  %s: %s\n", drive::english(finding.where).c_str(), english(finding.explanation).c_str());
  EXPECT_EQ(output.result.status, calibration::Status::Ok) << english(output.result.message);
  EXPECT_EQ(output.result.mounting.reference, calibration::BodyFrame::Machine);
  EXPECT_LT(error.rotation_deg, 0.05);
  EXPECT_LT(std::hypot(error.x_m, error.y_m), 0.01);
  ASSERT_EQ(output.plots.size(), 2u);
  const calibration::Curve &poses = output.plots[0].curves[0], &circle = output.plots[0].curves[1];
  ASSERT_EQ(poses.z.size(), poses.x.size());
  ASSERT_EQ(circle.z.size(), circle.x.size());
  const auto [low, high] = std::minmax_element(circle.z.begin(), circle.z.end());
  for (const double z_m : poses.z) EXPECT_TRUE(z_m > *low - 0.05 && z_m < *high + 0.05) << "off the circle in space";
}

TEST(slew_method, three_recordings_on_a_slope_give_rotation_and_slew_centre) {
  simulator::SlewYardOptions options;
  options.slope_deg = 2.0;
  expect_right(testing::yard_of(options, false), calibration::FirstPlane::Turn);
}

TEST(slew_method, poses_of_an_odometry_stand_in_for_the_scans_of_the_turn) {
  expect_right(testing::yard_of({}, true), calibration::FirstPlane::Ground);
}

// One draw of the three recordings is enough here; the long test draws many. Scans of an exact yard err less than their
// residuals let one think, so that what is said is wide; how wide is printed, and bounded.
TEST(slew_method, errors_over_simulated_recordings_are_no_larger_than_said) {
  const int seeds = testing::some_of_many(3, 1);
  for (const std::array<double, 6>& squares : testing::squares_over_recordings(11, seeds)) {
    double sum = 0.0;
    for (const double square : squares) sum += seeds * square;
    // The 0.1% limits of 6 and of 18 degrees of freedom.
    EXPECT_LT(sum, seeds == 1 ? 22.5 : 42.3);
    EXPECT_GT(sum, 0.2 * seeds / 3.0);
  }
}

TEST(slew_method, a_quarter_turn_is_refused_with_the_reason) {
  simulator::SlewYardOptions options;
  options.arc_deg = 90.0;
  const pipeline::PipelineOutput output =
      testing::run(testing::yard_of(options, true), testing::settings_with(calibration::FirstPlane::Ground));
  EXPECT_NE(english(output.result.message).find("arc"), std::string::npos) << english(output.result.message);
  EXPECT_EQ(calibration::parameter_names(output.result.observed()), "");
}

TEST(slew_method, a_missing_arm_and_a_tilted_ground_are_refused_with_the_reason) {
  simulator::SlewYardOptions options;
  options.arm = false;
  pipeline::PipelineOutput output =
      testing::run(testing::yard_of(options, true), testing::settings_with(calibration::FirstPlane::Ground));
  EXPECT_NE(english(output.result.message).find("plane of the arm is missing"), std::string::npos)
      << english(output.result.message);
  options = {};
  options.uneven_deg = 2.0;
  output = testing::run(testing::yard_of(options, true), testing::settings_with(calibration::FirstPlane::Ground));
  EXPECT_NE(english(output.result.message).find("tilted"), std::string::npos) << english(output.result.message);
}

TEST(slew_method, a_ground_that_leans_within_the_limit_is_named_and_in_sigma) {
  simulator::SlewYardOptions options;
  options.uneven_deg = 0.35;
  const testing::Yard yard = testing::yard_of(options, true);
  const pipeline::PipelineOutput output = testing::run(yard, testing::settings_with(calibration::FirstPlane::Ground));
  ASSERT_EQ(output.result.status, calibration::Status::Ok) << output.result.message;
  const testing::CalibrationError error = testing::error_of(output.result, yard.machine_from_lidar);
  const double sigma_deg =
      radians_to_degrees(std::hypot(output.result.estimate(calibration::Parameter::Pitch).sigma.value_or(0.0),
                                    output.result.estimate(calibration::Parameter::Roll).sigma.value_or(0.0)));
  std::printf("  off by %.3f deg, sigma of pitch and roll %.3f deg; %s\n", error.rotation_deg, sigma_deg,
              testing::said_of(output.findings, "ground-tilted").c_str());
  EXPECT_LT(error.rotation_deg, 3.0 * sigma_deg);
  EXPECT_TRUE(testing::has_code(output.findings, "ground-tilted"));
  EXPECT_FALSE(testing::has_code(
      testing::run(testing::yard_of({}, true), testing::settings_with(calibration::FirstPlane::Ground)).findings,
      "ground-tilted"));
}

TEST(slew_method, recordings_are_known_by_whole_words_of_their_names) {
  testing::Yard yard = testing::yard_of({}, true);
  std::swap(yard.sessions[1], yard.sessions[2]);
  const char* names[] = {"FullTurn", "the_arm", "first alarm, return"};
  for (std::size_t i = 0; i < 3; ++i) {
    drive::Session session = *yard.sessions[i];
    session.name = names[i];
    yard.sessions[i] = std::make_shared<const drive::Session>(std::move(session));
  }
  EXPECT_EQ(testing::run(yard, testing::settings_with(calibration::FirstPlane::Ground)).result.status,
            calibration::Status::Ok);
}

TEST(slew_method, recordings_are_known_by_their_folders_where_all_have_one_name) {
  testing::Yard yard = testing::yard_of({}, true);
  std::swap(yard.sessions[0], yard.sessions[2]);
  const char* folders[] = {"/data/slew_arm-sweep", "/data/slew_ground", "/data/slew_full-turn"};
  for (std::size_t i = 0; i < 3; ++i) {
    drive::Session session = *yard.sessions[i];
    session.name = "excavator";
    session.path = folders[i];
    yard.sessions[i] = std::make_shared<const drive::Session>(std::move(session));
  }
  const pipeline::PipelineOutput output = testing::run(yard, testing::settings_with(calibration::FirstPlane::Ground));
  EXPECT_EQ(output.result.status, calibration::Status::Ok);
  // What was taken for what stands in the result.
  pipeline::PipelineInput input;
  input.sessions = yard.sessions;
  std::string notes;
  for (const drive::Finding& finding : project::make_result_file(input, output, {}).findings)
    if (finding.code == results::kRecording)
      notes += drive::english(finding.where) + ": " + english(finding.explanation) + "\n";
  EXPECT_EQ(notes,
            "excavator (slew_ground): Taken for the recording: ground.\n"
            "excavator (slew_arm-sweep): Taken for the recording: arm.\n"
            "excavator (slew_full-turn): Taken for the recording: turn.\n");
}

TEST(slew_method, without_a_turn_it_says_so) {
  testing::Yard yard;
  yard.sessions.push_back(std::make_shared<const drive::Session>());
  EXPECT_THROW(testing::run(yard, {}), Error);
}

}  // namespace
}  // namespace remount::methods
