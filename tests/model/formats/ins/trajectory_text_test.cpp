#include "model/formats/ins/trajectory_text.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

namespace {

std::int64_t of_week(std::int64_t week, double seconds) {
  return *unix_ns_from_gps_week(week, std::llround(seconds * 1e9));
}

InsLog read_trajectory(const std::string& text, std::vector<drive::Finding>& findings) {
  return recognised_and_read("trajectory.txt", text, recognise_trajectory_text, read_trajectory_text, findings);
}

InsLog read_trajectory(const std::string& text) {
  std::vector<drive::Finding> findings;
  return read_trajectory(text, findings);
}

/// Of one line; @param what for messages
void expect_stamp(const std::string& text, std::int64_t expected_ns, const std::string& what) {
  const InsLog log = read_trajectory(text);
  ASSERT_EQ(log.ins.size(), 1U) << what;
  EXPECT_EQ(log.ins[0].stamp_ns, expected_ns) << what;
  EXPECT_FALSE(log.week_open) << what;
}

// Columns end where their units do; Q has none. Lines as Inertial Explorer prints them.
const std::string kExplorerHead =
    "Project:     drive\n"
    "Program:     Inertial Explorer Version 8.90.6611\n"
    "Profile:     All\n"
    "Source:      GNSS/INS Epochs(Smoothed TC Combined)\n"
    "\n"
    "Datum:       WGS84, (processing datum)\n"
    "Master 1:    Position 48 00 00.00000, 9 00 00.00000, 300.000 m (WGS84, Ellipsoidal hgt)\n"
    "\n"
    "   Week      GPSTime        Latitude       Longitude        H-Ell Q     Heading       Pitch        Roll    "
    "SDNorth "
    "    SDEast   SDHeight    RollSD   PitchSD    HdngSD\n"
    "(weeks)        (sec)     (+/-D M S)      (+/-D M S)          (m)         (deg)       (deg)       (deg)        (m) "
    "       (m)        (m)     (deg)     (deg)     (deg)\n";

TEST(trajectory_text, inertial_explorer_has_novatels_axes_and_states_errors) {
  std::vector<drive::Finding> findings;
  const InsLog log = read_trajectory(kExplorerHead +
                                         "   2288   252820.500  -33 51 36.00000  151 12 18.00000     310.250 1     "
                                         "90.0000      5.0000      2.0000      "
                                         "0.010      0.020      0.030     0.004     0.005     0.060\n"
                                         "   2288   252820.510   -0 00 36.00000  151 12 18.00000     310.250 4     "
                                         "90.0000      5.0000      2.0000      "
                                         "0.010      0.020      0.030     0.004     0.005     0.060\n"
                                         "   2288   252820.520  -33 51 36.00000  151 12 18.00000     310.250 4     "
                                         "90.0000      5.0000      2.0000      "
                                         "0.010      0.020      0.030     0.004     0.005     0.060\n"
                                         "   2288   252820.530  -33 51 36.00000  151 12 18.00000     310.250 2     "
                                         "90.0000      5.0000      2.0000      "
                                         "0.010      0.020      0.030     0.004     0.005     0.060\n"
                                         "\n"
                                         "Written on a Tuesday by somebody\n",
                                     findings);
  EXPECT_EQ(log.axes, drive::InsAxes::RightForwardUp);
  EXPECT_TRUE(log.stamps_from_gps);
  EXPECT_FALSE(log.week_open);
  ASSERT_EQ(log.ins.size(), 3U);
  EXPECT_EQ(testing::said_of(findings, "bad-ins"), "") << "the remark behind the table is none of its lines";
  EXPECT_NE(testing::finding_of(findings, "ins-far-away"), nullptr) << "a latitude of minus 36 seconds has its sign";
  const motion::InsSample& first = log.ins.front();
  EXPECT_EQ(first.stamp_ns, of_week(2288, 252820.5));
  EXPECT_NEAR(radians_to_degrees(first.latitude_rad), -33.86, 1e-12);
  EXPECT_NEAR(radians_to_degrees(first.longitude_rad), 151.205, 1e-12);
  EXPECT_EQ(first.height_m, 310.25);
  EXPECT_EQ(first.quality, motion::InsQuality::Good);
  EXPECT_EQ(log.ins[1].quality, motion::InsQuality::Degraded);
  EXPECT_EQ(first.sigma.position_enu_m, Eigen::Vector3d(0.02, 0.01, 0.03));
  EXPECT_NEAR(radians_to_degrees(first.sigma.attitude_rad.x()), 0.005, 1e-12) << "pitch is about x";
  EXPECT_NEAR(radians_to_degrees(first.sigma.attitude_rad.y()), 0.004, 1e-12) << "roll is about y";
  EXPECT_NEAR(radians_to_degrees(first.sigma.attitude_rad.z()), 0.06, 1e-12);
  const Eigen::Vector3d nose = first.enu_from_ins * Eigen::Vector3d::UnitY(),
                        right = first.enu_from_ins * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(nose.x(), std::cos(degrees_to_radians(5.0)), 1e-12) << "to the east";
  EXPECT_NEAR(nose.z(), std::sin(degrees_to_radians(5.0)), 1e-12) << "nose up";
  EXPECT_LT(right.z(), 0.0) << "right side down";
}

TEST(trajectory_text, others_have_the_axes_of_an_aircraft) {
  const InsLog log = read_trajectory(
      "# Exported by Qinertia\n"
      "GPS Week\tGPS Time\tLatitude\tLongitude\tAltitude Ellipsoid\tRoll\tPitch\tYaw\tRoll Std\tPitch Std\tYaw Std\n"
      "\t(ms)\t(deg)\t(deg)\t(m)\t(rad)\t(rad)\t(rad)\t(rad)\t(rad)\t(rad)\n"
      "2288\t252820500\t48.5\t9.25\t310\t0.02\t0.05\t1.5707963267948966\t0.001\t0.002\t0.003\n"
      "2288\t252820505\t48.5\t9.25\t310\t0.02\t0.05\t-1.5707963267948966\t0.001\t0.002\t0.003\n");
  EXPECT_EQ(log.axes, drive::InsAxes::ForwardLeftUp);
  ASSERT_EQ(log.ins.size(), 2U);
  EXPECT_EQ(log.ins[0].stamp_ns, of_week(2288, 252820.5));
  EXPECT_EQ(log.ins[1].stamp_ns - log.ins[0].stamp_ns, 5'000'000) << "milliseconds";
  const Eigen::Vector3d nose = log.ins[0].enu_from_ins * Eigen::Vector3d::UnitX(),
                        left = log.ins[0].enu_from_ins * Eigen::Vector3d::UnitY();
  EXPECT_NEAR(nose.x(), std::cos(0.05), 1e-12) << "to the east";
  EXPECT_NEAR(nose.z(), std::sin(0.05), 1e-12) << "nose up";
  EXPECT_NEAR(left.z(), std::cos(0.05) * std::sin(0.02), 1e-12) << "right side down";
  EXPECT_LT((log.ins[1].enu_from_ins * Eigen::Vector3d::UnitX()).x(), -0.9) << "to the west";
  EXPECT_LT((log.ins[0].sigma.attitude_rad - Eigen::Vector3d(0.001, 0.002, 0.003)).norm(), 1e-15);
  EXPECT_TRUE(std::isnan(log.ins[0].sigma.position_enu_m.x()));
}

TEST(trajectory_text, oxts_exports_have_their_units_behind_the_names_and_their_own_time_zone) {
  const InsLog log = read_trajectory(
      "\"Date (UTC+1,00)\",\"Time (UTC+1,00)\",TimeFromStart (s),PosLat (deg),PosLon (deg),PosAlt (m),VelNorth (km/h),"
      "AngleHeading (deg),AnglePitch (deg),AngleRoll (deg),PosLatStdev (m),PosLonStdev (m),PosAltStdev (m),"
      "AngleHeadingStdev (deg),AnglePitchStdev (deg),AngleRollStdev (deg)\n"
      "2023-11-14,23:13:20.125,0.0,57.71,11.94,36.5,11.9,90.0,0.5,1.5,0.01,0.02,0.03,0.1,0.02,0.03\n"
      "14/11/2023,23:13:20.135,0.0,57.71,11.94,36.5,11.9,90.0,0.5,1.5,,,,,,\n");
  ASSERT_EQ(log.ins.size(), 2U);
  EXPECT_EQ(log.axes, drive::InsAxes::ForwardLeftUp);
  EXPECT_FALSE(log.stamps_from_gps);
  EXPECT_EQ(log.ins[0].stamp_ns, 1'700'000'000'125'000'000) << "an hour ahead of UTC";
  EXPECT_EQ(log.ins[1].stamp_ns - log.ins[0].stamp_ns, 10'000'000);
  EXPECT_EQ(log.ins[0].sigma.position_enu_m, Eigen::Vector3d(0.02, 0.01, 0.03));
  EXPECT_NEAR(radians_to_degrees(log.ins[0].sigma.attitude_rad.z()), 0.1, 1e-12);
  EXPECT_TRUE(std::isnan(log.ins[1].sigma.position_enu_m.x())) << "empty: not stated";
}

// The same moment, 2023-11-14 22:13:20.5 UTC, told in all ways: week 2288, second 252818.5 of GPS.
TEST(trajectory_text, times_are_told_by_week_date_or_epoch) {
  const std::int64_t expected = of_week(2288, 252818.5);
  ASSERT_EQ(expected, 1'700'000'000'500'000'000 + 0);
  const std::string rest = " 48.5 9.25 310 1 2 3\n", names = " Latitude Longitude Height Roll Pitch Heading\n";
  const std::pair<std::string, std::string> ways[] = {
      {"Week GPSTime", "2288.00000 252818.5"},
      {"GPSTime GPSDate", "252818.5 2023-11-14"},
      {"GPSTime GPSDate", "22:13:38.5 2023/11/14"},
      {"GPSTime", "1384035218.5"},
      {"UTCTime", "1700000000.5"},
      {"UTCDate UTCTime", "2023-11-14 22:13:20.5"},
      {"UTCDate UTCTime", "14/11/2023 80000.5"},
      {"UTCTime Week GPSTime", "1700000000.5 2288 252818.5"},
  };
  for (const auto& [columns, values] : ways)
    expect_stamp(columns + names + values + rest, expected, columns + ": " + values);
  // With months first, and the time of day in three columns, as Inertial Explorer has it.
  expect_stamp(
      "UTCDate    UT UT UTCTim   Latitude  Longitude  H-Ell   Roll  Pitch Heading\n"
      "(MDY)      ho mi  (sec)      (deg)      (deg)    (m)  (deg)  (deg)   (deg)\n"
      "11/14/2023 22 13  20.50       48.5       9.25    310      1      2       3\n",
      expected, "UTCDate, hour, minute, second");
  const InsLog open = read_trajectory("GPSTime" + names + "252818.5" + rest);
  EXPECT_TRUE(open.week_open);
  EXPECT_EQ(open.ins.at(0).stamp_ns, of_week(0, 252818.5));
}

// Saturday 2023-11-18 and Monday 2023-11-20: their seconds of the day are seconds of the week within a minute of
// Sunday.
TEST(trajectory_text, times_of_day_are_of_their_date) {
  const std::string rest = " 48.5 9.25 310 1 2 3\n", names = " Latitude Longitude Height Roll Pitch Heading\n";
  struct Row {
    std::string columns, values;
    std::int64_t expected;
  };
  const Row rows[] = {
      {"GPSDate GPSTime", "2023-11-18 00:00:30", of_week(2288, 6 * 86400 + 30)},
      {"GPSDate GPSTime", "2023-11-20 23:59:30", of_week(2289, 2 * 86400 - 30)},
      {"UTCDate UTCTime", "2023-11-18 00:00:30", 1'700'265'630'000'000'000},
      {"UTCDate UTCTime", "2023-11-20 23:59:30", 1'700'524'770'000'000'000},
      {"Week GPSTime GPSDate", "2288 22:13:38.5 2023-11-14", of_week(2288, 252818.5)},
  };
  for (const auto& [columns, values, expected] : rows)
    expect_stamp(columns + names + values + rest, expected, columns + ": " + values);
}

// 2023-11-14 is a Tuesday, the third day of week 2288.
TEST(trajectory_text, seconds_beside_a_date_are_of_the_day_or_of_the_week_in_the_whole_table) {
  const auto read = [](const std::vector<std::string>& seconds, std::vector<drive::Finding>& findings) {
    std::string text = "Date(YMD) GPSTime(sec) Latitude Longitude Height Roll Pitch Heading\n";
    for (const std::string& one : seconds) text += "2023-11-14 " + one + " 48 9 310 0 0 0\n";
    return read_trajectory(text, findings);
  };
  constexpr double kTuesday_s = 2 * 86400.0;
  std::vector<drive::Finding> findings;
  // The first is broken, and could be seconds of the day.
  const InsLog weekly = read({"1000.0", "180000.0", "180000.1", "180000.2"}, findings);
  ASSERT_EQ(weekly.ins.size(), 3U);
  EXPECT_EQ(weekly.ins.front().stamp_ns, of_week(2288, 180000.0));
  EXPECT_TRUE(contains(testing::said_of(findings, "bad-ins"), "trajectory.txt:2:"));
  findings.clear();
  const InsLog daily = read({"180000.0", "1000.0", "1000.1", "1000.2"}, findings);
  ASSERT_EQ(daily.ins.size(), 3U);
  EXPECT_EQ(daily.ins.front().stamp_ns, of_week(2288, kTuesday_s + 1000.0));
  EXPECT_TRUE(contains(testing::said_of(findings, "bad-ins"), "trajectory.txt:2:"));
}

TEST(trajectory_text, times_of_day_without_a_date_are_refused) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const std::string names = " Latitude Longitude Height Roll Pitch Heading\n", rest = " 48.5 9.25 310 1 2 3\n";
  const auto read = [&](const std::string& text) {
    return read_trajectory_text(folder.write("a.txt", text), findings);
  };
  const std::string expected = "a time of day and no column tells the date. Export GPS time as seconds of the week";
  EXPECT_ERROR(read("Week GPSTime" + names + "2288 22:13:38.5" + rest), expected);
  EXPECT_ERROR(read("GPSTime" + names + "22:13:38.5" + rest), expected);
  EXPECT_ERROR(read("UTCTime" + names + "22:13:38.5" + rest), expected);
  EXPECT_ERROR(
      read("Week,GPSTime (HMS),Latitude,Longitude,Height,Roll,Pitch,Heading\n2288,22:13:38.5,48,9,310,1,2,3\n"),
      expected);
}

