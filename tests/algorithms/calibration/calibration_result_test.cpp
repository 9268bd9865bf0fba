#include "algorithms/calibration/calibration_result.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "algorithms/calibration/observability.h"
#include "algorithms/messages/render.h"

namespace remount::calibration {
namespace {

CalibrationResult solved() {
  CalibrationResult result;
  result.status = Status::Ok;
  result.message = Message::verbatim("solved");
  result.mounting.reference_from_sensor = rigid_from_six({1.0, -0.5, 2.0, 0.3, -0.1, 0.2});
  result.covariance = 4e-4 * Matrix6d::Identity();
  result.set_observed(ParameterSet::all(), {});
  return result;
}

TEST(calibration_result, an_estimate_has_the_value_of_the_mounting_and_the_sigma_of_the_covariance) {
  CalibrationResult result = solved();
  result.known[Parameter::Z].bootstrap_sigma = 0.03;
  result.set_measured({Parameter::Z});
  const Estimate z = result.estimate(Parameter::Z);
  EXPECT_TRUE(z.observed && z.measured && z.why_not_observed.empty());
  EXPECT_DOUBLE_EQ(z.value, 2.0);
  EXPECT_DOUBLE_EQ(*z.sigma, 0.02);
  EXPECT_DOUBLE_EQ(*z.bootstrap_sigma, 0.03);
  EXPECT_NEAR(result.estimate(Parameter::Yaw).value, 0.3, 1e-12);
  EXPECT_FALSE(result.estimate(Parameter::Yaw).measured);
}

TEST(calibration_result, what_is_not_observed_has_no_sigma_and_says_why) {
  CalibrationResult result = solved();
  result.known[Parameter::Z].bootstrap_sigma = 0.03;
  result.withdraw(Parameter::Z, Message::verbatim("flat driving"));
  const Estimate z = result.estimate(Parameter::Z);
  EXPECT_FALSE(z.observed || z.sigma || z.bootstrap_sigma);
  EXPECT_EQ(z.why_not_observed, Message::verbatim("flat driving"));
  EXPECT_DOUBLE_EQ(z.value, 2.0) << "what was given stays";
  EXPECT_EQ(result.observed(), ~ParameterSet{Parameter::Z});
  EXPECT_TRUE(result.estimate(Parameter::X).sigma.has_value());
  result.covariance = Matrix6d::Identity();
  EXPECT_FALSE(result.estimate(Parameter::Z).sigma) << "whatever stands in the covariance";
}

TEST(calibration_result, one_that_failed_says_why_of_every_parameter) {
  CalibrationResult result;
  for (const Parameter parameter : kParameters) EXPECT_FALSE(result.estimate(parameter).why_not_observed.empty());
  result.message = Message::verbatim("too few pairs");
  for (const Parameter parameter : kParameters)
    EXPECT_EQ(result.estimate(parameter).why_not_observed, Message::verbatim("too few pairs"));
  EXPECT_FALSE(is_usable(result));
}

TEST(calibration_result, concludes_with_status_and_reason_and_keeps_the_advice) {
  CalibrationResult result = solved();
  result.advice = {Message::verbatim("drive turns")};
  result.conclude(Status::NoUsableData, Message::verbatim("no INS"));
  EXPECT_EQ(result.status, Status::NoUsableData);
  EXPECT_EQ(result.message, Message::verbatim("no INS"));
  EXPECT_EQ(result.advice.size(), 1U);
  EXPECT_FALSE(is_usable(result)) << "whatever it observed before";
}

// They stand in files.
TEST(calibration_result, names_of_statuses_stay) {
  const std::pair<Status, const char*> names[] = {
      {Status::Ok, "ok"},
      {Status::Degenerate, "degenerate"},
      {Status::TooFewPairs, "too_few_pairs"},
      {Status::TooLittleData, "too_little_data"},
      {Status::NoUsableData, "no_usable_data"},
      {Status::NotConverged, "not_converged"},
      {Status::OutOfRange, "out_of_range"},
      {Status::Inconsistent, "inconsistent"},
      {Status::Cancelled, "cancelled"},
  };
  for (const auto& [status, name] : names) {
    EXPECT_EQ(to_string(status), name);
    EXPECT_EQ(status_from_string(name), status);
  }
  EXPECT_EQ(status_from_string("fine"), std::nullopt);
}

TEST(calibration_result, the_mean_of_offsets_counts_each_session_by_what_it_tells) {
  const TimeOffset mean = mean_time_offset({0.030, 0.0, 0.032}, {1e-4, 1.0, 1e-4});
  EXPECT_NEAR(mean.offset_s, 0.031, 1e-7) << "the second session tells nothing";
  EXPECT_NEAR(mean.sigma_s, 1e-4 / std::sqrt(2.0), 1e-9);
  const TimeOffset alike = mean_time_offset({0.010, 0.030}, {});
  EXPECT_NEAR(alike.offset_s, 0.020, 1e-12);
  EXPECT_FALSE(std::isfinite(alike.sigma_s));
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(std::isfinite(mean_time_offset({0.0, 0.0}, {never, never}).offset_s));
  EXPECT_FALSE(std::isfinite(mean_time_offset({}, {}).offset_s));
}

TEST(calibration_result, judged_parameters_say_what_their_direction_says) {
  CalibrationResult result;
  const SolveOptions options;
  Matrix6d information = 1e8 * Matrix6d::Identity();
  information(2, 2) = 0.0;  // z
  MotionSummary flat;
  flat.largest_rotation_rad = 1.0;
  result.directions = observed_directions(information, {information, Matrix6d::Zero()}, flat, options);
  judge_parameters((trusted_information(result.directions, options) + weak_prior(true)).inverse(), flat, options,
                   result);
  EXPECT_EQ(result.observed(), ~ParameterSet{Parameter::Z});
  EXPECT_EQ(english(result.estimate(Parameter::Z).why_not_observed), "z (height): not observable, flat driving");
  claim_nothing(Message::verbatim("a cancelled solution"), result);
  for (const Parameter parameter : kParameters)
    EXPECT_EQ(result.estimate(parameter).why_not_observed, Message::verbatim("a cancelled solution"));
}

}  // namespace
}  // namespace remount::calibration
