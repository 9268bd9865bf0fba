// Small valid inputs of every format that is read, to be damaged.
#pragma once

#include <cmath>
#include <functional>
#include <map>

#include "model/exporters/exporter.h"
#include "model/io/cloud_file.h"
#include "model/io/lzf.h"
#include "model/io/native_session_writer.h"
#include "model/project.h"
#include "model/session_report.h"
#include "model/simulator/simulator.h"
#include "tests/model/io/bag/sqlite_fixture.h"
#include "tests/model/io/mutator.h"
#include "tests/model/io/reader_fixtures.h"
#include "tests/model/io/temporary_folder.h"

namespace remount::samples {

namespace fs = std::filesystem;

/// Files of one input, and what reads them. `targets` are damaged, one at a time.
struct Subject {
  std::map<std::string, Bytes> files;
  std::vector<std::string> targets;
  std::function<void(const fs::path& folder)> read;
};

/// Everything that is done with a session before it is calibrated.
inline void read_session(const fs::path& path) {
  Progress progress;
  const Session session = open_session(path, progress);
  describe(session, report_session(session, progress));
}

inline std::string opening(const std::string& count, const std::string& encoding) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z ring time\nSIZE 4 4 4 2 4\nTYPE F F F U F\nCOUNT 1 1 1 1 1\nWIDTH " +
         count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + encoding + "\n";
}

