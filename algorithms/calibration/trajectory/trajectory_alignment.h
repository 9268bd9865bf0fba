// Alignment of the LiDAR's trajectory with that of the INS or the GNSS antenna, while data arrive or all at once.
// docs/maths/trajectory.md
#pragma once

#include <string>

#include "algorithms/calibration/trajectory/trajectory_answer.h"
#include "algorithms/core/progress.h"

namespace remount::calibration {

/// The answer after some of the data.
struct TrajectorySnapshot {
  double time_s = 0.0;                        ///< of data, all sessions together
  bool known = false;                         ///< false: too little data for any answer
  Mounting mounting;                          ///< as that of the result: of the antenna where there is no INS
  PerParameter<std::optional<double>> sigma;  ///< m, rad; nothing where not observed
  bool converged = false;  ///< what is observed has the sigma that is asked for, and has stayed within it
};

/// What is left at the end.
struct TrajectoryOutcome {
  TrajectoryAnswer answer;
  TrajectorySolution solution;
  double converged_after_s = std::numeric_limits<double>::quiet_NaN();  ///< first snapshot since which it stayed so
  std::size_t outliers = 0, measurements = 0;  ///< INS poses and fixes: without weight, and all
  bool fixes_left_out = false;                 ///< of a receiver beside poses of the INS, while a lag was sought
};

/// All data at once. result.status says what went wrong where something did: TooLittleData, NotConverged, Cancelled.
TrajectoryOutcome solve_alignment(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                  const SolveOptions& judged_by, const Progress& progress);

/// The time of the first of the last answers that are all converged; NaN where the last one is not.
double converged_after_s(const std::vector<TrajectorySnapshot>& history);

/// Takes epochs as they arrive. Each answer is warm from the one before and solves for the last minutes; what earlier
/// epochs said is kept as linear equations (trajectory_condense.h), so that an answer takes as long after an hour as
/// after some minutes. They are opened again where X turns out to be elsewhere than they were linearised at. `finish`
/// starts anew from all data, so that the end of a stream and a batch of the same data are the same. Not thread-safe.
class TrajectoryAligner {
 public:
  TrajectoryAligner(TrajectoryOptions options, SolveOptions judged_by,
                    std::optional<RigidTransform> nominal_ins_from_lidar, bool estimate_clock);

  /// What is known of X beside the drives. Before the first answer.
  void set_measured(const Measured& measured) { problem_.measured = window_.measured = measured; }
  void set_up_in_lidar(const std::optional<Eigen::Vector3d>& up) { problem_.up_in_lidar = window_.up_in_lidar = up; }
  /// The next session; epochs given are kept. Returns its index.
  std::size_t add_session(TrajectorySession session);
  /// Epochs of a session come in the order of their times, sessions one after the other or at once. Throws
  /// Error(Contract) for a time that does not ascend or a session that is not there.
  void push(std::size_t session, TrajectoryEpoch epoch);
  /// Whether update_s of data, or `after_s`, have arrived since the last update.
  bool due() const { return due(options_.update_s); }
  bool due(double after_s) const;
  /// Solves with what is there. Unchanged where cancelled, and then nothing is known.
  TrajectorySnapshot update(const Progress& progress);
  /// The final solution, from all data afresh: solve_alignment.
  TrajectoryOutcome finish(const Progress& progress) const;

  const TrajectoryProblem& problem() const { return problem_; }
  const std::vector<TrajectorySnapshot>& history() const { return history_; }
  /// How many answers started from nothing rather than from the one before.
  std::size_t cold_starts() const { return running_.cold_starts; }
  /// Epochs that the next answer solves for.
  std::size_t open_epochs() const;

 private:
  // The last solution, and what it was made from.
  struct Running {
    TrajectorySolution solution;
    TrajectoryPrior prior;
    std::vector<bool> takes_part;                             // sessions
    std::size_t at_start = 0, at_noise = 0, cold_starts = 0;  // the first two: epochs that were there
    bool doubtful = false;                                    // the past may be linear about another X
  };
  bool starts_anew(const Running& running) const;
  /// Improves `running`; false where what it leads to is no answer.
  bool solve_on(const TrajectoryProblem& usable, bool anew, Running& running, const Progress& progress) const;
  /// Condenses what is old in both, of which `usable` is the part that `running` solves.
  void shorten(TrajectoryProblem& usable, TrajectoryProblem& window, Running& running) const;
  double data_s() const;
  std::size_t epochs() const;
  bool enough() const;
  bool has_stayed(const TrajectorySnapshot& now) const;

  TrajectoryOptions options_;
  SolveOptions judged_by_;
  TrajectoryProblem problem_;  // everything
  TrajectoryProblem window_;   // the same with its older part condensed
  Running running_;
  double updated_s_ = 0.0;
  std::vector<TrajectorySnapshot> history_;
};

/// All sessions at once: pushes them as a stream with at most `most_snapshots` answers on the way for the plot, and
/// finishes. Cancellable.
TrajectoryOutcome align_trajectories(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                     const SolveOptions& judged_by, std::size_t most_snapshots,
                                     std::vector<TrajectorySnapshot>& history, Progress& progress);

}  // namespace remount::calibration
