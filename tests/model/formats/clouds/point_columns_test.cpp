// Which column of a cloud holds the times of its points, in every format; coordinates that are of a map.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "model/formats/bags/bag_reader.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/sessions/native_session_reader.h"
#include "tests/model/formats/bags/bag_maker.h"
#include "tests/model/formats/las_bytes.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

constexpr int kColumnPoints = 400;

/// 0.1 s of a sweep; `time` is what stands in the column of times.
template <class Time>
std::string text_rows(Time time) {
  std::string text;
  for (int i = 0; i < kColumnPoints; ++i) {
    const double azimuth = 2.0 * 3.14159 * i / kColumnPoints;
    char line[160];
    std::snprintf(line, sizeof line, "%.4f %.4f -1.5 %.9f\n", 8.0 * std::cos(azimuth), 8.0 * std::sin(azimuth),
                  time(0.1 * i / kColumnPoints));
    text += line;
  }
  return text;
}

std::string ply_with(const std::string& column, const std::string& rows) {
  return "ply\nformat ascii 1.0\ncomment Created by CloudCompare\nelement vertex " + std::to_string(kColumnPoints) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty double " + column + "\nend_header\n" + rows;
}

std::string pcd_with(const std::string& column, const std::string& rows, const std::string& type = "F") {
  const std::string count = std::to_string(kColumnPoints);
  return "# .PCD v0.7\nFIELDS x y z " + column + "\nSIZE 4 4 4 8\nTYPE F F F " + type + "\nCOUNT 1 1 1 1\nWIDTH " +
         count + "\nHEIGHT 1\nPOINTS " + count + "\nDATA ascii\n" + rows;
}

TEST(point_columns, names_that_other_programs_write_are_known_in_ply_and_pcd) {
  const TemporaryFolder folder;
  const auto seconds = [](double s) { return s; };
  const auto nanoseconds = [](double s) { return 1e9 * s; };
  for (const char* name : {"time", "t", "timestamp", "GpsTime", "gps_time", "point_time", "scalar_time",
                           "scalar_GpsTime", "scalar_Timestamp", "point_time_offset"})
    for (const std::string& bytes : {ply_with(name, text_rows(seconds)), pcd_with(name, text_rows(seconds))}) {
      const cloud::PointCloud cloud = load_cloud(folder.write(bytes[0] == 'p' ? "a.ply" : "a.pcd", bytes), 0);
      ASSERT_EQ(cloud.time_from_stamp_s.size(), cloud.size()) << name;
      EXPECT_NEAR(cloud.time_from_stamp_s.back(), 0.09975, 1e-6) << name;
    }
  for (const char* name : {"time_offset_ns", "offset_ns", "scalar_offset_ns", "time_ns"}) {
    const cloud::PointCloud cloud = load_cloud(folder.write("a.ply", ply_with(name, text_rows(nanoseconds))), 0);
    ASSERT_EQ(cloud.time_from_stamp_s.size(), cloud.size()) << name;
    EXPECT_NEAR(cloud.time_from_stamp_s.back(), 0.09975, 1e-6) << name;
  }
  const cloud::PointCloud offsets =
      load_cloud(folder.write("a.pcd", pcd_with("offset_us", text_rows([](double s) { return 1e6 * s; }))), 0);
  EXPECT_NEAR(offsets.time_from_stamp_s.back(), 0.09975, 1e-6);
}

class declared_per_point : public ::testing::Test {
 protected:
  /// The message of a session whose scans are declared to have times; empty where it opens.
  std::string message(const std::string& type, const std::string& bytes, const std::string& timing = "per-point",
                      long ins_s = 1'600'000'000) {
    const TemporaryFolder folder;
    const std::string name = "." + (type == "kitti-bin" ? std::string("bin") : type);
    for (int i = 0; i < 4; ++i) folder.write("s/160000000" + std::to_string(i) + name, bytes);
    folder.write("ins.csv", "t,lat,lon,h,yaw,p,r\n" + std::to_string(ins_s) + ",48,9,250,90,1,2\n" +
                                std::to_string(ins_s + 4) + ",48,9,250,91,1,2\n");
    folder.write("session.yaml",
                 "format: remount-session/1\nname: test\nscans: {directory: s, type: " + type +
                     ", stamps: from-names, timing: " + timing +
                     "}\nins:\n  file: ins.csv\n  columns:\n    time: {name: t, unit: s, scale: unix}\n    latitude: "
                     "{name: lat, unit: deg}\n    longitude: {name: lon, unit: deg}\n    height: h\n    attitude: "
                     "{convention: enu-yaw, unit: deg, yaw: yaw, pitch: p, roll: r}\n");
    return error_of([&] {
      Progress progress;
      session_ = NativeSessionReader().open(folder.path(), progress);
      points_ = session_.scans->load(1).size();
      times_ = session_.scans->load(1).time_from_stamp_s.size();
    });
  }
  drive::Session session_;
  std::size_t points_ = 0, times_ = 0;
};

