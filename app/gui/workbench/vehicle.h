// All LiDARs of the vehicle, of which one is worked on.
#pragma once

#include <deque>
#include <map>

#include "app/gui/workbench/calibrations.h"
#include "app/gui/workbench/vehicle_jobs.h"

namespace remount::gui {

/// Holds the LiDARs that the recordings have. One of them is worked on: the other parts hold its sessions, nominal and
/// result, and it is reviewed as a vehicle with one LiDAR is. Another that is shown changes places with it. A
/// calibration of several, and which is shown, are edits that can be undone.
class Vehicle : public WorkbenchPart {
  Q_OBJECT
 public:
  struct Parts {
    SessionList& sessions;
    Setup& setup;
    Outcome& outcome;
    Decisions& decisions;
    Solutions& solutions;
    Calibrations& calibrations;
  };
  Vehicle(const Desk& desk, const Parts& parts);

  /// Fewer than two: there is nothing to do together.
  const std::vector<VehicleLidar>& lidars() const { return lidars_; }
  /// Recordings of any of them, which places in a LiDAR's list refer to.
  const std::vector<VehicleRecording>& recordings() const { return recordings_; }
  /// The one that is worked on; nothing where the sessions that are open are of none, or of several.
  std::optional<motion::LidarIndex> shown() const;
  const CommonSolutionPtr& common() const { return common_; }  ///< null before the first
  /// What holds of a LiDAR now; null where it is not calibrated.
  OutputPtr output_of(motion::LidarIndex lidar) const;
  /// Whether the LiDAR is still as the common solution has it: no decision, option or nominal has moved it since.
  bool is_as_solved(motion::LidarIndex lidar) const;
  bool up_to_date() const;  ///< the common solution, for all of its LiDARs

  void tick(motion::LidarIndex lidar, bool on);
  void calibrate();    ///< each of the ticked LiDARs, then all of them together
  void solve_again();  ///< together, from what each has now
  /// Another LiDAR is worked on. Its recordings are opened where they are not yet.
  void show(motion::LidarIndex lidar);
  /// Shows the LiDAR where nothing else is other in a choice of topics for a session. False where it is no such choice.
  bool show_chosen(motion::SessionIndex session, const drive::TopicChoice& choice);
  /// Of these LiDARs, by their names.
  void edit_nominals(const std::map<std::string, RigidTransform>& ins_from_lidars);
  /// What is written holds these LiDARs.
  void mark_written(const std::vector<std::string>& names);

  // Steps of undo commands.
  VehicleState state() const;
  void apply(const VehicleState& state, const QString& step);
  void announce() { emit changed(); }

  /// What a project holds of the LiDARs beside the one that is worked on.
  std::vector<SavedLidar> others_to_save() const;
  /// Another project takes this one's place; its sessions, decisions and output are there already.
  void restore(const project::Project& project, std::vector<SavedLidar> others);

 signals:
  void changed();

 private:
  std::optional<motion::LidarIndex> lidar_of_sessions(const std::vector<SessionPtr>& sessions) const;
  void restore_bench();
  void restore_lidar(SavedLidar saved);
  void restore_common(const results::VehicleFile& file);
  void follow_sessions();
  void take_recordings(std::vector<VehicleRecording> recordings);
  void look();  ///< for LiDARs in the recordings
  void take_lidars(const std::vector<rig::RecordedLidar>& found);
  void warn_of_mixture();
  std::vector<std::filesystem::path> paths_of(const VehicleLidar& lidar) const;
  std::vector<drive::TopicChoice> topics_of(const VehicleLidar& lidar) const;
  const std::optional<RigidTransform>& nominal_of(motion::LidarIndex lidar) const;
  Bench bench() const;
  void put(const Bench& bench);
  bool may_solve(std::size_t lidars);  ///< says why not
  std::optional<LidarToSolve> to_solve_again(const SolvedLidar& solved, const VehicleState& now);
  void start(std::vector<LidarToSolve> lidars, const VehicleStep& step);
  void take(const std::vector<LidarToSolve>& solved, const CommonSolutionPtr& common, const Bench& begun_with,
            const VehicleStep& step);
  void tell(const CommonSolution& common);

  Parts parts_;
  std::vector<VehicleRecording> recordings_;
  std::vector<VehicleLidar> lidars_;
  CommonSolutionPtr common_;
  std::vector<SessionPtr> known_;  // the sessions that are open, as of when they were last looked at
  /// What was there with other sessions, which may come back by undo.
  std::deque<std::pair<std::vector<SessionPtr>, VehicleState>> before_;
  bool swapping_ = false;
  int look_ = 0;
};

}  // namespace remount::gui
