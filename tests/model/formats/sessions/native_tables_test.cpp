#include <gtest/gtest.h>

#include <tuple>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/sessions/native_session_reader.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kFirst_ns = 1'600'000'000'000'000'000;

/// Tables of others, and times of scans, as a manifest declares them.
class native_tables : public ::testing::Test {
 protected:
  native_tables() {
    for (const char* name : {"s/8.bin", "s/9.bin", "s/10.bin"}) folder_.write(name, std::string(32, '\x3f'));
    folder_.write("times.txt", "2020-09-13 12:26:40\n2020-09-13 12:26:40.1\n2020-09-13T12:26:40.25Z\n");
  }
  drive::Session open(const std::string& ins, const std::string& stamps = kRows) {
    folder_.write("session.yaml",
                  "format: remount-session/1\nname: test\nscans: {directory: s, type: kitti-bin, stamps: " + stamps +
                      ", timing: instant}\n" + ins);
    Progress progress;
    return NativeSessionReader().open(folder_.path(), progress);
  }
  std::string message(const std::string& ins, const std::string& stamps = kRows) {
    return error_of([&] { open(ins, stamps); });
  }
  /// Of columns time, latitude, longitude, height, yaw, pitch, roll by their numbers.
  static std::string ins(const std::string& table, const std::string& time, const std::string& more = "") {
    return "ins: {file: ins.txt, " + table + "columns: {time: {index: 0, " + time +
           "}, latitude: {index: 1, unit: deg}, longitude: {index: 2, unit: deg}, height: 3, attitude: {convention: "
           "heading, unit: deg, yaw: 4, pitch: 5, roll: 6" +
           more + "}}}\n";
  }
  static inline const std::string kRows =
      "{file: times.txt, table: {separator: bar}, time: {index: 0, unit: date, scale: unix}}";
  static inline const std::string kPlainIns = "1600000000,48,9,250,90,1,2\n1600000001,48,9,250,91,1,2\n";
  TemporaryFolder folder_;
};

