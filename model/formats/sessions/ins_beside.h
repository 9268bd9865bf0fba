// The log of an INS or of a GNSS receiver that lies beside a recording of the LiDAR.
#pragma once

#include <filesystem>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

/// Reads the motion of a session from the one log among these files, of whatever kind: NovAtel's INSPVAX, another whole
/// solution of an INS (ins_log.h), NMEA, RTKLIB, GPX, or poses, tried in this order; one that says it was
/// post-processed comes before NovAtel's. Logs that are passed over are named ("ins-log-chosen").
/// @return false where there is none. Throws Error(Unsupported) at `where` that names two where there are several of a
/// kind, and Error as the log's reader does.
bool read_ins_beside(const std::vector<std::filesystem::path>& files, const std::filesystem::path& where,
                     drive::Session& session);

}  // namespace remount::formats
