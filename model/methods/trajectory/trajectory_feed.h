// From sessions, complete or still growing, to what trajectory alignment takes.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "algorithms/calibration/trajectory/trajectory_alignment.h"
#include "algorithms/odometry/lidar/lidar_odometry.h"
#include "model/drive/session.h"
#include "model/settings/settings.h"

namespace remount::methods {

/// What was found out about the LiDAR's motion in one session.
struct SessionOdometry {
  std::vector<odometry::OdometryPose> poses;  ///< of the scans that could be read, or as the session gives them
  std::size_t scans_used = 0;                 ///< of the session's, readable or not
  std::size_t unreadable = 0;                 ///< scans
  Message first_unreadable;
  std::size_t unaligned = 0;  ///< scans that kept their prediction
  Message first_unaligned;
  std::size_t undetermined = 0;  ///< scans whose surroundings do not show every direction
};

/// How far the streams of a session reach that take part, none later than the LiDAR. A stream that has fallen silent
/// holds the others back for some seconds and no longer.
std::int64_t trajectory_reach_ns(const drive::Session& session, const std::vector<odometry::OdometryPose>& poses);

/// Which epochs of a session are wanted, by stamps of the LiDAR.
struct EpochRange {
  /// The stamp of an epoch before, which is repeated.
  std::int64_t since_ns = std::numeric_limits<std::int64_t>::min();
  std::int64_t until_ns = std::numeric_limits<std::int64_t>::max();  ///< nothing later than this is used
};

/// What is taken out of the times of a session.
struct SessionTimes {
  double clock_s = 0.0;         ///< t_ins = t_lidar + this
  double position_lag_s = 0.0;  ///< positions of the INS are older than its attitudes by this
  /// Beside poses of the INS. Fixes of a receiver go with its positions or with its attitudes, nobody knows which.
  bool with_fixes = true;
};

/// The epochs of a session: poses of the LiDAR, thinned, with the INS poses at their times and the GNSS fixes at
/// theirs, in a local level frame (ENU) about the first fix. Times count from the first pose.
calibration::TrajectorySession trajectory_session(const drive::Session& session, const SessionOdometry& odometry,
                                                  const settings::Settings& settings, const SessionTimes& times,
                                                  const EpochRange& range = {});

/// Runs the odometry over scans as they come, and the alignment as far as all streams reach. Answers on the way come
/// from the stream, the end from all data.
class TrajectoryFeed {
 public:
  using Tell = std::function<void(const calibration::TrajectorySnapshot&)>;
  using Sessions = std::vector<std::shared_ptr<const drive::Session>>;

  TrajectoryFeed(const settings::Settings& settings, std::optional<RigidTransform> nominal_ins_from_lidar, int threads);

  /// The next session. Throws Error(Unsupported) where it lacks a stream (method_needs.h).
  void begin(const drive::Session& session);
  /// The session begun last, with what it held before and perhaps more. Not `complete`: the last item of each stream
  /// may be half written and waits. Each answer is told; a batch asks for fewer. Throws Error(Unsupported) where it
  /// began with scans and has none any more.
  void offer(const drive::Session& session, bool complete, double least_update_s, const Tell& tell, Progress& progress);
  /// The final solution of the sessions, which are complete now, in the order in which they were begun.
  /// Clock offsets are taken out as the settings say: where it is left to the program, where they are clear.
  calibration::TrajectoryOutcome finish(const Sessions& sessions, Progress& progress);

  const std::vector<calibration::TrajectorySnapshot>& history() const { return aligner_.history(); }
  const std::vector<SessionOdometry>& odometry() const { return odometry_; }
  /// What the final solution was made from.
  const calibration::TrajectoryProblem& problem() const { return problem_; }

 private:
  void begin_odometry();
  /// What is sought beside X.
  struct Sought {
    bool clock = false;
    double position_lag_sigma_s = 0.0;  ///< 0: not sought
    bool odometry_drift = false;
    bool with_fixes = true;  ///< beside poses of the INS, see SessionTimes
  };
  calibration::TrajectoryOutcome solve_at(const Sessions& sessions, const std::vector<SessionTimes>& times,
                                          const Sought& sought, Progress& progress);
  calibration::TrajectoryOutcome solve_with_times(const Sessions& sessions, const Sought& sought, Progress& progress);
  void doubt_times_of(const calibration::CalibrationResult& found, calibration::CalibrationResult& result) const;
  calibration::TrajectoryOutcome solve_as_set(const Sessions& sessions, Progress& progress);
  calibration::TrajectoryOutcome solve_positions_alone(const Sessions& sessions, Progress& progress);
  bool used_are_first_of(const drive::ScanSource& scans) const;
  void keep_poses(const drive::Session& session, const std::vector<odometry::OdometryPose>& poses);
  void run_odometry(const drive::Session& session, std::size_t scans, const std::function<void()>& after,
                    Progress& progress);
  void push_epochs(const drive::Session& session, std::int64_t until_ns, double least_update_s, const Tell& tell,
                   Progress& progress);

  settings::Settings settings_;
  std::optional<RigidTransform> nominal_;
  int threads_;
  calibration::TrajectoryAligner aligner_;
  std::vector<SessionOdometry> odometry_;
  std::unique_ptr<odometry::LidarOdometry> running_;  // of the session begun last
  std::vector<std::int64_t> used_scans_ns_;           // likewise
  bool from_scans_ = false;                     // likewise: decided once, for poses and scans have frames of their own
  std::optional<Eigen::Vector3d> up_in_lidar_;  // of the ground in complete sessions; looked for without a nominal
  calibration::TrajectoryProblem problem_;
};

}  // namespace remount::methods
