#include "model/formats/sessions/known_files.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/core/error.h"
#include "messages/sessions.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/text_file.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kKnownHeadBytes = 4096;

constexpr KnownFile kPcap{say::known_pcap, say::known_pcap_remedy};
constexpr KnownFile kUbx{say::known_ubx, say::known_ubx_remedy};
constexpr KnownFile kNovatel{say::known_novatel, [] { return say::known_novatel_remedy(Frequency{10.0}); }};
constexpr KnownFile kNovatelAscii{say::known_novatel_ascii, say::known_novatel_ascii_remedy};
constexpr KnownFile kSbf{say::known_sbf, say::known_sbf_remedy};
constexpr KnownFile kApplanix{say::known_applanix, say::known_applanix_remedy};
constexpr KnownFile kRinex{say::known_rinex, say::known_rinex_remedy};
constexpr KnownFile kRtcm{say::known_rtcm, say::known_rtcm_remedy};
constexpr KnownFile kKittiPoses{say::known_kitti_poses, say::known_kitti_poses_remedy};
constexpr KnownFile kCloud{say::known_cloud, say::known_cloud_remedy};
constexpr KnownFile kE57{say::known_e57, say::known_e57_remedy};
constexpr KnownFile kDamagedBag{say::known_damaged_bag, say::known_damaged_bag_remedy};
constexpr KnownFile kOldDatabase{say::known_other_database, say::known_other_database_remedy};
constexpr KnownFile kArchive{say::known_archive, say::known_archive_remedy};
constexpr KnownFile kHdf5{say::known_hdf5, say::known_hdf5_remedy};
constexpr KnownFile kKml{say::known_kml, say::known_kml_remedy};

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
    {"# .PCD", kCloud},
    {"VERSION .7", kCloud},
    {"LASF", kCloud},
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

/// "$@", a checksum, a number, and a length that is a multiple of four.
bool is_sbf(std::string_view head) {
  if (!head.starts_with("$@") || head.size() < 8) return false;
  const auto length = little_number<std::uint16_t>(head, 6);
  return length >= 8 && length % 4 == 0;
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

}  // namespace

std::optional<KnownFile> known_file(const fs::path& path) {
  try {
    const std::string head = read_file_head(path, kKnownHeadBytes), name = lower_case(path.filename().string());
    if (head.empty()) return std::nullopt;
    for (const Magic& magic : kMagics)
      if (head.size() >= magic.at && std::string_view(head).substr(magic.at).starts_with(magic.bytes))
        return magic.file;
    if (head.starts_with("SQLite format 3")) return kOldDatabase;
    if (is_sbf(head)) return kSbf;
    if (is_rtcm(head)) return kRtcm;
    // Parts of a record have a number behind.
    const std::string unnumbered = name.substr(0, name.find_last_not_of(".0123456789") + 1);
    for (const char* ending : {".bag", ".mcap", ".db3", ".record"})
      if (name.ends_with(ending) || unnumbered.ends_with(ending)) return kDamagedBag;
    return known_text(utf8_text(head));
  } catch (const Error&) {
  } catch (const fs::filesystem_error&) {
    // cannot be looked at: not known
  }
  return std::nullopt;
}

}  // namespace remount::formats
