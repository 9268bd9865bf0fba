#include <gtest/gtest.h>

#include "model/checks/builtin.h"
#include "model/simulator/simulator.h"
#include "tests/model/checks/check_fixture.h"
#include "tests/support/forwarded_scans.h"

namespace remount::checks {
namespace {

/// The scans of another source, with points that are taken elsewhere.
class ChangedScans final : public testing::ForwardedScans {
 public:
  ChangedScans(std::shared_ptr<const ScanSource> scans, Eigen::Matrix3f change)
      : ForwardedScans(std::move(scans)), change_(std::move(change)) {}
  cloud::PointCloud load(std::size_t scan) const override {
    cloud::PointCloud cloud = ForwardedScans::load(scan);
    for (Eigen::Vector3f& point : cloud.points) point = change_ * point;
    return cloud;
  }

 private:
  Eigen::Matrix3f change_;
};

drive::Session drive(simulator::ScenarioKind scenario,
                     const SixParameters& mounting = {1.2, -0.3, 1.6, 0.1, 0.02, -0.02}) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = 15.0;
  options.beams = 16;
  options.azimuth_steps = 450;
  options.ins_from_lidar = rigid_from_six(mounting);
  return simulator::simulate_drive(options).session;
}

drive::Session changed(drive::Session session, const Eigen::Vector3f& signs) {
  session.scans = std::make_shared<ChangedScans>(session.scans, signs.asDiagonal());
  return session;
}

TEST(handedness_check, mirrored_clouds_are_named_whichever_axis_is_wrong) {
  const drive::Session street = drive(simulator::ScenarioKind::Street),
                       ramp = drive(simulator::ScenarioKind::ParkingRamp);
  for (const drive::Session& session : {street, ramp})
    for (const Eigen::Vector3f& signs :
         {Eigen::Vector3f(1, -1, 1), Eigen::Vector3f(-1, 1, 1), Eigen::Vector3f(1, 1, -1)}) {
      const std::vector<drive::Finding> findings = found_by(handedness_check(), changed(session, signs));
      EXPECT_TRUE(testing::has_code(findings, "cloud-left-handed")) << signs.transpose();
      if (!findings.empty()) {
        EXPECT_EQ(findings[0].severity, drive::Severity::Problem);
      }
    }
}

TEST(handedness_check, waits_until_the_clocks_are_mended) {
  drive::Session session = changed(drive(simulator::ScenarioKind::Street), {1, -1, 1});
  session.findings.push_back({drive::Severity::Warning, "clock-leap-seconds", {}, {}});
  EXPECT_TRUE(found_by(handedness_check(), session).empty());
}

TEST(handedness_check, right_handed_clouds_pass_however_the_sensor_is_mounted) {
  for (const SixParameters& mounting :
       {SixParameters{1.2, -0.3, 1.6, 0.1, 0, 0}, SixParameters{1.2, -0.3, 1.6, 2.5, 0.0, kPi},
        SixParameters{-1.0, 0.5, 1.6, -1.5, 0.5, 0.0}})
    EXPECT_TRUE(found_by(handedness_check(), drive(simulator::ScenarioKind::Street, mounting)).empty())
        << mounting.yaw_rad;
}

TEST(handedness_check, an_attitude_that_turns_the_wrong_way_is_not_blamed_on_the_cloud) {
  drive::Session session = drive(simulator::ScenarioKind::Street);
  for (motion::InsSample& sample : session.ins) sample.enu_from_ins = sample.enu_from_ins.conjugate();
  EXPECT_TRUE(testing::has_code(found_by(attitude_data_check(), session), "attitude-convention"));
  EXPECT_TRUE(found_by(handedness_check(), session).empty());
}

}  // namespace
}  // namespace remount::checks
