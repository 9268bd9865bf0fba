#include "model/methods/fusion_odometry/fusion_run.h"

#include <algorithm>
#include <cmath>
#include <future>

#include "algorithms/calibration/plot_curves.h"
#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "algorithms/odometry/fusion/fused_poses.h"
#include "messages/methods.h"
#include "messages/parameters.h"
#include "messages/plots.h"
#include "model/drive/session_frames.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/pipeline/scan_times.h"
#include "model/results/deciding_notes.h"

namespace remount::methods {
namespace {

bool compensates(const drive::Session& session, const settings::Settings& settings,
                 std::vector<drive::Finding>& findings) {
  if (settings.run.deskew == settings::DeskewMode::Off || !settings.fusion.deskew) return false;
  if (session.scan_timing == drive::ScanTiming::PerPoint) return true;
  if (session.scan_timing != drive::ScanTiming::SweepAzimuth) return false;
  if (session.sweep.certain || settings.run.deskew == settings::DeskewMode::On) return true;
  findings.push_back({drive::Severity::Note, "odometry-deskew-off", session.name, say::odometry_scans_as_they_are()});
  return false;
}

bool sensible(const std::vector<float>& times_s) {
  constexpr float kLongest_s = 5.0f;  // from the stamp
  return std::all_of(times_s.begin(), times_s.end(), [](float time_s) { return std::abs(time_s) <= kLongest_s; });
}

odometry::OdometryScan load_scan(const drive::Session& session, std::size_t index, bool compensated) {
  odometry::OdometryScan scan;
  scan.stamp_ns = session.scans->stamp_ns(index);
  scan.cloud_in_lidar = session.scans->load(index);
  if (compensated)
    scan.time_from_stamp_s =
        pipeline::told_times(session, scan.cloud_in_lidar, pipeline::sweep_of(session, settings::DeskewMode::On));
  return scan;
}

/// Reads one scan ahead, since reading takes about as long as the odometry.
class ScanAhead {
 public:
  ScanAhead(const drive::Session& session, bool compensated, std::vector<drive::Finding>& findings)
      : session_(session), compensated_(compensated), findings_(findings) {}

  odometry::OdometryScan get(std::size_t index) {
    if (!next_.valid()) ask(index);
    odometry::OdometryScan scan;
    try {
      scan = next_.get();
    } catch (const Error& error) {
      findings_.push_back(
          {drive::Severity::Warning, "scan-unreadable", session_.name, say::odometry_scan_unreadable(error.message())});
      scan.stamp_ns = session_.scans->stamp_ns(index);
    }
    if (!sensible(scan.time_from_stamp_s)) {  // not finite, or seconds away
      scan.time_from_stamp_s.clear();
      ++without_times_;
    }
    if (index + 1 < session_.scans->size()) ask(index + 1);
    return scan;
  }

  void tell_without_times() const {
    if (without_times_ > 0)
      findings_.push_back({drive::Severity::Warning, "odometry-point-times", session_.name,
                           say::odometry_point_times(without_times_, session_.scans->size())});
  }

