// Sessions in the layout of nuScenes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/files/input_file.h"
#include "model/formats/sessions/several_sessions.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/sessions/nuscenes_fixture.h"

namespace remount::formats {
namespace {

using Eigen::Vector3d;

TEST(nuscenes_reader, quaternions_are_w_first_and_the_vehicle_looks_ahead_left_up) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-0061");
  fixture.write(folder);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.format, "nuscenes");
  EXPECT_EQ(session.name, "scene-0061");
  EXPECT_EQ(session.lidar_name, "LIDAR_TOP");
  EXPECT_EQ(session.ins_axes, drive::InsAxes::ForwardLeftUp);
  ASSERT_EQ(session.world_from_ins.size(), 4U);
  EXPECT_EQ(session.world_from_ins[1].stamp_ns, 1'532'402'927'697'951'000);
  EXPECT_LT((session.world_from_ins[1].pose.translation() - Vector3d(412.5, 1181.25, 0.0)).norm(), 1e-9);
  const double thirty_rad = degrees_to_radians(30.0);
  EXPECT_NEAR(yaw_pitch_roll_from_rotation(session.world_from_ins[0].pose.linear()).yaw_rad, thirty_rad, 1e-9);
  EXPECT_NEAR(yaw_pitch_roll_from_rotation(session.world_from_ins[1].pose.linear()).pitch_rad, thirty_rad, 1e-9);
  EXPECT_NEAR(yaw_pitch_roll_from_rotation(session.world_from_ins[2].pose.linear()).roll_rad, thirty_rad, 1e-9);
  // LIDAR_TOP has x to the right and y ahead: turned by -90 degrees, its y is the vehicle's x.
  ASSERT_TRUE(session.nominal_ins_from_lidar);
  const Vector3d ahead = session.nominal_ins_from_lidar->linear() * Vector3d::UnitY();
  EXPECT_LT((ahead - Vector3d::UnitX()).norm(), 1e-9) << ahead.transpose();
  EXPECT_LT((session.nominal_ins_from_lidar->translation() - Vector3d(0.943713, 0.0, 1.84023)).norm(), 1e-12);
  ASSERT_EQ(session.scans->size(), 4U);
  const cloud::PointCloud cloud = session.scans->load(3);
  EXPECT_EQ(cloud.points, (std::vector<Eigen::Vector3f>{{1, 2, -1.5F}, {2, 2, -1.5F}, {3, 2, -1.5F}}));
  EXPECT_EQ(cloud.intensity, std::vector<float>(3, 40.0F));
  EXPECT_EQ(cloud.ring, std::vector<std::uint16_t>(3, 7));
  EXPECT_NE(find(session, "nominal-found"), nullptr);
  ASSERT_NE(find(session, "poses-by-mounting"), nullptr);
  EXPECT_EQ(find(session, "poses-by-mounting")->severity, drive::Severity::Note) << "whose poses they are is not known";
}

TEST(nuscenes_reader, only_sweeps_that_the_publisher_named_count_as_compensated) {
  for (const bool published : {true, false}) {
    const TemporaryFolder folder;
    NuscenesFixture fixture;
    fixture.prefix = published ? "n015-2018-07-24-11-22-45+0800__" : "simulated__";
    fixture.add_scene(folder, published ? "" : "a");
    fixture.write(folder);
    const drive::Session session = open(folder.path());
    EXPECT_EQ(session.scan_timing, published ? drive::ScanTiming::Instant : drive::ScanTiming::Unknown);
    EXPECT_EQ(find(session, "no-point-times") == nullptr, published);
    ASSERT_NE(find(session, "poses-by-mounting"), nullptr);
    EXPECT_EQ(find(session, "poses-by-mounting")->severity,
              published ? drive::Severity::Warning : drive::Severity::Note);
  }
}

/// As MAN TruckScenes has them: microseconds since 1970.
std::string timed_pcd(std::int64_t stamp_us) {
  std::string text =
      "VERSION 0.7\nFIELDS x y z intensity timestamp\nSIZE 4 4 4 4 8\nTYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH 400\n"
      "HEIGHT 1\nPOINTS 400\nDATA ascii\n";
  for (int i = 0; i < 400; ++i) {
    const double azimuth_rad = -0.0157 * i;  // clockwise, a turn
    text += std::to_string(10.0 * std::cos(azimuth_rad)) + " " + std::to_string(10.0 * std::sin(azimuth_rad)) +
            " 1 7 " + std::to_string(stamp_us - 100'000 + 125 * i) + "\n";
  }
  return text;
}

TEST(nuscenes_reader, points_of_pcd_have_the_times_that_stand_there) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.pcd = timed_pcd(1'532'402'927'647'951);
  fixture.add_scene(folder, "scene-1", 2);
  fixture.write(folder);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  const cloud::PointCloud cloud = session.scans->load(0);
  ASSERT_EQ(cloud.time_from_stamp_s.size(), 400U);
  EXPECT_NEAR(cloud.time_from_stamp_s.front(), -0.1F, 1e-5F);
  EXPECT_NEAR(cloud.time_from_stamp_s.back(), -0.1F + 399 * 125e-6F, 1e-5F);
}

TEST(nuscenes_reader, pcd_without_times_may_be_swept_in_any_way) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.pcd =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA "
      "ascii\n1 2 3\n";
  fixture.add_scene(folder, "scene-1");
  fixture.write(folder);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::Unknown);
  EXPECT_TRUE(contains(testing::said_of(session.findings, "no-point-times"), "columns: x y z"));
}

