// Which scans of which LiDARs are compared, and how they are registered.
#pragma once

#include <memory>
#include <vector>

#include "algorithms/calibration/rig/rig.h"
#include "model/pipeline/pair_clouds.h"
#include "model/pipeline/scan_store.h"
#include "model/rig/lidar_field.h"
#include "model/rig/rig_calibration.h"

namespace remount::rig {

/// A LiDAR that was calibrated alone, with what is needed to compare its scans with those of others. Stays where it is:
/// its scans refer to its motion.
class CalibratedLidar {
 public:
  /// @param cache_bytes for prepared scans
  CalibratedLidar(const LidarJob& job, const pipeline::PipelineOutput& output, std::size_t cache_bytes,
                  const Progress& progress);
  CalibratedLidar(const CalibratedLidar&) = delete;
  CalibratedLidar& operator=(const CalibratedLidar&) = delete;

  const LidarJob& job;
  const pipeline::PipelineOutput& output;
  pipeline::DriveMotion motion;  ///< with lags of positions as all LiDARs have them
  const LidarField field;
  pipeline::ScanStore scans;

  std::int64_t ins_stamp_ns(const motion::Keyframe& keyframe) const;  ///< on the clock of the INS
  motion::SessionIndex recording(const motion::Keyframe& keyframe) const { return job.recordings[keyframe.session]; }
  const RigidTransform& ins_from_lidar() const { return output.result.mounting.ins_from_lidar(); }
};
using CalibratedLidars = std::vector<std::unique_ptr<CalibratedLidar>>;

/// For every two LiDARs, scans of a recording that have much of what they show in common, as the mountings have it, and
/// were taken soon after each other: spread over the time of the drive, and so that few scans serve them all.
/// docs/maths/rig.md (G9)
std::vector<calibration::CrossPair> propose_cross_pairs(const CalibratedLidars& lidars);

/// Registers each from where the mountings have it; rejects failures with the reason.
void register_cross_pairs(const CalibratedLidars& lidars, std::vector<calibration::CrossPair>& cross_pairs, int threads,
                          Progress& progress);

/// Motion and information of each pair from the clouds at the motion that the common solution predicts, in place of its
/// own minimum, and what errors of the beams do to it.
void relinearise_cross_pairs(const CalibratedLidars& lidars, const std::vector<RigidTransform>& predicted,
                             std::vector<calibration::CrossPair>& cross_pairs, int threads, Progress& progress);

/// Clouds of a pair across LiDARs for the 3-D view, deskewed as for registration, each in the frame of its own LiDAR.
/// Without objects. Throws Error where a scan cannot be read.
pipeline::PairClouds load_cross_clouds(const LidarJob& job_a, const pipeline::PipelineOutput& output_a,
                                       const LidarJob& job_b, const pipeline::PipelineOutput& output_b,
                                       const motion::Pair& pair);

/// What both of two LiDARs see, from some of the accepted pairs of each two; motion by the INS as it is.
/// @param together the mountings of all together
std::vector<SharedSurfaces> compare_surfaces(const CalibratedLidars& lidars,
                                             const std::vector<calibration::CrossPair>& cross_pairs,
                                             const std::vector<RigidTransform>& together, int threads,
                                             const Progress& progress);

}  // namespace remount::rig
