// What session.yaml declares beside the streams that are files of their own.
#pragma once

#include "algorithms/core/progress.h"
#include "model/drive/session.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

/// Takes `ins_noise`. Throws Error(Format) with the line of what is wrong, as the others do.
void read_declared_noise(const DocumentView& root, drive::Session& session);

/// Takes `lidar` and `nominal`, of the manifest or of one of its LiDARs.
void read_declared_lidar(const DocumentView& node, drive::Session& session);

/// Takes `scans` that name a capture: its LiDAR's, or those of the `sensor` that they name.
void read_captured_scans(const DocumentView& node, const std::filesystem::path& folder, drive::Session& session,
                         Progress& progress);

/// Takes `ins` that is a log by its content, with what a log says of itself. False where it is none: a table, then.
/// @param node names the file
bool read_ins_log(const DocumentView& node, const std::filesystem::path& file, drive::Session& session);

/// Throws where times of points are declared and the points of the first scans tell none: they would be used as if they
/// had been measured at once. @param session as far as it is read
/// @return with `misfit` where the times are of no sweep, which is no reason to refuse the session
FoundPointTimes require_point_times(const DocumentView& timing, const TimedScanSource& scans,
                                    const drive::Session& session);

}  // namespace remount::formats
