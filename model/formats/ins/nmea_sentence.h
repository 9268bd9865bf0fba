// One sentence of NMEA 0183.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace remount::formats {

struct NmeaSentence {
  /// "GGA" of any talker; of makers' own the whole name, with what it is divided by: "PASHR", "PTNL,AVR", "KSXT".
  std::string_view type;
  std::string_view talker;               ///< "GP"; empty in those of makers
  std::vector<std::string_view> fields;  ///< after the type
  bool has_checksum = false;
  std::string_view field(std::size_t i) const { return i < fields.size() ? fields[i] : std::string_view{}; }
};

enum class NmeaLine { Sentence, NoSentence, WrongChecksum };

/// Takes the sentence out of a line, which may have something before its '$'. The views lead into `line`. With a wrong
/// checksum the type and the fields are as they can be read.
NmeaLine parse_nmea(std::string_view line, NmeaSentence& sentence);

/// Of what stands between '$' and '*', 0 to 255.
unsigned nmea_checksum(std::string_view body);

/// "hhmmss.sss" as ns since midnight; nothing where it is none.
std::optional<std::int64_t> nmea_time_ns(std::string_view text);

/// An angle in degrees, in radians; nothing where it is none or beyond two turns.
std::optional<double> nmea_degrees_rad(std::string_view text);

/// "ddmm.mmmm" (or "dddmm.mmmm") with N, S, E or W, in radians; nothing where it is none.
std::optional<double> nmea_angle_rad(std::string_view text, std::string_view side);

}  // namespace remount::formats
