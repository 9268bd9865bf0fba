#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/drive/attitude_convention.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

TEST(inspvax_log, checksum_is_novatels) {
  // The example of the OEM6 firmware reference manual for BESTPOSA.
  EXPECT_EQ(novatel_crc32("BESTPOSA,COM1,0,78.0,FINESTEERING,1427,325298.000,00000000,6145,2748;SOL_COMPUTED,SINGLE,51."
                          "11678928753,-114.03886216575,"
                          "1064.3470,-16.2708,WGS84,2.3434,1.3043,4.7300,\"\",0.000,0.000,7,7,0,0,0,06,0,03"),
            0x9c9a92bbu);
}

TEST(inspvax_log, ascii_lines_with_their_convention) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.log", "#BESTPOSA,other\n" + inspvaxa(2183, 269353.56, 90.0) +
                                              inspvaxa(2183, 269353.58, 91.0, "INS_SOLUTION_FREE"));
  ASSERT_EQ(recognise_novatel(file), NovatelFormat::Log);
  std::vector<drive::Finding> findings;
  const auto ins = read_novatel(file, NovatelFormat::Log, findings).ins;
  ASSERT_EQ(ins.size(), 2u);
  EXPECT_TRUE(contains(testing::said_of(findings, "bad-ins"), "a.log:1: expected '#BESTPOSA,<header>;"));
  EXPECT_EQ(findings.size(), 1U);
  EXPECT_EQ(ins[0].stamp_ns, 1'636'512'535'560'000'000) << "18 leap seconds";
  EXPECT_NEAR(radians_to_degrees(ins[0].latitude_rad), 51.11637873403, 1e-12);
  EXPECT_NEAR(ins[0].height_m, 1063.6093 - 16.9, 1e-9) << "above the ellipsoid";
  EXPECT_EQ(ins[0].quality, motion::InsQuality::Good);
  EXPECT_EQ(ins[1].quality, motion::InsQuality::Degraded);
  EXPECT_EQ(ins[0].sigma.position_enu_m, Eigen::Vector3d(0.9, 0.8, 1.2));
  EXPECT_NEAR(radians_to_degrees(ins[0].sigma.attitude_rad.y()), 0.5, 1e-12) << "roll is about y in right-forward-up";
  const Eigen::Vector3d nose_in_enu = ins[0].enu_from_ins * Eigen::Vector3d::UnitY();
  EXPECT_NEAR(nose_in_enu.x(), std::cos(degrees_to_radians(2.5)), 1e-12) << "heads east";
  EXPECT_NEAR(nose_in_enu.z(), std::sin(degrees_to_radians(-2.5)), 1e-12) << "nose down";
}

TEST(inspvax_log, the_hosts_clock_is_compared_with_gps_time_and_not_used) {
  const TemporaryFolder folder;
  std::string csv =
      "time,.header.gps_week,.header.gps_week_seconds,.ins_status,.latitude,.longitude,.altitude,.undulation,.roll,"
      ".pitch,.azimuth,.latitude_std,.longitude_std,.altitude_std,.roll_std,.pitch_std,.azimuth_std\n";
  constexpr std::int64_t kGps_ns = 1'636'512'535'000'000'000;  // UTC of week 2183, second 269353: 18 leap seconds
  for (int i = 0; i < 20; ++i)
    csv += std::to_string(kGps_ns + i * 10'000'000LL + 2'300'000'000LL) + ",2183," +
           std::to_string(269353.0 + 0.01 * i) + ",3,51.1,-114.0,1000,-16.9,0,0,90,1,1,1,0.1,0.1,0.1\n";
  std::vector<drive::Finding> findings;
  const NovatelLog log = read_novatel(folder.write("a.csv", csv), NovatelFormat::BagCsv, findings);
  ASSERT_EQ(log.ins.size(), 20U);
  EXPECT_EQ(log.ins[0].stamp_ns, kGps_ns) << "by GPS";
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "host-clock");
  EXPECT_TRUE(contains(english(findings[0].explanation), "2.300 s off UTC by GPS")) << english(findings[0].explanation);
}

TEST(inspvax_log, bad_lines_are_counted_and_skipped) {
  const TemporaryFolder folder;
  std::string flipped = inspvaxa(2183, 2.0, 90.0);
  flipped[70] = flipped[70] == '1' ? '2' : '1';
  const auto file =
      folder.write("a.log", inspvaxa(2183, 1.0, 90.0) + flipped + "#INSPVAXA,cut;off\n" + inspvaxa(2183, 3.0, 90.0) +
                                inspvaxa(2183, 3.0, 90.0) + inspvaxa(2183, 2.5, 90.0) + inspvaxa(2183, 700000.0, 90.0) +
                                inspvaxa(2183, 4.0, 90.0));
  std::vector<drive::Finding> findings;
  EXPECT_EQ(read_novatel(file, NovatelFormat::Log, findings).ins.size(), 3u);
  ASSERT_EQ(findings.size(), 3u);
  EXPECT_TRUE(contains(english(findings[0].explanation), "3 lines cannot be used")) << english(findings[0].explanation);
  EXPECT_TRUE(contains(english(findings[0].explanation), "a.log:2: the checksum does not agree"));
  EXPECT_EQ(findings[1].code, "ins-duplicate-stamps");
  EXPECT_EQ(findings[2].code, "ins-reversed-stamps");
  EXPECT_ERROR(read_novatel(folder.write("b.log", flipped), NovatelFormat::Log, findings),
               "no usable log of an INS (INSPVAX, INSPVA, INSPVAS)");
}

