#include "model/methods/fusion_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>

#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"
#include "model/session_frames.h"

namespace remount {
namespace {

bool compensates(const Session& session, const Settings& settings, std::vector<Finding>& findings) {
  if (settings.run.deskew == DeskewMode::Off || !settings.fusion.deskew) return false;
  if (session.scan_timing == ScanTiming::PerPoint) return true;
  if (session.scan_timing != ScanTiming::SweepAzimuth) return false;
  if (session.sweep.certain || settings.run.deskew == DeskewMode::On) return true;
  findings.push_back({Severity::Note, "odometry-deskew-off", session.name,
                      "The format does not say whether its scans are compensated for motion: the odometry uses them as "
                      "they are. Set run.deskew=on to compensate them."});
  return false;
}

OdometryScan load_scan(const Session& session, std::size_t index, bool compensated) {
  OdometryScan scan;
  scan.stamp_ns = session.scans->stamp_ns(index);
  scan.cloud_in_lidar = session.scans->load(index);
  if (!compensated) return scan;
  if (session.scan_timing == ScanTiming::SweepAzimuth)
    scan.time_from_stamp_s = sweep_times(scan.cloud_in_lidar, session.sweep.period_s, session.sweep.stamp_azimuth_rad,
                                         session.sweep.clockwise);
  else if (scan.cloud_in_lidar.time_from_stamp_s.size() == scan.cloud_in_lidar.size())
    scan.time_from_stamp_s = scan.cloud_in_lidar.time_from_stamp_s;
  return scan;
}

/// Reads one scan ahead, since reading takes about as long as the odometry.
class ScanAhead {
 public:
  ScanAhead(const Session& session, bool compensated, std::vector<Finding>& findings)
      : session_(session), compensated_(compensated), findings_(findings) {}

  OdometryScan get(std::size_t index) {
    if (!next_.valid()) ask(index);
    OdometryScan scan;
    try {
      scan = next_.get();
    } catch (const Error& error) {
      findings_.push_back({Severity::Warning, "scan-unreadable", session_.name,
                           std::string(error.what()) + " Its pose is the prediction of the odometry."});
      scan.stamp_ns = session_.scans->stamp_ns(index);
    }
    if (index + 1 < session_.scans->size()) ask(index + 1);
    return scan;
  }

