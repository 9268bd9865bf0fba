// Motion of the INS of every session, in metres, at the times of the scans.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/motion/motion_track.h"
#include "algorithms/motion/pair.h"
#include "algorithms/motion/sweep.h"
#include "model/conventions/attitude_rounding.h"
#include "model/drive/session.h"

namespace remount::pipeline {

/// INS trajectories of all sessions and the clock offset of each lidar (t_ins = t_lidar + offset).
class DriveMotion {
 public:
  /// Impossible positions are left out (model/conventions/impossible_motion.h). Throws Error(Unsupported) where a
  /// session has no INS motion at all, Error(Format) where none of it is possible.
  /// @param swept when the points of a scan of each session were measured; of those left out: at their stamps
  explicit DriveMotion(std::vector<std::shared_ptr<const drive::Session>> sessions,
                       std::vector<motion::Sweep> swept = {});

  const drive::Session& session(motion::SessionIndex index) const { return *sessions_[index]; }
  std::size_t session_count() const { return sessions_.size(); }
  const motion::MotionTrack& track(motion::SessionIndex index) const { return tracks_[index]; }
  double offset_s(motion::SessionIndex index) const { return offsets_s_[index]; }
  void set_offset_s(motion::SessionIndex index, double offset_s) { offsets_s_[index] = offset_s; }

  double position_lag_s(motion::SessionIndex index) const { return position_lags_s_[index]; }
  /// Takes out how much older the positions of a session are than its attitudes: those that were logged so much later
  /// go with these. At the ends of the data attitudes are left without.
  void set_position_lag_s(motion::SessionIndex index, double lag_s);

  /// Stamps of what the lidar delivers: scans, or poses of its odometry.
  std::vector<std::int64_t> lidar_stamps_ns(motion::SessionIndex session) const;
  /// local_from_ins at a lidar stamp, as `passage` has it; nothing outside the data or in a gap.
  std::optional<RigidTransform> local_from_ins(motion::SessionIndex session, std::int64_t lidar_stamp_ns) const;
  /// The motion of the INS during the scan with this stamp, known best in the middle of the time that it took; its pose
  /// at the stamp is `local_from_ins`.
  std::optional<motion::Passage> passage(motion::SessionIndex session, std::int64_t lidar_stamp_ns) const;

  /// The solver's nodes and times for keyframes; poses that the present clock offset moves out of the data keep
  /// identity velocity and the pose without offset.
  std::vector<calibration::JointNode> nodes(const std::vector<motion::Keyframe>& keyframes) const;
  std::vector<calibration::SessionNoise> noise() const;

 private:
  void add_errors_between_samples(const std::vector<motion::Keyframe>& keyframes,
                                  std::vector<calibration::JointNode>& nodes) const;

  std::vector<std::shared_ptr<const drive::Session>> sessions_;
  std::vector<motion::MotionTrack> tracks_;
  std::vector<double> offsets_s_, position_lags_s_;
  std::vector<motion::Sweep> swept_;  ///< by a scan of each session
  std::vector<conventions::AttitudeRounding> roundings_;
};

/// Poses of an odometry are consistent with themselves: the motion from a to c is that from a to b and b to c, and
/// adding it adds nothing but false confidence. Each keyframe of a session without scans keeps its nearest partner;
/// pairs that span a break of the odometry go.
void keep_independent_odometry(const DriveMotion& motion, const std::vector<motion::Keyframe>& keyframes,
                               std::vector<motion::Pair>& pairs);

/// Sets Q of the pairs of sessions that have poses of somebody's odometry instead of scans: the motion between two.
/// @param untold by session, as PipelineInput::odometry_untold: of the directions of motion in there, Q says nothing
void use_odometry(const DriveMotion& motion, const std::vector<motion::Keyframe>& keyframes,
                  const std::vector<std::vector<Matrix6d>>& untold, std::vector<motion::Pair>& pairs);

}  // namespace remount::pipeline