std::string floats_of_a_circle() {
  std::string bytes;
  for (int i = 0; i < kColumnPoints; ++i)
    for (const double value : {8.0 * std::cos(0.0157 * i), 8.0 * std::sin(0.0157 * i), -1.5, 0.3}) {
      const auto number = static_cast<float>(value);
      bytes.append(reinterpret_cast<const char*>(&number), 4);
    }
  return bytes;
}

LasOptions las_circle() {
  LasOptions options;
  options.points.clear();
  for (int i = 0; i < kColumnPoints; ++i)
    options.points.emplace_back(8.0 * std::cos(0.0157 * i), 8.0 * std::sin(0.0157 * i), -1.5);
  return options;
}

TEST_F(declared_per_point, times_that_are_not_there_are_an_error_that_names_what_is) {
  const auto zero = [](double) { return 0.0; };
  LasOptions one_time = las_circle();
  one_time.times.assign(kColumnPoints, 600'000'000.0);
  const struct {
    const char *type, *columns;
    std::string bytes;
  } cases[] = {{"ply", "columns: x y z scalar_intensity", ply_with("scalar_Intensity", text_rows(zero))},
               {"ply", "columns: x y z scalar_time", ply_with("scalar_time", text_rows(zero))},
               {"pcd", "columns: x y z intensity", pcd_with("intensity", text_rows(zero))},
               {"pcd", "columns: x y z t", pcd_with("t", text_rows(zero))},
               {"kitti-bin", "columns: x y z reflectance", floats_of_a_circle()},
               {"las", "gps_time (one value for all points)", las(one_time)},
               {"las", "gps_time (one value for all points)", las(las_circle())}};
  for (const auto& one : cases) {
    const std::string said = message(one.type, one.bytes);
    EXPECT_TRUE(contains(said, "session.yaml:3") && contains(said, one.columns) && contains(said, "time, t, timestamp"))
        << one.type << ": " << said;
  }
}