template <class T>
inline void append(Bytes& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

inline Bytes compressed_pcd() {
  constexpr int kPoints = 20;
  Bytes columns;
  for (int column = 0; column < 5; ++column)
    for (int i = 0; i < kPoints; ++i)
      if (column == 3)
        append(columns, static_cast<std::uint16_t>(i % 4));
      else
        append(columns, 0.5f * static_cast<float>(i / 3 + column));
  const Bytes packed = lzf_encode(columns);
  Bytes bytes = opening(std::to_string(kPoints), "binary_compressed");
  append(bytes, static_cast<std::uint32_t>(packed.size()));
  append(bytes, static_cast<std::uint32_t>(columns.size()));
  return bytes + packed;
}

inline Bytes ply(const std::string& encoding) {
  Bytes bytes = "ply\nformat " + encoding +
                " 1.0\nelement camera 2\nproperty list uchar float view\nelement vertex 6\nproperty float x\nproperty "
                "double y\nproperty float z\nproperty uchar ring\nend_header\n";
  if (encoding == "ascii") {
    bytes += "2 0.5 0.25\n0\n";
    for (int i = 0; i < 6; ++i) bytes += std::to_string(i) + " 1.5 -2.25 3\n";
    return bytes;
  }
  append(bytes, std::uint8_t{2}), append(bytes, 0.5f), append(bytes, 0.25f), append(bytes, std::uint8_t{0});
  for (int i = 0; i < 6; ++i)
    append(bytes, static_cast<float>(i)), append(bytes, 1.5), append(bytes, -2.25f), append(bytes, std::uint8_t{3});
  return bytes;
}

inline Bytes bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::map<std::string, Bytes> all_files(const fs::path& folder) {
  std::map<std::string, Bytes> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = bytes_of(entry.path());
  return files;
}

inline Subject of_one_file(const std::string& name, Bytes bytes, std::function<void(const fs::path&)> read) {
  return {{{name, std::move(bytes)}}, {name}, [=](const fs::path& folder) { read(folder / name); }};
}

inline Subject of_cloud(const std::string& name, Bytes bytes) {
  return of_one_file(name, std::move(bytes), [](const fs::path& path) { load_cloud(path, 1'600'000'000'000'000'000); });
}

inline SimulatedDrive tiny_drive() {
  SimulationOptions options;
  options.duration_s = 0.6;
  options.beams = 4;
  options.azimuth_steps = 24;
  options.ins_rate_hz = options.imu.rate_hz = options.wheels.rate_hz = 20.0;
  options.clockwise = false;
  return simulate_drive(options);
}

/// A written session of which every file that holds text, and the first scan, is damaged.
inline Subject of_folder(const fs::path& folder) {
  Subject subject{all_files(folder), {}, read_session};
  for (const auto& [name, bytes] : subject.files)
    if (name != "truth.yaml" && (bytes.find('\0') == Bytes::npos || name.find("0000") != std::string::npos))
      subject.targets.push_back(name);
  return subject;
}

inline Subject native() {
  const TemporaryFolder folder;
  Progress progress;
  write_drive(tiny_drive(), folder.path() / "s", "native", 1, progress);
  return of_folder(folder.path() / "s");
}

inline Subject kitti(bool sync) {
  const TemporaryFolder folder;
  Progress progress;
  Session session = tiny_drive().session;
  if (sync) {
    session.ins.resize(std::min(session.ins.size(), session.scans->size()));
    for (std::size_t i = 0; i < session.ins.size(); ++i) session.ins[i].stamp_ns = session.scans->stamp_ns(i);
  }
  write_kitti_raw_session(session, folder.path(), 1, progress);
  Subject subject = of_folder(folder.path());
  const Bytes stamps = "2011-09-26 13:02:25.1\n2011-09-26 13:02:25.2\n2011-09-26 13:02:25.3\n";
  subject.files["calib_imu_to_velo.txt"] = "calib_time: 25-May-2012\nR: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.8\n";
  subject.targets.push_back("calib_imu_to_velo.txt");
  for (const auto& [name, bytes] : subject.files)
    if (name.ends_with("velodyne_points/timestamps.txt")) {
      const std::string start = name.substr(0, name.size() - 4) + "_start.txt";
      subject.files[start] = subject.files[name.substr(0, name.size() - 4) + "_end.txt"] = stamps;
      subject.targets.push_back(start);
      break;
    }
  return subject;
}

/// A written drive as a bag, which is damaged in the middle of its chunks as well as in its index.
inline Subject bag(const std::string& format) {
  const TemporaryFolder folder;
  Progress progress;
  write_drive(tiny_drive(), folder.path() / "s", format, 1, progress);
  Subject subject{all_files(folder.path() / "s"), {}, read_session};
  for (const auto& [name, bytes] : subject.files)
    if (name != "truth.yaml") subject.targets.push_back(name);
  return subject;
}

/// The same drive as a database: its messages are those of an MCAP.
inline Subject sqlite_bag() {
  const TemporaryFolder folder;
  Progress progress;
  write_drive(tiny_drive(), folder.path() / "s", "mcap", 1, progress);
  const auto mcap = open_bag(folder.path() / "s", progress);
  std::vector<std::pair<std::string, std::string>> topics;
  std::vector<bags::TestMessage> messages;
  for (const BagTopic& topic : mcap->topics()) {
    for (const BagEntry& entry : topic.entries)
      messages.push_back({static_cast<std::uint32_t>(topics.size()), entry.log_time_ns, mcap->message(entry)});
    topics.emplace_back(topic.name, topic.type);
  }
  const fs::path database = folder.path() / "drive.db3";
  bags::write_database(database, topics, messages);
  return {{{"drive.db3", bytes_of(database)}}, {"drive.db3"}, [](const fs::path& path) {
            read_session(path / "drive.db3");
          }};
}

inline Subject smartloc() {
  Bytes odometry, truth;
  for (int i = 0; i < 12; ++i) {
    const Bytes time = std::to_string(0.2 * i);
    odometry += "odom3 " + time + " 5.8 0 0 0 0 -0.005 0.0025 0.0009 0.0009 4e-06 4e-06 4e-06\n";
    truth += "point3 " + time + " " + std::to_string(3785108.1 + i) + " 899901.4 5037234.4 0 0 0 0 0 0 0 0 0\n";
  }
  return {{{"a_Input.txt", odometry}, {"a_GT.txt", truth}}, {"a_Input.txt", "a_GT.txt"}, [](const fs::path& folder) {
            read_session(folder / "a_Input.txt");
          }};
}

inline Bytes poses(const char* separator, int count) {
  Bytes text;
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i, yaw = 1.5 * std::sin(0.31 * t) + 0.8 * std::sin(0.83 * t + 1.0);
    char line[256];
    std::snprintf(line, sizeof line, "%.6f%s%.3f%s2%s3%s0%s0%s%.12f%s%.12f\n", 1.6e9 + t, separator, t, separator,
                  separator, separator, separator, separator, std::sin(yaw / 2), separator, std::cos(yaw / 2));
    text += line;
  }
  return text;
}

