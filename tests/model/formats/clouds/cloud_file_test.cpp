#include "model/formats/clouds/cloud_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <random>

#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/lzf.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

using cloud::PointCloud;

namespace {

template <class T>
void append(std::string& bytes, T value, bool swap = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (swap) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string pcd_header(const std::string& fields, const std::string& sizes, const std::string& types,
                       const std::string& points, const std::string& data) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types + "\nWIDTH " + points +
         "\nHEIGHT 1\nPOINTS " + points + "\nDATA " + data + "\n";
}

class cloud_file : public ::testing::Test {
 protected:
  PointCloud load(const std::string& name, const std::string& bytes, std::int64_t stamp_ns = 0) {
    return load_cloud(folder_.write(name, bytes), stamp_ns);
  }
  TemporaryFolder folder_;
};

PointCloud made_cloud() {
  PointCloud cloud;
  for (int i = 0; i < 300; ++i) {
    cloud.points.emplace_back(0.25f * static_cast<float>(i), -1.0f / 3.0f, 2.0f);
    cloud.intensity.push_back(static_cast<float>(i % 7));
    cloud.ring.push_back(static_cast<std::uint16_t>(i * 200));
    cloud.time_from_stamp_s.push_back(1e-4f * static_cast<float>(i));
  }
  return cloud;
}

TEST_F(cloud_file, pcd_reads_back_what_was_written) {
  const PointCloud written = made_cloud();
  write_pcd(folder_.path() / "a.pcd", written);
  const PointCloud read = load_cloud(folder_.path() / "a.pcd", 0);
  EXPECT_EQ(read.points, written.points);
  EXPECT_EQ(read.intensity, written.intensity);
  EXPECT_EQ(read.ring, written.ring);
  EXPECT_EQ(read.time_from_stamp_s, written.time_from_stamp_s);
  EXPECT_EQ(read.dropped_points, 0u);
}

TEST_F(cloud_file, kitti_bin_reads_back_what_was_written) {
  const PointCloud written = made_cloud();
  write_kitti_bin(folder_.path() / "a.bin", written);
  const PointCloud read = load_cloud(folder_.path() / "a.bin", 0);
  EXPECT_EQ(read.points, written.points);
  EXPECT_EQ(read.intensity, written.intensity);
}

TEST_F(cloud_file, ascii_pcd_with_doubles_upper_case_and_any_order) {
  const PointCloud cloud = load(
      "a.pcd",
      "VERSION 0.7\nPOINTS 3\nFIELDS Intensity Z Ring X Y extra\nTYPE F F U F F I\nCOUNT 1 1 1 1 1 2\nSIZE 4 8 2 8 "
      "8 4\nHEIGHT 1\nWIDTH 3\nDATA ASCII\n7 3.5 4 1.5 2.5 0 0\n8 nan 5 1 1 0 0\n9 0 6 0 0 0 0\n");
  ASSERT_EQ(cloud.size(), 1u);
  EXPECT_EQ(cloud.points[0], Eigen::Vector3f(1.5f, 2.5f, 3.5f));
  EXPECT_EQ(cloud.intensity[0], 7.0f);
  EXPECT_EQ(cloud.ring[0], 4);
  EXPECT_EQ(cloud.dropped_points, 2u) << "one NaN and one at zero range";
}

TEST_F(cloud_file, binary_pcd_with_integer_and_double_coordinates) {
  std::string bytes = pcd_header("x y z", "2 8 4", "I F I", "2", "binary");
  append<std::int16_t>(bytes, -3), append<double>(bytes, 1.25), append<std::int32_t>(bytes, 70000);
  append<std::int16_t>(bytes, 4), append<double>(bytes, -2.5), append<std::int32_t>(bytes, -1);
  const PointCloud cloud = load("a.pcd", bytes);
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_EQ(cloud.points[0], Eigen::Vector3f(-3.0f, 1.25f, 70000.0f));
  EXPECT_EQ(cloud.points[1], Eigen::Vector3f(4.0f, -2.5f, -1.0f));
}

std::string compressed_pcd(std::uint32_t promised_extra = 0, std::uint32_t packed_extra = 0) {
  std::string columns;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 100; ++i) append(columns, static_cast<float>(axis + 1 + i / 10));
  const std::string packed = lzf_encode(columns);
  std::string bytes = pcd_header("x y z", "4 4 4", "F F F", "100", "binary_compressed");
  append(bytes, static_cast<std::uint32_t>(packed.size()) + packed_extra);
  append(bytes, static_cast<std::uint32_t>(columns.size()) + promised_extra);
  return bytes + packed;
}

