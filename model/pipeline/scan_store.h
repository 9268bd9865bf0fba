// Scans of the keyframes: loaded, compensated for motion and prepared for registration, within a memory bound.
#pragma once

#include <future>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/cloud/beam_errors.h"
#include "algorithms/cloud/objects.h"
#include "algorithms/core/progress.h"
#include "algorithms/motion/keyframes.h"
#include "algorithms/registration/prepared_cloud.h"
#include "model/pipeline/drive_motion.h"

namespace remount::pipeline {

/// Axis-aligned box in the lidar frame of a scan.
struct LidarBox {
  Eigen::Vector3f minimum, maximum;
};

/// Thread-safe. A scan is prepared once for all its pairs while the bound allows; the least recently used goes first.
class ScanStore {
 public:
  ScanStore(const DriveMotion& motion, registration::RegistrationOptions options, std::size_t bound_bytes)
      : motion_(motion), options_(options), bound_bytes_(bound_bytes) {}

  /// Motion within a scan is taken from the INS through this X; without a call scans are used as they are.
  /// @param sweeps of each session, that were found; empty: the sessions' own
  void compensate_motion(const RigidTransform& ins_from_lidar, const std::vector<bool>& session_uses_sweep,
                         const std::vector<drive::SweepModel>& sweeps = {});

  /// Takes these errors of the LiDAR's beams out of every scan as it is recorded, and no others. Without a call scans
  /// are as their session gives them.
  void mend_beams(const cloud::BeamErrors& errors) { beam_errors_ = errors; }

  /// The frames around a keyframe are gathered to one scan, each where the INS puts it through this X.
  /// @param session_frames of each session, how many; empty: keyframes are single scans
  void gather(const RigidTransform& ins_from_lidar, const std::vector<int>& session_frames);

  /// The scan, mended, gathered and compensated, in the lidar frame at its stamp; mended alone where cancelled. Throws
  /// Error where it cannot be read.
  cloud::PointCloud load(const motion::Keyframe& keyframe, const Progress& progress = {}) const;

  /// Prepared for registration without the points in `boxes`. `key` names the keyframe; the same key must come with the
  /// same arguments. Throws Error where the scan cannot be read. Empty where `progress` is cancelled; that is not kept,
  /// and a caller who waited for it without being cancelled prepares the scan itself.
  std::shared_ptr<const registration::PreparedCloud> prepare(motion::KeyframeIndex key,
                                                             const motion::Keyframe& keyframe,
                                                             const std::vector<LidarBox>& boxes,
                                                             const Progress& progress = {});

 private:
  using Future = std::shared_future<std::shared_ptr<const registration::PreparedCloud>>;
  std::shared_ptr<const registration::PreparedCloud> prepare(const motion::Keyframe& keyframe,
                                                             const std::vector<LidarBox>& boxes,
                                                             const Progress& progress) const;
  /// One scan in the lidar frame at the keyframe's stamp.
  cloud::PointCloud load_frame(const motion::Keyframe& keyframe, motion::ScanIndex scan,
                               const Progress& progress) const;
  motion::GatheredFrames frames_of(motion::SessionIndex session) const;
  void forget_oldest(motion::KeyframeIndex keep);

  const DriveMotion& motion_;
  registration::RegistrationOptions options_;
  std::size_t bound_bytes_;
  std::optional<RigidTransform> compensation_;
  std::optional<cloud::BeamErrors> beam_errors_;
  std::vector<std::optional<drive::SweepModel>> sweeps_;  // nothing: not by a sweep
  RigidTransform gathered_through_ = RigidTransform::Identity();
  std::vector<int> session_frames_;

  std::mutex mutex_;
  std::map<motion::KeyframeIndex, Future> ready_;
  std::list<motion::KeyframeIndex> recently_used_;  // newest first
  std::map<motion::KeyframeIndex, std::size_t> bytes_;
  std::size_t total_bytes_ = 0;
};

}  // namespace remount::pipeline
