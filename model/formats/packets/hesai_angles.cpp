#include "model/formats/packets/hesai_angles.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/text_file.h"
#include "model/formats/packets/files_beside.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostAngleBytes = std::uint64_t{128} << 10U;
constexpr double kMostElevation_deg = 90.0, kMostAzimuth_deg = 360.0;

bool is_heading(const std::vector<std::string_view>& fields) {
  return fields.size() == 3 && lower_case(fields[1]).starts_with("elevation") &&
         lower_case(fields[2]).starts_with("azimuth");
}

double checked_angle(double angle_deg, double most_deg, const std::string& where) {
  if (!(std::abs(angle_deg) <= most_deg))
    throw Error(ErrorCode::Format, where, say::capture_number_within(-most_deg, most_deg, angle_deg));
  return angle_deg;
}

template <class Angles>
std::optional<Angles> choose_angles(FilesBeside<Angles> files, const BesidePackets& beside, const std::string& where) {
  return choose_beside(std::move(files), beside, [&](const fs::path& one, const fs::path& other, std::string name) {
    return Error(ErrorCode::Unsupported, where,
                 say::capture_hesai_several(name_beside(one), name_beside(other), std::move(name)));
  });
}

/// Parses what may be of this sensor: a file with another one's address is not, whatever is in it.
template <class Parse>
auto read_those_of(const BesidePackets& beside, std::string_view ending, const Parse& parse) {
  return read_files_beside(beside, ending, kMostAngleBytes, [&](const std::string& bytes, const fs::path& file) {
    return names_other_address(file, beside) ? decltype(parse(bytes, file))() : parse(bytes, file);
  });
}

}  // namespace

std::optional<HesaiAngles> parse_hesai_angles(const std::string& bytes, const fs::path& file) {
  constexpr std::size_t kHeadingWithin = 3;
  const std::string text = utf8_text(bytes);
  LineReader lines(text);
  std::string_view line;
  std::vector<std::string_view> fields;
  bool found = false;
  while (!found && lines.line_number() < kHeadingWithin && lines.next(line)) {
    split_csv(line, fields);
    found = is_heading(fields);
  }
  if (!found) return std::nullopt;
  HesaiAngles angles{file, {}, {}};
  while (lines.next(line)) {
    split_csv(line, fields);
    if (fields.size() != 3) continue;  // a checksum, an empty line
    const std::size_t number = lines.line_number(), expected = angles.elevations_deg.size() + 1;
    if (require_number(fields[0], "Laser id", file, number) != static_cast<double>(expected))
      throw Error(ErrorCode::Format, at_line(file, number), say::capture_hesai_order(expected, std::string(fields[0])));
    const std::string where = at_line(file, number);
    angles.elevations_deg.push_back(
        checked_angle(require_number(fields[1], "Elevation", file, number), kMostElevation_deg, where));
    angles.azimuths_deg.push_back(
        checked_angle(require_number(fields[2], "Azimuth", file, number), kMostAzimuth_deg, where));
  }
  return angles;
}

std::optional<HesaiAngles> find_hesai_angles(const BesidePackets& beside, std::size_t channels,
                                             const std::string& where) {
  auto files = read_those_of(beside, ".csv", parse_hesai_angles);
  std::erase_if(files.found, [&](const HesaiAngles& angles) { return angles.elevations_deg.size() != channels; });
  return choose_angles(std::move(files), beside, where);
}