inline Bytes pose_lines(int count) {
  Bytes text;
  for (int i = 0; i < count; ++i) {
    char line[256];
    std::snprintf(line, sizeof line, "2021-10-26-16-21-%02d-%03d 1 0 0 %d 0 1 0 0 0 0 1 0\n", 10 + i / 10, i % 10 * 100,
                  i);
    text += line;
  }
  return text;
}

inline Bytes odometry_csv(int count) {
  Bytes text =
      "time,.header.seq,.header.stamp.secs,.header.stamp.nsecs,.pose.pose.position.x,.pose.pose.position.y,"
      ".pose.pose.position.z,.pose.pose.orientation.x,.pose.pose.orientation.y,.pose.pose.orientation.z,"
      ".pose.pose.orientation.w\n";
  for (int i = 0; i < count; ++i)
    text += std::to_string(i) + "," + std::to_string(i) + ",1636512535," + std::to_string(560000000 + i * 10000000) +
            "," + std::to_string(i) + ",0,0,0,0,0,1\n";
  return text;
}

inline Bytes inspvax_csv(int count) {
  Bytes text =
      "time,.header.gps_week,.header.gps_week_seconds,.ins_status,.latitude,.longitude,.altitude,.undulation,.roll,"
      ".pitch,.azimuth,.latitude_std,.longitude_std,.altitude_std,.roll_std,.pitch_std,.azimuth_std\n";
  for (int i = 0; i < count; ++i)
    text += std::to_string(1636512535000000000 + i * 20000000LL) + ",2183," + std::to_string(269353560 + 20 * i) +
            ",3,51.1,-114.0,1063.6,-16.9,0.5,0.25," + std::to_string(90 + i) + ",0.1,0.1,0.1,0.01,0.01,0.02\n";
  return text;
}

inline Subject of_files(std::map<std::string, Bytes> files) {
  Subject subject{std::move(files), {}, read_session};
  for (const auto& [name, bytes] : subject.files) subject.targets.push_back(name);
  return subject;
}

inline Bytes inspvax_log(int count) {
  Bytes text;
  for (int i = 0; i < count; ++i) text += inspvaxa(2183, 100.0 + 0.02 * i, 90.0 + i);
  return text;
}

inline Bytes motion_pairs(int count) {
  Bytes text = "# pairs\nset,i,j";
  for (const char letter : {'P', 'Q'})
    for (int i = 0; i < 12; ++i) text += std::string(",") + letter + std::to_string(i / 4) + std::to_string(i % 4);
  for (int k = 0; k < count; ++k) {
    text += "\ns," + std::to_string(k) + "," + std::to_string(k + 1);
    for (int matrix = 0; matrix < 2; ++matrix)
      for (int i = 0; i < 12; ++i) text += i % 5 == 0 ? ",1" : ",0";
  }
  return text + "\n";
}

inline ResultFile result() {
  ResultFile file;
  file.result.status = Status::Ok;
  file.result.observed.fill(true);
  file.result.covariance = Matrix6d::Identity() * 1e-6;
  file.result.ins_from_lidar = rigid_from_six({0.9, -0.25, 0.75, 2.0, -0.02, 0.015});
  file.ins_axes = InsAxes::ForwardLeftUp;
  return file;
}

/// A project with a calibration in it.
inline Bytes project() {
  const TemporaryFolder folder;
  Project project;
  project.sessions = {folder.path() / "one"};
  project.nominal_ins_from_lidar = RigidTransform::Identity();
  project.verdicts.push_back({0, 1, 2, PairState::Rejected, "by hand"});
  PipelineOutput output;
  for (int i = 0; i < 4; ++i)
    output.keyframes.push_back({0, i, 1'600'000'000'000'000'000 + i * 100'000'000LL, 1.0 * i});
  for (int i = 0; i < 3; ++i) {
    Pair pair;
    pair.keyframe_a = i;
    pair.keyframe_b = i + 1;
    output.pairs.push_back(pair);
  }
  output.result = result().result;
  project.output = output;
  project.basis.session_count = 1;
  save_project(project, folder.path() / "p.remount");
  return bytes_of(folder.path() / "p.remount");
}

}  // namespace remount::samples
