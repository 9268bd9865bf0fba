#include "model/results/disagreement.h"

#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"

namespace remount::results {
namespace {

std::vector<drive::Finding> said_of(double rotation_rms_deg, calibration::Status status) {
  calibration::CalibrationResult result;
  result.status = status;
  result.set_observed(calibration::ParameterSet::all(), {});
  result.rotation_rms_rad = degrees_to_radians(rotation_rms_deg);
  std::vector<drive::Finding> findings{{drive::Severity::Warning, "motions-differ", {}, {}}};
  report_disagreement(result, findings);
  return findings;
}

TEST(disagreement, of_motions_beyond_noise_is_told) {
  EXPECT_TRUE(said_of(0.4, calibration::Status::Ok).empty()) << "an earlier one is taken away";
  EXPECT_TRUE(said_of(3.0, calibration::Status::TooFewPairs).empty()) << "nothing is claimed then";
  const std::vector<drive::Finding> findings = said_of(2.3, calibration::Status::Ok);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, drive::Severity::Warning);
}

}  // namespace
}  // namespace remount::results
