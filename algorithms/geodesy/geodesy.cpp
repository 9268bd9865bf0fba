#include "algorithms/geodesy/geodesy.h"

#include <GeographicLib/UTMUPS.hpp>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geodesy/earth_radius.h"

namespace remount::geodesy {

UtmGrid::UtmGrid(double latitude_rad, double longitude_rad) {
  double easting_m = 0.0, northing_m = 0.0;
  try {
    GeographicLib::UTMUPS::Forward(radians_to_degrees(latitude_rad), radians_to_degrees(longitude_rad), zone_, north_,
                                   easting_m, northing_m);
  } catch (const std::exception& problem) {
    throw Error(ErrorCode::Contract, "INS position", Message::verbatim(problem.what()));
  }
}

GridFix UtmGrid::project(double latitude_rad, double longitude_rad) const {
  GridFix fix;
  int zone = 0;
  bool north = true;
  double convergence_deg = 0.0;
  try {
    GeographicLib::UTMUPS::Forward(radians_to_degrees(latitude_rad), radians_to_degrees(longitude_rad), zone, north,
                                   fix.easting_m, fix.northing_m, convergence_deg, fix.point_scale, zone_);
  } catch (const std::exception& problem) {
    throw Error(ErrorCode::Contract, "INS position", Message::verbatim(problem.what()));
  }
  // The southern hemisphere's false northing is the only difference between the two halves of a zone.
  if (zone_ > 0 && north != north_) fix.northing_m += north ? 1.0e7 : -1.0e7;
  fix.convergence_rad = degrees_to_radians(convergence_deg);
  return fix;
}

std::optional<GridFix> grid_fix_at(double easting_m, double northing_m, bool northern) {
  constexpr int kAnyZone = 31;
  GridFix fix{easting_m, northing_m, 1.0, 0.0};
  double latitude_deg = 0.0, longitude_deg = 0.0, convergence_deg = 0.0;
  try {
    GeographicLib::UTMUPS::Reverse(kAnyZone, northern, easting_m, northing_m, latitude_deg, longitude_deg,
                                   convergence_deg, fix.point_scale);
  } catch (const std::exception&) {
    return std::nullopt;
  }
  fix.convergence_rad = degrees_to_radians(convergence_deg);
  return fix;
}

double metres_per_grid_metre(double point_scale, double height_m) {
  return (1.0 + height_m / kEarthRadius_m) / point_scale;
}

std::vector<motion::StampedPose> local_from_ins(std::span<const motion::InsSample> samples) {
  std::vector<motion::StampedPose> poses;
  poses.reserve(samples.size());
  if (samples.empty()) return poses;
  const UtmGrid grid(samples.front().latitude_rad, samples.front().longitude_rad);
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  GridFix previous;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const motion::InsSample& sample = samples[i];
    const GridFix fix = grid.project(sample.latitude_rad, sample.longitude_rad);
    if (i > 0) {
      const double mean_scale = 0.5 * (fix.point_scale + previous.point_scale);
      const double mean_height_m = 0.5 * (sample.height_m + samples[i - 1].height_m);
      const double metres = metres_per_grid_metre(mean_scale, mean_height_m);
      position_m.x() += (fix.easting_m - previous.easting_m) * metres;
      position_m.y() += (fix.northing_m - previous.northing_m) * metres;
      position_m.z() += sample.height_m - samples[i - 1].height_m;
    }
    // A direction of true azimuth A has grid azimuth A - convergence: a counter-clockwise turn by the convergence.
    const Eigen::Matrix3d grid_from_enu = rotation_from_yaw_pitch_roll({fix.convergence_rad, 0.0, 0.0});
    poses.push_back({sample.stamp_ns, make_rigid(grid_from_enu * sample.enu_from_ins.toRotationMatrix(), position_m)});
    previous = fix;
  }
  return poses;
}

}  // namespace remount::geodesy
