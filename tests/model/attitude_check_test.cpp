#include "model/attitude_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "model/io/attitude_convention.h"
#include "model/simulator/simulator.h"

namespace remount {
namespace {

Session drive() {
  SimulationOptions options;
  options.duration_s = 20.0;
  options.beams = 4;
  options.azimuth_steps = 20;
  return simulate_drive(options).session;
}

std::string codes(const Session& session) {
  std::string text;
  for (const Finding& finding : attitude_findings(session)) text += finding.code + " ";
  return text;
}

TEST(attitude_check, right_attitudes_pass_however_the_sensor_is_mounted) {
  for (const double yaw_deg : {0.0, 90.0, 180.0, -40.0}) {
    Session session = drive();
    for (InsSample& sample : session.ins)
      sample.enu_from_ins =
          sample.enu_from_ins * Eigen::AngleAxisd(degrees_to_radians(yaw_deg), Eigen::Vector3d::UnitZ());
    EXPECT_EQ(codes(session), "") << yaw_deg;
  }
}

TEST(attitude_check, a_quaternion_of_another_convention_is_named) {
  Session as_if_enu = drive(), as_if_ned = drive(), conjugated = drive();
  // What each sample says when the log's frames are taken for the other ones.
  const Eigen::Quaterniond ned_from_enu(Eigen::Matrix3d{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}});
  const Eigen::Quaterniond frd_from_flu(Eigen::Matrix3d{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
  for (InsSample& sample : as_if_enu.ins)
    sample.enu_from_ins = ned_from_enu * sample.enu_from_ins * frd_from_flu.conjugate();
  for (InsSample& sample : as_if_ned.ins)
    sample.enu_from_ins = enu_from_ins(sample.enu_from_ins, QuaternionConvention::NedFromBody);
  for (InsSample& sample : conjugated.ins) sample.enu_from_ins = sample.enu_from_ins.conjugate();
  EXPECT_EQ(codes(as_if_enu), "heading-against-travel ");
  EXPECT_EQ(codes(as_if_ned), "heading-against-travel ");
  EXPECT_EQ(codes(conjugated), "heading-against-travel ");
}

TEST(attitude_check, an_ins_upside_down_is_named_where_its_axes_are_known) {
  Session session = drive();
  const Eigen::Quaterniond over(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  for (InsSample& sample : session.ins) sample.enu_from_ins = sample.enu_from_ins * over;
  EXPECT_EQ(codes(session), "attitude-upside-down ");
  session.world_from_ins = metric_poses(session);
  session.ins.clear();
  EXPECT_EQ(codes(session), "") << "a pose file may have any axes";
}

TEST(attitude_check, headings_of_their_own_are_named_for_poses_too) {
  Session session = drive();
  for (InsSample& sample : session.ins)
    sample.enu_from_ins =
        Eigen::AngleAxisd(degrees_to_radians(1e-7) * static_cast<double>(sample.stamp_ns % 7200000000),
                          Eigen::Vector3d::UnitZ()) *
        Eigen::Quaterniond::Identity();
  session.world_from_ins = metric_poses(session);
  session.ins.clear();
  EXPECT_EQ(codes(session), "heading-against-travel ");
}

TEST(attitude_check, no_result_stands_on_a_heading_that_contradicts_the_travel) {
  const std::vector<Finding> findings = {{Severity::Problem, "heading-against-travel", "drive", ""}};
  CalibrationResult good;
  good.status = Status::Degenerate;
  good.observed.fill(true);
  good.translation_rms_m = 0.02;
  good.advice = {"drive more"};
  CalibrationResult fits = good, bad = good, failed = good, cancelled = good, other = good;
  blame_attitude(findings, fits);
  EXPECT_EQ(fits.status, Status::Degenerate) << "a robot may move sideways";
  bad.translation_rms_m = 6.0;
  other.translation_rms_m = 6.0;
  blame_attitude(findings, bad);
  EXPECT_EQ(bad.status, Status::Inconsistent);
  ASSERT_EQ(bad.advice.size(), 1U);
  EXPECT_NE(bad.advice[0].find("convention"), std::string::npos);
  failed.status = Status::TooFewPairs;
  blame_attitude(findings, failed);
  EXPECT_EQ(failed.status, Status::TooFewPairs);
  EXPECT_NE(failed.advice[0].find("convention"), std::string::npos);
  cancelled.status = Status::Cancelled;
  blame_attitude(findings, cancelled);
  EXPECT_EQ(cancelled.advice[0], "drive more");
  blame_attitude({}, other);
  EXPECT_EQ(other.status, Status::Degenerate);
}

TEST(attitude_check, a_vehicle_that_hardly_moves_tells_nothing) {
  Session session = drive();
  for (InsSample& sample : session.ins) {
    sample.latitude_rad = session.ins.front().latitude_rad;
    sample.longitude_rad = session.ins.front().longitude_rad;
    sample.height_m = 0.0;
    sample.enu_from_ins = sample.enu_from_ins.conjugate();
  }
  EXPECT_EQ(codes(session), "");
  EXPECT_EQ(codes(Session{}), "");
}

}  // namespace
}  // namespace remount
