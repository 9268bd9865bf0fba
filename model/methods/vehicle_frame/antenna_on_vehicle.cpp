#include "model/methods/vehicle_frame/antenna_on_vehicle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/calibration/antenna/antenna_fit.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/vehicle_frame/vehicle_frame_start.h"
#include "algorithms/geodesy/geodesy.h"
#include "messages/methods.h"
#include "messages/plots.h"
#include "messages/quantities.h"
#include "messages/stages.h"
#include "model/methods/vehicle_frame/vehicle_frame_method.h"

namespace remount::methods {
namespace {

constexpr double kWindow_s = 40.0;  // of a heading that may drift: a degree in a minute with a plain gyroscope

std::vector<calibration::StampedPosition> positions_of(const drive::Session& session) {
  std::vector<calibration::StampedPosition> positions;
  std::vector<motion::InsSample> samples;
  for (const motion::GnssFix& fix : session.gnss) {
    motion::InsSample sample;
    sample.stamp_ns = fix.stamp_ns;
    sample.latitude_rad = fix.latitude_rad;
    sample.longitude_rad = fix.longitude_rad;
    sample.height_m = fix.height_m;
    samples.push_back(sample);
  }
  if (!samples.empty())
    for (const motion::StampedPose& pose : geodesy::local_from_ins(samples))
      positions.push_back({pose.stamp_ns, pose.pose.translation()});
  return positions;
}

void fill(const calibration::AntennaFit& fit, const pipeline::PipelineInput& input,
          calibration::CalibrationResult& result) {
  const calibration::SolveOptions& solve = input.settings.solve;
  RigidTransform vehicle_from_antenna = input.nominal_ins_from_lidar.value_or(RigidTransform::Identity());
  const double limit2 = solve.max_translation_sigma_m * solve.max_translation_sigma_m;
  calibration::ParameterSet observed;
  for (const calibration::Parameter axis : {calibration::Parameter::X, calibration::Parameter::Y})
    if (const int i = calibration::row_of(axis); fit.covariance_m2(i, i) < limit2) {
      observed.insert(axis);
      vehicle_from_antenna.translation()[i] = fit.antenna_in_vehicle_m[i];
    }
  result.covariance.topLeftCorner<2, 2>() = fit.covariance_m2.topLeftCorner<2, 2>();
  result.set_observed(observed, say::unknown_sigma_above_limit());
  for (const calibration::Parameter never : {calibration::Parameter::Z, calibration::Parameter::Yaw,
                                             calibration::Parameter::Pitch, calibration::Parameter::Roll})
    result.withdraw(never, say::antenna_drives_in_plane());
  result.mounting.reference_from_sensor = vehicle_from_antenna;
  const bool any = !observed.empty(), sees_x = observed.contains(calibration::Parameter::X);
  const auto words = sees_x && observed.contains(calibration::Parameter::Y) ? say::antenna_both_observed
                     : sees_x                                               ? say::antenna_x_observed
                     : any                                                  ? say::antenna_y_observed
                                                                            : say::antenna_not_observed;
  result.conclude(calibration::Status::Degenerate, words(Length{fit.end_error_m}, Length{fit.integrated_m},
                                                         Share{fit.end_error_m / std::max(1.0, fit.integrated_m)}));
  result.advice.push_back(say::antenna_give_poses());
  if (!any) result.advice.push_back(say::antenna_needs_turns());
}

drive::Finding gap_of(const calibration::AntennaFit& fit, const std::string& session) {
  return {drive::Severity::Warning, "drive-gap", session,
          say::antenna_drive_gap(Duration{*fit.first_gap_s}, Length{fit.integrated_m}, Length{fit.distance_m})};
}

calibration::Curve curve(Message name, const std::vector<calibration::StampedPosition>& positions, bool dots) {
  calibration::Curve out{std::move(name), {}, {}, {}, dots, {}};  // in the plane
  for (const calibration::StampedPosition& position : positions) {
    out.x.push_back(position.position_m.x());
    out.y.push_back(position.position_m.y());
  }
  return out;
}

}  // namespace

pipeline::PipelineOutput run_antenna_on_vehicle(const pipeline::PipelineInput& input, Progress& progress) {
  const drive::Session& session = *input.sessions.front();
  pipeline::PipelineOutput output;
  output.method = kVehicleFrameMethod.id;
  output.nominal_known = output.initial_known = input.nominal_ins_from_lidar.has_value();
  calibration::CalibrationResult& result = output.result;
  result.mounting.reference = calibration::BodyFrame::Vehicle;
  result.mounting.sensor = calibration::BodyFrame::Antenna;
  for (const auto& each : input.sessions)
    output.findings.insert(output.findings.end(), each->findings.begin(), each->findings.end());
  if (input.sessions.size() > 1)
    output.findings.push_back(
        {drive::Severity::Warning, "first-session-only", session.name, say::antenna_first_session_only()});
  progress.report(say::stage_integrating_wheels_and_yaw_rate, 0, 0);
  const std::vector<calibration::StampedPosition> positions = positions_of(session);
  const calibration::VehicleFrameOptions& options = input.settings.vehicle_frame;
  const calibration::AntennaFit fit = calibration::fit_antenna(
      motion::WheelImuSignals(session.imu, session.wheels), positions, calibration::stated_imu_mounting(options),
      degrees_to_radians(options.imu_mounting_sigma_deg), kWindow_s, progress);
  output.session_uses_sweep.assign(input.sessions.size(), false);
  if (!fit.found) {
    const bool cancelled = fit.failure == calibration::Status::Cancelled;
    result.conclude(fit.failure, cancelled ? say::method_cancelled() : say::antenna_not_integrated(fit.why));
    return output;
  }
  fill(fit, input, result);
  if (fit.first_gap_s) output.findings.push_back(gap_of(fit, session.name));
  output.initial_ins_from_lidar = output.compensation_ins_from_lidar = result.mounting.reference_from_sensor;
  output.quantities = {
      {"yaw rate bias", say::quantity_yaw_rate_bias(), fit.yaw_rate_bias_radps, fit.yaw_rate_bias_sigma_radps, "rad/s",
       true},
      {"wheel scale", say::quantity_wheel_scale(), fit.wheel_scale, fit.wheel_scale_sigma, "", true},
      {"distance", say::quantity_distance(), fit.integrated_m, std::numeric_limits<double>::quiet_NaN(), "m", true},
      {"end error", say::quantity_end_error(), fit.end_error_m, std::numeric_limits<double>::quiet_NaN(), "m", true},
      {"end error as measured", say::quantity_end_error_as_measured(), fit.end_error_raw_m,
       std::numeric_limits<double>::quiet_NaN(), "m", true}};
  output.plots.push_back({say::plot_wheels_and_yaw_rate(),
                          say::plot_axis_x(),
                          say::plot_axis_y(),
                          true,
                          {curve(say::plot_curve_bias_taken_out(), fit.integrated, false),
                           curve(say::plot_curve_as_measured(), fit.integrated_raw, false),
                           curve(say::plot_curve_positions(), positions, true)}});
  calibration::thin(output.plots, 1000);
  return output;
}

}  // namespace remount::methods
