// Small valid files of every format, damaged in thousands of ways: each is read, or refused by an Error that names the
// file. Deterministic; REMOUNT_MUTATIONS sets how many mutations a reader gets. Meant for the sanitizers.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>
#include <iostream>

#include "model/batch/fleet.h"
#include "model/io/motion_pairs_file.h"
#include "model/settings_file.h"
#include "tests/model/io/las_bytes.h"
#include "tests/model/io/mutator.h"
#include "tests/model/io/sample_inputs.h"

namespace remount {
namespace {

using namespace samples;

int mutations() {
  const char* text = std::getenv("REMOUNT_MUTATIONS");
  return text ? std::max(1, std::atoi(text)) : 300;
}

/// The same on every platform, unlike std::hash.
unsigned seed_of(const std::string& name) {
  unsigned seed = 2166136261U;
  for (const char c : name) seed = (seed ^ static_cast<unsigned char>(c)) * 16777619U;
  return seed;
}

/// Peak memory of the process, MB.
double peak_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// ---- The test

class mutated_input : public ::testing::Test {
 protected:
  /// Damages one file at a time: cut at many lengths, then at random. What comes back is data or an Error that names
  /// the input.
  void run(const std::string& name, const Subject& subject) {
    name_ = name;
    mutations_ = refused_ = 0;
    longest_s_ = 0.0;
    for (const auto& [file, bytes] : subject.files) folder_.write(file, bytes);
    try {
      subject.read(folder_.path());
    } catch (const Error& error) {
      FAIL() << name << " is not valid to begin with: " << error.what();
    }
    const double peak_before_mb = peak_mb();
    const std::size_t cuts =
        std::max<std::size_t>(1, static_cast<std::size_t>(mutations()) / 5 / subject.targets.size());
    for (const std::string& target : subject.targets) {
      const Bytes& good = subject.files.at(target);
      for (std::size_t i = 0; i < std::min(cuts, good.size()) && !HasFatalFailure(); ++i)
        attempt(subject, target, good.substr(0, good.size() * i / std::min(cuts, good.size())));
    }
    Mutator mutator(seed_of(name));
    while (mutations_ < mutations() && !HasFatalFailure()) {
      const std::string& target = subject.targets[mutator.below(subject.targets.size())];
      attempt(subject, target, mutator.damaged(subject.files.at(target)));
    }
    const double grown_mb = peak_mb() - peak_before_mb;
    std::cout << name << ": " << mutations_ << " mutations, " << refused_ << " refused, longest " << longest_s_
              << " s, memory grew by " << grown_mb << " MB\n";
    EXPECT_LT(grown_mb, 400.0) << name << ": more than such small files can need";
  }

 private:
  void attempt(const Subject& subject, const std::string& target, const Bytes& damaged) {
    const int number = mutations_++;
    folder_.write(target, damaged);
    const auto started = std::chrono::steady_clock::now();
    try {
      subject.read(folder_.path());
    } catch (const Error& error) {
      ++refused_;
      const bool named = contains(error.what(), folder_.path().string()) || contains(error.what(), target);
      if (!named) keep(damaged);
      ASSERT_TRUE(named) << name_ << " mutation " << number << " of " << target << ": " << error.what();
    } catch (const std::exception& error) {
      keep(damaged);
      FAIL() << name_ << " mutation " << number << " of " << target << ": not an Error: " << error.what();
    }
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    longest_s_ = std::max(longest_s_, took_s);
    ASSERT_LT(took_s, 20.0) << name_ << " mutation " << number << " of " << target;
    folder_.write(target, subject.files.at(target));
  }

  /// For the one who mends it.
  static void keep(const Bytes& bytes) {
    std::ofstream(fs::temp_directory_path() / "remount-mutation", std::ios::binary) << bytes;
  }

