// The vehicle-frame calibration of sessions: wheels and IMU integrated, the sensor's poses against them.
// docs/maths/vehicle-frame.md
#include "model/methods/vehicle_frame/vehicle_frame_method.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/plot_curves.h"
#include "algorithms/calibration/vehicle_frame/vehicle_frame.h"
#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "algorithms/motion/motion_track.h"
#include "algorithms/odometry/lidar/lidar_odometry.h"
#include "messages/methods.h"
#include "messages/places.h"
#include "messages/plots.h"
#include "messages/stages.h"
#include "model/conventions/attitude_check.h"
#include "model/drive/session_frames.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/calibrate.h"
#include "model/methods/vehicle_frame/antenna_on_vehicle.h"
#include "model/methods/vehicle_frame/vehicle_clock.h"
#include "model/methods/vehicle_frame/wheel_direction.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/scan_times.h"
#include "model/pipeline/solve_stage.h"

namespace remount::methods {
namespace {

using Eigen::Vector3d;

// An INS is an IMU too: its turns from sample to sample, as rates in the middle of each step.
std::vector<motion::ImuSample> rates_of(const std::vector<motion::StampedPose>& world_from_vehicle) {
  std::vector<motion::ImuSample> samples;
  for (std::size_t i = 1; i < world_from_vehicle.size(); ++i) {
    const motion::StampedPose &before = world_from_vehicle[i - 1], &after = world_from_vehicle[i];
    if (after.stamp_ns <= before.stamp_ns) continue;
    motion::ImuSample sample;
    sample.stamp_ns = before.stamp_ns + (after.stamp_ns - before.stamp_ns) / 2;
    sample.angular_rate_radps =
        so3_log(before.pose.linear().transpose() * after.pose.linear()) / seconds(after.stamp_ns - before.stamp_ns);
    sample.specific_force_mps2.setConstant(std::numeric_limits<double>::quiet_NaN());
    samples.push_back(sample);
  }
  return samples;
}

// Attitude of the vehicle as the INS knows it, its axes taken to x forward, y left, z up.
std::vector<motion::StampedPose> reference_of(const drive::Session& session) {
  std::vector<motion::StampedPose> poses = drive::metric_poses(session);
  const RigidTransform level_from_ins = drive::forward_left_up_from(session.ins_axes);
  for (motion::StampedPose& pose : poses) pose.pose = pose.pose * level_from_ins.inverse();
  return poses;
}

// Poses of the sensor: given, or by the LiDAR odometry over the scans. Scans that it could not align are left out.
std::vector<motion::StampedPose> sensor_poses(const drive::Session& session, const settings::Settings& settings,
                                              std::vector<drive::Finding>& findings, Progress& progress) {
  if (!session.scans) return session.odometry_from_lidar;
  odometry::LidarOdometry odometry(settings.lidar_odometry, settings.registration);
  std::vector<motion::StampedPose> poses;
  std::size_t failed = 0;
  Message first_failure;
  const auto fail = [&](const Message& what) {
    if (failed++ == 0) first_failure = what;
  };
  const auto take = [&](const std::vector<odometry::OdometryPose>& final_poses) {
    for (const odometry::OdometryPose& pose : final_poses)
      if (pose.aligned)
        poses.push_back({pose.stamp_ns, pose.odometry_from_lidar});
      else
        fail(say::of_file(pipeline::scan_name_at(*session.scans, pose.stamp_ns), pose.problem));
  };
  for (std::size_t i = 0; i < session.scans->size() && !progress.cancelled(); ++i) {
    progress.report(say::stage_lidar_odometry, i, session.scans->size());
    try {
      const cloud::PointCloud cloud = session.scans->load(i);
      take(odometry.push(cloud, pipeline::scan_times(session, cloud, settings.run.deskew), session.scans->stamp_ns(i),
                         progress));
    } catch (const Error& error) {
      fail(say::of_file(session.scans->name(i), error.message()));
    }
  }
  if (!progress.cancelled()) take(odometry.finish(progress));
  if (failed > 0)
    findings.push_back({drive::Severity::Warning, "odometry-scans", session.name,
                        say::vehicle_scans_not_aligned(failed, session.scans->size(), first_failure)});
  return poses;
}

calibration::VehicleDrive drive_of(const drive::Session& session, const settings::Settings& settings,
                                   std::vector<drive::Finding>& findings, Progress& progress) {
  std::vector<motion::StampedPose> reference;
  if (!session.ins.empty() || !session.world_from_ins.empty()) reference = reference_of(session);
  std::vector<motion::ImuSample> imu = session.imu;
  const bool by_reference = imu.size() < 2;
  if (by_reference) {
    imu = rates_of(reference);
    findings.push_back({drive::Severity::Note, "imu-from-ins", session.name, say::vehicle_imu_from_ins()});
  }
  return {motion::WheelImuSignals(imu, session.wheels), sensor_poses(session, settings, findings, progress),
          std::move(reference), by_reference};
}

struct Integrated {
  std::vector<double> way_m;
  std::vector<RigidTransform> by[3];  // order of kIntegrations
  std::vector<RigidTransform> by_sensor;
};
constexpr motion::WheelIntegration kIntegrations[] = {
    motion::WheelIntegration::ClosedForm, motion::WheelIntegration::Euler, motion::WheelIntegration::Planar};
constexpr Message (*kNames[])() = {say::plot_curve_closed_form, say::plot_curve_euler, say::plot_curve_planar};

// The drive from pose to pose of the sensor, up to its first gap, by each integration and by the sensor itself.
Integrated integrate(const calibration::VehicleDrive& drive, const calibration::VehicleFrameResult& result) {
  Integrated out;
  const std::vector<motion::StampedPose>& poses = drive.world_from_sensor;
  const RigidTransform& x =
      result.calibration.mounting.between(calibration::BodyFrame::Vehicle, calibration::BodyFrame::Lidar);
  RigidTransform start = RigidTransform::Identity(), first = RigidTransform::Identity();
  std::size_t begin = poses.size();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto steps = drive.sensed.steps(poses[i - 1].stamp_ns, poses[i].stamp_ns);
    if (!steps && begin < i) break;
    if (!steps) continue;
    if (begin > i) {
      begin = i - 1;
      first = poses[begin].pose;
      if (const auto level = motion::MotionTrack(drive.reference_from_vehicle).at(poses[begin].stamp_ns))
        start.linear() = level->linear();
      out.way_m = {0.0};
      out.by_sensor = {start};
      for (std::vector<RigidTransform>& by : out.by) by = {start};
    }
    std::vector<motion::MotionStep> scaled = *steps;
    double way_m = out.way_m.back();
    for (motion::MotionStep& step : scaled) {
      // The mean of both wheels with half of what the right one's way is longer by than the left's.
      const double asymmetry = (result.right_over_left - 1.0) / (result.right_over_left + 1.0);
      step.travel_m = result.wheel_scale * (step.travel_m + 0.5 * asymmetry * step.wheel_difference_m);
      step.turn_in_imu_rad = result.gyro_scale.cwiseProduct(step.turn_in_imu_rad);
      way_m += std::abs(step.travel_m);
    }
    for (std::size_t k = 0; k < 3; ++k)
      out.by[k].push_back(motion::integrate_steps(scaled, out.by[k].back(), result.vehicle_from_imu,
                                                  result.gyro_bias_radps, kIntegrations[k])
                              .back());
    RigidTransform moved = first.inverse() * poses[i].pose;
    moved.translation() *= result.scale;
    out.by_sensor.push_back(start * x * moved * x.inverse());
    out.way_m.push_back(way_m);
  }
  return out;
}

std::vector<calibration::Plot> plots_of(const Integrated& drive) {
  calibration::Plot map{.title = say::plot_three_integrations(),
                        .x_label = say::plot_axis_x(),
                        .y_label = say::plot_axis_y(),
                        .equal_axes = true,
                        .curves = {}};
  calibration::Plot height{.title = say::plot_height_along_the_way(),
                           .x_label = say::plot_axis_way(),
                           .y_label = say::plot_axis_z(),
                           .curves = {}};
  calibration::Plot distance{.title = say::plot_distance_from_sensor(),
                             .x_label = say::plot_axis_way(),
                             .y_label = say::plot_axis_metres(),
                             .curves = {}};
  const auto add = [&](const Message& name, const std::vector<RigidTransform>& poses, bool with_distance) {
    calibration::Curve across = calibration::line_curve(name), up = across, off = across;
    for (std::size_t i = 0; i < poses.size() && i < drive.way_m.size(); ++i) {
      across.x.push_back(poses[i].translation().x());
      across.y.push_back(poses[i].translation().y());
      across.z.push_back(poses[i].translation().z());
      up.x.push_back(drive.way_m[i]);
      up.y.push_back(poses[i].translation().z());
      off.x.push_back(drive.way_m[i]);
      off.y.push_back((poses[i].translation() - drive.by_sensor[i].translation()).norm());
    }
    map.curves.push_back(across);
    height.curves.push_back(up);
    if (with_distance) distance.curves.push_back(off);
  };
  for (std::size_t k = 0; k < 3; ++k) add(kNames[k](), drive.by[k], true);
  add(say::plot_curve_sensor(), drive.by_sensor, false);
  std::vector<calibration::Plot> plots{map, height, distance};
  calibration::thin(plots, 1000);
  return plots;
}

// What sensors were found to be wrong by, where it is beyond doubt and would have been seen in the result.
void report_scales(const calibration::VehicleFrameResult& result, std::vector<drive::Finding>& findings) {
  constexpr double kWorthSaying = 0.004, kBeyondDoubt = 5.0;
  if (!calibration::is_usable(result.calibration)) return;
  for (const calibration::NamedQuantity& quantity : result.quantities) {
    const double off = quantity.value - 1.0;
    if (!quantity.observed || std::abs(off) < std::max(kWorthSaying, kBeyondDoubt * quantity.sigma)) continue;
    const Share share{std::abs(1.0 / quantity.value - 1.0)}, sigma{quantity.sigma};
    const bool large = off < 0.0;
    if (quantity.id == calibration::kGyroScale)
      findings.push_back({drive::Severity::Note, "gyro-scale", say::place_imu(),
                          (large ? say::vehicle_rates_too_large : say::vehicle_rates_too_small)(share, sigma)});
    else if (quantity.id == calibration::gyro_scale_of_axis(quantity.id.back()))
      findings.push_back({drive::Severity::Note, "gyro-scale", say::place_imu(),
                          (large ? say::vehicle_rates_of_axis_too_large : say::vehicle_rates_of_axis_too_small)(
                              std::string(1, quantity.id.back()), share, sigma)});
    else if (quantity.id == calibration::kRightOverLeft)
      findings.push_back({drive::Severity::Note, "wheel-sides", say::place_wheels(),
                          (large ? say::vehicle_right_wheel_faster : say::vehicle_right_wheel_slower)(share, sigma)});
  }
}

void report(const calibration::VehicleFrameResult& result, bool wheel_scale_asked,
            std::vector<drive::Finding>& findings) {
  if (result.imu_to_reference)
    findings.push_back({drive::Severity::Note, "imu-to-vehicle", say::place_imu(), result.imu_to_reference->words});
  if (!result.imu_to_sensor.words.empty())
    findings.push_back(
        {drive::Severity::Note, "imu-to-sensor", say::place_imu_and_sensor(), result.imu_to_sensor.words});
  report_scales(result, findings);
  constexpr double kTyres = 0.06;  // four times what tyres are expected to differ by
  if (calibration::is_usable(result.calibration) && std::abs(std::log(result.wheel_scale)) > kTyres &&
      !wheel_scale_asked) {
    const Share part{std::abs(1.0 - 1.0 / result.wheel_scale)};
    findings.push_back({drive::Severity::Warning, "wheel-scale", say::place_wheels(), say::vehicle_wheel_scale(part)});
  }
  if (result.calibration.status == calibration::Status::Degenerate &&
      !result.calibration.known[calibration::Parameter::Z].observed)
    findings.push_back(
        {drive::Severity::Warning, "height-unobserved", say::place_vehicle_frame(), say::vehicle_height_unobserved()});
}

}  // namespace