// 2023-11-14 22:13:20 UTC.
TEST(trajectory_text, the_zone_is_that_of_the_time_or_else_of_the_date) {
  const std::string names = ",Latitude,Longitude,Height,Roll,Pitch,Heading\n", rest = ",48.5,9.25,310,1,2,3\n";
  const std::pair<std::string, std::string> ways[] = {
      {"Date (UTC+5:30),Time (UTC+5:30)", "2023-11-15,03:43:20"},
      {"Date (UTC-03:30),Time (UTC-03:30)", "2023-11-14,18:43:20"},
      {"Time (UTC+1.00),Date (UTC)", "23:13:20,2023-11-14"},
      {"Date (UTC+1),UTCTime", "2023-11-14,23:13:20"},
      {"Date (UTC),Time (UTC),Local (UTC+2)", "2023-11-14,22:13:20,0"},
  };
  for (const auto& [columns, values] : ways)
    expect_stamp(columns + names + values + rest, 1'700'000'000'000'000'000, columns + ": " + values);
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  for (const char* zone : {"UTC+25", "UTC+5:75", "UTC+1h", "UTC1"})
    EXPECT_ERROR(read_trajectory_text(folder.write("a.txt", "Date (UTC),Time (" + std::string(zone) + ")" + names +
                                                                "2023-11-14,22:13:20" + rest),
                                      findings),
                 "the column 'Time' has the time zone '" + std::string(zone) + "', which is not known");
}

