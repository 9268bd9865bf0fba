// Poses that are of a plane: what they do not tell is not claimed.
#include "model/conventions/plane_poses.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/conventions/assumed_tilt.h"
#include "model/method_registry/calibration_method.h"
#include "model/overview/motion_outlook.h"
#include "model/pipeline/pipeline.h"
#include "tests/model/simulator/written_drive.h"
#include "tests/support/calibration_checks.h"
#include "tests/support/findings.h"

namespace remount::conventions {
namespace {

/// What a source of poses leaves out.
enum class LeftOut { Nothing, Heights, Tilts, Both };

RigidTransform flattened(const RigidTransform& pose, LeftOut left_out) {
  Eigen::Vector3d place = pose.translation();
  Eigen::Matrix3d rotation = pose.linear();
  if (left_out == LeftOut::Heights || left_out == LeftOut::Both) place.z() = 0.0;
  if (left_out == LeftOut::Tilts || left_out == LeftOut::Both) {
    const double yaw_rad = std::atan2(rotation(1, 0), rotation(0, 0));
    rotation = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  return make_rigid(rotation, place);
}

/// A drive over ramps with the poses of its INS, as a source has them that leaves that out.
struct PlaneDrive {
  std::shared_ptr<const drive::Session> session;
  RigidTransform truth;
};

PlaneDrive plane_drive(LeftOut left_out, simulator::ScenarioKind scenario = simulator::ScenarioKind::ParkingRamp) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.seed = 3;
  options.duration_s = 24.0;
  options.beams = 8;
  options.azimuth_steps = 90;
  options.ins_rate_hz = 20.0;
  const formats::TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(simulator::simulate_drive(options), simulator::drive_in(folder), "poses", 1, progress);
  auto session = std::make_shared<drive::Session>(formats::open_session(simulator::drive_in(folder), progress));
  for (motion::StampedPose& pose : session->world_from_ins) pose.pose = flattened(pose.pose, left_out);
  settle_plane(*session);
  return {session, simulator::true_mounting(folder)};
}

TEST(plane_poses, are_told_from_measured_ones_and_what_they_leave_open_is_set) {
  for (const auto& [left_out, said] : {std::pair{LeftOut::Nothing, ""},
                                       {LeftOut::Heights, "All poses have the same height"},
                                       {LeftOut::Tilts, "All poses are level, over"},
                                       {LeftOut::Both, "All poses are level and have the same height"}}) {
    const PlaneDrive drive = plane_drive(left_out);
    const drive::Session& session = *drive.session;
    const bool measured = left_out == LeftOut::Nothing;
    EXPECT_EQ(session.ins_tilt_sigma_rad, measured ? 0.0 : kAssumedTilt_rad) << said;
    EXPECT_EQ(assumed_tilt_sigma_rad(session), session.ins_tilt_sigma_rad) << said;
    EXPECT_EQ(session.unmeasured_height_sigma_m > 0.0, left_out == LeftOut::Heights || left_out == LeftOut::Both)
        << said;
    EXPECT_EQ(testing::has_code(session.findings, kPosesInPlane), !measured) << said;
    if (!measured) {
      testing::expect_told(session.findings, kPosesInPlane, said);
      EXPECT_EQ(testing::finding_of(session.findings, kPosesInPlane)->severity, drive::Severity::Warning);
    }
  }
}

TEST(plane_poses, that_hardly_move_say_nothing) {
  drive::Session session;
  for (int i = 0; i < 10; ++i)
    session.world_from_ins.push_back({i, make_rigid(Eigen::Matrix3d::Identity(), {0.4 * i, 0.0, 1.5})});
  settle_plane(session);
  EXPECT_TRUE(session.findings.empty());
  EXPECT_EQ(session.ins_tilt_sigma_rad, 0.0);
}

TEST(plane_poses, claim_no_height_pitch_or_roll_of_the_mounting) {
  using calibration::Parameter;
  for (const simulator::ScenarioKind scenario : {simulator::ScenarioKind::Hill, simulator::ScenarioKind::ParkingRamp})
    for (const LeftOut left_out : {LeftOut::Heights, LeftOut::Tilts, LeftOut::Both})
      for (const std::string method : {"pairwise", "trajectory"}) {
        SCOPED_TRACE(method + ", left out " + std::to_string(static_cast<int>(left_out)) + ", scenario " +
                     std::to_string(static_cast<int>(scenario)));
        const PlaneDrive drive = plane_drive(left_out, scenario);
        pipeline::PipelineInput input;
        input.settings.run.map_check = false;
        input.sessions.push_back(drive.session);
        input.nominal_ins_from_lidar = drive.truth * rigid_from_six({0.2, -0.2, -0.3, 0.03, -0.03, 0.02});
        Progress progress;
        const calibration::CalibrationResult result =
            method_registry::calibration_method(method).run(input, progress).result;
        testing::error_of(result, drive.truth);
        EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
        EXPECT_TRUE(result.known[Parameter::Yaw].observed);
        // Many slopes up and down average: just within what counts as observed, as of logs of headings alone.
        for (const Parameter tilt : {Parameter::Pitch, Parameter::Roll})
          EXPECT_GT(result.estimate(tilt).sigma.value_or(1.0), degrees_to_radians(0.5)) << to_string(tilt);
        EXPECT_GT(result.estimate(Parameter::Z).sigma.value_or(1.0), 0.2);
        testing::expect_within_sigma(result, drive.truth, 3.5);
      }
}

TEST(plane_poses, are_told_before_anything_is_calibrated) {
  using calibration::Parameter;
  for (const LeftOut left_out : {LeftOut::Heights, LeftOut::Tilts, LeftOut::Both}) {
    const overview::MotionOutlook outlook = overview::motion_outlook(*plane_drive(left_out).session, {}, {});
    EXPECT_TRUE(outlook.determinable.contains(Parameter::Yaw));
    for (const Parameter open : {Parameter::Z, Parameter::Pitch, Parameter::Roll})
      EXPECT_FALSE(outlook.determinable.contains(open)) << to_string(open) << " " << static_cast<int>(left_out);
  }
}

}  // namespace
}  // namespace remount::conventions