TEST_F(native_tables, separators_decimals_and_lines_above) {
  folder_.write("ins.txt",
                "of a drive\n\nt;lat;lon;h;hdg;p;r\n1600000000,5;48,25;9;250;90;1;2\n1600000001;48,25;9;250;91;1;2\n");
  const drive::Session session = open(
      ins("table: {separator: semicolon, decimals: comma, skip_lines: 3}, ", "unit: s, scale: unix, offset_s: -18"));
  ASSERT_EQ(session.ins.size(), 2U);
  EXPECT_EQ(session.ins[0].stamp_ns, kFirst_ns - 17'500'000'000);
  EXPECT_DOUBLE_EQ(session.ins[0].latitude_rad, degrees_to_radians(48.25));
  for (const auto& [separator, name] : {std::pair('\t', "tab"), {'|', "bar"}, {' ', "blanks"}}) {
    std::string text = kPlainIns;
    std::replace(text.begin(), text.end(), ',', separator);
    folder_.write("ins.txt", text);
    EXPECT_EQ(open(ins("table: {separator: " + std::string(name) + "}, ", "unit: s, scale: unix")).ins.size(), 2U)
        << name;
  }
}

TEST_F(native_tables, dates_weeks_and_nanoseconds) {
  folder_.write("ins.txt", "12:26:40.5Z,48,9,250,90,1,2,2020-09-13\n12:26:41Z,48,9,250,90,1,2,2020-09-13\n");
  EXPECT_EQ(open(ins("", "unit: date, scale: unix, day: 7")).ins[0].stamp_ns, kFirst_ns + 500'000'000);
  EXPECT_EQ(open(ins("", "unit: date, scale: gps, day: 7")).ins[0].stamp_ns, kFirst_ns + 500'000'000 - 18'000'000'000);
  folder_.write("ins.txt", "1600000000,48,9,250,90,1,2,5\n1600000000,48,9,250,90,1,2,7\n");
  EXPECT_EQ(open(ins("", "unit: s, scale: unix, nanoseconds: 7")).ins[1].stamp_ns, kFirst_ns + 7);
  const std::int64_t in_week_ns = gps_ns_from_unix_ns(kFirst_ns) % 604'800'000'000'000;
  const std::string second = std::to_string(in_week_ns / 1'000'000'000);
  folder_.write("ins.txt", second + ",48,9,250,90,1,2\n" + second + ".5,48,9,250,90,1,2\n");
  const drive::Session session = open(ins("", "unit: s, scale: gps-week"));
  EXPECT_TRUE(session.ins_week_open);
  EXPECT_EQ(session.ins[0].stamp_ns, *unix_ns_from_gps_week(0, in_week_ns));
}

TEST_F(native_tables, times_beyond_what_a_stamp_holds_are_none) {
  folder_.write("ins.txt", "1600000000,48,9,250,90,1,2\n8500000000,48,9,250,91,1,2\n1600000001,48,9,250,91,1,2\n");
  const drive::Session session = open(ins("", "unit: s, scale: unix, offset_s: 1000000000"));
  ASSERT_EQ(session.ins.size(), 2U) << "the other sum would overflow";
  EXPECT_EQ(session.ins[0].stamp_ns, kFirst_ns + 1'000'000'000'000'000'000);
  EXPECT_NE(find(session, "bad-ins"), nullptr);
  for (const char* name : {"l/9223372036854775807.bin", "l/1600000000000000000.bin"})
    folder_.write(name, std::string(32, '\x3f'));
  folder_.write(
      "session.yaml",
      "format: remount-session/1\nname: t\nscans: {directory: l, type: kitti-bin, stamps: {names: ns}, timing: "
      "instant}\n" +
          ins("", "unit: s, scale: unix"));
  Progress progress;
  const drive::Session named = NativeSessionReader().open(folder_.path(), progress);
  ASSERT_EQ(named.scans->size(), 1U);
  EXPECT_NE(find(named, "bad-scan-names"), nullptr);
}

TEST_F(native_tables, angles_that_count_the_other_way) {
  folder_.write("ins.txt", kPlainIns);
  const drive::Session as_is = open(ins("", "unit: s, scale: unix"));
  const drive::Session negated = open(ins("", "unit: s, scale: unix", ", negated: [pitch]"));
  const auto nose_up = [](const drive::Session& session) {
    return (session.ins[0].enu_from_ins * Eigen::Vector3d::UnitX()).z();
  };
  EXPECT_NEAR(nose_up(as_is), std::sin(degrees_to_radians(1.0)), 1e-12);
  EXPECT_NEAR(nose_up(negated), -nose_up(as_is), 1e-12);
}

TEST_F(native_tables, poses_of_any_columns) {
  folder_.write("ins.txt", "t E N D hdg p r\n1600000000 1 2 3 90 0 0\n1600000001 2 2 3 90 0 0\n");
  const drive::Session session = open(
      "ins_poses:\n  file: ins.txt\n  table: {separator: blanks}\n  columns:\n    time: {name: t, unit: s, scale: "
      "unix}\n"
      "    position: {east: E, north: N, down: D}\n"
      "    attitude: {convention: heading, unit: deg, yaw: hdg, pitch: p, roll: r}\n");
  ASSERT_EQ(session.world_from_ins.size(), 2U);
  EXPECT_EQ(session.world_from_ins[0].pose.translation(), Eigen::Vector3d(1, 2, -3));
  EXPECT_LT((session.world_from_ins[0].pose.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitX()).norm(),
            1e-12)
      << "heads east";
  EXPECT_EQ(session.ins_axes, drive::InsAxes::ForwardLeftUp);
}

TEST_F(native_tables, times_of_scans_by_rows_by_names_and_in_names) {
  folder_.write("ins.txt", kPlainIns);
  const std::string motion = ins("", "unit: s, scale: unix");
  const drive::Session by_rows = open(motion);
  ASSERT_EQ(by_rows.scans->size(), 3U);
  EXPECT_EQ(by_rows.scans->name(0), "8.bin") << "8 is before 10";
  EXPECT_EQ(by_rows.scans->stamp_ns(2), kFirst_ns + 250'000'000);
  folder_.write("named.csv", "scan,ms\n10,1600000000250\n8.bin,1600000000000\n77,1600000000000\n");
  const drive::Session by_names =
      open(motion, "{file: named.csv, time: {name: ms, unit: ms, scale: unix}, scan: scan}");
  ASSERT_EQ(by_names.scans->size(), 2U);
  EXPECT_EQ(by_names.scans->name(1), "10.bin");
  ASSERT_FALSE(by_names.findings.empty());
  EXPECT_EQ(by_names.findings[0].code, "missing-scans");
  for (const char* name : {"u/c_1600000000123456.bin", "n/1600000000_123456000.bin"})
    folder_.write(name, std::string(32, '\x3f'));
  for (const auto& [directory, names] : {std::pair("u", "us"), {"n", "s"}}) {
    folder_.write("session.yaml", std::string("format: remount-session/1\nname: t\nscans: {directory: ") + directory +
                                      ", type: kitti-bin, stamps: {names: " + names + "}, timing: instant}\n" + motion);
    Progress progress;
    EXPECT_EQ(NativeSessionReader().open(folder_.path(), progress).scans->stamp_ns(0), kFirst_ns + 123'456'000)
        << names;
  }
}

TEST_F(native_tables, names_may_be_dates) {
  folder_.write("ins.txt", kPlainIns);
  for (const char* name : {"d/2020-09-13-12-26-40-250.bin", "e/top_20200913_122640.250.bin"})
    folder_.write(name, std::string(32, '\x3f'));
  const std::int64_t leap_ns = 18'000'000'000;
  for (const auto& [directory, stamps, apart_ns] : {std::tuple("d", "from-names", std::int64_t{0}),
                                                    {"e", "from-names", 0},
                                                    {"e", "{names: date, scale: gps}", -leap_ns},
                                                    {"d", "{names: date, offset_s: -3600}", -3600'000'000'000}}) {
    folder_.write("session.yaml", std::string("format: remount-session/1\nname: t\nscans: {directory: ") + directory +
                                      ", type: kitti-bin, stamps: " + stamps + ", timing: instant}\n" +
                                      ins("", "unit: s, scale: unix"));
    Progress progress;
    EXPECT_EQ(NativeSessionReader().open(folder_.path(), progress).scans->stamp_ns(0),
              kFirst_ns + 250'000'000 + apart_ns)
        << directory << stamps;
  }
}

TEST_F(native_tables, dates_in_columns_of_their_own_and_microseconds) {
  folder_.write(
      "ins.txt",
      "40.5,48,9,250,90,1,2,2020,9,13,12,26\n41,48,9,250,90,1,2,2020,9,13,12,26\n0,48,9,250,90,1,2,2020,13,1,1,1\n");
  const std::string parts = "unit: s, year: 7, month: 8, day: 9, hour: 10, minute: 11, scale: ";
  const drive::Session session = open(ins("", parts + "unix"));
  ASSERT_EQ(session.ins.size(), 2U) << "there is no thirteenth month";
  EXPECT_EQ(session.ins[0].stamp_ns, kFirst_ns + 500'000'000);
  EXPECT_EQ(open(ins("", parts + "gps")).ins[0].stamp_ns, kFirst_ns + 500'000'000 - 18'000'000'000);
  folder_.write("ins.txt", "1600000000,48,9,250,90,1,2,5\n1600000000,48,9,250,90,1,2,7\n");
  EXPECT_EQ(open(ins("", "unit: s, scale: unix, microseconds: 7")).ins[1].stamp_ns, kFirst_ns + 7'000);
  EXPECT_EQ(open(ins("", "unit: s, scale: unix, milliseconds: 7")).ins[1].stamp_ns, kFirst_ns + 7'000'000);
  for (const char* wrong :
       {"unit: s, scale: unix, month: 7", "unit: ms, scale: unix, year: 1, month: 2, day: 3, hour: 4, minute: 5",
        "unit: s, scale: gps-week, year: 1, month: 2, day: 3, hour: 4, minute: 5"})
    EXPECT_TRUE(contains(message(ins("", wrong)), "expected 'year'")) << wrong;
  EXPECT_TRUE(
      contains(message(ins("", "unit: s, scale: unix, microseconds: 7, milliseconds: 7")), "one of them at most"));
}

TEST_F(native_tables, a_number_that_stands_for_no_value_is_declared) {
  folder_.write("ins.txt", "1600000000,48,9,250,90,1,2\n1600000001,48,9,-123,91,1,2\n1600000002,48,9,,91,1,2\n");
  const drive::Session session = open(ins("table: {no_value: -123}, ", "unit: s, scale: unix"));
  EXPECT_EQ(session.ins.size(), 1U);
  ASSERT_NE(find(session, "bad-ins"), nullptr);
  EXPECT_EQ(open(ins("", "unit: s, scale: unix")).ins.size(), 2U);
}

TEST_F(native_tables, mistakes_are_named) {
  folder_.write("ins.txt", kPlainIns);
  const std::string motion = ins("", "unit: s, scale: unix");
  folder_.write("two.txt", "1600000000\n1600000001\n");
  const auto expect = [](const std::string& text, const char* part) {
    EXPECT_TRUE(contains(text, part)) << "message: '" << text << "'";
  };
  expect(message(motion, "{file: two.txt, time: {index: 0, unit: s, scale: unix}}"), "has 2 times for 3 scans");
  expect(message(motion, "{file: two.txt, time: {index: 0, unit: s, scale: gps-week}}"), "times of scans are of scale");
  expect(message(motion, "{names: h}"), "is not one of");
  expect(message(ins("table: {decimals: comma}, ", "unit: s, scale: unix")), "cannot be told apart");
  expect(message(ins("table: {separator: dots}, ", "unit: s, scale: unix")), "is not one of");
  expect(message(ins("table: {skip_lines: -1}, ", "unit: s, scale: unix")), "number of lines");
  expect(message(ins("", "unit: s, scale: unix, offset_s: 1e12")), "seconds that are added");
  expect(message(ins("", "unit: s, scale: unix, day: 3")), "'day' stands with");
  expect(message(ins("", "unit: ms, scale: unix, nanoseconds: 3")), "'nanoseconds' stands with");
  expect(message(ins("", "unit: date, scale: gps-week")), "a date is of scale");
  expect(message(ins("", "unit: date, scale: unix")), "expected a date and time");
  expect(message(ins("", "unit: s, scale: unix", ", negated: [height]")), "is not one of");
}

}  // namespace
}  // namespace remount::formats