// One broken time must not take the rest of the log to another week.
TEST(trajectory_text, a_week_ends_only_in_a_short_step) {
  const auto read = [](const std::vector<std::string>& times, std::vector<drive::Finding>& findings) {
    std::string text = "GPSTime Latitude Longitude Height Roll Pitch Heading\n";
    for (const std::string& time : times) text += time + " 48 9 310 0 0 0\n";
    return read_trajectory(text, findings);
  };
  std::vector<drive::Finding> findings;
  const InsLog whole = read({"604799.5", "0.5", "1.5"}, findings);
  ASSERT_EQ(whole.ins.size(), 3U);
  EXPECT_EQ(whole.ins.back().stamp_ns - whole.ins.front().stamp_ns, 2'000'000'000);
  EXPECT_TRUE(findings.empty());
  for (const char* broken : {"604000.0", "400000.0"}) {
    findings.clear();
    const InsLog log = read({"1000.00", broken, "1000.01", "1000.02"}, findings);
    ASSERT_EQ(log.ins.size(), 3U) << broken;
    EXPECT_EQ(log.ins.back().stamp_ns - log.ins.front().stamp_ns, 20'000'000) << broken;
    testing::expect_told(findings, "bad-ins", "trajectory.txt:3:");
  }
  findings.clear();
  const InsLog first = read({"1000.0", "500000.00", "500000.01", "500000.02"}, findings);
  EXPECT_EQ(first.ins.back().stamp_ns, of_week(0, 500000.02)) << "the first was broken";
}

TEST(trajectory_text, rows_with_more_fields_than_names_are_broken) {
  std::vector<drive::Finding> findings;
  const InsLog log = read_trajectory(
      "Week GPSTime Latitude Longitude Height Roll Pitch Heading\n"
      "2288 1 48 9 310 0 0 0\n2288 Tue 2 48 9 310 0 0 0\n2288 3 48 9 310 0 0 0 \n",
      findings);
  EXPECT_EQ(log.ins.size(), 2U);
  testing::expect_told(findings, "bad-ins", "trajectory.txt:3: has 9 fields, expected 8");
  // A comma for the point of decimals parts a number; behind the last one there may be nothing.
  findings.clear();
  const InsLog commas = read_trajectory(
      "Week,GPSTime,Latitude,Longitude,Height,Roll,Pitch,Heading\n"
      "2288,1,48.0,9,310,0,0,0\n2288,2,48,0,9,310,0,0,0\n2288,3,48.0,9,310,0,0,0,\n",
      findings);
  EXPECT_EQ(commas.ins.size(), 2U);
  testing::expect_told(findings, "bad-ins", "trajectory.txt:3: has 9 fields, expected 8");
}

TEST(trajectory_text, all_rows_may_have_a_last_column_without_a_name) {
  std::vector<drive::Finding> findings;
  const InsLog log = read_trajectory(
      "Week,GPSTime,Latitude,Longitude,Height,Roll,Pitch,Heading\n"
      "2288,1,48.0,9,310,0,0,0,fixed\n2288,2,48.0,9,310,0,0,0,fixed\n2288,3,48,0,9,310,0,0,0,fixed\n",
      findings);
  ASSERT_EQ(log.ins.size(), 2U);
  for (const motion::InsSample& sample : log.ins) EXPECT_EQ(sample.height_m, 310.0);
  testing::expect_told(findings, "bad-ins", "trajectory.txt:4: has 10 fields, expected 9");
}

TEST(trajectory_text, names_stand_at_the_beginning) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const std::string table = "Week GPSTime Latitude Longitude Height Roll Pitch Heading\n2288 1 48 9 310 0 0 0\n";
  const std::string remark = "# " + std::string(1000, '-') + "\n";
  std::string remarks;
  for (int i = 0; i < 70; ++i) remarks += remark;
  EXPECT_EQ(read_trajectory_text(folder.write("a.txt", remark + table), findings).ins.size(), 1U);
  EXPECT_ERROR(read_trajectory_text(folder.write("a.txt", remarks + table), findings),
               "expected a line of column names");
  // Signs that are longer in UTF-8 than in UTF-16, and such that are shorter: in both the head is 64 KiB of the file.
  const auto utf16 = [](const std::string& sign, std::size_t signs, const std::string& latin) {
    std::string bytes = std::string("\xFF\xFE#\0", 4);
    for (std::size_t i = 0; i < signs; ++i) bytes += sign;
    for (const char c : "\n" + latin) bytes += {c, '\0'};
    return bytes;
  };
  for (const std::string& sign : {std::string("\x2D\x4E"), std::string("-\0", 2)}) {
    const auto within = folder.write("a.txt", utf16(sign, 30'000, table)),
               behind = folder.write("b.txt", utf16(sign, 33'000, table));
    EXPECT_TRUE(recognise_trajectory_text(within));
    EXPECT_EQ(read_trajectory_text(within, findings).ins.size(), 1U);
    EXPECT_FALSE(recognise_trajectory_text(behind));
    EXPECT_ERROR(read_trajectory_text(behind, findings), "expected a line of column names");
  }
  std::string apart;  // a bracket in every word, and none that closes one
  for (int i = 0; i < 1'000'000; ++i) apart += "( ";
  EXPECT_ERROR(read_trajectory_text(folder.write("a.txt", apart), findings), "expected a line of column names");
}

TEST(trajectory_text, heights_above_the_sea_need_the_geoid) {
  std::vector<drive::Finding> findings;
  const std::string names = "Week,GPSTime,Latitude,Longitude,Altitude MSL,Roll,Pitch,Heading";
  EXPECT_EQ(read_trajectory(names + ",Undulation\n2288,1,48,9,310,0,0,0,47.5\n", findings).ins.at(0).height_m, 357.5);
  EXPECT_TRUE(findings.empty());
  EXPECT_EQ(read_trajectory(names + "\n2288,1,48,9,310,0,0,0\n", findings).ins.at(0).height_m, 310.0);
  testing::expect_told(findings, "height-above-sea", "the undulation of the geoid is not given");
}

TEST(trajectory_text, broken_lines_are_counted) {
  std::vector<drive::Finding> findings;
  const InsLog log = read_trajectory(
      "Week GPSTime Latitude Longitude Height Roll Pitch Heading\n"
      "2288 1 48 9 310 0 0 0\n2288 2 48 9 310 0 0\n2288 3 48 9 310 0 95 0\n2288 4 148 9 310 0 0 0\n"
      "2288 x 48 9 310 0 0 0\n2288 700000 48 9 310 0 0 0\n2288 6 -9999 9 310 0 0 0\n2288 7 48 9 310 0 0 0\n",
      findings);
  EXPECT_EQ(log.ins.size(), 2U);
  testing::expect_told(findings, "bad-ins", "6 lines cannot be used");
  testing::expect_told(findings, "bad-ins", "trajectory.txt:3: has 7 fields, expected 8");
}

TEST(trajectory_text, what_is_missing_is_named) {
  const TemporaryFolder folder;
  std::vector<drive::Finding> findings;
  const auto read = [&](const std::string& text) {
    return read_trajectory_text(folder.write("a.txt", text), findings);
  };
  EXPECT_ERROR(
      read("Program: Inertial Explorer Version 8.90\n\nWeek GPSTime Latitude Longitude H-Ell Q\n1 2 3 4 5 6\n"),
      "a.txt:3: has no column of roll, pitch, heading");
  EXPECT_ERROR(read("Latitude,Longitude,Roll,Pitch,Heading\n1,2,3,4,5\n"), "has no column of height, time");
  EXPECT_ERROR(read("Week,GPSTime,Latitude,Longitude,Height (ft),Roll,Pitch,Heading\n1,2,3,4,5,6,7,8\n"),
               "the column 'Height' has the unit 'ft', which is not known");
  EXPECT_ERROR(read("Week,GPSTime (\xc2\xb5s),Latitude,Longitude,Height,Roll,Pitch,Heading\n1,2,3,4,5,6,7,8\n"),
               "the column 'GPSTime' has the unit '\xc2\xb5s', which is not known");
  EXPECT_ERROR(read("Week,GPSTime,Latitude,Longitude,Height,Roll,Pitch,Heading\n"), "holds no usable INS sample");
  EXPECT_ERROR(read("nothing\n"), "expected a line of column names");
}

TEST(trajectory_text, other_tables_are_none) {
  const TemporaryFolder folder;
  for (const char* text :
       {"", "1 2 3\n", "time,x,y,z,qx,qy,qz,qw\n0,1,2,3,0,0,0,1\n",
        "stamp,latitude,longitude,height,temperature\n1,2,3,4,5\n",
        "Latitude and Longitude are angles. Roll and Pitch are, too.\n",
        "Time Latitude Longitude Roll Pitch Heading\nare words, GPSTime is one, too.\n",
        "Inertial Explorer tells Latitude Longitude Height Roll\nand says 12 words about 3 things of 4 kinds\n",
        "GPSTime,Latitude,Longitude,Height,Roll,Pitch,Heading\n"})
    EXPECT_FALSE(recognise_trajectory_text(folder.write("a.txt", text))) << text;
  EXPECT_FALSE(recognise_trajectory_text(folder.path()));
}

}  // namespace
}  // namespace remount::formats