TEST_F(cloud_file, compressed_pcd) {
  const PointCloud cloud = load("a.pcd", compressed_pcd());
  ASSERT_EQ(cloud.size(), 100u);
  EXPECT_EQ(cloud.points[99], Eigen::Vector3f(10.0f, 11.0f, 12.0f));
  EXPECT_ERROR(load("b.pcd", compressed_pcd(12)), "expected 100 points");
  EXPECT_ERROR(load("c.pcd", compressed_pcd(0, 1)), "compressed bytes");
  std::string broken = compressed_pcd();
  broken[broken.size() - 3] = '\x7f';
  EXPECT_ERROR(load("d.pcd", broken), "d.pcd: byte");
}

TEST_F(cloud_file, lzf_decodes_what_it_encodes_and_refuses_the_rest) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    std::string bytes(static_cast<std::size_t>(random() % 5000), '\0');
    for (char& c : bytes) c = static_cast<char>(random() % (1 + random() % 8));
    const std::string packed = lzf_encode(bytes);
    ASSERT_EQ(lzf_decode(packed, bytes.size()), bytes);
    if (!bytes.empty()) {
      EXPECT_FALSE(lzf_decode(packed, bytes.size() - 1));
    }
    EXPECT_FALSE(lzf_decode(packed, bytes.size() + 1));
  }
  EXPECT_FALSE(lzf_decode("\x20\x05", 100)) << "refers to before the start";
  EXPECT_FALSE(lzf_decode("abc", std::size_t{1} << 40)) << "must not take memory for it";
}

TEST_F(cloud_file, times_become_relative_to_the_stamp) {
  constexpr std::int64_t kStamp = 1'635'265'289'468'000'000;
  const auto with_times = [&](const std::string& name, const std::string& size, const std::string& type,
                              const std::string& text) {
    return load(name + ".pcd", pcd_header("x y z " + name, "4 4 4 " + size, "F F F " + type, "2", "ascii") + text,
                kStamp);
  };
  const auto expect = [](const PointCloud& cloud, float first, float second) {
    ASSERT_EQ(cloud.time_from_stamp_s.size(), 2u);
    EXPECT_NEAR(cloud.time_from_stamp_s[0], first, 1e-6f);
    EXPECT_NEAR(cloud.time_from_stamp_s[1], second, 1e-6f);
  };
  expect(with_times("time", "4", "F", "1 1 1 -0.05\n1 1 1 0.05\n"), -0.05f, 0.05f);
  expect(with_times("t", "4", "U", "1 1 1 0\n1 1 1 99000000\n"), 0.0f, 0.099f);
  expect(with_times("offset_time", "4", "U", "1 1 1 500\n1 1 1 1500\n"), 5e-7f, 1.5e-6f);
  expect(with_times("timestamp", "8", "F", "1 1 1 1635265289.478\n1 1 1 1635265289.567\n"), 0.010f, 0.099f);
  expect(with_times("time_stamp", "8", "U", "1 1 1 1635265289478000000\n1 1 1 1635265289567000000\n"), 0.010f, 0.099f);
  expect(with_times("timestamp", "8", "F", "1 1 1 1635236489.378\n1 1 1 1635236489.467\n"), -0.09f, -0.001f);  // 8 h
  expect(with_times("TIMESTAMP", "8", "F", "1 1 1 1000000000.5\n1 1 1 1000000000.6\n"), 0.0f, 0.1f);  // another clock
  expect(with_times("time", "4", "F", "1 1 1 0\n1 1 1 99000\n"), 0.0f, 0.099f);                       // microseconds
}

