// NovAtel INSPVAX and INSPVA: the ASCII log, and the CSV of INSPVAX exported from a bag.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

enum class InspvaxFormat { AsciiLog, BagCsv };

/// From the first megabyte; nothing where it is neither. Never throws.
std::optional<InspvaxFormat> recognise_inspvax(const std::filesystem::path& path);

struct InspvaxLog {
  std::vector<motion::InsSample> ins;
  /// Bag CSV only: of 1, how many lines have a host time of their own. A spreadsheet rounds them all to one.
  double distinct_host_times = 0.0;
};

/// INS samples with UTC stamps from GPS week and time of week. Attitude: AttitudeConvention::NovAtel, so the INS frame
/// is SPAN's body frame, x right, y forward, z up. Height is above the ellipsoid (INSPVA's own; MSL height plus
/// undulation of INSPVAX). In an ASCII log a log stands anywhere within its line: behind the prompt of a port or the
/// time of a terminal. INSPVA (and INSPVAS) serves where the file has it more than three times as often as INSPVAX,
/// whose errors it then has (give_errors). The host's time column is not used; what it differs from GPS time is a
/// finding ("host-clock"). Lines with a wrong CRC or broken fields are left out and counted in findings. Throws Error
/// where the file cannot be read or no line is usable.
InspvaxLog read_inspvax(const std::filesystem::path& path, InspvaxFormat format, std::vector<drive::Finding>& findings);

/// What one INSPVAX says, in its own units and conventions.
struct InspvaxValues {
  motion::InsQuality quality = motion::InsQuality::Unknown;
  double latitude_deg = 0.0, longitude_deg = 0.0;
  double height_m = 0.0;      ///< above mean sea level
  double undulation_m = 0.0;  ///< of the geoid above the ellipsoid
  double roll_deg = 0.0, pitch_deg = 0.0, azimuth_deg = 0.0;
  double latitude_std_m = 0.0, longitude_std_m = 0.0, height_std_m = 0.0;
  double roll_std_deg = 0.0, pitch_std_deg = 0.0, azimuth_std_deg = 0.0;
  /// Of a log that states none: NaN.
  static InspvaxValues without_errors();
};
/// Without its stamp. Throws Error(Format) at `where` for a position or an angle that is not possible.
motion::InsSample ins_sample(const InspvaxValues& values, const std::string& where);
/// Of the inertial solution status, by number or by name; of names that belong to the solution status of a position,
/// by their number: ROS' novatel_gps_driver took the wrong table until September 2026.
motion::InsQuality inspvax_quality(std::string_view status);
bool is_of_wrong_table(std::string_view status);
/// Adds "ins-status-misnamed" where there are such.
void report_misnamed(std::size_t count, const std::string& where, std::vector<drive::Finding>& findings);

/// Errors of samples that state none (INSPVA), from the nearest of others that do (INSPVAX), not more than two seconds
/// away; their quality stays their own. Both ascending.
void give_errors(std::vector<motion::InsSample>& ins, const std::vector<motion::InsSample>& with_errors);

/// NovAtel's CRC-32 of a log's text between '#' and '*'.
std::uint32_t novatel_crc32(std::string_view text);

}  // namespace remount::formats
