// Axes of an INS by the direction of travel, in session, result, exports and obstacle check.
#include "model/conventions/travel_axes.h"

#include <gtest/gtest.h>

#include "model/conventions/travel_direction.h"
#include "model/drive/session_frames.h"
#include "model/formats/sessions/session_reader.h"
#include "model/pipeline/input_checks.h"
#include "model/results/exporters/exporter.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::conventions {

using drive::InsAxes;

namespace {

simulator::SimulatedDrive driven(double speed_mps) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::Street;
  options.duration_s = 25.0;
  options.speed_mps = speed_mps;
  options.beams = 1;
  options.azimuth_steps = 16;
  options.ins_rate_hz = 20.0;
  return simulator::simulate_drive(options);
}

constexpr InsAxes kAllAxes[] = {InsAxes::ForwardLeftUp, InsAxes::RightForwardUp, InsAxes::BackwardRightUp,
                                InsAxes::LeftBackwardUp};

/// As an INS with other axes logs the drive.
drive::Session logged_in(const simulator::SimulatedDrive& drive, InsAxes axes) {
  drive::Session session = drive.session;
  session.scans.reset();
  const Eigen::Quaterniond level_from_ins(drive::forward_left_up_from(axes).linear());
  for (motion::InsSample& sample : session.ins) sample.enu_from_ins = sample.enu_from_ins * level_from_ins;
  return session;
}

bool told_by_travel(const drive::Session& session) { return testing::has_code(session.findings, "ins-axes-by-travel"); }

TEST(travel_axes, are_told_of_every_box_whatever_the_format_calls_them) {
  const simulator::SimulatedDrive drive = driven(9.0);
  for (const InsAxes axes : kAllAxes)
    for (const bool declared : {true, false}) {
      drive::Session session = logged_in(drive, axes);
      if (!declared) session.ins_axes.reset();
      settle_axes(session);
      EXPECT_EQ(session.ins_axes, axes);
      EXPECT_EQ(told_by_travel(session), !declared || axes != InsAxes::ForwardLeftUp);
    }
}

TEST(travel_axes, whose_z_points_down_are_not_called_by_a_name) {
  const simulator::SimulatedDrive drive = driven(9.0);
  for (const bool declared : {true, false}) {
    drive::Session session = drive.session;
    session.scans.reset();
    for (motion::InsSample& sample : session.ins)
      sample.enu_from_ins = sample.enu_from_ins * Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);  // forward, right, down
    if (!declared) session.ins_axes.reset();
    settle_axes(session);
    EXPECT_FALSE(session.ins_axes);
    EXPECT_FALSE(told_by_travel(session));
    ASSERT_FALSE(session.findings.empty());
    EXPECT_EQ(session.findings.back().code, "ins-axes-down");
  }
}

TEST(travel_axes, of_a_slow_vehicle_that_may_be_in_reverse_are_left_as_they_are_declared) {
  const simulator::SimulatedDrive drive = driven(3.0);
  for (const InsAxes axes : {InsAxes::BackwardRightUp, InsAxes::LeftBackwardUp}) {
    drive::Session session = logged_in(drive, axes);
    settle_axes(session);
    EXPECT_EQ(session.ins_axes, InsAxes::ForwardLeftUp);
    EXPECT_FALSE(told_by_travel(session));
  }
  drive::Session sideways = logged_in(drive, InsAxes::RightForwardUp);
  settle_axes(sideways);
  EXPECT_EQ(sideways.ins_axes, InsAxes::RightForwardUp);
}

TEST(travel_axes, of_one_drive_are_those_of_another_that_is_too_short_to_tell) {
  const simulator::SimulatedDrive drive = driven(9.0);
  const auto longer = std::make_shared<drive::Session>(logged_in(drive, InsAxes::RightForwardUp));
  const auto shorter = std::make_shared<drive::Session>(*longer);
  shorter->ins.resize(40);
  for (motion::InsSample& sample : shorter->ins) sample.stamp_ns += 1'000'000'000'000;
  settle_axes(*longer);
  settle_axes(*shorter);
  EXPECT_EQ(shorter->ins_axes, InsAxes::ForwardLeftUp) << "as its format has it";
  EXPECT_EQ(drive::common_axes({shorter, longer}), InsAxes::RightForwardUp);
  EXPECT_NO_THROW(pipeline::check_companions({shorter, longer}));
}

TEST(travel_axes, of_exports_are_turned_to_those_of_apollo_from_all_and_never_twice) {
  const RigidTransform level_from_lidar = rigid_from_six({0.9, -0.25, 0.75, 0.03, -0.02, 0.015});
  for (const InsAxes axes : kAllAxes) {
    results::ResultFile result;
    result.ins_axes = axes;
    result.result.mounting.reference_from_sensor = drive::forward_left_up_from(axes).inverse() * level_from_lidar;
    if (axes == InsAxes::RightForwardUp) {
      EXPECT_ERROR(results::exporter("apollo-rfu").write(result, {}), "must not be turned again");
      continue;
    }
    const std::string text = results::exporter("apollo-rfu").write(result, {});
    const RigidTransform read = results::exporter("apollo-rfu").read(text, "x.yaml");  // in x forward, y left
    EXPECT_LT((read.matrix() - level_from_lidar.matrix()).cwiseAbs().maxCoeff(), 1e-9) << to_string(axes);
  }
}

TEST(travel_axes, of_a_robot_that_goes_any_way_are_not_told) {
  const simulator::SimulatedDrive drive = driven(5.0);
  drive::Session session = drive.session;
  session.scans.reset();
  for (std::size_t i = 0; i < session.ins.size(); ++i)
    session.ins[i].enu_from_ins =
        Eigen::Quaterniond(Eigen::AngleAxisd(0.05 * static_cast<double>(i), Eigen::Vector3d::UnitZ()));
  EXPECT_FALSE(travel_direction(MetricPoses(session)));
  settle_axes(session);
  EXPECT_FALSE(told_by_travel(session));
}

TEST(travel_direction, is_known_to_a_tenth_of_a_degree_and_knows_how_well) {
  for (const double turned_deg : {0.0, 1.5, -2.2, 91.0}) {
    const simulator::SimulatedDrive drive = driven(8.0);
    drive::Session session = drive.session;
    session.scans.reset();
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(-degrees_to_radians(turned_deg), Eigen::Vector3d::UnitZ()));
    for (motion::InsSample& sample : session.ins) sample.enu_from_ins = sample.enu_from_ins * turned;
    const auto travel = travel_direction(MetricPoses(session));
    ASSERT_TRUE(travel);
    const double off_deg = radians_to_degrees(travel->yaw_rad) - turned_deg;
    std::printf("  turned by %.1f deg: off by %+.3f deg, sigma %.3f\n", turned_deg, off_deg,
                radians_to_degrees(travel->sigma_rad));
    EXPECT_LT(std::abs(off_deg), 3.0 * radians_to_degrees(travel->sigma_rad));
    EXPECT_LT(radians_to_degrees(travel->sigma_rad), 0.5);
    EXPECT_TRUE(travel->forwards);
  }
}

}  // namespace
}  // namespace remount::conventions
