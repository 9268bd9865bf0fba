#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/drive/attitude_convention.h"
#include "model/formats/sessions/native_session_reader.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

const std::string kManifestScans = "scans: {directory: s, type: kitti-bin, stamps: from-names, timing: instant}\n";
const std::string kIns =
    "ins:\n  file: ins.csv\n  columns:\n    time: {name: t, unit: s, scale: unix}\n    latitude: {name: lat, unit: "
    "deg}\n"
    "    longitude: {name: lon, unit: deg}\n    height: h\n    attitude: {convention: heading, unit: deg, yaw: hdg, "
    "pitch: p, roll: r}\n";
const std::string kManifestHead = "format: remount-session/1\nname: test\n";

class native_manifest : public ::testing::Test {
 protected:
  native_manifest() {
    folder_.write("s/1600000000.bin", std::string(32, '\x3f'));
    folder_.write("s/1600000000.1.bin", std::string(32, '\x3f'));
    folder_.write("ins.csv", "t,lat,lon,h,hdg,p,r\n1600000000,48,9,250,90,1,2\n1600000000.5,48,9,250,91,1,2\n");
  }
  drive::Session open(const std::string& manifest) {
    folder_.write("session.yaml", manifest);
    Progress progress;
    return NativeSessionReader().open(folder_.path(), progress);
  }
  std::string message(const std::string& manifest) {
    return error_of([&] { open(manifest); });
  }
  TemporaryFolder folder_;
};

#define EXPECT_REFUSED(manifest, part)                                  \
  do {                                                                  \
    const std::string text_ = message(manifest);                        \
    EXPECT_TRUE(contains(text_, part)) << "message: '" << text_ << "'"; \
  } while (false)

TEST_F(native_manifest, columns_units_and_convention_as_declared) {
  const drive::Session session =
      open(kManifestHead + kManifestScans + kIns + "ins_noise: {position_sigma_m: 0.01, attitude_sigma_deg: 0.02}\n");
  ASSERT_EQ(session.ins.size(), 2u);
  EXPECT_EQ(session.ins[1].stamp_ns, 1'600'000'000'500'000'000);
  EXPECT_NEAR(session.ins[0].latitude_rad, degrees_to_radians(48), 1e-15);
  const Eigen::Vector3d nose_in_enu = session.ins[0].enu_from_ins * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(nose_in_enu.x(), std::cos(degrees_to_radians(1)), 1e-12) << "east";
  EXPECT_NEAR(nose_in_enu.z(), std::sin(degrees_to_radians(1)), 1e-12) << "nose up";
  EXPECT_EQ(session.scans->stamp_ns(1), 1'600'000'000'100'000'000);
  EXPECT_NEAR(session.ins_attitude_white_sigma_rad, degrees_to_radians(0.02), 1e-15);
  EXPECT_TRUE(std::isnan(session.ins_attitude_bias_sigma_rad));
}

