#include "algorithms/calibration/trajectory/trajectory_refusal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "messages/calibration.h"

namespace remount::calibration {
namespace {

constexpr double kOtherScale = 1.25;

// In steps that are far longer than the noise of positions, which makes a way of its own out of a stay. 1 where INS and
// odometry have too little in common.
double metres_per_unit(const TrajectoryProblem& problem) {
  constexpr double kBeyondNoise = 10.0, kLeastTravel_m = 3.0;
  double measured_m = 0.0, odometry_m = 0.0;
  for (const TrajectorySession& session : problem.sessions) {
    const TrajectoryEpoch* before = nullptr;  // with a pose of the INS; fixes may lie between two
    for (const TrajectoryEpoch& here : session.epochs) {
      if (!here.ins) continue;
      if (before) {
        const double step_m = (here.ins->enu_from_ins.translation() - before->ins->enu_from_ins.translation()).norm();
        if (step_m < kBeyondNoise * here.ins->position_sigma_m) continue;
        measured_m += step_m;
        odometry_m += (here.odometry_from_lidar.translation() - before->odometry_from_lidar.translation()).norm();
      }
      before = &here;
    }
  }
  return measured_m > kLeastTravel_m && odometry_m > 0.0 ? measured_m / odometry_m : 1.0;
}

bool far_from_one(double ratio, double limit) { return std::abs(std::log(ratio)) >= std::log(limit); }

bool over_scans(const TrajectoryProblem& problem) {
  return std::ranges::any_of(problem.sessions,
                             [](const TrajectorySession& session) { return session.odometry_over_scans; });
}

// The same by the scales of the odometry that were found; 1 where none is far from one.
double found_metres_per_unit(const TrajectoryProblem& problem, const TrajectoryState& state, double limit) {
  constexpr double kLeast = 1e-3;  // a scale that ran to zero or beyond is no ratio
  for (std::size_t s = 0; s < problem.sessions.size(); ++s) {
    const double units_per_metre = std::max(kLeast, 1.0 + state.scale[s]);
    if (!problem.sessions[s].epochs.empty() && far_from_one(units_per_metre, limit)) return 1.0 / units_per_metre;
  }
  return 1.0;
}

TrajectoryAnswer not_aligned() {
  TrajectoryAnswer answer = without_numbers(Status::NotConverged, say::trajectory_not_aligned());
  answer.result.advice.push_back(say::look_at_odometry());
  return answer;
}

TrajectoryAnswer of_another_scale(const TrajectoryProblem& problem, double ins_per_lidar_way) {
  const bool ins_longer = ins_per_lidar_way > 1.0, own = over_scans(problem);
  Message longer = has_ins(problem) ? say::way_of_ins() : say::way_of_gnss(), shorter = say::way_of_lidar();
  if (!ins_longer) std::swap(longer, shorter);
  TrajectoryAnswer answer = without_numbers(
      Status::Inconsistent,
      (own ? say::way_longer_slipped : say::way_longer_not_metres)(
          std::move(longer), ins_longer ? ins_per_lidar_way : 1.0 / ins_per_lidar_way, std::move(shorter)));
  answer.result.advice.push_back(own ? say::look_at_units_of_scans() : say::look_at_units_of_poses());
  return answer;
}

}  // namespace

TrajectoryAnswer without_numbers(Status status, Message message) {
  TrajectoryAnswer answer;
  answer.result.conclude(status, std::move(message));
  return answer;
}

std::optional<TrajectoryAnswer> refusal_of(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                           const TrajectoryState& state, bool aligned) {
  constexpr double kExpected = 3.0;  // sigmas of what the settings expect of the odometry's scale
  const double limit = std::max(kOtherScale, 1.0 + 0.01 * kExpected * options.odometry_scale_percent);
  double ratio = found_metres_per_unit(problem, state, limit);
  if (!aligned && !far_from_one(ratio, limit)) ratio = metres_per_unit(problem);
  if (far_from_one(ratio, limit)) return of_another_scale(problem, ratio);
  return aligned ? std::nullopt : std::optional(not_aligned());
}

}  // namespace remount::calibration
