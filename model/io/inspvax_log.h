// NovAtel INSPVAX: the ASCII log, and the CSV exported from a bag.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/session.h"

namespace remount {

enum class InspvaxFormat { AsciiLog, BagCsv };

/// From the first megabyte; nothing where it is neither. Never throws.
std::optional<InspvaxFormat> recognise_inspvax(const std::filesystem::path& path);

struct InspvaxLog {
  std::vector<InsSample> ins;
  /// Bag CSV only: of 1, how many lines have a host time of their own. A spreadsheet rounds them all to one.
  double distinct_host_times = 0.0;
};

/// INS samples with UTC stamps from GPS week and time of week. Attitude: AttitudeConvention::NovAtel, so the INS frame
/// is SPAN's body frame, x right, y forward, z up. Height is above the ellipsoid (MSL height plus undulation). The
/// host's time column is not used; what it differs from GPS time is a finding ("host-clock"). Lines with a wrong CRC or
/// broken fields are left out and counted in findings. Throws Error where the file cannot be read or no line is usable.
InspvaxLog read_inspvax(const std::filesystem::path& path, InspvaxFormat format, std::vector<Finding>& findings);

/// What one INSPVAX says, in its own units and conventions.
struct InspvaxValues {
  InsQuality quality = InsQuality::Unknown;
  double latitude_deg = 0.0, longitude_deg = 0.0;
  double height_m = 0.0;      ///< above mean sea level
  double undulation_m = 0.0;  ///< of the geoid above the ellipsoid
  double roll_deg = 0.0, pitch_deg = 0.0, azimuth_deg = 0.0;
  double latitude_std_m = 0.0, longitude_std_m = 0.0, height_std_m = 0.0;
  double roll_std_deg = 0.0, pitch_std_deg = 0.0, azimuth_std_deg = 0.0;
};
/// Without its stamp. Throws Error(Format) at `where` for a position or an angle that is not possible.
InsSample ins_sample(const InspvaxValues& values, const std::string& where);
/// Of the inertial solution status, by number or by name.
InsQuality inspvax_quality(std::string_view status);

/// NovAtel's CRC-32 of a log's text between '#' and '*'.
std::uint32_t novatel_crc32(std::string_view text);

}  // namespace remount
