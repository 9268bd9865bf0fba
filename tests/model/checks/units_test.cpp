#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/checks/builtin.h"
#include "model/simulator/simulator.h"
#include "tests/model/checks/check_fixture.h"

namespace remount::checks {
namespace {

drive::Session drive_with_imu() {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::FigureEight;
  options.duration_s = 15.0;
  options.beams = 2;
  options.azimuth_steps = 20;
  return simulator::simulate_drive(options).session;
}

TEST(unit_check, right_units_pass) {
  const drive::Session session = drive_with_imu();
  ASSERT_GT(session.imu.size(), 100U);
  EXPECT_TRUE(found_by(unit_check(), session).empty()) << english(found_by(unit_check(), session)[0].explanation);
  EXPECT_TRUE(found_by(unit_check(), good_drive()).empty());
}

TEST(unit_check, radians_that_are_taken_for_degrees_lie_in_the_sea) {
  drive::Session session = good_drive();
  for (motion::InsSample& sample : session.ins) {
    sample.latitude_rad = degrees_to_radians(sample.latitude_rad);
    sample.longitude_rad = degrees_to_radians(sample.longitude_rad);
  }
  const std::vector<drive::Finding> findings = found_by(unit_check(), session);
  ASSERT_TRUE(testing::has_code(findings, "position-unit"));
  EXPECT_EQ(findings[0].severity, drive::Severity::Problem);
  EXPECT_NE(english(findings[0].explanation).find("latitude 0.8500"), std::string::npos)
      << english(findings[0].explanation);
}

TEST(unit_check, rates_in_degrees_and_forces_in_g_are_named) {
  drive::Session degrees = drive_with_imu(), shrunk = degrees, in_g = degrees;
  for (motion::ImuSample& sample : degrees.imu) sample.angular_rate_radps *= 180.0 / kPi;
  for (motion::ImuSample& sample : shrunk.imu) sample.angular_rate_radps *= kPi / 180.0;
  for (motion::ImuSample& sample : in_g.imu) sample.specific_force_mps2 /= 9.81;
  std::printf("degrees: %s\n", testing::said_of(found_by(unit_check(), degrees), "imu-rate-unit").c_str());
  EXPECT_TRUE(testing::has_code(found_by(unit_check(), degrees), "imu-rate-unit"));
  EXPECT_TRUE(testing::has_code(found_by(unit_check(), shrunk), "imu-rate-unit"));
  EXPECT_TRUE(testing::has_code(found_by(unit_check(), in_g), "imu-force-unit"));
  EXPECT_FALSE(testing::has_code(found_by(unit_check(), in_g), "imu-rate-unit"));
}

TEST(unit_check, the_beginning_of_a_bend_is_no_other_unit) {
  drive::Session bend = drive_with_imu();
  bend.ins.clear();
  for (std::size_t i = 0; i < bend.imu.size(); ++i) {
    motion::ImuSample& imu = bend.imu[i];
    const double time_s = 1e-9 * static_cast<double>(imu.stamp_ns - bend.imu.front().stamp_ns);
    imu.angular_rate_radps = {0.0, 0.0, 0.5 + 0.004 * (i % 2 == 0 ? 1.0 : -1.0)};
    motion::InsSample ins;
    ins.stamp_ns = imu.stamp_ns;
    ins.latitude_rad = 0.85;
    ins.longitude_rad = 0.2;
    ins.enu_from_ins = Eigen::AngleAxisd(0.5 * time_s, Eigen::Vector3d::UnitZ());
    bend.ins.push_back(ins);
  }
  EXPECT_FALSE(testing::has_code(found_by(unit_check(), bend), "imu-rate-unit"));
}

}  // namespace
}  // namespace remount::checks
