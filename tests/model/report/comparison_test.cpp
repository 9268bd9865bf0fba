#include "model/report/comparison.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"

namespace remount::report {
namespace {

NamedResult result(const std::string& name, double yaw_rad, double sigma_rad) {
  NamedResult out{name, {}};
  out.file.result.status = calibration::Status::Ok;
  out.file.result.mounting.reference_from_sensor = rigid_from_six({0.9, -0.2, 0.7, yaw_rad, 0.0, 0.0});
  out.file.result.set_observed(calibration::ParameterSet::all(), {});
  out.file.result.covariance = sigma_rad * sigma_rad * Matrix6d::Identity();
  return out;
}

TEST(compare_results, warns_where_two_differ_by_more_than_they_claim_and_only_there) {
  const auto near = compare_results({result("a", 0.010, 0.001), result("b", 0.012, 0.001)});
  ASSERT_EQ(near.size(), 1U);
  EXPECT_FALSE(near[0].contradict) << near[0].words;
  EXPECT_NE(english(near[0].words).find("yaw differs by 0.115 deg, 1.4 times"), std::string::npos) << near[0].words;
  const auto far = compare_results({result("a", 0.010, 0.001), result("b", 0.020, 0.001)});
  EXPECT_TRUE(far[0].contradict) << far[0].words;
  EXPECT_NE(english(far[0].words).find("a and b contradict each other: yaw"), std::string::npos) << far[0].words;
}

TEST(compare_results, a_lidar_can_have_been_moved_between_two_recordings_and_not_within_one) {
  NamedResult a = result("a", 0.010, 0.001), b = result("b", 0.020, 0.001);
  a.file.inputs = {{"drive", "scan.pcd", 12, "aa"}, {"drive", "ins.csv", 30, "bb"}};
  b.file.inputs = a.file.inputs;
  EXPECT_EQ(english(compare_results({a, b})[0].words).find("moved in between"), std::string::npos);
  b.file.inputs[1].sha256 = "cc";
  EXPECT_NE(english(compare_results({a, b})[0].words).find("moved in between"), std::string::npos);
  a.file.inputs.clear();
  b.file.inputs.clear();
  EXPECT_NE(english(compare_results({a, b})[0].words).find("moved in between"), std::string::npos) << "not known";
}

TEST(compare_results, angles_on_either_side_of_half_a_turn_are_near) {
  const auto compared = compare_results({result("a", kPi - 0.001, 0.001), result("b", -kPi + 0.001, 0.001)});
  EXPECT_FALSE(compared[0].contradict) << compared[0].words;
  EXPECT_NEAR(compared[0].difference.difference[calibration::Parameter::Yaw], -0.002, 1e-12);
}

TEST(compare_results, every_two_once_and_what_is_not_observed_by_both_is_left_out) {
  NamedResult flat = result("flat", 0.5, 0.001);
  flat.file.result.status = calibration::Status::Degenerate;
  flat.file.result.withdraw(calibration::Parameter::Yaw, Message::verbatim("not shown by this drive"));
  flat.file.result.covariance.row(3).setConstant(std::nan(""));
  flat.file.result.covariance.col(3).setConstant(std::nan(""));
  const auto compared = compare_results({result("a", 0.0, 0.001), flat, result("c", 0.0, 0.001)});
  ASSERT_EQ(compared.size(), 3U);
  EXPECT_FALSE(compared[0].contradict) << "yaw is not observed by both: " << compared[0].words;
  EXPECT_TRUE(std::isnan(compared[0].difference.sigma[calibration::Parameter::Yaw]));
}

TEST(compare_results, other_frames_and_unusable_results_are_not_compared_and_say_so) {
  NamedResult vehicle = result("wheels", 0.5, 0.001), failed = result("failed", 0.0, 0.001);
  vehicle.file.result.mounting.reference = calibration::BodyFrame::Vehicle;
  failed.file.result.status = calibration::Status::NotConverged;
  const auto compared = compare_results({result("a", 0.0, 0.001), vehicle, failed});
  for (const ComparedResults& pair : compared) {
    EXPECT_FALSE(pair.contradict);
    EXPECT_EQ(english(pair.words).rfind("Not compared: ", 0), 0U) << pair.words;
    EXPECT_TRUE(std::isnan(pair.difference.difference[calibration::Parameter::X]));
  }
  EXPECT_NE(english(compared[0].words).find("\"ins\" and wheels in \"vehicle\""), std::string::npos)
      << compared[0].words;
}

}  // namespace
}  // namespace remount::report