TEST_F(native_manifest, columns_by_index_with_gps_time_radians_and_quaternion) {
  folder_.write("raw.csv", "some header\n0.8,0.15,250,2183,269353560,0,0,0.70710678118654757,0.70710678118654757\n");
  const drive::Session session =
      open(kManifestHead + kManifestScans +
           "ins:\n  file: raw.csv\n  columns:\n    time: {index: 4, unit: ms, scale: gps, week: 3}\n"
           "    latitude: {index: 0, unit: rad}\n    longitude: {index: 1, unit: rad}\n    height: 2\n"
           "    attitude: {convention: quaternion-enu, x: 5, y: 6, z: 7, w: 8}\n");
  ASSERT_EQ(session.ins.size(), 1u);
  EXPECT_EQ(session.ins[0].stamp_ns, 1'636'512'535'560'000'000);
  EXPECT_DOUBLE_EQ(session.ins[0].latitude_rad, 0.8);
  EXPECT_LT((session.ins[0].enu_from_ins * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

TEST_F(native_manifest, pose_streams_on_both_sides) {
  folder_.write("ins.txt", "1600000000 0 0 0 0 0 0 1\n1600000001 1 0 0 0 0 0 1\n");
  folder_.write("lidar.csv", "1600000000,0,0,0,0,0,0,1\n1600000001,1,0,0,0,0,0,1\n");
  const drive::Session session = open(
      kManifestHead + "ins_poses: {file: ins.txt, format: tum}\nlidar_poses: {file: lidar.csv, format: eth-csv}\n");
  EXPECT_EQ(session.world_from_ins.size(), 2u);
  EXPECT_EQ(session.odometry_from_lidar.size(), 2u);
}

TEST_F(native_manifest, mistakes_are_named_with_their_line) {
  EXPECT_REFUSED("", "session.yaml");
  EXPECT_REFUSED("format: remount-session/2\nname: x\n" + kManifestScans + kIns, "session.yaml:1");
  EXPECT_REFUSED(kManifestHead + kManifestScans + kIns + "colour: red\n", "session.yaml:12");
  EXPECT_REFUSED(kManifestHead + kManifestScans + kIns + "name: again\n", "name");
  EXPECT_REFUSED(kManifestHead + kIns, "expected either 'scans' or 'lidar_poses'");
  EXPECT_REFUSED(kManifestHead + kManifestScans, "expected either 'ins' or 'ins_poses'");
  EXPECT_REFUSED(kManifestHead + kManifestScans + kIns +
                     "nominal: {x_m: .nan, y_m: 0, z_m: 0, yaw_deg: 0, pitch_deg: 0, roll_deg: 0}\n",
                 "session.yaml:12");
  EXPECT_REFUSED(kManifestHead + kManifestScans + kIns + "nominal: {x_m: 1}\n", "session.yaml:12");
  EXPECT_REFUSED(kManifestHead + kManifestScans + kIns + "ins_noise: {position_sigma_m: -1}\n", "not negative");
  EXPECT_REFUSED(kManifestHead + "scans: {directory: s, type: e57, stamps: from-names, timing: instant}\n" + kIns,
                 "'e57' is not one of");
  EXPECT_REFUSED(kManifestHead + "scans: {directory: nowhere, type: pcd, stamps: from-names, timing: instant}\n" + kIns,
                 "there is no folder");
  EXPECT_REFUSED(kManifestHead + "scans: {directory: s, type: pcd, stamps: from-names, timing: instant}\n" + kIns,
                 "no scan with a stamp");
  EXPECT_REFUSED(kManifestHead + "scans: {directory: s, type: kitti-bin, stamps: from-names, timing: sweep}\n" + kIns,
                 "'sweep' stands with");
  EXPECT_REFUSED(kManifestHead + "scans: {directory: s, type: kitti-bin, stamps: none.csv, timing: instant}\n" + kIns,
                 "none.csv: cannot be opened");
  EXPECT_REFUSED(kManifestHead + "x: &a [1, *a]\n", "session.yaml:3");
  std::string wrong_column = kIns;
  wrong_column.replace(wrong_column.find("hdg"), 3, "yaw");
  EXPECT_REFUSED(kManifestHead + kManifestScans + wrong_column, "ins.csv:1: has no column 'yaw'");
  EXPECT_REFUSED(
      kManifestHead + kManifestScans +
          "ins: {file: s, columns: {time: {name: t, unit: s, scale: unix}, latitude: {name: a, unit: deg}, longitude: "
          "{name: a, unit: deg}, height: h, attitude: {convention: heading, unit: deg, yaw: a, pitch: a, roll: a}}}\n",
      "is a directory");
  EXPECT_REFUSED(std::string(2 << 20, '#'), "bytes");
  EXPECT_REFUSED(std::string(5000, '['), "session.yaml");
}

TEST_F(native_manifest, bad_ins_lines_become_findings) {
  folder_.write("ins.csv",
                "t,lat,lon,h,hdg,p,r\n1600000000,48,9,250,90,1,2\nabc\n1600000001,48,9,nan,90,1,2\n1600000002,148,9,"
                "250,90,1,2\n1600000003,48,9,250,90,1,2\n");
  const drive::Session session = open(kManifestHead + kManifestScans + kIns);
  EXPECT_EQ(session.ins.size(), 2u);
  ASSERT_EQ(session.findings.size(), 1u);
  EXPECT_TRUE(contains(english(session.findings[0].explanation), "3 lines cannot be used"))
      << english(session.findings[0].explanation);
  EXPECT_TRUE(contains(english(session.findings[0].explanation), "ins.csv:3"));
  folder_.write("ins.csv", "t,lat,lon,h,hdg,p,r\n1,2\n");
  EXPECT_REFUSED(kManifestHead + kManifestScans + kIns, "holds no usable INS sample");
}

TEST_F(native_manifest, stamp_tables_and_one_bad_scan) {
  folder_.write("stamps.csv", "file,stamp_ns\n1600000000.bin,5\n1600000000.1.bin,7\nmissing.bin,9\n");
  folder_.write("s/1600000000.bin", "abc");
  const drive::Session session =
      open(kManifestHead + "scans: {directory: s, type: kitti-bin, stamps: stamps.csv, timing: instant}\n" + kIns);
  ASSERT_EQ(session.scans->size(), 2u);
  ASSERT_EQ(session.findings.size(), 1u);
  EXPECT_EQ(session.findings[0].code, "missing-scans");
  EXPECT_ERROR(session.scans->load(0), "holds 3 bytes");
  EXPECT_EQ(session.scans->load(1).size(), 2u);
}

}  // namespace
}  // namespace remount::formats
