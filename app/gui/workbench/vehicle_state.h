// Values of a vehicle with several LiDARs: each of them as it would be worked on alone, and what they say together.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/workbench/calibrated.h"
#include "model/project/project.h"
#include "model/results/vehicle_file.h"
#include "model/rig/recorded_lidars.h"
#include "model/rig/rig_calibration.h"

namespace remount::gui {

/// A recording, of one LiDAR or of several.
struct VehicleRecording {
  std::filesystem::path path;
  std::string name;
  drive::TopicChoice topics;  ///< but for that of the LiDAR
};

/// A LiDAR as a project has it.
struct SavedLidar {
  project::OtherLidar lidar;  ///< without the output
  OutputPtr output;           ///< null: not calibrated
};

/// A LiDAR of the vehicle. What is said of the one that is being worked on stands in the other parts of the workbench
/// meanwhile, and here as it was before.
struct VehicleLidar {
  rig::RecordedLidar recorded;       ///< its recordings by their places among those of the vehicle
  bool ticked = true;                ///< calibrated together with the others
  std::vector<SessionPtr> sessions;  ///< of its recordings; null: not opened yet
  std::optional<RigidTransform> nominal_ins_from_lidar{};  ///< once they are open
  CalibratedPtr calibrated{};                              ///< null: not yet
  std::shared_ptr<const SavedLidar> saved{};               ///< of a project, until its recordings are opened

  const std::string& name() const { return recorded.name; }
};

/// What is being worked on.
struct Bench {
  std::vector<SessionPtr> sessions;
  std::optional<RigidTransform> nominal_ins_from_lidar;
  CalibratedPtr calibrated;  ///< null: nothing is, and nothing was decided
};

/// A LiDAR as it went into a common solution, and as it came out.
struct SolvedLidar {
  rig::LidarJob job;
  OutputPtr output;  ///< with the result of all together, where it took part
  OutputPtr alone;   ///< its own calibration
  KeptVerdicts decisions;
  std::vector<Eigen::Vector3f> seen_m;  ///< some of what it sees, in its own frame
};

/// LiDARs that were calibrated together.
struct CommonSolution {
  std::vector<SolvedLidar> lidars;
  results::VehicleFile file;
  std::vector<Message> heights;                     ///< what only LiDARs together are silent about
  std::vector<rig::SharedSurfaces> surfaces;        ///< by places in `lidars`
  std::vector<calibration::CrossPair> cross_pairs;  ///< by places in `lidars`
};
using CommonSolutionPtr = std::shared_ptr<const CommonSolution>;

/// What an edit of a vehicle did.
struct VehicleStep {
  enum class Kind { Calibrated, SolvedAgain, Shown, Nominals } kind = Kind::Calibrated;
  std::string lidar{};  ///< that is shown
};
QString in_words(const VehicleStep& step);

struct VehicleState {
  std::vector<VehicleRecording> recordings;
  std::vector<VehicleLidar> lidars;
  CommonSolutionPtr common;
  Bench bench;
};

}  // namespace remount::gui
