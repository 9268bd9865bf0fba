#include "algorithms/calibration/slew/slew_details.h"

#include <array>
#include <cmath>
#include <limits>

#include "algorithms/calibration/plot_curves.h"

namespace remount {

using Eigen::Vector3d;

void name_slew_quantities(SlewResult& result) {
  const CircleFit& circle = result.circle;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  auto& list = result.quantities;
  constexpr std::array<const char*, 3> kCentre{"slew centre x", "slew centre y", "slew centre z"};
  for (int k = 0; k < 3; ++k)
    list.push_back({kCentre[static_cast<std::size_t>(k)], result.axis.centre_in_lidar_m[k],
                    std::sqrt(result.axis.covariance(k, k)), "m", true});
  list.push_back({"slew radius", circle.radius_m, circle.radius_sigma_m, "m", true});
  list.push_back({"arc", circle.arc_rad, kNone, "rad", true});
  list.push_back({"circle residual", circle.in_plane_rms_m, kNone, "m", true});
  list.push_back({"turn plane residual", circle.off_plane_rms_m, kNone, "m", true});
  if (result.ground.found) {
    list.push_back({"ground residual", result.ground.rms_m, kNone, "m", true});
    list.push_back(
        {"angle between ground and turn", result.ground_to_turn_rad, result.ground_to_turn_sigma_rad, "rad", true});
  }
  list.push_back({"arm residual", result.arm.rms_m, kNone, "m", true});
  list.push_back({"angle between arm and first plane", 0.5 * kPi - result.arm_square_error_rad, kNone, "rad", true});
}

void draw_slew(const SlewData& data, SlewResult& result) {
  const RigidTransform& machine_from_lidar = result.calibration.mounting.between(BodyFrame::Machine, BodyFrame::Lidar);
  Curve poses = dot_curve("LiDAR"), circle = line_curve("fitted circle"), centre = dot_curve("slew axis");
  Curve off = dot_curve("from the circle"), high = dot_curve("from its plane");
  const Vector3d middle = machine_from_lidar * result.circle.centre_m;
  const Vector3d axis = machine_from_lidar.linear() * result.circle.axis;
  for (const RigidTransform& pose : data.first_from_lidar) {
    const Vector3d at = machine_from_lidar * pose.translation();
    poses.x.push_back(at.x());
    poses.y.push_back(at.y());
    poses.z.push_back(at.z());
    const Vector3d out = pose.translation() - result.circle.centre_m;
    const double along = out.dot(result.circle.axis);
    const double angle = std::atan2(at.y() - middle.y(), at.x() - middle.x());
    off.x.push_back(radians_to_degrees(angle));
    high.x.push_back(radians_to_degrees(angle));
    off.y.push_back(1e3 * ((out - along * result.circle.axis).norm() - result.circle.radius_m));
    high.y.push_back(1e3 * along);
  }
  for (int i = 0; i <= 180; ++i) {
    const double angle = 2.0 * kPi * i / 180.0;
    const double x = result.circle.radius_m * std::cos(angle), y = result.circle.radius_m * std::sin(angle);
    circle.x.push_back(middle.x() + x);
    circle.y.push_back(middle.y() + y);
    circle.z.push_back(middle.z() - (axis.x() * x + axis.y() * y) / axis.z());  // in the plane of the turn
  }
  centre.x = {middle.x()};
  centre.y = {middle.y()};
  centre.z = {middle.z()};
  result.plots.push_back({.title = "Turn of the LiDAR about the slew axis",
                          .x_label = "x (m)",
                          .y_label = "y (m)",
                          .equal_axes = true,
                          .curves = {poses, circle, centre}});
  result.plots.push_back({.title = "Distance from the fitted circle",
                          .x_label = "slew angle (deg)",
                          .y_label = "mm",
                          .curves = {off, high}});
}

}  // namespace remount