TEST_F(cloud_file, times_since_power_up_keep_their_sweep_in_pcd_and_ply) {
  constexpr std::int64_t kStamp = 1'635'265'289'468'000'000;
  std::string seconds, nanoseconds;
  for (int i = 0; i <= 100; ++i) {
    seconds += "1 1 1 " + std::to_string(1234.5 + 0.001 * i) + "\n";
    nanoseconds += "1 1 1 " + std::to_string(200'000'000'000 + 1'000'000 * i) + "\n";
  }
  seconds += "1 1 1 0\n", nanoseconds += "1 1 1 0\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 102\nproperty float x\nproperty float y\nproperty float z\nproperty "
      "double timestamp\nend_header\n";
  for (const std::string& rows : {seconds, nanoseconds})
    for (const std::string& bytes :
         {pcd_header("x y z timestamp", "4 4 4 8", "F F F F", "102", "ascii") + rows, ply + rows}) {
      const ReadCloud read = read_cloud_file(folder_.write(bytes[0] == 'p' ? "a.ply" : "a.pcd", bytes), kStamp);
      EXPECT_TRUE(read.points_have_another_clock);
      ASSERT_EQ(read.cloud.size(), 101u);
      EXPECT_EQ(read.cloud.dropped_points, 1u) << "the one at time 0";
      EXPECT_NEAR(read.cloud.time_from_stamp_s.front(), 0.0f, 1e-6f);
      EXPECT_NEAR(read.cloud.time_from_stamp_s.back(), 0.1f, 1e-6f);
    }
}

TEST_F(cloud_file, coordinates_of_one_byte_are_refused_where_points_are_bytes) {
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "1 1 1", "I I I", "2", "binary") + "abcdef"),
               "the coordinate x has one byte, expected two or more");
  const auto ply = [](const std::string& format) {
    return "ply\nformat " + format + " 1.0\nelement vertex 1\nproperty float x\nproperty uchar y\nproperty float " +
           "z\nend_header\n";
  };
  EXPECT_ERROR(load("a.ply", ply("binary_big_endian") + "123456789"), "the coordinate y has one byte");
  EXPECT_EQ(load("a.ply", ply("ascii") + "1 2 3\n").size(), 1u);
}

TEST_F(cloud_file, malformed_pcd_is_an_error_that_names_the_place) {
  const std::string good = pcd_header("x y z", "4 4 4", "F F F", "2", "ascii") + "1 2 3\n4 5 6\n";
  EXPECT_EQ(load("good.pcd", good).size(), 2u);
  EXPECT_ERROR(load("a.pcd", ""), "a.pcd:1: is empty");
  EXPECT_ERROR(load("a.pcd", "FIELDS x y z\nSIZE 4 4 4\n"), "no DATA line");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4 4", "F F F", "2", "ascii") + "1.000 2.000 3.000\n"),
               "after 1 of 2 points");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4 4", "F F F", "2", "ascii") + "1.000 2 3\n4 5\n"),
               "a.pcd:11: has 2 values, expected 3");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4 4", "F F F", "1", "ascii") + "1 2 abc\n"),
               "a.pcd:10: z is 'abc'");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4 -4", "F F F", "1", "ascii") + "1 2 3\n"), "SIZE holds '-4'");
  EXPECT_ERROR(
      load("a.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 -1\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3\n"),
      "COUNT holds '-1'");
  EXPECT_ERROR(
      load("a.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 65536\nHEIGHT 65536\nPOINTS 0\nDATA binary\n"),
      "WIDTH times HEIGHT is 4294967296");
  EXPECT_ERROR(
      load("a.pcd",
           "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 9000000000000000000\nHEIGHT 9000000000\nDATA binary\n"),
      "does not fit");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4 4", "F F F", "4000000000", "binary") + "abc"), "hold at most 0");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4 4", "F F F", "4000000000", "binary_compressed") + "abcdefghijkl"),
               "hold at most");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y", "4 4", "F F", "1", "ascii") + "1 2\n"), "expected x, y and z");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4 3", "F F F", "1", "ascii") + "1 2 3\n"), "TYPE F with SIZE 3");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4", "F F F", "1", "ascii") + "1 2 3\n"), "SIZE has 2");
  EXPECT_ERROR(load("a.pcd", pcd_header("x y z", "4 4 4", "F F F", "1", "zipped") + "1 2 3\n"), "DATA is 'zipped'");
  EXPECT_ERROR(load("a.pcd", "FIELDS x y z\nNONSENSE 1\n"), "'NONSENSE' is not a line");
  std::string many = "FIELDS";
  for (int i = 0; i < 1'000'000; ++i) many += " f";
  EXPECT_ERROR(load("a.pcd", many + "\nDATA ascii\n"), "at most 512");
  EXPECT_ERROR(
      load("a.pcd",
           "FIELDS x y z w\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1000000\nWIDTH 1000\nHEIGHT 1\nDATA binary\n" +
               std::string(100, 'x')),
      "hold at most 0");
}

