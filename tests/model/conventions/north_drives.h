// Drives whose poses are of a grid, with attitudes to its north or to the true one.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/geodesy/geodesy.h"
#include "model/drive/session_frames.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/pipeline.h"
#include "model/simulator/drive_formats.h"
#include "tests/support/findings.h"

namespace remount::conventions::north {

inline constexpr std::size_t kYawOf = 3;

struct Site {
  const char* name;
  double latitude_deg, longitude_deg;
};

inline simulator::SimulatedDrive drive_at(const Site& place, int seed = 1,
                                          simulator::ScenarioKind scenario = simulator::ScenarioKind::FigureEight) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = 40.0;
  options.speed_mps = 7.0;
  options.beams = 1;  // the LiDAR is given by its poses
  options.azimuth_steps = 16;
  options.ins_rate_hz = 50.0;
  options.gnss.rate_hz = 5.0;
  options.latitude_deg = place.latitude_deg;
  options.longitude_deg = place.longitude_deg;
  options.seed = seed;
  return simulator::simulate_drive(options);
}

enum class AttitudesTo { True, Grid };
enum class Origin { Utm, Start };

struct Poses {
  std::vector<motion::StampedPose> world_from_ins;
  double convergence_rad = 0.0;
};

/// A transverse Mercator projection; as close to oblique and conic ones as a convergence needs.
struct NationalGrid {
  const char* name;
  double middle_deg, origin_deg, scale, easting_m, northing_m;
  geodesy::GridFix project(double latitude_rad, double longitude_rad) const {
    constexpr double kUtm_deg = 9.0, kUtmScale = 0.9996, kUtmEasting_m = 5e5;
    const geodesy::UtmGrid utm(degrees_to_radians(origin_deg), degrees_to_radians(kUtm_deg));
    const double turned_rad = degrees_to_radians(kUtm_deg - middle_deg);  // the earth is round
    geodesy::GridFix fix = utm.project(latitude_rad, longitude_rad + turned_rad);
    const geodesy::GridFix origin = utm.project(degrees_to_radians(origin_deg), degrees_to_radians(kUtm_deg));
    fix.easting_m = (fix.easting_m - kUtmEasting_m) * scale / kUtmScale + easting_m;
    fix.northing_m = (fix.northing_m - origin.northing_m) * scale / kUtmScale + northing_m;
    fix.point_scale *= scale / kUtmScale;
    return fix;
  }
};

/// @param ins_turned_rad by which the INS is turned in its vehicle, beside what the simulator has
template <class Grid>
Poses grid_poses(const Grid& grid, const simulator::SimulatedDrive& drive, AttitudesTo north, Origin origin,
                 double ins_turned_rad = 0.0) {
  const std::vector<motion::InsSample>& ins = drive.session.ins;
  const geodesy::GridFix start = grid.project(ins.front().latitude_rad, ins.front().longitude_rad);
  const Eigen::Matrix3d ins_from_turned = rotation_from_yaw_pitch_roll({ins_turned_rad, 0.0, 0.0});
  Poses out;
  out.convergence_rad = start.convergence_rad;
  for (const motion::InsSample& sample : ins) {
    const geodesy::GridFix fix = grid.project(sample.latitude_rad, sample.longitude_rad);
    Eigen::Vector3d at(fix.easting_m, fix.northing_m, sample.height_m);
    if (origin == Origin::Start) at -= Eigen::Vector3d(start.easting_m, start.northing_m, ins.front().height_m);
    const double turned_rad = north == AttitudesTo::Grid ? fix.convergence_rad : 0.0;
    const Eigen::Matrix3d attitude =
        rotation_from_yaw_pitch_roll({turned_rad, 0.0, 0.0}) * sample.enu_from_ins.toRotationMatrix();
    out.world_from_ins.push_back({sample.stamp_ns, make_rigid(attitude * ins_from_turned, at)});
  }
  return out;
}

inline Poses utm_poses(const simulator::SimulatedDrive& drive, AttitudesTo north, Origin origin,
                       double ins_turned_rad = 0.0) {
  const motion::InsSample& start = drive.session.ins.front();
  return grid_poses(geodesy::UtmGrid(start.latitude_rad, start.longitude_rad), drive, north, origin, ins_turned_rad);
}

inline drive::Session session_of(const simulator::SimulatedDrive& drive, const Poses& poses, bool fixes) {
  drive::Session session;
  session.name = "drive";
  session.world_from_ins = poses.world_from_ins;
  session.odometry_from_lidar = simulator::exact_odometry(drive);
  if (fixes) session.gnss = drive.session.gnss;
  return session;
}

inline calibration::CalibrationResult solved(drive::Session session, const std::string& method = "pairwise") {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(std::move(session))};
  Progress progress;
  return method_registry::calibration_method(method).run(input, progress).result;
}

inline double yaw_error_deg(const calibration::CalibrationResult& result, const RigidTransform& truth) {
  return radians_to_degrees(
      wrap_angle_rad(six_from_rigid(result.mounting.reference_from_sensor).yaw_rad - six_from_rigid(truth).yaw_rad));
}

inline double yaw_sigma_deg(const calibration::CalibrationResult& result) {
  return radians_to_degrees(result.estimate(calibration::kParameters[kYawOf]).sigma.value_or(std::nan("")));
}

inline bool tells(const drive::Session& session, const std::string& code) {
  return testing::has_code(session.findings, code);
}

}  // namespace remount::conventions::north