TEST(nuscenes_reader, one_bad_row_costs_what_it_says_and_no_more) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-1", 6);
  NuscenesFixture other = fixture;
  const auto spoil = [](std::string& table, const std::string& good, const std::string& bad) {
    table.replace(table.find(good), good.size(), bad);
  };
  spoil(other.sample_data, "\"timestamp\": 1532402927697951", "\"timestamp\": \"soon\"");
  spoil(other.sample_data, "\"filename\": \"sweeps/LIDAR_TOP/scene-1__LIDAR_TOP__1532402927747951",
        "\"filename\": \"../a");
  spoil(other.poses, "\"token\": \"p3\", \"timestamp\": 15", "\"token\": \"p3\", \"timestamp\": 1.5");
  other.sample_data.insert(0, "\n{\"token\" 1},\n");
  other.write(folder);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.scans->size(), 4U);
  EXPECT_EQ(session.world_from_ins.size(), 3U);
  testing::expect_told(session.findings, "bad-rows", "3 rows of the table cannot be used and are left out");
  testing::expect_told(session.findings, "bad-rows", "sample_data.json:2: expected a row");
  testing::expect_told(session.findings, "bad-poses", "1 row of the table cannot be used");
  EXPECT_EQ(find(session, "missing-poses"), nullptr) << "it is there, and broken";
}

TEST(nuscenes_reader, sweeps_without_a_pose_are_counted_and_stay) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-1", 6);
  for (const char* token : {"\"p2\"", "\"p4\""}) fixture.poses.replace(fixture.poses.find(token), 4, "\"z\"");
  fixture.sample_data.replace(fixture.sample_data.find("\"p3\""), 4, "\"p2\"");  // shares one that is missing
  fixture.write(folder);
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.scans->size(), 6U) << "they are not left out";
  EXPECT_EQ(session.world_from_ins.size(), 3U);
  testing::expect_told(session.findings, "missing-poses", "3 sweeps have no ego pose");
  testing::expect_told(session.findings, "missing-poses",
                       "First: sweeps/LIDAR_TOP/scene-1__LIDAR_TOP__1532402927747951");
}

TEST(nuscenes_reader, of_several_versions_that_with_most_of_the_scans_is_used_and_others_are_named) {
  const TemporaryFolder folder;
  NuscenesFixture mini, all;
  mini.add_scene(folder, "scene-1", 3);
  mini.write(folder, "v1.0-a");  // first by name
  all.add_scene(folder, "scene-1", 5);
  all.write(folder, "v1.0-b");
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.scans->size(), 5U);
  testing::expect_told(session.findings, "tables-chosen", "v1.0-b is used");
  testing::expect_told(session.findings, "tables-chosen", "v1.0-a would do as well");
  const drive::Session asked = open(folder.path() / "v1.0-a");
  EXPECT_EQ(asked.scans->size(), 3U);
  EXPECT_EQ(find(asked, "tables-chosen"), nullptr);
  EXPECT_EQ(open(folder.path() / "v1.0-a/").scans->size(), 3U);
  NuscenesFixture other;  // another drive, of which nothing is in the others
  other.add_scene(folder, "scene-2", 3);
  other.write(folder, "v1.0-c");
  EXPECT_ERROR(open(folder.path()), "holds 2 scenes");
  folder.write("v1.0-c/sensor.json", "{}");
  const drive::Session broken = open(folder.path());
  EXPECT_EQ(broken.scans->size(), 5U);
  testing::expect_told(broken.findings, "bad-tables", "1 version of the tables cannot be read");
}

