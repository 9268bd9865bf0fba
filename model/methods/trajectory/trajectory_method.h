// Trajectory alignment of sessions: at once, or of one that still grows.
#pragma once

#include "model/method_registry/calibration_method.h"
#include "model/methods/trajectory/trajectory_feed.h"
#include "model/pipeline/pipeline.h"

namespace remount::methods {

extern const method_registry::CalibrationMethod kTrajectoryMethod;

/// Alignment of the LiDAR's trajectory with INS poses or GNSS positions.
pipeline::PipelineOutput run_trajectory_method(const pipeline::PipelineInput& input, Progress& progress);

/// What a method leaves behind, from a feed that has finished.
pipeline::PipelineOutput trajectory_output(const pipeline::PipelineInput& input, const TrajectoryFeed& feed,
                                           const calibration::TrajectoryOutcome& outcome);

/// Plots of a finished feed: X against time with its sigma, and each session's trajectory over its fixes.
std::vector<calibration::Plot> trajectory_plots(const TrajectoryFeed& feed,
                                                const calibration::TrajectoryOutcome& outcome);

struct FollowOptions {
  double poll_s = 0.5;           ///< how often the files are looked at
  double settled_s = 5.0;        ///< a session that has not grown for so long is complete
  bool declared_nominal = true;  ///< where the input has no nominal, that of the session
  drive::TopicChoice topics;     ///< of a bag
};

/// What a followed session led to.
struct FollowedSession {
  std::shared_ptr<const drive::Session> session;         ///< as it was in the end
  std::optional<RigidTransform> nominal_ins_from_lidar;  ///< that was used
  pipeline::PipelineOutput output;                       ///< as run_trajectory_method gives for it
};

/// Follows a session that is written while it is read: opens it as soon as that is possible, and again whenever it may
/// have grown. What is half written waits for the rest. Ends when the session has not grown for a while, or when
/// `following` is cancelled; the result is then worked out under `finishing`. Throws Error where the session cannot be
/// opened by then.
/// @param input its sessions are not used
FollowedSession follow_trajectory(const std::filesystem::path& path, const pipeline::PipelineInput& input,
                                  const FollowOptions& options, const TrajectoryFeed::Tell& tell, Progress& following,
                                  Progress& finishing);

}  // namespace remount::methods
