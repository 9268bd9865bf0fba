// What an INS stream tells about itself and about the drive: status, standstill of the log, jumps, too little motion.
#pragma once

#include <vector>

#include "model/session.h"

namespace remount {

/// Findings "ins-gaps", "ins-frozen", "ins-jump", "ins-status", "little-turning" and "flat-driving", each with what to
/// do. Motion is judged while the LiDAR is recorded.
std::vector<Finding> ins_findings(const Session& session);

}  // namespace remount
