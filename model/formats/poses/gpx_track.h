// GPX 1.0 and 1.1: track points with time, as fixes of a GNSS receiver.
#pragma once

#include <filesystem>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

/// From the first bytes. Never throws.
bool recognise_gpx(const std::filesystem::path& path);

/// Points of all tracks in the order of the file. Their errors are not stated: 3 m and 5 m in height are assumed, as a
/// finding says. Points without a time or a place become a finding. Reads tags alone: entities and DTDs mean nothing.
/// Throws Error(Io), Error(Format) where there is no usable point.
std::vector<motion::GnssFix> read_gpx(const std::filesystem::path& path, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