TEST(nuscenes_reader, a_scan_stands_for_its_scene_where_there_are_several) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-0061");
  fixture.add_scene(folder, "scene-0103", 3);
  fixture.write(folder);
  EXPECT_ERROR(open(folder.path()), "holds 2 scenes");
  EXPECT_ERROR(open(folder.path()), "scene-0103: ");
  Progress progress;
  try {
    open_session(folder.path(), progress);
    ADD_FAILURE() << "opened one of two";
  } catch (const SeveralSessions& several) {
    ASSERT_EQ(several.sessions().size(), 2U);
    EXPECT_EQ(open(several.sessions()[0]).name, "scene-0061");
    const drive::Session second = open(several.sessions()[1]);
    EXPECT_EQ(second.name, "scene-0103");
    EXPECT_EQ(second.world_from_ins.size(), 3U);
    EXPECT_EQ(second.scans->size(), 3U);
  }
  for (const char* kind : {"samples", "sweeps"})
    for (const auto& scan : files_in(folder.path() / kind / "LIDAR_TOP"))
      if (scan.filename().string().starts_with("scene-0103")) std::filesystem::remove(scan);
  EXPECT_EQ(open(folder.path()).name, "scene-0061") << "the other was not unpacked";
}

TEST(nuscenes_reader, lidars_go_by_their_channels) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.sensors.replace(fixture.sensors.size() - 1, 1,
                          R"(, {"token": "s2", "channel": "LIDAR_REAR", "modality": "lidar"}])");
  fixture.calibrated.replace(
      fixture.calibrated.size() - 1, 1,
      R"(, {"token": "c2", "sensor_token": "s2", "translation": [-1, 0, 1], "rotation": [1, 0, 0, 0]}])");
  fixture.add_scene(folder, "scene-1", 4, {"c1", "c2"});
  fixture.write(folder);
  Progress progress;
  const std::vector<drive::LidarOffer> offers = offer_lidars(folder.path(), progress);
  ASSERT_EQ(offers.size(), 2U);
  EXPECT_EQ(offers[0].name, "LIDAR_REAR");
  EXPECT_EQ(offers[1].scans, 4U);
  const drive::Session first = open(folder.path());
  EXPECT_EQ(first.lidar_name, "LIDAR_REAR");
  EXPECT_NE(find(first, "lidar-chosen"), nullptr);
  EXPECT_EQ(first.topics.size(), 2U);
  const drive::Session top = open_session(folder.path(), offers[1].choice, progress);
  EXPECT_EQ(top.lidar_name, "LIDAR_TOP");
  EXPECT_EQ(top.scans->size(), 4U);
  EXPECT_EQ(top.scans->load(0).ring.front(), 7);
  EXPECT_NEAR(top.nominal_ins_from_lidar->translation().x(), 0.943713, 1e-12);
  EXPECT_ERROR(open_session(folder.path(), {{"lidar", "LIDAR_LEFT"}}, progress), "LIDAR_TOP");
  EXPECT_ERROR(open_session(folder.path(), {{"ins", "a"}}, progress), "no topics");
  ASSERT_TRUE(offer_topics(folder.path(), progress));
}

TEST(nuscenes_reader, what_is_missing_or_broken_is_named) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-1");
  fixture.write(folder);
  const auto files = files_in(folder.path() / "sweeps/LIDAR_TOP");
  std::filesystem::remove(files[0]);
  folder.write("sweeps/LIDAR_TOP/" + files[1].filename().string(), "abc");
  const drive::Session session = open(folder.path());
  EXPECT_EQ(session.scans->size(), 3U);
  EXPECT_NE(find(session, "missing-scans"), nullptr);
  EXPECT_ERROR(session.scans->load(1), "holds 3 bytes");
  NuscenesFixture other = fixture;
  other.poses.replace(other.poses.find("\"p1\""), 4, "\"p9\"");
  other.write(folder);
  const drive::Session fewer = open(folder.path());
  EXPECT_EQ(fewer.world_from_ins.size(), 3U);
  EXPECT_NE(find(fewer, "missing-poses"), nullptr);
  other = fixture;
  other.poses.clear();
  other.write(folder);
  EXPECT_ERROR(open(folder.path()), "has no pose of the scene");
  other = fixture;
  other.calibrated.replace(other.calibrated.find("0.943713"), 8, "\"broken\"");
  other.write(folder);
  EXPECT_ERROR(open(folder.path()), "has no sweep of a LiDAR in a scene");
  EXPECT_ERROR(open(folder.path()), "calibrated_sensor.json: byte");
  fixture.write(folder);
  std::filesystem::remove(folder.path() / "v1.0-mini/scene.json");
  EXPECT_ERROR(open(folder.path()), "scene.json");
  fixture.write(folder);
  std::filesystem::remove_all(folder.path() / "sweeps");
  std::filesystem::remove_all(folder.path() / "samples");
  EXPECT_ERROR(open(folder.path()), "Unpack the data");
}

}  // namespace
}  // namespace remount::formats
