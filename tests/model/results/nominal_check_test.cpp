#include "model/results/nominal_check.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"

namespace remount::results {
namespace {

calibration::CalibrationResult solved_at(const RigidTransform& ins_from_lidar) {
  calibration::CalibrationResult result;
  result.status = calibration::Status::Ok;
  result.set_observed(calibration::ParameterSet::all(), {});
  result.mounting.reference_from_sensor = ins_from_lidar;
  return result;
}

RigidTransform mounted(double x_m, double yaw_deg) {
  return make_rigid(rotation_from_yaw_pitch_roll({degrees_to_radians(yaw_deg), 0.0, 0.0}), {x_m, 0.0, 0.5});
}

std::vector<drive::Finding> found(const RigidTransform& nominal, const calibration::CalibrationResult& result) {
  std::vector<drive::Finding> findings;
  report_nominal(nominal, result, findings);
  return findings;
}

TEST(nominal_check, a_remounted_sensor_is_no_finding) {
  EXPECT_TRUE(found(mounted(1.0, 3.0), solved_at(mounted(1.2, -6.0))).empty());
}

TEST(nominal_check, a_sensor_that_looks_backwards_is_one) {
  const std::vector<drive::Finding> findings = found(mounted(1.0, 180.0), solved_at(mounted(1.0, 0.0)));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].code, "nominal-far");
  EXPECT_NE(english(findings[0].explanation).find("180.0 deg and 0.00 m"), std::string::npos)
      << english(findings[0].explanation);
  EXPECT_NE(english(findings[0].explanation).find("axes or signs"), std::string::npos)
      << english(findings[0].explanation);
}

TEST(nominal_check, the_inverse_is_named) {
  const std::vector<drive::Finding> findings = found(mounted(1.5, 60.0).inverse(), solved_at(mounted(1.51, 61.0)));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(english(findings[0].explanation).find("lidar_from_ins"), std::string::npos)
      << english(findings[0].explanation);
}

TEST(nominal_check, an_earlier_finding_goes_with_its_reason) {
  std::vector<drive::Finding> findings;
  report_nominal(mounted(1.0, 180.0), solved_at(mounted(1.0, 0.0)), findings);
  report_nominal(mounted(1.0, 180.0), solved_at(mounted(1.0, 179.0)), findings);
  EXPECT_TRUE(findings.empty());
}

TEST(nominal_check, a_result_that_is_none_says_nothing_about_the_nominal) {
  calibration::CalibrationResult failed = solved_at(mounted(1.0, 0.0));
  failed.status = calibration::Status::TooFewPairs;
  EXPECT_TRUE(found(mounted(1.0, 180.0), failed).empty());
}

}  // namespace
}  // namespace remount::results
