#include "model/io/known_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "model/io/text_file.h"

namespace remount {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kKnownHeadBytes = 4096;

constexpr KnownFile kPcap{"a capture of network packets (pcap)",
                          "Play it through the driver of the sensor, and record the points that it makes as a bag."};
constexpr KnownFile kUbx{"u-blox's binary log (UBX)",
                         "Convert it to NMEA with sentences GGA, GST and RMC, as u-center does, or to GPX."};
constexpr KnownFile kNovatel{"NovAtel's binary log",
                             "Convert it to ASCII with NovAtel Convert: INSPVAXA at 10 Hz or more is read."};
constexpr KnownFile kNovatelAscii{"NovAtel's ASCII log without INSPVAXA or INSPVAA",
                                  "Log one of the two: they have position and attitude of the INS."};
constexpr KnownFile kSbf{"Septentrio's binary log (SBF)",
                         "Convert it to NMEA with sentences GGA, GST, RMC and PSSN,HRP, or its INS solution to a CSV, "
                         "and name the columns in a session.yaml."};
constexpr KnownFile kSbet{
    "a trajectory of Applanix (SBET)",
    "Export it as a CSV with time, latitude, longitude, height, roll, pitch and heading, and name "
    "the columns in a session.yaml."};
constexpr KnownFile kNcom{"the binary log of an OxTS INS (NCOM)",
                          "Export it as a CSV with NAVsolve, and name the columns in a session.yaml."};
constexpr KnownFile kApplanix{"the raw log of an Applanix POS",
                              "Process it, export the trajectory as a CSV, and name the columns in a session.yaml."};
constexpr KnownFile kRinex{"GNSS observations (RINEX)",
                           "Process them to positions first: NMEA or GPX is read, or a CSV that a session.yaml names."};
constexpr KnownFile kRtcm{"GNSS corrections (RTCM 3)", "Positions are needed: log NMEA of the receiver."};
constexpr KnownFile kKittiPoses{"poses of 12 numbers a line without times, as KITTI's odometry has them",
                                "Put the time of each scan before its pose, as in TUM's format: seconds, x y z, "
                                "quaternion x y z w."};
constexpr KnownFile kLaz{"a compressed point cloud (LAZ)",
                         "Unpack it to LAS, as laszip does; scans belong into a folder, each with its time, which a "
                         "session.yaml describes."};
constexpr KnownFile kCloud{
    "a point cloud",
    "One cloud is no drive: scans belong into a folder, each with its time, which a session.yaml "
    "describes."};
constexpr KnownFile kE57{"point clouds of a scanner (E57)",
                         "Export each scan as PCD, PLY or LAS, and give them their times in a session.yaml."};
constexpr KnownFile kLvx{"a recording of Livox Viewer (LVX)",
                         "Convert it to a bag with Livox's ROS driver, which keeps the times of the points."};
constexpr KnownFile kDamagedBag{"a bag by its name that does not begin as one",
                                "It is damaged, or was not copied whole: copy it again from where it was recorded."};
constexpr KnownFile kOldDatabase{"an SQLite database that is no bag by its name",
                                 "Where it is a bag of ROS 2, call it .db3."};
constexpr KnownFile kArchive{"an archive", "Unpack it, and open the folder that comes out."};
constexpr KnownFile kHdf5{"an HDF5 file", "Export scans and poses from it to formats that are read."};
constexpr KnownFile kKml{"a drawing for maps (KML)", "Export the track as GPX, with the times of its points."};

struct Magic {
  std::string_view bytes;
  KnownFile file;
  std::size_t at = 0;
};

/// What a file begins with, in the order in which it is tried.
constexpr Magic kMagics[] = {
    {"\xd4\xc3\xb2\xa1", kPcap},
    {"\xa1\xb2\xc3\xd4", kPcap},
    {"\x4d\x3c\xb2\xa1", kPcap},
    {"\xa1\xb2\x3c\x4d", kPcap},
    {"\x0a\x0d\x0d\x0a", kPcap},
    {"\xb5\x62", kUbx},
    {"\xaa\x44\x12", kNovatel},
    {"\xaa\x44\x13", kNovatel},
    {"$GRP", kApplanix},
    {"ASTM-E57", kE57},
    {"livox_tech", kLvx},
    {"# .PCD", kCloud},
    {"VERSION .7", kCloud},
    {"ply\n", kCloud},
    {"ply\r", kCloud},
    {"PK\x03\x04", kArchive},
    {"\x1f\x8b", kArchive},
    {"\xfd"
     "7zXZ",
     kArchive},
    {"7z\xbc\xaf", kArchive},
    {"BZh", kArchive},
    {"Rar!", kArchive},
    {"ustar", kArchive, 257},
    {"\x28\xb5\x2f\xfd", kArchive},
    {"\x89HDF", kHdf5},
};

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// Records of 17 doubles: time of week, latitude, longitude, height and so on.
bool is_sbet(std::string_view head, std::uint64_t size) {
  constexpr std::size_t kRecord = 136;
  if (size % kRecord != 0 || head.size() < 2 * kRecord) return false;
  const auto plausible = [&](std::size_t at) {
    const auto seconds = number_at<double>(head, at), latitude = number_at<double>(head, at + 8),
               longitude = number_at<double>(head, at + 16), height = number_at<double>(head, at + 24);
    return seconds >= 0.0 && seconds < 1e10 && std::abs(latitude) <= kPi / 2.0 && std::abs(longitude) <= kPi &&
           std::abs(height) < 1e5 && (latitude != 0.0 || longitude != 0.0);
  };
  const double step_s = number_at<double>(head, kRecord) - number_at<double>(head, 0);
  return plausible(0) && plausible(kRecord) && step_s > 0.0 && step_s < 10.0;
}

/// "$@", a checksum, a number, and a length that is a multiple of four.
bool is_sbf(std::string_view head) {
  if (!head.starts_with("$@") || head.size() < 8) return false;
  const auto length = number_at<std::uint16_t>(head, 6);
  return length >= 8 && length % 4 == 0;
}

bool is_ncom(std::string_view head) {
  constexpr std::size_t kPacket = 72;
  return head.size() >= 2 * kPacket && head[0] == '\xe7' && head[kPacket] == '\xe7';
}

/// The first byte of RTCM 3, six bits that are zero, a length, and the next message behind it.
bool is_rtcm(std::string_view head) {
  if (head.size() < 6 || head[0] != '\xd3' || (head[1] & 0xfc) != 0) return false;
  const auto low = static_cast<unsigned char>(head[2]);
  const std::size_t next = 6 + (static_cast<std::size_t>(head[1] & 3) << 8U | low);
  return next < head.size() && head[next] == '\xd3';
}

bool is_kitti_pose(std::string_view line) {
  std::vector<std::string_view> tokens;
  split_blanks(line, tokens);
  return tokens.size() == 12 &&
         std::all_of(tokens.begin(), tokens.end(), [](std::string_view token) { return parse_number(token); });
}

std::optional<KnownFile> known_text(const std::string& text) {
  LineReader lines(text);
  std::string_view line;
  if (!lines.next(line)) return std::nullopt;
  if (line.find("RINEX VERSION") != std::string_view::npos) return kRinex;
  if (text.find("<kml") != std::string::npos) return kKml;
  if (is_kitti_pose(line)) return kKittiPoses;
  for (const char* log : {"#BESTPOSA,", "#BESTGNSSPOSA,", "#RAWIMUSXA,", "%RAWIMUSA,", "#INSATTA,", "#TIMEA,"})
    if (text.find(log) != std::string::npos) return kNovatelAscii;
  return std::nullopt;
}

/// LAS writes into the format of its points that they are compressed.
KnownFile las_or_laz(std::string_view head, std::string_view name) {
  constexpr std::size_t kPointFormat = 104;
  const bool packed = head.size() > kPointFormat && (static_cast<unsigned char>(head[kPointFormat]) & 0xc0) != 0;
  return packed || name.ends_with(".laz") ? kLaz : kCloud;
}

}  // namespace

std::optional<KnownFile> known_file(const fs::path& path) {
  try {
    const std::string head = read_file_head(path, kKnownHeadBytes), name = lower_case(path.filename().string());
    if (head.empty()) return std::nullopt;
    for (const Magic& magic : kMagics)
      if (head.size() >= magic.at && std::string_view(head).substr(magic.at).starts_with(magic.bytes))
        return magic.file;
    if (head.starts_with("LASF")) return las_or_laz(head, name);
    if (head.starts_with("SQLite format 3")) return kOldDatabase;
    if (is_sbf(head)) return kSbf;
    if (is_ncom(head)) return kNcom;
    if (is_rtcm(head)) return kRtcm;
    for (const char* ending : {".bag", ".mcap", ".db3"})
      if (name.ends_with(ending)) return kDamagedBag;
    if (is_sbet(head, fs::file_size(path))) return kSbet;
    return known_text(utf8_text(head));
  } catch (const Error&) {
  } catch (const fs::filesystem_error&) {
    // cannot be looked at: not known
  }
  return std::nullopt;
}

}  // namespace remount