  TemporaryFolder folder_;
  std::string name_;
  int mutations_ = 0, refused_ = 0;
  double longest_s_ = 0.0;
};

TEST_F(mutated_input, of_native_sessions) { run("native", native()); }
TEST_F(mutated_input, of_rosbag1) { run("rosbag1", bag("rosbag1")); }
TEST_F(mutated_input, of_mcap) { run("mcap", bag("mcap")); }
TEST_F(mutated_input, of_rosbag2_databases) { run("rosbag2 database", sqlite_bag()); }
TEST_F(mutated_input, of_smartloc) { run("smartloc", smartloc()); }
TEST_F(mutated_input, of_kitti_extract) { run("kitti extract", kitti(false)); }
TEST_F(mutated_input, of_kitti_sync) { run("kitti sync", kitti(true)); }
TEST_F(mutated_input, of_opencalib) {
  run("opencalib poses", of_files({{"novatel-pose.txt", pose_lines(20)}, {"top_lidar-pose.txt", pose_lines(20)}}));
}
TEST_F(mutated_input, of_opencalib_scans) {
  std::map<std::string, Bytes> files{{"novatel-pose.txt", pose_lines(3)}};
  for (int i = 0; i < 3; ++i) files["pcd/2021-10-26-16-21-10-" + std::to_string(i) + "00.pcd"] = compressed_pcd();
  run("opencalib scans", of_files(files));
}
TEST_F(mutated_input, of_novatel_logs) {
  run("novatel log", of_files({{"a.log", inspvax_log(12)}, {"lidar.txt", poses(" ", 40)}}));
}
TEST_F(mutated_input, of_novatel_csv) {
  run("novatel csv", of_files({{"ins.csv", inspvax_csv(12)}, {"aft_mapped.csv", odometry_csv(12)}}));
}
TEST_F(mutated_input, of_pose_files) {
  run("tum and eth poses", of_files({{"hand.csv", poses(",", 40)}, {"camera.txt", poses(" ", 40)}}));
}
TEST_F(mutated_input, of_pcd_ascii) {
  Bytes rows;
  for (int i = 0; i < 10; ++i) rows += std::to_string(i) + " 2.5 3 4 0.01\n";
  run("pcd ascii", of_cloud("a.pcd", opening("10", "ascii") + rows));
}
TEST_F(mutated_input, of_pcd_binary) {
  Bytes rows;
  for (int i = 0; i < 10; ++i) {
    for (int axis = 0; axis < 3; ++axis) append(rows, static_cast<float>(i + axis));
    append(rows, static_cast<std::uint16_t>(i)), append(rows, 0.01f);
  }
  run("pcd binary", of_cloud("a.pcd", opening("10", "binary") + rows));
}
TEST_F(mutated_input, of_pcd_compressed) { run("pcd compressed", of_cloud("a.pcd", compressed_pcd())); }
TEST_F(mutated_input, of_ply_ascii) { run("ply ascii", of_cloud("a.ply", ply("ascii"))); }
TEST_F(mutated_input, of_ply_binary) { run("ply binary", of_cloud("a.ply", ply("binary_little_endian"))); }
TEST_F(mutated_input, of_kitti_bin) {
  Bytes bytes;
  for (int i = 0; i < 40; ++i) append(bytes, static_cast<float>(i) * 0.5f);
  run("kitti bin", of_cloud("a.bin", bytes));
}
TEST_F(mutated_input, of_xyzi_text) { run("xyzi text", of_cloud("a.txt", "1 2 3 0.5\n4 5 6 0.25\n7 8 9 1\n")); }
TEST_F(mutated_input, of_las) {
  LasOptions options;
  options.times = {300'000'000.25, 300'000'000.34};
  run("las 1.2", of_cloud("a.las", las(options)));
  options.minor = 4, options.format = 6;
  run("las 1.4", of_cloud("a.las", las(options)));
}
TEST_F(mutated_input, of_gnss_logs) {
  const Bytes lidar = poses(" ", 40);
  Bytes nmea = "$GPRMC,122600.00,A,,,,,,,130920,,,A\n";
  for (int i = 0; i < 12; ++i)
    nmea += "$GPGGA,12264" + std::to_string(i % 10) +
            ".00,4846.10,N,00911.50,E,4,12,0.8,250.0,M,48.0,M,,\n$PASHR,12264" + std::to_string(i % 10) +
            ".00,350.0,T,+02.00,-01.00,+0.00,0.10,0.11,0.20,2,1\n";
  run("nmea", of_files({{"gnss.nmea", nmea}, {"lidar.txt", lidar}}));
  Bytes gpx = "<gpx version=\"1.1\"><trk><trkseg>\n";
  for (int i = 0; i < 6; ++i)
    gpx += "<trkpt lat=\"48.5\" lon=\"9.25\"><ele>310</ele><time>2020-09-13T12:26:4" + std::to_string(i) +
           "Z</time></trkpt>\n";
  run("gpx", of_files({{"track.gpx", gpx + "</trkseg></trk></gpx>\n"}, {"lidar.txt", lidar}}));
}
TEST_F(mutated_input, of_apollo_odometry) {
  Bytes text = "timestamp,position_type,qw,qx,qy,qz,x,y,z\n";
  for (int i = 0; i < 20; ++i)
    text += std::to_string(1600000000 + i) + ",56,1,0,0,0," + std::to_string(586000 + i) + ",4405000,31\n";
  run("apollo odometry", of_files({{"ins.csv", text}, {"lidar.txt", poses(" ", 40)}}));
}
TEST_F(mutated_input, of_fleets) {
  run("fleet", of_one_file("fleet.yaml",
                           "format: remount-fleet/1\nresults: r\ndrift: {sigmas: 3}\nsettings: {pairing: {max_gap_s: "
                           "3}}\nvehicles:\n  - {name: v, nominal: [1, 2, 3, 4, 5, 6], sessions: [a, [b, c]]}\n",
                           [](const fs::path& path) { load_fleet(path); }));
}
TEST_F(mutated_input, of_motion_pairs) {
  run("motion pairs", of_one_file("pairs.csv", motion_pairs(5), [](const fs::path& path) { read_motion_pairs(path); }));
}
TEST_F(mutated_input, of_results) {
  for (const char* id : {"yaml", "json"})
    run(std::string("result ") + id, of_one_file(std::string("r.") + id, exporter(id).write(result(), {}),
                                                 [](const fs::path& path) { load_result(path); }));
}
TEST_F(mutated_input, of_nominal_files) {
  for (const auto& format : exporters())
    run("nominal " + std::string(format->id()),
        of_one_file(std::string(format->file_name()), format->write(result(), {}),
                    [](const fs::path& path) { read_any_mounting(path); }));
  run("nominal six numbers", of_one_file("six.txt", "# x y z yaw pitch roll\n0.9, -0.25, 0.75, 90, 0, 0\n",
                                         [](const fs::path& path) { read_any_mounting(path); }));
}
TEST_F(mutated_input, of_settings) {
  run("settings",
      of_one_file("config.yaml", settings_text(Settings{}), [](const fs::path& path) { load_settings(path); }));
}
TEST_F(mutated_input, of_projects) {
  run("project", of_one_file("p.remount", project(), [](const fs::path& path) { load_project(path); }));
}

TEST_F(mutated_input, that_is_no_regular_file_is_refused_at_once) {
  const TemporaryFolder folder;
  const fs::path fifo = folder.path() / "fifo", directory = folder.path() / "directory";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  fs::create_directories(directory);
  const std::vector<std::pair<const char*, std::function<void(const fs::path&)>>> readers{
      {"cloud", [](const fs::path& path) { load_cloud(path, 0, CloudFormat::Pcd); }},
      {"pairs", [](const fs::path& path) { read_motion_pairs(path); }},
      {"result", [](const fs::path& path) { load_result(path); }},
      {"nominal", [](const fs::path& path) { read_any_mounting(path); }},
      {"settings", [](const fs::path& path) { load_settings(path); }},
      {"project", [](const fs::path& path) { load_project(path); }},
      {"session", [](const fs::path& path) { open(path); }}};
  for (const auto& [name, read] : readers)
    for (const fs::path& path : {fifo, directory, fs::path("/dev/zero"), fs::path("/dev/null")})
      EXPECT_TRUE(contains(error_of([&] { read(path); }), path.string())) << name << " " << path;
}

}  // namespace
}  // namespace remount
