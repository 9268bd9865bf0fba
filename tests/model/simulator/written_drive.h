// Simulated drives as they are written, read again and calibrated.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <string>

#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/session_readers.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/captured_sensor.h"
#include "model/simulator/lidar_model.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/calibration_checks.h"

namespace remount::simulator {

// ---- Written and read

inline std::filesystem::path drive_in(const formats::TemporaryFolder& folder) { return folder.path() / "drive"; }

inline drive::Session read_back(const SimulatedDrive& drive, const std::string& format,
                                const formats::TemporaryFolder& folder) {
  Progress progress;
  write_drive(drive, drive_in(folder), format, 1, progress);
  return formats::open_session(drive_in(folder), progress);
}

/// Where the sensors are, as truth.yaml says beside a drive that was written.
inline formats::DocumentNode truth_in(const formats::TemporaryFolder& folder) {
  return formats::read_document(drive_in(folder) / "truth.yaml");
}

inline RigidTransform true_mounting(const formats::TemporaryFolder& folder) {
  const formats::DocumentNode root = truth_in(folder);
  return formats::transform_from_document(formats::DocumentView(*root.find("ins_from_lidar"), "truth.yaml"));
}

inline SimulationOptions lasting(double duration_s) {
  SimulationOptions options;
  options.duration_s = duration_s;
  return options;
}

/// Of a LiDAR with few rays, where scans do not count.
inline SimulationOptions with_few_rays(double duration_s = 3.0) {
  SimulationOptions options = lasting(duration_s);
  options.beams = 8;
  options.azimuth_steps = 90;
  return options;
}

/// The same south of the equator and west of Greenwich.
inline SimulationOptions in_the_south_west() {
  SimulationOptions options = with_few_rays();
  options.latitude_deg = -33.9;
  options.longitude_deg = -70.6;
  return options;
}

/// Of formats whose publishers compensate their scans for motion.
inline bool has_compensated_scans(std::string_view format) {
  return format == "kitti-odometry" || format == "nuscenes";
}

/// Long enough for trajectories.
inline SimulationOptions parking_ramp() {
  SimulationOptions options = with_few_rays(40.0);
  options.scenario = ScenarioKind::ParkingRamp;
  return options;
}

// ---- What is read against what was simulated

/// The larger one; NaN where one of them is.
inline double worse_of(double a, double b) { return std::isnan(a) || b <= a ? a : b; }

/// Largest differences of the samples of an INS.
struct SampleErrors {
  double latitude_rad = 0.0, longitude_rad = 0.0, height_m = 0.0, turned_rad = 0.0;
};

/// Expects as many samples of the same stamps. @param written_from_read axes of the INS
inline SampleErrors sample_errors(const std::vector<motion::InsSample>& read,
                                  const std::vector<motion::InsSample>& written,
                                  const Eigen::Quaterniond& written_from_read = Eigen::Quaterniond::Identity()) {
  SampleErrors worst;
  EXPECT_EQ(read.size(), written.size());
  std::size_t other_stamps = 0;
  for (std::size_t i = 0; i < std::min(read.size(), written.size()); ++i) {
    other_stamps += read[i].stamp_ns != written[i].stamp_ns;
    worst.latitude_rad = worse_of(worst.latitude_rad, std::abs(read[i].latitude_rad - written[i].latitude_rad));
    worst.longitude_rad = worse_of(worst.longitude_rad, std::abs(read[i].longitude_rad - written[i].longitude_rad));
    worst.height_m = worse_of(worst.height_m, std::abs(read[i].height_m - written[i].height_m));
    worst.turned_rad =
        worse_of(worst.turned_rad, read[i].enu_from_ins.angularDistance(written[i].enu_from_ins * written_from_read));
  }
  EXPECT_EQ(other_stamps, 0U) << "of " << read.size();
  std::cout << read.size() << " samples: at most " << worst.latitude_rad << " and " << worst.longitude_rad << " rad, "
            << worst.height_m << " m, attitudes " << worst.turned_rad << " rad off\n";
  return worst;
}

/// A point with its time since the start of the drive.
struct TimedPoint {
  double time_s = 0.0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  int ring = -1;  ///< -1: not known
};

inline std::vector<TimedPoint> timed_points(const drive::ScanSource& scans) {
  std::vector<TimedPoint> points;
  for (std::size_t scan = 0; scan < scans.size(); ++scan) {
    const cloud::PointCloud cloud = scans.load(scan);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      points.push_back({1e-9 * static_cast<double>(scans.stamp_ns(scan) - kDriveStart_ns) +
                            static_cast<double>(cloud.time_from_stamp_s.at(i)),
                        cloud.points[i].cast<double>(), cloud.ring.empty() ? -1 : cloud.ring[i]});
  }
  return points;
}

inline std::vector<TimedPoint> timed_points(const CapturedSensor& sensor, const Scene& scene) {
  std::vector<TimedPoint> points;
  for (std::size_t packet = 0; packet < sensor.packets(scene.options()); ++packet)
    for (const PacketReturn& found : sensor.returns(scene, packet))
      points.push_back({found.time_s, found.point, found.ring});
  return points;
}

/// Largest differences of points, one after the other.
struct PointErrors {
  std::size_t read = 0, simulated = 0, of_other_rings = 0;
  double worst_m = std::numeric_limits<double>::infinity(), worst_s = worst_m;
};

/// Points that are missing are those at the end.
inline PointErrors point_errors(const std::string& format, const std::vector<TimedPoint>& read,
                                const std::vector<TimedPoint>& simulated) {
  PointErrors errors{read.size(), simulated.size(), 0, 0.0, 0.0};
  EXPECT_LE(read.size(), simulated.size()) << format;
  for (std::size_t i = 0; i < std::min(read.size(), simulated.size()); ++i) {
    errors.worst_m = worse_of(errors.worst_m, (read[i].point - simulated[i].point).norm());
    errors.worst_s = worse_of(errors.worst_s, std::abs(read[i].time_s - simulated[i].time_s));
    errors.of_other_rings += read[i].ring != simulated[i].ring;
  }
  std::cout << format << ": " << errors.read << " of " << errors.simulated << " points: at most "
            << 1e3 * errors.worst_m << " mm and " << 1e6 * errors.worst_s << " us off\n";
  return errors;
}

/// Of a drive with a sensor in place of its LiDAR. Expects all scans, rings and samples of the INS.
inline PointErrors point_errors(const CapturedSensor& sensor, double duration_s) {
  const SimulatedDrive drive = simulate_drive(lasting(duration_s));
  const Scene& scene = *scene_of(drive.session.scans);
  const std::string format(sensor.format);
  const formats::TemporaryFolder folder;
  const drive::Session session = read_back(drive, format, folder);
  EXPECT_EQ(session.ins.size(), drive.session.ins.size());
  EXPECT_TRUE(session.scans);
  if (!session.scans) return {};
  EXPECT_EQ(session.scans->size(), static_cast<std::size_t>(std::lround(duration_s * scene.options().scan_rate_hz)));
  const PointErrors errors = point_errors(format, timed_points(*session.scans), timed_points(sensor, scene));
  EXPECT_EQ(errors.of_other_rings, 0U);
  return errors;
}

// ---- Calibrated

using Calibrate = calibration::CalibrationResult (*)(const pipeline::PipelineInput& input, Progress& progress);

inline calibration::CalibrationResult by_pairs(const pipeline::PipelineInput& input, Progress& progress) {
  return pipeline::run_pipeline(input, progress).result;
}
inline calibration::CalibrationResult by_trajectories(const pipeline::PipelineInput& input, Progress& progress) {
  return method_registry::calibration_method("trajectory").run(input, progress).result;
}

/// A drive that was written in a format and read again.
struct CalibratedDrive {
  calibration::CalibrationResult result;
  RigidTransform truth;  ///< ins_from_lidar, as it stands beside the drive
  testing::CalibrationError error;
};

inline CalibratedDrive calibrated(const SimulatedDrive& drive, const std::string& format, Calibrate calibrate,
                                  const std::optional<RigidTransform>& nominal_ins_from_lidar = std::nullopt) {
  const formats::TemporaryFolder folder;
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<drive::Session>(read_back(drive, format, folder))};
  input.nominal_ins_from_lidar = nominal_ins_from_lidar;
  input.settings.run.map_check = false;
  Progress progress;
  CalibratedDrive out;
  out.result = calibrate(input, progress);
  out.truth = true_mounting(folder);
  out.error = testing::error_of(out.result, out.truth);
  return out;
}

/// On a ramp, with the nominal known; error_of prints what is measured. Packets of every make give a short drive with
/// few beams back to 0.015 degrees and 2 mm in x and y. The limits leave room for other drives, and are far below what
/// directions or times do that are read wrongly.
inline void expect_calibrated_on_ramp(SimulationOptions options, const std::string& format) {
  options.scenario = ScenarioKind::ParkingRamp;
  const CalibratedDrive found = calibrated(simulate_drive(options), format, by_pairs, options.ins_from_lidar);
  EXPECT_LT(found.error.rotation_deg, 0.1);
  EXPECT_LT(std::hypot(found.error.x_m, found.error.y_m), 0.05);
}

}  // namespace remount::simulator