namespace {

constexpr double kEncoderUnits = 25600.0;  // of a degree
constexpr std::size_t kAdjusts = 180;      // of a channel: every second degree

/// Between the two places at which it was measured.
double adjust_deg(const std::vector<std::int8_t>& adjusts, std::size_t channel, double encoder_deg, double unit) {
  const double place = std::fmod(encoder_deg, 360.0) * kAdjusts / 360.0;
  const auto before = std::min(static_cast<std::size_t>(place), kAdjusts - 1), behind = (before + 1) % kAdjusts;
  const double share = place - static_cast<double>(before);
  return 0.01 * unit *
         ((1.0 - share) * adjusts[channel * kAdjusts + before] + share * adjusts[channel * kAdjusts + behind]);
}

std::vector<double> encoder_angles(std::string_view bytes, std::size_t at, std::size_t count, double unit,
                                   double most_deg, const std::string& where) {
  std::vector<double> angles_deg;
  for (std::size_t i = 0; i < count; ++i)
    angles_deg.push_back(checked_angle(
        unit * little_number<std::int32_t>(bytes, at + i * sizeof(std::int32_t)) / kEncoderUnits, most_deg, where));
  return angles_deg;
}

std::vector<std::int8_t> signed_bytes(std::string_view bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace

std::optional<std::size_t> HesaiMirrors::mirror_at(double encoder_deg) const {
  const auto forward = [](double from_deg, double to_deg) { return std::fmod(to_deg - from_deg + 720.0, 360.0); };
  for (std::size_t mirror = 0; mirror < begins_deg.size(); ++mirror)
    if (forward(begins_deg[mirror], encoder_deg) < forward(begins_deg[mirror], ends_deg[mirror])) return mirror;
  return std::nullopt;
}

std::array<double, 2> HesaiMirrors::angles_deg(std::size_t mirror, std::size_t channel, double encoder_deg) const {
  const double turned_deg = std::fmod(encoder_deg - begins_deg[mirror] + 360.0, 360.0);
  // A mirror turns light by twice its own angle.
  return {2.0 * turned_deg - azimuths_deg[channel] + adjust_deg(azimuth_adjusts, channel, encoder_deg, adjust_unit),
          elevations_deg[channel] + adjust_deg(elevation_adjusts, channel, encoder_deg, adjust_unit)};
}

std::optional<HesaiMirrors> parse_hesai_mirrors(const std::string& bytes, const fs::path& file) {
  constexpr std::size_t kMirrorHeadBytes = 16, kNumberBytes = 4, kChecksumBytes = 32, kMostMirrors = 16;
  if (bytes.size() < kMirrorHeadBytes || !bytes.starts_with("\xee\xff")) return std::nullopt;
  const auto byte = [&](std::size_t at) { return byte_at(bytes, at); };
  if (byte(2) != 1 || byte(3) != 5)
    throw Error(ErrorCode::Unsupported, file.string(), say::capture_hesai_mirrors_version(byte(2), byte(3)));
  const std::size_t channels = byte(4), mirrors = byte(5);
  const std::size_t expected = kMirrorHeadBytes + kNumberBytes * 2 * (mirrors + channels) + 2 * channels * kAdjusts;
  if (mirrors == 0 || mirrors > kMostMirrors || (bytes.size() != expected && bytes.size() != expected + kChecksumBytes))
    throw Error(ErrorCode::Format, file.string(),
                say::capture_hesai_mirrors_size(bytes.size(), expected + kChecksumBytes, channels, mirrors));
  HesaiMirrors angles;
  angles.file = file;
  const double unit = angles.adjust_unit = byte(15);
  std::size_t at = kMirrorHeadBytes;
  const auto next = [&](std::size_t count, double most_deg) {
    const std::size_t from = std::exchange(at, at + count * kNumberBytes);
    return encoder_angles(bytes, from, count, unit, most_deg, file.string());
  };
  angles.begins_deg = next(mirrors, kMostAzimuth_deg), angles.ends_deg = next(mirrors, kMostAzimuth_deg);
  angles.azimuths_deg = next(channels, kMostAzimuth_deg), angles.elevations_deg = next(channels, kMostElevation_deg);
  angles.azimuth_adjusts = signed_bytes(std::string_view(bytes).substr(at, channels * kAdjusts));
  angles.elevation_adjusts =
      signed_bytes(std::string_view(bytes).substr(at + channels * kAdjusts, channels * kAdjusts));
  return angles;
}

std::optional<HesaiMirrors> find_hesai_mirrors(const BesidePackets& beside, const std::string& where) {
  constexpr std::size_t kMirroredChannels = 128;
  auto files = read_those_of(beside, ".dat", parse_hesai_mirrors);
  std::erase_if(files.found,
                [&](const HesaiMirrors& angles) { return angles.elevations_deg.size() != kMirroredChannels; });
  return choose_angles(std::move(files), beside, where);
}

}  // namespace remount::formats
