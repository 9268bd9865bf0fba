#include "model/formats/ins/ncom_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/ins/ncom_records.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

std::int64_t stamp_of(std::int64_t minutes, int millisecond) {
  return unix_ns_from_gps_ns((minutes * 60'000 + millisecond) * 1'000'000);
}

InsLog read_packets(const std::string& bytes, std::vector<drive::Finding>& findings) {
  return recognised_and_read("drive.ncom", bytes, recognise_ncom, read_ncom, findings);
}

TEST(ncom_file, attitudes_are_those_of_a_vehicle_with_z_down) {
  std::vector<drive::Finding> findings;
  const InsLog log = read_packets(NcomRecord{.millisecond = 10'000, .heading_rad = kPi / 2.0}.bytes() +
                                      NcomRecord{.millisecond = 10'010, .pitch_rad = 0.25}.bytes() +
                                      NcomRecord{.millisecond = 10'020, .roll_rad = -0.5}.bytes() +
                                      NcomRecord{.millisecond = 10'030, .heading_rad = -kPi / 2.0}.bytes(),
                                  findings);
  ASSERT_EQ(log.ins.size(), 4U);
  EXPECT_EQ(log.axes, drive::InsAxes::ForwardLeftUp);
  const auto ahead = [&](std::size_t i) { return log.ins[i].enu_from_ins * Eigen::Vector3d::UnitX(); };
  EXPECT_LT((ahead(0) - Eigen::Vector3d::UnitX()).norm(), 1e-6) << "to the east";
  EXPECT_NEAR(ahead(1).z(), std::sin(0.25), 1e-6) << "nose up";
  EXPECT_NEAR(ahead(1).y(), std::cos(0.25), 1e-6) << "to the north";
  EXPECT_NEAR((log.ins[2].enu_from_ins * Eigen::Vector3d::UnitY()).z(), std::sin(-0.5), 1e-6) << "left side down";
  EXPECT_LT((ahead(3) + Eigen::Vector3d::UnitX()).norm(), 1e-6) << "to the west";
  EXPECT_EQ(log.ins[0].latitude_rad, 0.9);
  EXPECT_EQ(log.ins[0].longitude_rad, 0.16);
  EXPECT_EQ(log.ins[0].height_m, 310.0);
  EXPECT_EQ(log.ins[0].stamp_ns, stamp_of(23'067'253, 10'000));
  EXPECT_TRUE(findings.empty());
}

TEST(ncom_file, errors_come_in_channels_of_their_own_and_last) {
  std::vector<drive::Finding> findings;
  const InsLog log =
      read_packets(NcomRecord{.millisecond = 10'000}.bytes() +
                       NcomRecord{.millisecond = 10'010, .channel = 3, .errors = {10, 20, 30}}.bytes() +
                       NcomRecord{.millisecond = 10'020, .channel = 5, .errors = {100, 200, 300}}.bytes() +
                       NcomRecord{.millisecond = 10'030, .channel = 7}.bytes() +
                       NcomRecord{.millisecond = 10'040, .channel = 3, .errors = {40, 50, 60}, .age = 150}.bytes(),
                   findings);
  ASSERT_EQ(log.ins.size(), 5U);
  EXPECT_TRUE(std::isnan(log.ins[0].sigma.position_enu_m.x())) << "nobody has said yet";
  EXPECT_LT((log.ins[1].sigma.position_enu_m - Eigen::Vector3d(0.02, 0.01, 0.03)).norm(), 1e-15) << "mm: north, east";
  EXPECT_TRUE(std::isnan(log.ins[1].sigma.attitude_rad.x()));
  EXPECT_LT((log.ins[3].sigma.attitude_rad - Eigen::Vector3d(3e-3, 2e-3, 1e-3)).norm(), 1e-15)
      << "0.01 mrad: heading, pitch, roll, here about x, y, z";
  EXPECT_TRUE(std::isnan(log.ins[4].sigma.position_enu_m.x())) << "too old";
}

TEST(ncom_file, the_status_is_the_quality) {
  std::vector<drive::Finding> findings;
  std::string bytes;
  for (const int status : {0, 1, 2, 3, 4, 5, 10, 11, 20, 22})
    bytes += NcomRecord{.status = status, .millisecond = 10'000 + 10 * status}.bytes();
  const InsLog log = read_packets(bytes, findings);
  ASSERT_EQ(log.ins.size(), 3U);
  EXPECT_EQ(log.ins[0].quality, motion::InsQuality::Invalid) << "initialising";
  EXPECT_EQ(log.ins[1].quality, motion::InsQuality::Degraded) << "locking";
  EXPECT_EQ(log.ins[2].quality, motion::InsQuality::Good) << "locked";
  testing::expect_told(findings, "ins-log-chosen", "7 packets were sent while the INS had no solution");
}

TEST(ncom_file, minutes_run_on_and_the_first_packets_have_theirs_from_later_ones) {
  std::vector<drive::Finding> findings;
  std::string bytes;
  std::vector<std::int64_t> expected;
  for (int i = 0; i < 400; ++i) {  // over two ends of minutes
    const int time_ms = 55'000 + 200 * i;
    NcomRecord record{.millisecond = time_ms % 60'000, .channel = 1, .minutes = 23'067'253 + time_ms / 60'000};
    if (i % 50 == 40) record.channel = 0;
    // At the end of a minute the status may be of another.
    if (time_ms % 60'000 == 0) record.channel = 0, record.minutes -= 1;
    expected.push_back(stamp_of(23'067'253 + time_ms / 60'000, time_ms % 60'000));
    bytes += record.bytes();
  }
  const InsLog log = read_packets(bytes, findings);
  ASSERT_EQ(log.ins.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(log.ins[i].stamp_ns, expected[i]) << i;
  EXPECT_FALSE(log.week_open);
}

TEST(ncom_file, what_stands_beside_a_gap_of_minutes_has_no_time) {
  std::vector<drive::Finding> findings;
  std::string bytes;
  const auto add = [&](int from_ms, int channel, std::int32_t minutes) {
    for (int i = 0; i < 5; ++i)
      bytes += NcomRecord{.millisecond = from_ms + 10 * i, .channel = i == 4 ? channel : 1, .minutes = minutes}.bytes();
  };
  add(10'000, 0, 100'000);
  add(20'000, 1, 100'000);  // whose minute is told after the gap only
  add(5'000, 0, 100'007);
  add(6'000, 0, 100'007);
  const InsLog log = read_packets(bytes, findings);
  EXPECT_EQ(log.ins.size(), 11U);
  EXPECT_EQ(log.ins.front().stamp_ns, stamp_of(100'000, 10'000));
  EXPECT_EQ(log.ins.back().stamp_ns, stamp_of(100'007, 6'040));
  testing::expect_told(findings, "ins-log-chosen", "9 packets stand beside a gap");
}

TEST(ncom_file, damaged_packets_and_what_stands_between_are_passed_over) {
  std::vector<drive::Finding> findings;
  const std::string good = NcomRecord{.millisecond = 10'000}.bytes();
  std::string broken = NcomRecord{.millisecond = 10'010}.bytes();
  broken[30] = static_cast<char>(broken[30] + 1);
  const InsLog log = read_packets(good.substr(40) + "\xe7" + good + NcomRecord{.millisecond = 10'005}.bytes() + broken +
                                      "noise" + NcomRecord{.millisecond = 10'020, .latitude_rad = 7.0}.bytes() +
                                      NcomRecord{.millisecond = 10'030}.bytes() + good.substr(0, 50),
                                  findings);
  EXPECT_EQ(log.ins.size(), 3U);
  testing::expect_told(findings, "bad-ins", "1 record cannot be used");
  testing::expect_told(findings, "bad-ins", "latitude, longitude or height is not possible");
  testing::expect_told(findings, "ins-log-chosen", "160 bytes belong to no packet");
}

TEST(ncom_file, what_is_missing_is_named) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const std::string untimed = NcomRecord{.channel = 1}.bytes();
  EXPECT_ERROR(read_ncom(folder.write("a.ncom", untimed + untimed), findings), "no packet tells the minute");
  EXPECT_ERROR(read_ncom(folder.write("a.ncom", NcomRecord{.status = 1}.bytes()), findings),
               "no usable packet with a solution; 1 was sent without one");
  EXPECT_ERROR(read_ncom(folder.write("a.ncom", ""), findings), "a.ncom");
  for (const std::string& other : {std::string(), std::string(500, '\xe7'), untimed, std::string(500, '\0')})
    EXPECT_FALSE(recognise_ncom(folder.write("a.bin", other))) << other.size();
}

}  // namespace
}  // namespace remount::formats
