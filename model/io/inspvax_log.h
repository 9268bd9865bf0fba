// NovAtel INSPVAX: the ASCII log, and the CSV exported from a bag.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
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

/// NovAtel's CRC-32 of a log's text between '#' and '*'.
std::uint32_t novatel_crc32(std::string_view text);

}  // namespace remount
