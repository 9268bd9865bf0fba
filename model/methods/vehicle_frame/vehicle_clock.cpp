// docs/maths/clocks.md (K10)
#include "model/methods/vehicle_frame/vehicle_clock.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/stamps.h"
#include "algorithms/motion/clock_alignment.h"
#include "messages/methods.h"
#include "model/pipeline/offset_search.h"
#include "model/pipeline/scan_times.h"
#include "model/results/result_file.h"

namespace remount::methods {
namespace {

// Attitude against that at the start, from rates alone.
std::vector<motion::StampedPose> integrated_turns(const std::vector<motion::ImuSample>& imu) {
  std::vector<motion::StampedPose> poses;
  RigidTransform start_from_imu = RigidTransform::Identity();
  for (std::size_t i = 0; i < imu.size(); ++i) {
    if (i > 0) {
      const double step_s = seconds(imu[i].stamp_ns - imu[i - 1].stamp_ns);
      start_from_imu.linear() *= so3_exp(0.5 * step_s * (imu[i - 1].angular_rate_radps + imu[i].angular_rate_radps));
    }
    poses.push_back({imu[i].stamp_ns, start_from_imu});
  }
  return poses;
}

// t_vehicle = t_sensor + offset; not `found` where the drive does not tell.
motion::ClockAlignment sensor_clock(const drive::Session& session, const calibration::VehicleDrive& drive,
                                    const settings::Settings& settings) {
  if (!pipeline::tells_clock(session, settings.run.deskew)) return {};
  motion::ClockAlignmentOptions options;
  options.max_offset_s = 1.0;
  const std::vector<motion::StampedPose> turns = integrated_turns(drive.sensed.imu());
  motion::ClockAlignment clock = motion::align_clocks(turns, drive.world_from_sensor, options);
  clock.found = clock.found && !clock.ambiguous;
  return clock;
}

void shift_sensor(double by_s, calibration::VehicleDrive& drive) {
  const auto by_ns = static_cast<std::int64_t>(std::llround(by_s * 1e9));
  for (motion::StampedPose& pose : drive.world_from_sensor) pose.stamp_ns += by_ns;
}

calibration::VehicleFrameResult solve_drives(const pipeline::PipelineInput& input,
                                             const std::vector<calibration::VehicleDrive>& drives, Progress& progress) {
  return calibration::solve_vehicle_frame(drives, input.nominal_ins_from_lidar, input.settings.vehicle_frame,
                                          input.settings.solve, progress);
}

// The offsets of all sessions as a result states them; those that are not told count as none, with no error.
void state_clocks(const std::vector<motion::ClockAlignment>& clocks, bool applied,
                  calibration::CalibrationResult& result) {
  if (std::ranges::none_of(clocks, &motion::ClockAlignment::found)) return;
  result.session_time_offset_s.assign(clocks.size(), 0.0);
  result.session_time_offset_sigma_s.assign(clocks.size(), std::numeric_limits<double>::infinity());
  for (std::size_t s = 0; s < clocks.size(); ++s) {
    if (!clocks[s].found) continue;
    result.session_time_offset_s[s] = clocks[s].offset_s;
    result.session_time_offset_sigma_s[s] = clocks[s].sigma_s;
  }
  result.time_offset = calibration::mean_time_offset(result.session_time_offset_s, result.session_time_offset_sigma_s);
  result.time_offset.applied = applied;
}

}  // namespace

Vector6d moved_by_clock(double offset_s, const RigidTransform& vehicle_from_sensor,
                        const calibration::SolveOptions& options,
                        const std::function<calibration::CalibrationResult(double)>& solved_with) {
  constexpr double kBeyondLimits = 100.0;
  for (const double share : {1.0, -1.0, 0.5, -0.5, 0.25, -0.25}) {
    const calibration::CalibrationResult other = solved_with(share * offset_s);
    if (other.status == calibration::Status::Cancelled) return Vector6d::Zero();
    if (calibration::is_usable(other))
      return difference(vehicle_from_sensor,
                        other.mounting.between(calibration::BodyFrame::Vehicle, calibration::BodyFrame::Lidar)) /
             share;
  }
  return kBeyondLimits * calibration::observation_limits(options);
}

calibration::VehicleFrameResult solve_vehicle_frame_with_clocks(const pipeline::PipelineInput& input,
                                                                std::vector<calibration::VehicleDrive>& drives,
                                                                Progress& progress) {
  std::vector<motion::ClockAlignment> clocks;
  for (std::size_t s = 0; s < drives.size(); ++s)
    clocks.push_back(sensor_clock(*input.sessions[s], drives[s], input.settings));
  calibration::CalibrationResult found;
  state_clocks(clocks, false, found);
  const calibration::ClockOffsetUse use = input.settings.solve.apply_time_offset;
  const bool apply = use == calibration::ClockOffsetUse::Yes ||
                     (use == calibration::ClockOffsetUse::Auto && pipeline::clock_differs(found));
  for (std::size_t s = 0; apply && s < drives.size(); ++s)
    if (clocks[s].found) shift_sensor(clocks[s].offset_s, drives[s]);
  calibration::VehicleFrameResult result = solve_drives(input, drives, progress);
  calibration::CalibrationResult& calibration = result.calibration;
  if (!calibration::is_usable(calibration)) return result;
  for (std::size_t s = 0; s < drives.size() && !progress.cancelled(); ++s) {
    if (!clocks[s].found) continue;
    const double left_s = apply ? clocks[s].sigma_s : std::hypot(clocks[s].offset_s, clocks[s].sigma_s);
    const auto solved_with = [&](double offset_s) {
      std::vector<calibration::VehicleDrive> moved = drives;
      shift_sensor(offset_s, moved[s]);
      return solve_drives(input, moved, progress).calibration;
    };
    calibration::add_doubt(
        moved_by_clock(left_s, calibration.mounting.reference_from_sensor, input.settings.solve, solved_with),
        say::vehicle_clocks_apart(), input.settings.solve, calibration);
  }
  calibration::state_vehicle_frame(result.intervals, calibration);
  calibration.time_offset = found.time_offset;
  calibration.time_offset.applied = apply && std::isfinite(found.time_offset.sigma_s);
  calibration.session_time_offset_s = found.session_time_offset_s;
  calibration.session_time_offset_sigma_s = found.session_time_offset_sigma_s;
  return result;
}

}  // namespace remount::methods