 private:
  void ask(std::size_t index) {
    next_ = std::async(std::launch::async, [this, index] { return load_scan(session_, index, compensated_); });
  }
  const Session& session_;
  bool compensated_;
  std::vector<Finding>& findings_;
  std::future<OdometryScan> next_;
};

void tell_missing(const Session& session, const FusionOptions& options, std::vector<Finding>& findings) {
  std::string missing;
  const auto add = [&missing](const char* what) { missing += (missing.empty() ? "" : ", ") + std::string(what); };
  const auto has_force = [](const ImuSample& sample) { return sample.specific_force_mps2.allFinite(); };
  if (options.ackermann && session.wheels.empty()) add("wheel speeds");
  if (options.ackermann && session.imu.empty()) add("angular rates");
  if (options.accelerometer && std::none_of(session.imu.begin(), session.imu.end(), has_force)) add("accelerations");
  if (options.barometer && session.barometer.empty()) add("a barometer");
  if (!missing.empty())
    findings.push_back({Severity::Note, "odometry-without", session.name,
                        "The session has no " + missing + ": the odometry does without."});
}

void tell_blind(const Session& session, const std::vector<FusedScan>& scans, std::vector<Finding>& findings) {
  std::size_t blind = 0, guessed = 0;
  for (std::size_t i = 1; i < scans.size(); ++i)
    if (!scans[i].undetermined.empty()) ++(scans[i].dead_reckoned ? blind : guessed);
  const std::string of = " of " + std::to_string(scans.size()) + " scans do not tell of every direction of the motion";
  if (blind > 0)
    findings.push_back({Severity::Note, "odometry-by-wheels", session.name,
                        std::to_string(blind) + of + "; there it rests on wheels and gyroscope."});
  if (guessed > 0)
    findings.push_back(
        {Severity::Warning, "odometry-guessed", session.name,
         std::to_string(guessed) + of +
             ", nor do wheels: there a steady motion was assumed, and poses may be far off. Record wheel "
             "speeds, or drive where there is more to see."});
}

}  // namespace

FusionRun run_fusion_odometry(const Session& session, const std::optional<RigidTransform>& nominal_ins_from_lidar,
                              const Settings& settings, int threads, Progress& progress) {
  if (!session.scans || session.scans->size() == 0)
    throw Error(ErrorCode::Unsupported, session.name, "has no scans; the multi-sensor odometry needs them");
  FusionRun run;
  FusionOptions options = settings.fusion;
  FusionMounting mounting;
  SensorStreams streams;
  if (nominal_ins_from_lidar) {
    const RigidTransform vehicle_from_ins = options.vehicle_from_ins() * forward_left_up_from(session.ins_axes);
    mounting.vehicle_from_lidar = vehicle_from_ins * *nominal_ins_from_lidar;
    mounting.vehicle_from_imu = options.vehicle_from_ins() * options.ins_from_imu();
    streams = {session.imu, session.wheels, session.barometer};
    tell_missing(session, options, run.findings);
  } else {
    options.ackermann = options.accelerometer = options.barometer = false;
    run.findings.push_back({Severity::Warning, "odometry-scans-only", session.name,
                            "Without a nominal mounting the odometry uses the scans alone. Give --nominal to use "
                            "wheels, IMU and barometer as well."});
  }
  ScanAhead scans(session, compensates(session, settings, run.findings), run.findings);
  run.odometry = solve_fusion_odometry(
      session.scans->size(), [&](std::size_t index) { return scans.get(index); }, mounting, streams, options, threads,
      progress);
  run.odometry_from_lidar = odometry_from_lidar(run.odometry.scans, mounting.vehicle_from_lidar);
  tell_blind(session, run.odometry.scans, run.findings);
  return run;
}

std::vector<Plot> fusion_plots(const Session& session, const FusionRun& run) {
  Curve path{session.name, {}, {}, {}, false}, height{"height", {}, {}, {}, false};
  Curve pitch{"pitch", {}, {}, {}, false}, roll{"roll", {}, {}, {}, false}, residual{"residual", {}, {}, {}, false};
  const std::vector<FusedScan>& scans = run.odometry.scans;
  for (const FusedScan& scan : scans) {
    const double t = static_cast<double>(scan.stamp_ns - scans.front().stamp_ns) * 1e-9;
    const Eigen::Vector3d at = scan.odometry_from_vehicle.translation();
    const YawPitchRoll angles = yaw_pitch_roll_from_rotation(scan.odometry_from_vehicle.linear());
    path.x.push_back(at.x());
    path.y.push_back(at.y());
    for (Curve* curve : {&height, &pitch, &roll, &residual}) curve->x.push_back(t);
    height.y.push_back(at.z());
    height.sigma.push_back(std::sqrt(scan.covariance(2, 2)));
    pitch.y.push_back(radians_to_degrees(angles.pitch_rad));
    roll.y.push_back(radians_to_degrees(angles.roll_rad));
    residual.y.push_back(std::isfinite(scan.residual_m) ? scan.residual_m : 0.0);
  }
  const std::string name = session.name.empty() ? "" : ": " + session.name;
  std::vector<Plot> plots{{"Odometry from above" + name, "forward from the start [m]", "left of it [m]", true, {path}},
                          {"Height" + name, "time [s]", "height above the start [m]", false, {height}},
                          {"Pitch and roll" + name, "time [s]", "angle [deg]", false, {pitch, roll}},
                          {"Scan to map" + name, "time [s]", "median distance of features [m]", false, {residual}}};
  thin(plots, 2000);
  return plots;
}

std::string tum_text(const std::vector<StampedPose>& poses) {
  std::string text = "# t x y z qx qy qz qw: odometry from lidar, m\n";
  for (const StampedPose& stamped : poses) {
    const Eigen::Quaterniond q(stamped.pose.linear());
    const Eigen::Vector3d t = stamped.pose.translation();
    char line[256];
    std::snprintf(line, sizeof line, "%lld.%09lld %.9f %.9f %.9f %.12f %.12f %.12f %.12f\n",
                  static_cast<long long>(stamped.stamp_ns / 1000000000),
                  static_cast<long long>(stamped.stamp_ns % 1000000000), t.x(), t.y(), t.z(), q.x(), q.y(), q.z(),
                  q.w());
    text += line;
  }
  return text;
}

}  // namespace remount
