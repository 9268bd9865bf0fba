// When the points of a scan were measured, as far as the session and the settings say.
#pragma once

#include <string>
#include <vector>

#include "model/session.h"
#include "model/settings.h"

namespace remount {

/// Times from the stamp, s, one for each point; empty where neither the points nor a sweep tell them.
/// @param by_sweep whether a sweep may tell them: files of some formats do not say whether their scans are compensated
std::vector<float> told_times(const Session& session, const PointCloud& cloud, bool by_sweep);

/// The same as the settings have it; empty where the scan is to be used as it is.
std::vector<float> scan_times(const Session& session, const PointCloud& cloud, DeskewMode mode);

/// Of the scan with a stamp, which is one of the source's; stamps ascend.
std::string scan_name_at(const ScanSource& scans, std::int64_t stamp_ns);

}  // namespace remount
