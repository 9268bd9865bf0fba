// Positions that RTKLIB computed (.pos).
#pragma once

#include <filesystem>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

/// By the line of column names behind '%'. Never throws.
bool recognise_rtklib(const std::filesystem::path& path);

/// Fixes with strictly ascending stamps. Positions as latitude, longitude and height, in decimals or in degrees,
/// minutes and seconds, as earth-centred coordinates, or as a baseline from the base whose place the head tells. Times
/// of GPS or UTC, by date or by week and seconds. Errors with their correlations; where none are stated, what the
/// quality of a solution usually means. Lines that cannot be used, and those without a solution, are counted. Throws
/// Error(Io), Error(Format) where there is no usable fix.
std::vector<motion::GnssFix> read_rtklib(const std::filesystem::path& path, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
