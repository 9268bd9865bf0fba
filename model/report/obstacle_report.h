// The obstacle check on a scan of a session: what the distances become under the new mounting.
#pragma once

#include <cstddef>
#include <memory>

#include "algorithms/quality/obstacle_check.h"
#include "model/drive/session.h"
#include "model/settings/settings.h"

namespace remount::report {

/// Obstacles of one scan under the nominal and the calibrated mounting. The scan is compensated for motion where the
/// session says how and has INS motion at its time; objects are found once and are the same under both. INS axes that
/// are not x forward, y left are turned so, for the outline of the vehicle is given in these. Throws Error where the
/// session has no scans, there is no such scan, it cannot be read, or options are out of range.
quality::ObstacleComparison compare_obstacles_of_scan(const std::shared_ptr<const drive::Session>& session,
                                                      std::size_t scan, const RigidTransform& nominal_ins_from_lidar,
                                                      const RigidTransform& calibrated_ins_from_lidar,
                                                      const settings::Settings& settings,
                                                      const quality::ObstacleOptions& options);

}  // namespace remount::report