pipeline::PipelineOutput run_vehicle_frame(const pipeline::PipelineInput& given, Progress& progress) {
  const pipeline::PipelineInput input = pipeline::with_possible_motion(given);
  if (input.sessions.empty()) throw Error(ErrorCode::Contract, "", say::method_no_session());
  settings::require_valid(input.settings);
  refuse_measured(input.settings.measured, kVehicleFrameMethod.id, say::method_frame_vehicle());
  method_registry::require_served(kVehicleFrameMethod, input.sessions);
  if (has_antenna_only(*input.sessions.front())) return run_antenna_on_vehicle(input, progress);
  pipeline::PipelineOutput output;
  output.method = kVehicleFrameMethod.id;
  output.nominal_known = output.initial_known = input.nominal_ins_from_lidar.has_value();
  std::vector<calibration::VehicleDrive> drives;
  std::vector<drive::Finding> blamed;  ///< of those whose turns are the INS's: elsewhere its attitude is only drawn
  for (const auto& session : input.sessions) {
    output.findings.insert(output.findings.end(), session->findings.begin(), session->findings.end());
    drives.push_back(drive_of(*session, input.settings, output.findings, progress));
    if (session->imu.size() < 2) blamed.insert(blamed.end(), session->findings.begin(), session->findings.end());
  }
  calibration::VehicleFrameResult result = solve_vehicle_frame_with_clocks(input, drives, progress);
  refuse_backward_wheels(drives, input.settings.vehicle_frame, result);
  output.result = result.calibration;
  output.quantities = result.quantities;
  output.initial_ins_from_lidar =
      input.nominal_ins_from_lidar ? *input.nominal_ins_from_lidar : result.calibration.mounting.reference_from_sensor;
  output.compensation_ins_from_lidar = result.calibration.mounting.reference_from_sensor;
  output.session_uses_sweep.assign(input.sessions.size(), false);
  report(result, input.settings.vehicle_frame.estimate_wheel_scale, output.findings);
  pipeline::report_clock(input, output.result, output.findings);
  conventions::blame_attitude(blamed, output.result);
  if (calibration::is_solved(result.calibration.status)) {
    progress.report(say::stage_comparing_integrations, 0, 0);
    output.plots = plots_of(integrate(drives.front(), result));
  }
  return output;
}

}  // namespace remount::methods