TEST_F(cloud_file, ply_in_every_encoding_with_lists_before) {
  const auto header = [](const std::string& format, const std::string& scalar) {
    return "ply\nformat " + format +
           " 1.0\ncomment made\nelement face 2\nproperty list uchar int vertex_indices\nelement vertex 2\nproperty " +
           scalar + " x\nproperty " + scalar + " y\nproperty " + scalar + " z\nproperty uchar intensity\nend_header\n";
  };
  for (const bool big : {false, true}) {
    std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian", "double");
    for (int face = 0; face < 2; ++face) {
      append<std::uint8_t>(bytes, static_cast<std::uint8_t>(face + 2));
      for (int i = 0; i < face + 2; ++i) append<std::int32_t>(bytes, i, big);
    }
    for (int i = 0; i < 2; ++i) {
      for (int axis = 0; axis < 3; ++axis) append<double>(bytes, 1.5 * (axis + 1) + i, big);
      append<std::uint8_t>(bytes, static_cast<std::uint8_t>(200 + i));
    }
    const PointCloud cloud = load("a.ply", bytes);
    ASSERT_EQ(cloud.size(), 2u) << big;
    EXPECT_EQ(cloud.points[1], Eigen::Vector3f(2.5f, 4.0f, 5.5f));
    EXPECT_EQ(cloud.intensity[1], 201.0f);
    EXPECT_ERROR(load("b.ply", bytes.substr(0, bytes.size() - 1)), "b.ply: byte");
  }
  const std::string text = header("ascii", "float");
  EXPECT_EQ(load("c.ply", text + "3 0 1 2\n3 0 1 2\n1 2 3 4\n5 6 7 8\n").points[1], Eigen::Vector3f(5.0f, 6.0f, 7.0f));
  EXPECT_ERROR(load("d.ply", text + "3 0 1 2\n3 0 1 2\n1.5 2 3 4\n5 6 7\n"), "d.ply:15");
  EXPECT_ERROR(load("d.ply", text + "3 0 1 2\n9 0 1 2\n1 2 3 4\n5 6 7 1\n"), "a list promises more");
}

TEST_F(cloud_file, malformed_ply_is_an_error_that_names_the_place) {
  const std::string vertex = "property float x\nproperty float y\nproperty float z\nend_header\n";
  EXPECT_ERROR(load("a.ply", ""), "does not begin with 'ply'");
  EXPECT_ERROR(load("a.ply", "ply\nelement vertex 1\n" + vertex), "no 'format' line");
  EXPECT_ERROR(load("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"), "no 'end_header'");
  EXPECT_ERROR(load("a.ply", "ply\nformat ascii 1.0\nelement vertex -1\n" + vertex), "a.ply:3: expected 'element");
  EXPECT_ERROR(load("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n" + vertex + "abc"),
               "promises 4000000000");
  EXPECT_ERROR(load("a.ply", "ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int v\nend_header\n"),
               "no element 'vertex'");
  EXPECT_ERROR(load("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty list uchar float y\nproperty "
                    "float z\nend_header\n1 0 2\n"),
               "expected x, y and z");
  EXPECT_ERROR(load("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty decimal x\n"), "'decimal' is not");
}

TEST_F(cloud_file, kitti_bin_of_wrong_length_and_text_scans) {
  EXPECT_ERROR(load("a.bin", ""), "holds 0 bytes");
  EXPECT_ERROR(load("a.bin", std::string(17, 'x')), "holds 17 bytes that are no points");
  const PointCloud text = load("a.txt", "1.5 2 3 0.5\n0 0 0 0\n4 5 6 0.25\n");
  EXPECT_EQ(text.size(), 2u);
  EXPECT_EQ(text.dropped_points, 1u);
  EXPECT_ERROR(load("b.txt", "1 2 3 4\n1 2\n"), "b.txt:2");
  EXPECT_ERROR(load("b.dat", "1 2 3 4\n"), "is no PCD, PLY");
}