TEST(novatel_reader, a_log_alone_says_what_is_missing) {
  const TemporaryFolder folder;
  const drive::Session session = open(folder.write("a.log", inspvaxa(2183, 1.0, 90.0) + inspvaxa(2183, 1.02, 90.0)));
  EXPECT_EQ(session.format, "novatel");
  EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp);
  ASSERT_NE(find(session, "one-stream"), nullptr);
}

/// Screw angles of INS and LiDAR over `gap` LiDAR poses agree: the clocks do too.
double angle_rms_rad(const drive::Session& session, std::size_t gap) {
  double sum = 0.0;
  int count = 0;
  const auto attitude_at = [&](std::int64_t stamp_ns, Eigen::Quaterniond& q) {
    const auto after =
        std::lower_bound(session.ins.begin(), session.ins.end(), stamp_ns,
                         [](const motion::InsSample& sample, std::int64_t stamp) { return sample.stamp_ns < stamp; });
    if (after == session.ins.begin() || after == session.ins.end()) return false;
    const motion::InsSample &b = *after, &a = *(after - 1);
    q = a.enu_from_ins.slerp(static_cast<double>(stamp_ns - a.stamp_ns) / static_cast<double>(b.stamp_ns - a.stamp_ns),
                             b.enu_from_ins);
    return true;
  };
  const auto& lidar = session.odometry_from_lidar;
  for (std::size_t i = 0; i + gap < lidar.size(); ++i) {
    Eigen::Quaterniond a, b;
    if (!attitude_at(lidar[i].stamp_ns, a) || !attitude_at(lidar[i + gap].stamp_ns, b)) continue;
    const double difference =
        a.angularDistance(b) - so3_log((lidar[i].pose.inverse() * lidar[i + gap].pose).linear()).norm();
    sum += difference * difference;
    ++count;
  }
  return count > 100 ? std::sqrt(sum / count) : 1e9;
}

TEST(novatel_reader, real_drives_land_on_the_ins_time_line) {
  SKIP_WITHOUT(shared_data() / "zxl19");
  for (const char* bag : {"bag1", "bag2", "bag4"}) {
    drive::Session session = open(shared_data() / "zxl19" / bag);
    ASSERT_NE(find(session, "clock-aligned"), nullptr) << bag;
    EXPECT_GT(session.ins.size(), 2900u);
    EXPECT_GT(session.odometry_from_lidar.size(), 560u);
    const double rms = angle_rms_rad(session, 10);
    EXPECT_LT(radians_to_degrees(rms), 0.2) << bag;
    for (motion::StampedPose& pose : session.odometry_from_lidar) pose.stamp_ns += 100'000'000;
    EXPECT_GT(angle_rms_rad(session, 10), 1.5 * rms) << "a tenth of a second off must show";
  }
}

TEST(novatel_reader, spreadsheet_stamps_do_not_matter_and_the_intact_file_is_preferred) {
  const auto bag4 = shared_data() / "zxl19" / "bag4";
  SKIP_WITHOUT(bag4);
  const drive::Session both = open(bag4);
  ASSERT_NE(find(both, "ins-file-chosen"), nullptr);
  EXPECT_TRUE(contains(english(find(both, "ins-file-chosen")->explanation), "rounded-stamps"));
  const TemporaryFolder folder;
  std::filesystem::copy_file(bag4 / "bag4-novatel_data-inspvax-rounded-stamps.csv", folder.path() / "rounded.csv");
  std::filesystem::copy_file(bag4 / "bag4-aft_mapped_to_init.csv", folder.path() / "aft_mapped.csv");
  const drive::Session rounded = open(folder.path());
  EXPECT_NE(find(rounded, "host-stamps-rounded"), nullptr);
  ASSERT_EQ(rounded.odometry_from_lidar.size(), both.odometry_from_lidar.size());
  EXPECT_NEAR(
      static_cast<double>(rounded.odometry_from_lidar[9].stamp_ns - both.odometry_from_lidar[9].stamp_ns) * 1e-9, 0.0,
      0.005);
}

}  // namespace
}  // namespace remount::formats
