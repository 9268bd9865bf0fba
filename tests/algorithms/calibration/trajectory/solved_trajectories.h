// Trajectories that are simulated, solved and compared with the truth.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "algorithms/calibration/trajectory/trajectory_alignment.h"
#include "tests/algorithms/support/trajectory_drive.h"

namespace remount::calibration {

using testing::TrajectoryDriveOptions;

inline TrajectoryProblem problem_of(const std::vector<TrajectoryDriveOptions>& drives) {
  TrajectoryProblem problem;
  for (const TrajectoryDriveOptions& drive : drives) problem.sessions.push_back(testing::trajectory_session(drive));
  return problem;
}

inline TrajectoryOutcome solve(const TrajectoryProblem& problem, const TrajectoryOptions& options = {}) {
  std::vector<TrajectorySnapshot> history;
  Progress progress;
  return align_trajectories(problem, options, SolveOptions{}, 0, history, progress);
}

inline Vector6d error_of(const CalibrationResult& result, const RigidTransform& truth) {
  const SixParameters found = six_from_rigid(result.mounting.reference_from_sensor), exact = six_from_rigid(truth);
  Vector6d error;
  error << found.x_m - exact.x_m, found.y_m - exact.y_m, found.z_m - exact.z_m,
      wrap_angle_rad(found.yaw_rad - exact.yaw_rad), found.pitch_rad - exact.pitch_rad,
      wrap_angle_rad(found.roll_rad - exact.roll_rad);
  return error;
}

inline void print(const char* what, const CalibrationResult& result, const RigidTransform& truth) {
  const Vector6d error = error_of(result, truth);
  std::printf("  %s (%s):", what, std::string(to_string(result.status)).c_str());
  for (int i = 0; i < 6; ++i) {
    const double unit = i < 3 ? 1e3 : 180.0 / kPi;
    std::printf(" %s %.4f+-%.4f", std::string(to_string(kParameters[i])).c_str(), error[i] * unit,
                result.estimate(kParameters[i]).sigma.value_or(NAN) * unit);
  }
  std::printf(" (mm, deg)\n");
}

}  // namespace remount::calibration