TEST_F(declared_per_point, times_that_are_not_there_hide_no_turn_of_the_gps_week) {
  const std::string cloud = pcd_with("intensity", text_rows([](double) { return 0.0; }));
  constexpr long kTurn_s = 1024L * 7 * 86'400;
  const std::string both = message("pcd", cloud, "per-point", 1'600'000'000 - kTurn_s);
  EXPECT_TRUE(contains(both, "columns: x y z intensity") && contains(both, "turns of the GPS week")) << both;
  EXPECT_FALSE(contains(message("pcd", cloud), "GPS week"));
}

TEST_F(declared_per_point, seconds_of_a_week_as_32_bit_floats_are_no_times) {
  const auto rounded = [](double s) { return static_cast<double>(static_cast<float>(302'400.3 + s)); };
  EXPECT_TRUE(contains(message("ply", ply_with("scalar_GpsTime", text_rows(rounded))), "32-bit floats cannot hold"));
}

TEST_F(declared_per_point, times_that_are_there_are_taken) {
  EXPECT_EQ(message("ply", ply_with("scalar_GpsTime", text_rows([](double s) { return s; }))), "");
  EXPECT_EQ(session_.scan_timing, drive::ScanTiming::PerPoint);
  EXPECT_EQ(times_, static_cast<std::size_t>(kColumnPoints));
}

TEST_F(declared_per_point, declared_instant_no_point_is_lost_for_its_time) {
  // Minutes of a drive in one file, as surveyors export it: of no sweep, and not asked for.
  LasOptions options = las_circle();
  for (int i = 0; i < kColumnPoints; ++i) options.times.push_back(600'000'000.0 + (i % 2 == 0 ? 0.001 * i : 300.0 + i));
  EXPECT_EQ(message("las", las(options), "instant"), "");
  EXPECT_EQ(points_, static_cast<std::size_t>(kColumnPoints));
  options = las_circle();
  for (int i = 0; i < kColumnPoints; ++i) options.times.push_back(284'000'000.0 + 2.5e-4 * i);
  EXPECT_EQ(message("las", las(options), "instant"), "");
  EXPECT_EQ(points_, static_cast<std::size_t>(kColumnPoints));
  EXPECT_EQ(times_, static_cast<std::size_t>(kColumnPoints)) << "times of a sweep are kept";
}

TEST_F(declared_per_point, unknown_is_a_timing_of_its_own_with_a_warning) {
  EXPECT_EQ(message("kitti-bin", floats_of_a_circle(), "unknown"), "");
  EXPECT_EQ(session_.scan_timing, drive::ScanTiming::Unknown);
  ASSERT_EQ(session_.findings.size(), 1U);
  EXPECT_EQ(session_.findings[0].code, "no-point-times");
  EXPECT_EQ(session_.findings[0].severity, drive::Severity::Warning);
}

TEST(point_columns, coordinates_of_a_map_are_named_in_every_format) {
  const TemporaryFolder folder;
  std::string text, floats;
  LasOptions survey;
  survey.points.clear();
  survey.offset_m = 400'000.0;
  for (int i = 0; i < 64; ++i) {
    const double x = 414'000.0 + 0.5 * i, y = 432'000.0 - 0.2 * i, z = 170.0 + 0.1 * (i % 7);
    char line[96];
    std::snprintf(line, sizeof line, "%.2f %.2f %.2f 0\n", x, y, z);
    text += line;
    for (const double value : {x, y, z, 0.5}) {
      const auto number = static_cast<float>(value);
      floats.append(reinterpret_cast<const char*>(&number), 4);
    }
    survey.points.emplace_back(x, y, z);
  }
  const std::string head = "FIELDS x y z i\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 64\nHEIGHT 1\nDATA ascii\n";
  const std::string vertex =
      "ply\nformat ascii 1.0\nelement vertex 64\nproperty double x\nproperty double y\nproperty double z\nproperty "
      "float i\nend_header\n";
  const std::string near_origin = [] {  // a local map whose origin is kilometres away
    std::string rows;
    for (int i = 0; i < 64; ++i)
      rows += std::to_string(5200.0 + i) + " " + std::to_string(-3100.5 - 0.3 * i) + " 12.5 0\n";
    return rows;
  }();
  const std::pair<const char*, std::string> files[] = {{"a.pcd", head + text}, {"a.ply", vertex + text},
                                                       {"a.txt", text},        {"a.bin", floats},
                                                       {"a.las", las(survey)}, {"b.pcd", head + near_origin}};
  for (const auto& [name, bytes] : files) {
    const std::filesystem::path written = folder.write(name, bytes);
    const std::string said = error_of([&] { load_cloud(written, 0); });
    EXPECT_TRUE(contains(said, name) && contains(said, "coordinates of a map (up to")) << name << ": " << said;
  }
  const std::filesystem::path bag_path = folder.path() / "map.bag";
  bags::BagMaker bag(bag_path);
  bag.add_ins("/ins", 41);
  cloud::PointCloud far;
  for (int i = 0; i < 64; ++i) far.points.emplace_back(414'000.0f + static_cast<float>(i), 432'000.0f, 170.0f);
  for (int i = 0; i < 5; ++i)
    bag.add(bags::kStart_ns + i * bags::kStep_ns, "/points", "sensor_msgs/PointCloud2",
            bags::cloud_message(far, bags::kStart_ns + i * bags::kStep_ns, "map", bags::MessageEncoding::Ros1));
  bag.finish();
  Progress progress;
  const drive::Session session = bags::BagReader().open(bag_path, progress);
  EXPECT_TRUE(contains(error_of([&] { session.scans->load(0); }), "coordinates of a map (up to"));
}

TEST(point_columns, pcd_with_padding_of_no_bytes_and_without_width) {
  const TemporaryFolder folder;
  std::string data;
  for (int i = 0; i < 5; ++i) {
    for (const float value : {1.0f + static_cast<float>(i), 2.0f, 3.0f})
      data.append(reinterpret_cast<const char*>(&value), 4);
    data.append(3, '\x7f');  // padding
  }
  const std::string fields = "FIELDS x y z _ _\nSIZE 4 4 4 1 1\nTYPE F F F U U\nCOUNT 1 1 1 3 0\n";
  for (const char* size : {"WIDTH 5\nHEIGHT 1\nPOINTS 5\n", "WIDTH 0\nHEIGHT 0\nPOINTS 5\n",
                           "WIDTH 0\nHEIGHT 1\nPOINTS 5\n", "WIDTH 5\nHEIGHT 0\nPOINTS 5\n", "WIDTH 5\nHEIGHT 1\n"}) {
    const cloud::PointCloud cloud = load_cloud(folder.write("a.pcd", fields + size + "DATA binary\n" + data), 0);
    ASSERT_EQ(cloud.size(), 5U) << size;
    EXPECT_EQ(cloud.points[4], Eigen::Vector3f(5.0f, 2.0f, 3.0f)) << size;
  }
  EXPECT_TRUE(contains(error_of([&] {
                         load_cloud(folder.write("a.pcd", fields + "WIDTH 0\nHEIGHT 1\nPOINTS 6\nDATA binary\n" + data),
                                    0);
                       }),
                       "promises 6 points"));
  EXPECT_TRUE(contains(error_of([&] {
                         load_cloud(folder.write("a.pcd", fields + "WIDTH 4\nHEIGHT 1\nPOINTS 5\nDATA binary\n" + data),
                                    0);
                       }),
                       "POINTS is 5, but WIDTH times HEIGHT is 4"));
}

}  // namespace
}  // namespace remount::formats
