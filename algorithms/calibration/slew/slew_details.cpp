#include "algorithms/calibration/slew/slew_details.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/calibration/plot_curves.h"
#include "algorithms/core/index.h"
#include "messages/plots.h"
#include "messages/quantities.h"

namespace remount::calibration {

using Eigen::Vector3d;

void name_slew_quantities(SlewResult& result) {
  const CircleFit& circle = result.circle;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  auto& list = result.quantities;
  const std::array<std::pair<const char*, Message>, 3> centre{{{"slew centre x", say::quantity_slew_centre_x()},
                                                               {"slew centre y", say::quantity_slew_centre_y()},
                                                               {"slew centre z", say::quantity_slew_centre_z()}}};
  for (int k = 0; k < 3; ++k) {
    const auto& [id, name] = centre[index_at(k)];
    list.push_back({id, name, result.axis.centre_in_lidar_m[k], std::sqrt(result.axis.covariance(k, k)), "m", true});
  }
  list.push_back({"slew radius", say::quantity_slew_radius(), circle.radius_m, circle.radius_sigma_m, "m", true});
  list.push_back({"arc", say::quantity_arc(), circle.arc_rad, kNone, "rad", true});
  list.push_back({"circle residual", say::quantity_circle_residual(), circle.in_plane_rms_m, kNone, "m", true});
  list.push_back(
      {"turn plane residual", say::quantity_turn_plane_residual(), circle.off_plane_rms_m, kNone, "m", true});
  if (result.ground.found) {
    list.push_back({"ground residual", say::quantity_ground_residual(), result.ground.rms_m, kNone, "m", true});
    list.push_back({"angle between ground and turn", say::quantity_angle_between_ground_and_turn(),
                    result.ground_to_turn_rad, result.ground_to_turn_sigma_rad, "rad", true});
  }
  list.push_back({"arm residual", say::quantity_arm_residual(), result.arm.rms_m, kNone, "m", true});
  list.push_back({"angle between arm and first plane", say::quantity_angle_between_arm_and_first_plane(),
                  0.5 * kPi - result.arm_square_error_rad, kNone, "rad", true});
}

void draw_slew(const SlewData& data, SlewResult& result) {
  const RigidTransform& machine_from_lidar = result.calibration.mounting.between(BodyFrame::Machine, BodyFrame::Lidar);
  Curve poses = dot_curve(say::plot_curve_lidar()), circle = line_curve(say::plot_curve_fitted_circle()),
        centre = dot_curve(say::plot_curve_slew_axis());
  Curve off = dot_curve(say::plot_curve_from_circle()), high = dot_curve(say::plot_curve_from_plane());
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
  result.plots.push_back({.title = say::plot_turn_about_slew_axis(),
                          .x_label = say::plot_axis_x(),
                          .y_label = say::plot_axis_y(),
                          .equal_axes = true,
                          .curves = {poses, circle, centre}});
  result.plots.push_back({.title = say::plot_distance_from_circle(),
                          .x_label = say::plot_axis_slew_angle(),
                          .y_label = say::plot_axis_millimetres(),
                          .curves = {off, high}});
}

}  // namespace remount::calibration