 private:
  void ask(std::size_t index) {
    next_ = std::async(std::launch::async, [this, index] { return load_scan(session_, index, compensated_); });
  }
  const drive::Session& session_;
  bool compensated_;
  std::vector<drive::Finding>& findings_;
  std::size_t without_times_ = 0;
  std::future<odometry::OdometryScan> next_;
};

void tell_missing(const drive::Session& session, const odometry::FusionOptions& options,
                  std::vector<drive::Finding>& findings) {
  std::vector<Message> missing;
  const auto has_force = [](const motion::ImuSample& sample) { return sample.specific_force_mps2.allFinite(); };
  if (options.ackermann && session.wheels.empty()) missing.push_back(say::odometry_wheel_speeds());
  if (options.ackermann && session.imu.empty()) missing.push_back(say::odometry_angular_rates());
  if (options.accelerometer && std::none_of(session.imu.begin(), session.imu.end(), has_force))
    missing.push_back(say::odometry_accelerations());
  if (options.barometer && session.barometer.empty()) missing.push_back(say::odometry_a_barometer());
  if (!missing.empty())
    findings.push_back({drive::Severity::Note, "odometry-without", session.name, say::odometry_without(missing)});
}

/// Streams that exist, and yet no scan could use.
void tell_unused(const drive::Session& session, const odometry::FusionOptions& options,
                 const std::vector<odometry::FusedScan>& scans, std::vector<drive::Finding>& findings) {
  const auto never = [&scans](bool odometry::FusedScan::*part) {
    return std::none_of(scans.begin(), scans.end(), [part](const odometry::FusedScan& scan) { return scan.*part; });
  };
  const auto has_force = [](const motion::ImuSample& sample) { return sample.specific_force_mps2.allFinite(); };
  std::vector<Message> unused;
  if (options.ackermann && !session.wheels.empty() && never(&odometry::FusedScan::dead_reckoned))
    unused.push_back(say::odometry_wheel_speeds());
  if (options.accelerometer && std::any_of(session.imu.begin(), session.imu.end(), has_force) &&
      never(&odometry::FusedScan::levelled))
    unused.push_back(say::odometry_accelerations());
  if (options.barometer && !session.barometer.empty() && never(&odometry::FusedScan::height_measured))
    unused.push_back(say::odometry_a_barometer());
  if (!unused.empty() && scans.size() > 1)
    findings.push_back({drive::Severity::Warning, "odometry-unused", session.name, say::odometry_unused(unused)});
}

void tell_mounting(const drive::Session& session, const odometry::FusionOptions& options,
                   std::vector<drive::Finding>& findings) {
  const odometry::FusionOptions unset;
  const bool all_zero = difference(options.vehicle_from_ins(), unset.vehicle_from_ins()).norm() == 0.0;
  if (all_zero && options.ackermann && !session.wheels.empty())
    findings.push_back(
        {drive::Severity::Warning, "odometry-mounting-unset", session.name, say::odometry_mounting_unset()});
}

void tell_restarts(const drive::Session& session, const std::vector<odometry::FusedScan>& scans,
                   std::vector<drive::Finding>& findings) {
  const auto restarts =
      std::count_if(scans.begin(), scans.end(), [](const odometry::FusedScan& scan) { return scan.map_restarted; });
  if (restarts > 0)
    findings.push_back(
        {drive::Severity::Warning, "odometry-restarted", session.name, say::odometry_restarted(restarts)});
}

std::vector<std::int64_t> breaks_of(const std::vector<odometry::FusedScan>& scans, FusionUse use) {
  std::vector<std::int64_t> breaks_ns;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const odometry::FusedScan& scan = scans[i];
    const bool told = scan.undetermined.empty() && !scan.untold.isIdentity();
    const bool carried = use != FusionUse::ScansAlone && scan.dead_reckoned && !scan.untold.isIdentity();
    if (!scan.usable || scan.map_restarted || !(told || carried)) breaks_ns.push_back(scan.stamp_ns);
  }
  return breaks_ns;
}

bool has_other_sensors(const drive::Session& session) {
  return !session.wheels.empty() || !session.imu.empty() || !session.barometer.empty();
}

void tell_blind(const drive::Session& session, const std::vector<odometry::FusedScan>& scans, FusionUse use,
                bool with_mounting, std::vector<drive::Finding>& findings) {
  std::size_t blind = 0, guessed = 0;
  for (std::size_t i = 1; i < scans.size(); ++i)
    if (!scans[i].undetermined.empty()) ++(scans[i].dead_reckoned ? blind : guessed);
  const auto by_wheels = use == FusionUse::Calibration ? say::odometry_by_wheels_untold : say::odometry_by_wheels;
  if (blind > 0)
    findings.push_back(
        {drive::Severity::Note, results::kOdometryByWheels, session.name, by_wheels(blind, scans.size())});
  const bool wheels_idle = !session.wheels.empty() && !with_mounting;
  const auto nothing_tells = wheels_idle ? say::odometry_guessed_beside_idle_wheels : say::odometry_guessed;
  if (guessed > 0)
    findings.push_back(
        {drive::Severity::Warning, "odometry-guessed", session.name, nothing_tells(guessed, scans.size())});
}

}  // namespace

