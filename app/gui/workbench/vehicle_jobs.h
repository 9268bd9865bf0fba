// What is done with the LiDARs of a vehicle beside the window's thread, and what becomes of it.
#pragma once

#include "app/gui/jobs/engine.h"
#include "app/gui/workbench/vehicle_state.h"

namespace remount::gui {

/// A LiDAR that is to be solved together with others.
struct LidarToSolve {
  VehicleLidar lidar;
  std::vector<std::filesystem::path> paths;  ///< of its recordings
  std::vector<drive::TopicChoice> topics;
  /// What `alone` was made from; nothing where it is to be calibrated, with what is set now.
  std::optional<pipeline::PipelineInput> input;
  OutputPtr alone;  ///< null where it is to be calibrated
};

/// As find_lidars calls the only LiDAR of a recording that names none.
std::string lidar_of(const drive::Session& session);

bool is_same_nominal(const std::optional<RigidTransform>& one, const std::optional<RigidTransform>& other);

/// A choice of topics but for the LiDAR's.
drive::TopicChoice without_lidar(drive::TopicChoice topics);

/// Forgets sessions that were read with other topics than these, the LiDAR's aside; true where none was, and all are
/// open.
bool keep_read_with(const std::vector<drive::TopicChoice>& topics, std::vector<SessionPtr>& sessions);

/// Opens what is not open yet. The nominal of a LiDAR that is opened for the first time is the one that its recordings
/// declare; what a project holds of it becomes what it would be after its calibration. Throws Error.
void open_lidar(const Engine& engine, const std::vector<std::filesystem::path>& paths,
                const std::vector<drive::TopicChoice>& topics, VehicleLidar& lidar, Progress& progress);

/// Opens, calibrates or solves again, and solves all together. Null where cancelled; `lidars` have their sessions then.
CommonSolutionPtr solve_lidars(const Engine& engine, std::vector<LidarToSolve>& lidars,
                               const settings::Settings& settings, Progress& progress);

/// A LiDAR as it is worked on after a common solution. @param before what was calibrated of it; may be null
CalibratedPtr calibrated_of(const SolvedLidar& lidar, const CalibratedPtr& before);

/// The same, obeying the decisions of now, which are others than those that it was solved with.
CalibratedPtr decided_anew(const Calibrated& calibrated, const KeptVerdicts& decisions);

/// What a project holds of a LiDAR. @param topics of its recordings
SavedLidar saved_of(const VehicleLidar& lidar, const std::vector<std::filesystem::path>& paths,
                    std::vector<drive::TopicChoice> topics, const settings::Settings& settings);

/// A common solution as far as a project holds it. @param decisions of each LiDAR of the file
CommonSolutionPtr common_of_project(const results::VehicleFile& file, const std::vector<KeptVerdicts>& decisions);

}  // namespace remount::gui
