// A session that is written while it is read: what is handed out, and what that costs.
#include "model/formats/growing_session.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <iostream>
#include <sstream>

#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/ins/nmea_text.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

namespace fs = std::filesystem;

/// Scans whose names are their stamps, an INS and fixes.
void write_whole(const fs::path& folder, double duration_s, bool stamps_in_names = true) {
  simulator::SimulationOptions options;
  options.duration_s = duration_s;
  options.beams = 2;
  options.azimuth_steps = 16;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  Progress progress;
  write_native_session(drive.session, folder, 1, progress);
  if (!stamps_in_names) return;
  for (std::size_t i = 0; i < drive.session.scans->size(); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "%010zu.pcd", i);
    fs::rename(folder / "scans" / name, folder / "scans" / (std::to_string(drive.session.scans->stamp_ns(i)) + ".pcd"));
  }
  std::string manifest = bytes_of(folder / "session.yaml");
  const std::string by_table = "scan_stamps.csv";
  manifest.replace(manifest.find(by_table), by_table.size(), "from-names");
  std::ofstream(folder / "session.yaml", std::ios::binary) << manifest;
}

/// Grows a copy of a session to so many parts of a whole; lines are cut anywhere.
class Growing {
 public:
  Growing(fs::path whole, fs::path copy, std::size_t parts)
      : whole_(std::move(whole)), copy_(std::move(copy)), parts_(parts) {
    fs::create_directories(copy_ / "scans");
    for (const fs::path& file : files_in(whole_ / "scans")) scans_.push_back(file.filename());
    for (const char* table : {"imu.csv", "wheels.csv", "barometer.csv", "session.yaml"})
      if (fs::exists(whole_ / table)) fs::copy_file(whole_ / table, copy_ / table);
  }
  void grow_to(std::size_t part) {
    for (const char* table : {"ins.csv", "gnss.csv"}) {
      const std::string bytes = bytes_of(whole_ / table);
      std::ofstream(copy_ / table, std::ios::binary) << bytes.substr(0, bytes.size() * part / parts_);
    }
    for (std::size_t i = 0; i < scans_.size() * part / parts_; ++i)
      fs::copy_file(whole_ / "scans" / scans_[i], copy_ / "scans" / scans_[i], fs::copy_options::skip_existing);
  }
  std::uint64_t table_bytes() const { return fs::file_size(whole_ / "ins.csv") + fs::file_size(whole_ / "gnss.csv"); }
  std::uint64_t manifest_bytes() const { return fs::file_size(whole_ / "session.yaml"); }

 private:
  fs::path whole_, copy_;
  std::size_t parts_;
  std::vector<fs::path> scans_;
};

template <class Item>
void expect_beginning(const std::vector<Item>& part, const std::vector<Item>& whole) {
  ASSERT_LE(part.size(), whole.size());
  for (std::size_t i = 0; i < part.size(); ++i) EXPECT_EQ(part[i].stamp_ns, whole[i].stamp_ns) << i;
}

/// As Windows' editors and exporters write texts.
std::string utf16(const std::string& text) {
  std::string wide = "\xFF\xFE";
  for (const char c : text) wide += c, wide += '\0';
  return wide;
}

TEST(growing_session, in_another_encoding_is_read_as_a_whole) {
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "copy";
  write_whole(copy, 3.0, false);
  Progress progress;
  const drive::Session whole = open_session(copy, progress, checks::LookAt::Streams);
  for (const char* table : {"ins.csv", "gnss.csv", "scan_stamps.csv"}) {
    const std::string plain = bytes_of(copy / table);
    for (const std::string& text : {utf16(plain), "\xEF\xBB\xBF" + plain}) {
      SCOPED_TRACE(table);
      std::ofstream(copy / table, std::ios::binary) << text;
      GrowingSession growing(copy, {});
      const drive::Session* now = growing.look();
      ASSERT_NE(now, nullptr) << growing.problem();
      EXPECT_EQ(now->ins.size(), whole.ins.size());
      EXPECT_EQ(now->gnss.size(), whole.gnss.size());
      ASSERT_NE(now->scans, nullptr);
      EXPECT_EQ(now->scans->size(), whole.scans->size());
    }
    std::ofstream(copy / table, std::ios::binary) << plain;
  }
}

/// The same drive with an INS that counts the seconds of a GPS week.
void count_weeks(const fs::path& session) {
  std::istringstream lines(bytes_of(session / "ins.csv"));
  std::string text = "tow", line;
  std::getline(lines, line);
  text += line.substr(line.find(',')) + "\n";
  while (std::getline(lines, line)) {
    const std::size_t comma = line.find(',');
    text += std::to_string(gps_ns_from_unix_ns(std::stoll(line.substr(0, comma))) % kGpsWeek_ns) + line.substr(comma) +
            "\n";
  }
  std::ofstream(session / "ins.csv", std::ios::binary) << text;
  std::ofstream(session / "session.yaml", std::ios::binary)
      << "format: remount-session/1\nname: w\n"
         "scans: {directory: scans, type: pcd, stamps: from-names, timing: per-point}\n"
         "ins:\n  file: ins.csv\n  columns:\n    time: {name: tow, unit: ns, scale: gps-week}\n"
         "    latitude: {name: latitude_deg, unit: deg}\n    longitude: {name: longitude_deg, unit: deg}\n"
         "    height: {name: height_m, unit: m}\n"
         "    attitude: {convention: enu-yaw, unit: deg, yaw: yaw_deg, pitch: pitch_deg, roll: roll_deg}\n";
}

