// Latitude and longitude, and earth-centred coordinates, where metres are expected.
#include "model/conventions/pose_units.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/drive/session_frames.h"
#include "model/formats/session_readers.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::conventions {
namespace {

simulator::SimulatedDrive driven_somewhere(double latitude_deg, double longitude_deg) {
  simulator::SimulationOptions options;
  options.scenario = simulator::ScenarioKind::FigureEight;
  options.duration_s = 20.0;
  options.beams = 1;
  options.azimuth_steps = 16;
  options.ins_rate_hz = 20.0;
  options.latitude_deg = latitude_deg;
  options.longitude_deg = longitude_deg;
  return simulator::simulate_drive(options);
}

enum class Written { LatitudeFirst, LongitudeFirst, Radians, EarthCentred };

Eigen::Vector3d written(const motion::InsSample& sample, Written as) {
  const double latitude = radians_to_degrees(sample.latitude_rad), longitude = radians_to_degrees(sample.longitude_rad);
  if (as == Written::LatitudeFirst) return {latitude, longitude, sample.height_m};
  if (as == Written::LongitudeFirst) return {longitude, latitude, sample.height_m};
  if (as == Written::Radians) return {sample.latitude_rad, sample.longitude_rad, sample.height_m};
  const double a = 6378137.0, e2 = 0.00669437999014, s = std::sin(sample.latitude_rad),
               c = std::cos(sample.latitude_rad);
  const double n = a / std::sqrt(1.0 - e2 * s * s);
  return {(n + sample.height_m) * c * std::cos(sample.longitude_rad),
          (n + sample.height_m) * c * std::sin(sample.longitude_rad), (n * (1.0 - e2) + sample.height_m) * s};
}

std::string opening(const simulator::SimulatedDrive& drive, Written as) {
  std::vector<motion::StampedPose> poses;
  for (const motion::InsSample& sample : drive.session.ins)
    poses.push_back({sample.stamp_ns, make_rigid(sample.enu_from_ins.toRotationMatrix(), written(sample, as))});
  const formats::TemporaryFolder folder;
  folder.write("ins.txt", formats::tum_text(poses));
  folder.write("lidar.txt", formats::tum_text(simulator::exact_odometry(drive)));
  Progress progress;
  return formats::error_of([&] { formats::open_session(folder.path(), progress); });
}

TEST(pose_units, degrees_radians_and_earth_centred_positions_are_refused_by_name) {
  for (const auto& [latitude_deg, longitude_deg] :
       {std::pair{22.3, 114.17}, std::pair{48.8, 9.2}, std::pair{-33.9, 151.2}, std::pair{0.4, -0.3}}) {
    const simulator::SimulatedDrive drive = driven_somewhere(latitude_deg, longitude_deg);
    EXPECT_TRUE(formats::contains(opening(drive, Written::LatitudeFirst), "look like degrees")) << latitude_deg;
    EXPECT_TRUE(formats::contains(opening(drive, Written::LongitudeFirst), "look like degrees")) << latitude_deg;
    EXPECT_TRUE(formats::contains(opening(drive, Written::Radians), "look like ")) << opening(drive, Written::Radians);
    EXPECT_TRUE(formats::contains(opening(drive, Written::EarthCentred), "earth-centred")) << latitude_deg;
  }
}

TEST(pose_units, metres_are_taken_wherever_the_drive_is_and_however_little_it_moves) {
  const simulator::SimulatedDrive drive =
      driven_somewhere(57.2, -5.0);  // where northings of UTM are as large as the earth's radius
  drive::Session session;
  session.world_from_ins = drive::metric_poses(drive.session);
  EXPECT_NO_THROW(refuse_foreign_units(session));
  drive::Session on_grid = session;
  for (motion::StampedPose& pose : on_grid.world_from_ins)
    pose.pose.translation() += Eigen::Vector3d(380e3, 6.34e6, 90.0);
  EXPECT_NO_THROW(refuse_foreign_units(on_grid));
  for (const double share : {1e-1, 1e-2, 1e-3, 0.0}) {  // a rig that is moved by hand, or stands
    drive::Session slow = session;
    for (motion::StampedPose& pose : slow.world_from_ins) pose.pose.translation() *= share;
    EXPECT_NO_THROW(refuse_foreign_units(slow)) << share;
  }
}

}  // namespace
}  // namespace remount::conventions
