// UTM positions beside attitudes to true north: told, taken out, or in the sigma of yaw.
#include "model/conventions/pose_north.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_session_writer.h"
#include "tests/model/conventions/north_drives.h"
#include "tests/model/formats/bags/bag_maker.h"
#include "tests/support/calibration_checks.h"

namespace remount::conventions {
namespace {

using namespace north;

/// To both sides of their zones' middles, and of the equator.
constexpr Site kPlaces[] = {{"east in its zone, north", 48.8, 11.9},
                            {"west in its zone, north", 35.6, 138.4},
                            {"east in its zone, south", -33.9, 155.6},
                            {"west in its zone, south", -54.8, -71.5},
                            {"far north", 64.1, -18.4},
                            {"middle of its zone", 48.8, 9.05},
                            {"equator", 0.3, 37.2}};

/// Once as it is logged: what it is about.
TEST(pose_north, that_is_left_alone_turns_x_by_the_convergence_without_a_word) {
  const simulator::SimulatedDrive drive = drive_at(kPlaces[0]);
  const calibration::CalibrationResult result =
      solved(session_of(drive, utm_poses(drive, AttitudesTo::True, Origin::Utm), false));
  EXPECT_NEAR(std::abs(yaw_error_deg(result, drive.ins_from_lidar)), 2.18, 0.15);
}

/// By how much attitudes are off against the axes of the positions: what X is turned by.
double attitudes_off_deg(const drive::Session& session, const simulator::SimulatedDrive& drive) {
  const std::vector<motion::StampedPose> exact =
      geodesy::local_from_ins(drive.session.ins);  // of the grid, attitudes too
  const std::size_t at = exact.size() / 2;
  const Eigen::Matrix3d off = session.world_from_ins[at].pose.linear() * exact[at].pose.linear().transpose();
  return radians_to_degrees(yaw_pitch_roll_from_rotation(off).yaw_rad);
}

TEST(pose_north, of_the_grid_and_true_north_are_told_apart_everywhere) {
  for (const Site& place : kPlaces) {
    SCOPED_TRACE(place.name);
    const simulator::SimulatedDrive drive = drive_at(place);
    for (const Origin origin : {Origin::Utm, Origin::Start})
      for (const AttitudesTo north : {AttitudesTo::True, AttitudesTo::Grid})
        for (const bool fixes : {true, false}) {
          if (origin == Origin::Start && !fixes) continue;  // below
          const Poses poses = utm_poses(drive, north, origin);
          drive::Session session = session_of(drive, poses, fixes);
          settle_north(session);
          const double convergence_deg = radians_to_degrees(poses.convergence_rad),
                       off_deg = attitudes_off_deg(session, drive),
                       sigma_deg = radians_to_degrees(session.ins_north_sigma_rad);
          std::printf("%s: convergence %+.3f, %s, attitudes to %s, %s: off by %+.4f deg, sigma %.4f\n", place.name,
                      convergence_deg, origin == Origin::Utm ? "with origin" : "without origin",
                      north == AttitudesTo::True ? "true north" : "the grid", fixes ? "fixes" : "no fixes", off_deg,
                      sigma_deg);
          EXPECT_LT(std::abs(off_deg), 0.02 + 2.0 * sigma_deg);
          EXPECT_LT(sigma_deg, fixes ? 0.8 : 1.1);  // without fixes the hemisphere is open, too
          // What an INS that is turned by it would look like as well.
          EXPECT_TRUE(!fixes || 0.05 + 3.5 * sigma_deg > std::abs(convergence_deg));
          // Where the two norths are far apart, which of them it is has been told.
          if (std::abs(convergence_deg) < 1.2) continue;
          EXPECT_LT(std::abs(off_deg), 0.02);
          EXPECT_EQ(tells(session, "utm-true-north"), north == AttitudesTo::True);
        }
  }
}

TEST(pose_north, that_is_told_gives_x_within_its_sigma) {
  for (const Site& place : {kPlaces[0], kPlaces[3]}) {
    const simulator::SimulatedDrive drive = drive_at(place);
    drive::Session session = session_of(drive, utm_poses(drive, AttitudesTo::True, Origin::Utm), true);
    settle_north(session);
    const calibration::CalibrationResult result = solved(session);
    std::printf("%s: yaw off by %+.4f deg, sigma %.4f\n", place.name, yaw_error_deg(result, drive.ins_from_lidar),
                yaw_sigma_deg(result));
    EXPECT_EQ(result.status, calibration::Status::Ok) << english(result.message);
    testing::expect_within_sigma(result, drive.ins_from_lidar, 3.5);
    EXPECT_LT(std::abs(yaw_error_deg(result, drive.ins_from_lidar)), 0.15);
  }
}

TEST(pose_north, that_no_number_and_no_fix_tells_is_named_and_within_the_sigma_of_every_method) {
  for (const Site& place : {kPlaces[0], kPlaces[2]}) {
    const simulator::SimulatedDrive drive = drive_at(place);
    drive::Session session = session_of(drive, utm_poses(drive, AttitudesTo::True, Origin::Start), false);
    settle_north(session);
    EXPECT_TRUE(tells(session, "north-unknown"));
    for (const char* method : {"pairwise", "trajectory"}) {
      const calibration::CalibrationResult result = solved(session, method);
      std::printf("%s, %s: yaw off by %+.3f deg, sigma %.3f\n", place.name, method,
                  yaw_error_deg(result, drive.ins_from_lidar), yaw_sigma_deg(result));
      testing::expect_within_sigma(result, drive.ins_from_lidar, 2.5);
      EXPECT_TRUE(!result.known[calibration::kParameters[kYawOf]].observed || yaw_sigma_deg(result) > 0.5);
    }
  }
}

TEST(pose_north, of_a_world_that_is_turned_as_a_whole_is_left_alone) {
  const simulator::SimulatedDrive drive = drive_at(kPlaces[0]);
  for (const double turned_rad : {0.0, 0.7, -2.0}) {
    Poses poses;
    const RigidTransform world_from_enu = rigid_from_six({12.0, -7.0, 3.0, turned_rad, 0.0, 0.0});
    for (const motion::StampedPose& pose : drive::metric_poses(drive.session))
      poses.world_from_ins.push_back({pose.stamp_ns, world_from_enu * pose.pose});
    for (const bool fixes : {true, false}) {
      drive::Session session = session_of(drive, poses, fixes);
      settle_north(session);
      EXPECT_FALSE(tells(session, "utm-true-north")) << turned_rad;
      const calibration::CalibrationResult result = solved(session);
      testing::expect_within_sigma(result, drive.ins_from_lidar, 3.5);
      // Along the grid, where the fixes are of it, attitudes may be to true north and the INS turned.
      EXPECT_LT(yaw_sigma_deg(result), fixes && turned_rad == 0.0 ? 0.8 : 0.3) << turned_rad;
    }
  }
}

void write_odometry(const std::vector<motion::StampedPose>& poses, const std::string& topic, const std::string& frame,
                    bags::BagMaker& bag) {
  for (const motion::StampedPose& pose : poses) {
    bags::MessageWriter writer(bags::kRos1);
    writer.header(pose.stamp_ns, frame).string("base");
    const Eigen::Quaterniond turn(pose.pose.linear());
    for (const double value : pose.pose.translation()) writer.number(value);
    for (const double value : turn.coeffs()) writer.number(value);
    for (int k = 0; k < 36 + 6 + 36; ++k) writer.number(0.0);
    bag.add(pose.stamp_ns + 1'000'000, topic, "nav_msgs/Odometry", writer.bytes());
  }
}

TEST(pose_north, is_settled_in_every_source_of_poses) {
  const simulator::SimulatedDrive drive = drive_at(kPlaces[0]);
  const Poses poses = utm_poses(drive, AttitudesTo::True, Origin::Utm);
  const formats::TemporaryFolder folder;
  const std::string ins = formats::tum_text(poses.world_from_ins),
                    lidar = formats::tum_text(simulator::exact_odometry(drive));
  std::string csv = ins;
  std::replace(csv.begin(), csv.end(), ' ', ',');
  folder.write("tum/ins.txt", ins);
  folder.write("tum/lidar.txt", lidar);
  folder.write("csv/ins.csv", csv);
  folder.write("csv/lidar.txt", lidar);
  folder.write("native/a.txt", ins);
  folder.write("native/b.txt", lidar);
  folder.write("native/session.yaml",
               "format: remount-session/1\nname: n\nins_poses: {file: a.txt, format: tum}\n"
               "lidar_poses: {file: b.txt, format: tum}\n");
  bags::BagMaker bag(folder.path() / "drive.bag");
  write_odometry(poses.world_from_ins, "/novatel/oem7/odom", "map", bag);
  write_odometry(simulator::exact_odometry(drive), "/lio/odometry", "map", bag);
  bag.finish();
  for (const char* source : {"tum", "csv", "native", "drive.bag"}) {
    SCOPED_TRACE(source);
    Progress progress;
    const drive::Session session =
        std::string(source) == "drive.bag"
            ? formats::open_session(folder.path() / source, drive::TopicChoice{{"lidar", "/lio/odometry"}}, progress)
            : formats::open_session(folder.path() / source, progress);
    EXPECT_TRUE(tells(session, "utm-true-north"));
    const calibration::CalibrationResult result = solved(session);
    std::printf("%s: yaw off by %+.4f deg, sigma %.4f\n", source, yaw_error_deg(result, drive.ins_from_lidar),
                yaw_sigma_deg(result));
    testing::expect_within_sigma(result, drive.ins_from_lidar, 3.5);
    EXPECT_LT(std::abs(yaw_error_deg(result, drive.ins_from_lidar)), 0.15);
  }
}

TEST(pose_north, is_settled_once_by_what_is_written_of_it) {
  for (const bool fixes : {false, true}) {
    const simulator::SimulatedDrive drive = drive_at(kPlaces[0]);
    drive::Session session = session_of(drive, utm_poses(drive, AttitudesTo::True, Origin::Utm), fixes);
    settle_north(session);
    const formats::TemporaryFolder folder;
    Progress progress;
    formats::write_native_session(session, folder.path() / "s", 1, progress);
    const drive::Session again = formats::open_session(folder.path() / "s", progress);
    ASSERT_EQ(again.world_from_ins.size(), session.world_from_ins.size());
    const auto span = [](const drive::Session& one) {
      return one.world_from_ins.front().pose.inverse() * one.world_from_ins[one.world_from_ins.size() / 3].pose;
    };
    std::printf("distance written and read again: off by %.2g\n",
                span(again).translation().norm() / span(session).translation().norm() - 1.0);
    EXPECT_LT((span(again).translation() - span(session).translation()).norm(),
              (fixes ? 1e-3 : 1e-8) * span(session).translation().norm());
    EXPECT_LT(attitudes_off_deg(again, drive), 0.02);
  }
}

TEST(pose_north, scale_of_the_grid_is_taken_out_of_distances) {
  const simulator::SimulatedDrive drive = drive_at(kPlaces[5]);
  drive::Session session = session_of(drive, utm_poses(drive, AttitudesTo::Grid, Origin::Utm), false);
  const auto length = [](const std::vector<motion::StampedPose>& poses) {
    double sum_m = 0.0;
    for (std::size_t i = 50; i < poses.size(); i += 50)
      sum_m += (poses[i].pose.translation() - poses[i - 50].pose.translation()).norm();
    return sum_m;
  };
  const double logged_m = length(session.world_from_ins);
  settle_north(session);
  const double exact_m = length(geodesy::local_from_ins(drive.session.ins));
  EXPECT_LT(std::abs(length(session.world_from_ins) / exact_m - 1.0), 1e-6);
  EXPECT_GT(std::abs(logged_m / exact_m - 1.0), 3e-4);
}

}  // namespace
}  // namespace remount::conventions