TEST(growing_session, seconds_of_a_week_meet_the_scans) {
  constexpr std::size_t kLooks = 3;
  const TemporaryFolder folder;
  write_whole(folder.path() / "whole", 3.0);
  count_weeks(folder.path() / "whole");
  Growing files(folder.path() / "whole", folder.path() / "copy", kLooks);
  GrowingSession growing(folder.path() / "copy", {});
  for (std::size_t part = 1; part <= kLooks; ++part) {
    files.grow_to(part);
    const drive::Session* now = growing.look();
    ASSERT_NE(now, nullptr) << growing.problem();
    ASSERT_NE(now->scans, nullptr);
    ASSERT_FALSE(now->ins.empty());
    const double apart_s = 1e-9 * static_cast<double>(now->scans->stamp_ns(0) - now->ins.front().stamp_ns);
    std::cout << "the first scan is " << apart_s << " s behind the first sample\n";
    EXPECT_LT(std::abs(apart_s), 5.0) << part;
  }
}

TEST(growing_session, each_look_costs_what_is_new) {
  constexpr std::size_t kLooks = 50;
  const TemporaryFolder folder;
  write_whole(folder.path() / "whole", 10.0);
  Growing files(folder.path() / "whole", folder.path() / "copy", kLooks);
  GrowingSession growing(folder.path() / "copy", {});
  Progress progress;
  const drive::Session whole = open_session(folder.path() / "whole", progress, checks::LookAt::Streams);
  const drive::Session* now = nullptr;
  for (std::size_t part = 1; part <= kLooks; ++part) {
    files.grow_to(part);
    now = growing.look();
    if (!now) continue;  // no complete line yet
    expect_beginning(now->ins, whole.ins);
    expect_beginning(now->gnss, whole.gnss);
    EXPECT_EQ(now->scans ? now->scans->size() : 0u, whole.scans->size() * part / kLooks) << part;
  }
  ASSERT_TRUE(now) << growing.problem();
  EXPECT_EQ(now->ins.size(), whole.ins.size());
  EXPECT_EQ(now->gnss.size(), whole.gnss.size());
  for (std::size_t i = 0; i < whole.ins.size(); i += 97)
    EXPECT_EQ(now->ins[i].latitude_rad, whole.ins[i].latitude_rad) << i;
  EXPECT_EQ(now->scan_timing, whole.scan_timing);
  EXPECT_EQ(now->nominal_ins_from_lidar.has_value(), whole.nominal_ins_from_lidar.has_value());
  std::printf("  %llu bytes read in %zu looks; the tables hold %llu, the manifest %llu\n",
              static_cast<unsigned long long>(growing.bytes_read()), kLooks,
              static_cast<unsigned long long>(files.table_bytes()),
              static_cast<unsigned long long>(files.manifest_bytes()));
  // Once, and lines again that were not complete.
  EXPECT_LT(growing.bytes_read(), files.table_bytes() + kLooks * (files.manifest_bytes() + 1000));
  EXPECT_GE(growing.bytes_read(), files.table_bytes());
  EXPECT_EQ(growing.files_examined(), whole.scans->size());
  const std::uint64_t before = growing.bytes_read();
  ASSERT_TRUE(growing.look());
  EXPECT_EQ(growing.bytes_read(), before + files.manifest_bytes());  // nothing has come
  EXPECT_EQ(growing.files_examined(), whole.scans->size());
}

TEST(growing_session, what_is_written_anew_is_read_anew) {
  const TemporaryFolder folder;
  write_whole(folder.path() / "whole", 2.0);
  Growing files(folder.path() / "whole", folder.path() / "copy", 4);
  GrowingSession growing(folder.path() / "copy", {});
  files.grow_to(4);
  const drive::Session* now = growing.look();
  ASSERT_TRUE(now) << growing.problem();
  const std::size_t all = now->ins.size();
  files.grow_to(2);
  EXPECT_FALSE(growing.look());
  EXPECT_NE(english(growing.problem()).find("shorter"), std::string::npos) << growing.problem();
  now = growing.look();
  ASSERT_TRUE(now) << growing.problem();
  EXPECT_LT(now->ins.size(), all);
  EXPECT_GT(now->ins.size(), all / 4);
}

TEST(growing_session, another_format_is_opened_as_a_whole) {
  const TemporaryFolder folder;
  const fs::path log = folder.path() / "drive.nmea";
  std::string text = nmea_line("GPZDA,123510.00,15,03,2021,00,00");
  for (int second = 0; second < 9; ++second)
    text += nmea_line("GPGGA,12351" + std::to_string(second) + ".00,4807.038,N,01131.000,E,4,08,0.9,545.4,M,46.9,M,,");
  GrowingSession growing(folder.path(), {});
  EXPECT_FALSE(growing.look());
  EXPECT_FALSE(growing.problem().empty());
  std::ofstream(log, std::ios::binary) << text;
  const drive::Session* now = growing.look();
  ASSERT_TRUE(now) << growing.problem();
  EXPECT_EQ(now->gnss.size(), 9u);
}

}  // namespace
}  // namespace remount::formats
