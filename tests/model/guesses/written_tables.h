// A simulated drive whose INS is written as tables that nobody declared, beside its scans.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/geometry/rotation.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/time_stamp.h"
#include "tests/model/simulator/written_drive.h"

namespace remount::guesses {

/// One sample of the INS, with its pose in a metric world.
struct WrittenSample {
  motion::InsSample ins;
  RigidTransform world_from_ins;
};

inline std::string seconds_text(std::int64_t stamp_ns) {
  const std::string rest = std::to_string(1'000'000'000 + stamp_ns % 1'000'000'000);
  return std::to_string(stamp_ns / 1'000'000'000) + "." + rest.substr(1);
}

inline std::string degrees_text(double angle_rad) { return formats::exact_text(radians_to_degrees(angle_rad)); }
inline std::string number(double value) { return formats::exact_text(value); }

/// How a table is written: what stands above the rows, and the fields of a row.
struct WrittenLayout {
  std::string name;
  std::string head;
  std::string separator = ",";
  bool decimal_commas = false;
  std::function<std::vector<std::string>(const WrittenSample&)> row;
};

inline drive::AttitudeAngles heading_angles(const WrittenSample& sample) {
  return drive::angles_from(sample.ins.enu_from_ins, drive::AttitudeConvention::Heading);
}
inline drive::AttitudeAngles yaw_angles(const WrittenSample& sample) {
  return drive::angles_from(sample.ins.enu_from_ins, drive::AttitudeConvention::EnuYaw);
}

inline std::string table_text(const WrittenLayout& layout, const std::vector<WrittenSample>& samples) {
  std::string text = layout.head;
  for (const WrittenSample& sample : samples) {
    std::string line;
    for (const std::string& field : layout.row(sample)) line += (line.empty() ? "" : layout.separator) + field;
    if (layout.decimal_commas) std::replace(line.begin(), line.end(), '.', ',');
    text += line + "\n";
  }
  return text;
}

/// How the times of the scans are told.
enum class ScanNames { Table, Nanoseconds, Microseconds, RowsOfTimes, RowsWithNames };

/// The scans of a drive in "scans", named or with a table as `names` says.
inline void write_scans(const std::filesystem::path& native, const std::filesystem::path& folder, ScanNames names) {
  namespace fs = std::filesystem;
  fs::create_directories(folder / "scans");
  std::ifstream table(native / "scan_stamps.csv");
  std::string line, times, pairs = "cloud;utc (us)\n";
  std::getline(table, line);
  for (int i = 0; std::getline(table, line); ++i) {
    const std::string file = line.substr(0, line.find(','));
    const std::int64_t stamp_ns = std::stoll(line.substr(line.find(',') + 1));
    std::string to = file;
    if (names == ScanNames::Nanoseconds) to = std::to_string(stamp_ns) + ".pcd";
    if (names == ScanNames::Microseconds) to = "cloud_" + std::to_string(stamp_ns / 1000) + ".pcd";
    if (names == ScanNames::RowsOfTimes) to = std::to_string(i) + ".pcd";
    fs::copy_file(native / "scans" / file, folder / "scans" / to);
    times += formats::format_date_ns(stamp_ns) + "\n";
    pairs += fs::path(to).stem().string() + ";" + std::to_string(stamp_ns / 1000) + "\n";
  }
  const auto write = [&](const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; };
  if (names == ScanNames::Table) fs::copy_file(native / "scan_stamps.csv", folder / "scan_stamps.csv");
  if (names == ScanNames::RowsOfTimes) write("timestamps.txt", times);
  if (names == ScanNames::RowsWithNames) write("clouds.csv", pairs);
}

inline std::vector<WrittenSample> written_samples(const drive::Session& session) {
  const std::vector<motion::StampedPose> poses = drive::metric_poses(session);
  std::vector<WrittenSample> samples;
  for (std::size_t i = 0; i < session.ins.size(); ++i) samples.push_back({session.ins[i], poses[i].pose});
  return samples;
}

}  // namespace remount::guesses
