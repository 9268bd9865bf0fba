// Files of poses as sessions: whose they are.
#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

/// EuRoC's order, w before x y z: turned by 60 degrees to the left, then nose up, then right side down.
std::string euroc_truth(const char* head) {
  const double half_rad = degrees_to_radians(30.0), c = std::cos(half_rad), s = std::sin(half_rad);
  std::string text = std::string(head) + "\n";
  int i = 0;
  for (const Eigen::Vector4d& wxyz :
       {Eigen::Vector4d(c, 0, 0, s), Eigen::Vector4d(c, 0, -s, 0), Eigen::Vector4d(c, s, 0, 0)}) {
    char line[256];
    std::snprintf(line, sizeof line, "%lld,4.5,-1.75,0.5,%.15f,%.15f,%.15f,%.15f,0.1,0.2,0.3\n",
                  1'403'636'580'838'555'648LL + 5'000'000LL * i++, wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    text += line;
  }
  return text;
}

TEST(pose_session_reader, the_truth_of_euroc_and_tum_vi_is_of_the_body_with_w_first) {
  constexpr const char* kEuroc =
      "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], v_RS_R_x [m "
      "s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1]";
  constexpr const char* kTumVi =
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],a,b,c";
  for (const auto& [name, head] :
       {std::pair{"mav0/state_groundtruth_estimate0/data.csv", kEuroc}, {"mav0/mocap0/data.csv", kTumVi}}) {
    const TemporaryFolder folder;
    const drive::Session session = open(folder.write(name, euroc_truth(head)));
    EXPECT_EQ(session.format, "poses");
    EXPECT_TRUE(session.odometry_from_lidar.empty()) << name;
    ASSERT_EQ(session.world_from_ins.size(), 3U) << name;
    EXPECT_EQ(session.world_from_ins[1].stamp_ns, 1'403'636'580'843'555'648);
    const Eigen::Vector3d place = session.world_from_ins[2].pose.translation();
    EXPECT_LT((place - Eigen::Vector3d(4.5, -1.75, 0.5)).norm(), 1e-12);
    const double sixty_rad = degrees_to_radians(60.0);
    EXPECT_NEAR(yaw_pitch_roll_from_rotation(session.world_from_ins[0].pose.linear()).yaw_rad, sixty_rad, 1e-9);
    EXPECT_NEAR(yaw_pitch_roll_from_rotation(session.world_from_ins[1].pose.linear()).pitch_rad, -sixty_rad, 1e-9);
    EXPECT_NEAR(yaw_pitch_roll_from_rotation(session.world_from_ins[2].pose.linear()).roll_rad, sixty_rad, 1e-9);
  }
}

TEST(pose_session_reader, the_truth_is_found_from_any_parent_and_goes_with_poses_of_the_lidar) {
  constexpr const char* kHead =
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []";
  const TemporaryFolder folder;
  folder.write("MH_01/mav0/state_groundtruth_estimate0/data.csv", euroc_truth(kHead));
  folder.write("MH_01/mav0/vicon0/data.csv", euroc_truth(kHead) + euroc_truth(kHead));
  folder.write("MH_01/mav0/imu0/data.csv",
               "#timestamp [ns],w_x,w_y,w_z,a_x,a_y,a_z\n1403636580838555648,0,0,0,0,0,9\n");
  for (const char* below : {"MH_01", "MH_01/mav0", "MH_01/mav0/", "MH_01/mav0/state_groundtruth_estimate0"}) {
    const drive::Session session = open(folder.path() / below);
    EXPECT_EQ(session.world_from_ins.size(), 3U) << below;
    EXPECT_TRUE(session.odometry_from_lidar.empty()) << below;
    EXPECT_NE(find(session, "one-stream"), nullptr) << below;
    EXPECT_TRUE(contains(session.files.at(0).string(), "state_groundtruth")) << "estimated, before what Vicon saw";
  }
  std::string odometry;
  for (int i = 0; i < 3; ++i)
    odometry += "1403636580.8" + std::to_string(40 + 4 * i) + " " + std::to_string(i) + " 0 0 0 0 0 1\n";
  folder.write("MH_01/mav0/lidar.txt", odometry);
  const drive::Session both = open(folder.path() / "MH_01/mav0");
  EXPECT_EQ(both.world_from_ins.size(), 3U);
  EXPECT_EQ(both.odometry_from_lidar.size(), 3U);
  EXPECT_EQ(find(both, "one-stream"), nullptr);
}

TEST(pose_session_reader, the_same_numbers_in_tums_order_are_of_w_last) {
  const TemporaryFolder folder;
  folder.write("d/lidar.txt", "1 0 0 0 0 0 0.5 0.8660254037844386\n2 1 0 0 0 0 0 1\n3 2 0 0 0 0 0 1\n");
  const drive::Session session = open(folder.path() / "d/lidar.txt");
  ASSERT_EQ(session.odometry_from_lidar.size(), 3U);
  EXPECT_NEAR(yaw_pitch_roll_from_rotation(session.odometry_from_lidar[0].pose.linear()).yaw_rad,
              degrees_to_radians(60.0), 1e-9);
}

}  // namespace
}  // namespace remount::formats