TEST_F(cloud_file, only_regular_files_are_read) {
  std::filesystem::create_directory(folder_.path() / "x.pcd");
  EXPECT_ERROR(load_cloud(folder_.path() / "x.pcd", 0), "is a directory, expected a regular file");
  ASSERT_EQ(::mkfifo((folder_.path() / "fifo.pcd").c_str(), 0600), 0);
  EXPECT_ERROR(load_cloud(folder_.path() / "fifo.pcd", 0), "is a FIFO");
  EXPECT_ERROR(load_cloud("/dev/zero", 0), "is a device");
  EXPECT_ERROR(load_cloud(folder_.path() / "missing.pcd", 0), "missing.pcd: cannot be opened");
  std::filesystem::create_symlink("loop.pcd", folder_.path() / "loop.pcd");
  EXPECT_ERROR(load_cloud(folder_.path() / "loop.pcd", 0), "loop.pcd: cannot be opened");
}

// Mutations of good files either load or throw Error, in little time and little memory.
TEST_F(cloud_file, mutated_files_never_crash) {
  std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement face 3\nproperty list uchar int v\nelement vertex 9\nproperty "
      "float x\nproperty float y\nproperty float z\nend_header\n";
  ply += std::string(3 * 5, '\1') + std::string(9 * 12, '\2');
  const std::string ascii = pcd_header("x y z t", "4 4 4 4", "F F F U", "3", "ascii") + "1 2 3 4\n5 6 7 8\n9 1 2 3\n";
  std::mt19937 random(7);
  int loaded = 0, refused = 0;
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& good : {compressed_pcd(), ply, ascii}) {
    for (int round = 0; round < 3000; ++round) {
      std::string bytes = good;
      for (unsigned i = 0; i <= random() % 4; ++i) {
        const std::size_t at = random() % bytes.size();
        switch (random() % 4) {
          case 0:
            bytes[at] = static_cast<char>(random());
            break;
          case 1:
            bytes[at] = "0123456789- \n"[random() % 13];
            break;
          case 2:
            bytes.erase(at, random() % 9);
            break;
          default:
            bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 9));
            break;
        }
        if (bytes.empty()) break;
      }
      try {
        if (bytes.starts_with("ply"))
          parse_ply(bytes, "m.ply", 0);
        else
          parse_pcd(bytes, "m.pcd", 0);
        ++loaded;
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(loaded, 50);
  EXPECT_GT(refused, 500);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, 2'000'000) << "kB at most, of the whole test program";
}

TEST(cloud_file_on_real_data, reads_open_calib_and_zxl19) {
  const auto opencalib = shared_data() / "opencalib" / "top_center_lidar" / "2021-10-26-16-21-29-468.pcd";
  SKIP_WITHOUT(opencalib);
  const PointCloud cloud = load_cloud(opencalib, 0);
  EXPECT_EQ(cloud.size() + cloud.dropped_points, 80787u);
  EXPECT_EQ(cloud.ring.size(), cloud.size());
  // The name is local time (8 h east) and says when the turn ends.
  const PointCloud stamped = load_cloud(opencalib, 1'635'265'289'468'000'000);
  EXPECT_NEAR(*std::min_element(stamped.time_from_stamp_s.begin(), stamped.time_from_stamp_s.end()), -0.0989f, 1e-3f);
  EXPECT_NEAR(*std::max_element(cloud.time_from_stamp_s.begin(), cloud.time_from_stamp_s.end()), 0.0999f, 1e-3f);
  const PointCloud still = load_cloud(shared_data() / "zxl19" / "static1.pcd", 0);
  EXPECT_EQ(still.size() + still.dropped_points, 171522u);
  EXPECT_EQ(*std::max_element(still.ring.begin(), still.ring.end()), 63);
}

}  // namespace
}  // namespace remount::formats
