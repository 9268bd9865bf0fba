// All LiDARs of a vehicle in one calibration: each alone, then all of them together. docs/maths/rig.md
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/rig/rig.h"
#include "model/pipeline/pipeline.h"

namespace remount::rig {

/// A LiDAR and the drives that it recorded.
struct LidarJob {
  std::string name;
  pipeline::PipelineInput input;  ///< of that LiDAR: its sessions, its nominal mounting
  /// Where each of its sessions stands among the recordings of the vehicle, so that those of one INS are known.
  std::vector<motion::SessionIndex> recordings;
};

struct LidarOutput {
  std::string name;
  pipeline::PipelineOutput
      output;           ///< of its own calibration; its result is that of all together, where it is in there
  bool joined = false;  ///< took part in the common solution
  /// What its own calibration gave, where `output` has the result of all together; null where it has not.
  std::shared_ptr<const pipeline::PipelineOutput> alone = {};
  /// How many times their errors its own drives differ, where this LiDAR alone contradicts itself: it moved between
  /// them.
  std::optional<double> drives_differ = {};
};

/// Surfaces that two LiDARs see: how far the points of one lie off the surfaces of the other, root mean square, under
/// the mountings that each found alone and under those of all together. Noise of ranges is in both.
struct SharedSurfaces {
  motion::LidarIndex lidar_a, lidar_b;
  double separate_m = 0.0, together_m = 0.0;
};

struct RigOutput {
  std::vector<LidarOutput> lidars;  ///< in the order of the jobs
  /// Of the LiDARs that took part, in their order; LiDARs are named by their places in `lidars`.
  std::vector<calibration::CrossPair> cross_pairs;
  std::vector<calibration::RelativeMounting> relatives;
  std::vector<calibration::RigAgreement> agreements;
  std::vector<SharedSurfaces> surfaces;                 ///< of every two with cross pairs
  std::vector<std::vector<motion::LidarIndex>> groups;  ///< joined by what they see
  Eigen::MatrixXd covariance;                           ///< of the mountings that took part, as RigSolution has it
  std::vector<drive::Finding> findings;                 ///< of what they have to do with each other
  bool solved = false;
  bool all_drives_differ = false;  ///< those of no LiDAR agree with each other: the INS moved rather than all of them
};

/// Whether values measured by hand say where a LiDAR sits: which of several, they do not say.
bool measures_one_lidar(const settings::Settings& settings);

/// A LiDAR whose own calibration is not usable is left out of what is common, with a finding; the others are solved
/// without it. One LiDAR gives what `calibrate` gives. Throws as that does.
RigOutput calibrate_rig(const std::vector<LidarJob>& jobs, Progress& progress);

/// Solves together LiDARs that were calibrated alone, and whose pairs somebody may have decided about since: the second
/// half of calibrate_rig. @param alone what each job gave, or a solution again of it, with its details
RigOutput solve_rig_again(const std::vector<LidarJob>& jobs,
                          const std::vector<std::shared_ptr<const pipeline::PipelineOutput>>& alone,
                          Progress& progress);

}  // namespace remount::rig