FusionRun run_fusion_odometry(const drive::Session& session,
                              const std::optional<RigidTransform>& mounting_ins_from_lidar,
                              const settings::Settings& settings, int threads, Progress& progress, FusionUse use) {
  if (!session.scans || session.scans->size() == 0)
    throw Error(ErrorCode::Unsupported, session.name, say::odometry_needs_scans());
  FusionRun run;
  odometry::FusionOptions options = settings.fusion;
  odometry::FusionMounting mounting;
  mounting.to_be_judged = use == FusionUse::Calibration;
  odometry::SensorStreams streams;
  if (use == FusionUse::ScansAlone) {
    options.ackermann = options.accelerometer = options.barometer = false;
  } else if (mounting_ins_from_lidar) {
    const RigidTransform vehicle_from_ins = options.vehicle_from_ins() * drive::forward_left_up_from(session.ins_axes);
    mounting.vehicle_from_lidar = vehicle_from_ins * *mounting_ins_from_lidar;
    mounting.vehicle_from_imu = options.vehicle_from_ins() * options.ins_from_imu();
    streams = {session.imu, session.wheels, session.barometer};
    tell_missing(session, options, run.findings);
    tell_mounting(session, options, run.findings);
  } else {
    options.ackermann = options.accelerometer = options.barometer = false;
    if (has_other_sensors(session))
      run.findings.push_back(
          {drive::Severity::Warning, "odometry-scans-only", session.name, say::odometry_scans_only()});
  }
  ScanAhead scans(session, compensates(session, settings, run.findings), run.findings);
  run.odometry = odometry::solve_fusion_odometry(
      session.scans->size(), [&](std::size_t index) { return scans.get(index); }, mounting, streams, options, threads,
      progress);
  const std::vector<odometry::FusedScan>& fused = run.odometry.scans;
  run.odometry_from_lidar = use == FusionUse::Calibration
                                ? odometry::uncorrected_odometry_from_lidar(fused, mounting.vehicle_from_lidar)
                                : odometry::odometry_from_lidar(fused, mounting.vehicle_from_lidar);
  if (use == FusionUse::Calibration) run.untold = odometry::untold_motions(fused, mounting.vehicle_from_lidar);
  run.breaks_ns = breaks_of(fused, use);
  scans.tell_without_times();
  tell_restarts(session, fused, run.findings);
  if (use == FusionUse::ScansAlone || run.odometry.cancelled) return run;
  if (mounting_ins_from_lidar) tell_unused(session, options, fused, run.findings);
  tell_blind(session, fused, use, mounting_ins_from_lidar.has_value(), run.findings);
  return run;
}

std::vector<calibration::Plot> fusion_plots(const drive::Session& session, const FusionRun& run) {
  calibration::Curve path = calibration::line_curve(Message::verbatim(session.name)),
                     height = calibration::line_curve(say::plot_curve_height()),
                     pitch = calibration::line_curve(say::parameter_pitch()),
                     roll = calibration::line_curve(say::parameter_roll()),
                     residual = calibration::line_curve(say::plot_curve_residual());
  const std::vector<odometry::FusedScan>& scans = run.odometry.scans;
  for (const odometry::FusedScan& scan : scans) {
    const double t = seconds(scan.stamp_ns - scans.front().stamp_ns);
    const Eigen::Vector3d at = scan.odometry_from_vehicle.translation();
    const YawPitchRoll angles = yaw_pitch_roll_from_rotation(scan.odometry_from_vehicle.linear());
    path.x.push_back(at.x());
    path.y.push_back(at.y());
    path.z.push_back(at.z());
    for (calibration::Curve* curve : {&height, &pitch, &roll}) curve->x.push_back(t);
    height.y.push_back(at.z());
    height.sigma.push_back(std::sqrt(scan.covariance(2, 2)));
    pitch.y.push_back(radians_to_degrees(angles.pitch_rad));
    roll.y.push_back(radians_to_degrees(angles.roll_rad));
    if (!std::isfinite(scan.residual_m)) continue;  // no feature of the scan lies on the map
    residual.x.push_back(t);
    residual.y.push_back(scan.residual_m);
  }
  const auto of_session = [&](const Message& title) {
    return session.name.empty() ? title : say::plot_of_session(title, session.name);
  };
  std::vector<calibration::Plot> plots{
      {of_session(say::plot_odometry_from_above()), say::plot_axis_start_x(), say::plot_axis_start_y(), true, {path}},
      {of_session(say::plot_height()), say::plot_axis_seconds(), say::plot_axis_start_z(), false, {height}},
      {of_session(say::plot_pitch_and_roll()), say::plot_axis_seconds(), say::plot_axis_angle(), false, {pitch, roll}},
      {of_session(say::plot_scan_to_map()),
       say::plot_axis_seconds(),
       say::plot_axis_rms_of_features(),
       false,
       {residual}}};
  calibration::thin(plots, 2000);
  return plots;
}

std::string odometry_text(const std::vector<motion::StampedPose>& poses) {
  return "# t x y z qx qy qz qw: odometry from lidar, m\n" + formats::tum_text(poses);
}

}  // namespace remount::methods
