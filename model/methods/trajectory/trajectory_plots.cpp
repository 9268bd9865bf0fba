#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "messages/plots.h"
#include "model/methods/trajectory/trajectory_method.h"

namespace remount::methods {
namespace {

calibration::Plot parameters_against_time(const std::vector<calibration::TrajectorySnapshot>& history, bool angles) {
  calibration::Plot plot;
  plot.x_label = say::plot_axis_time();
  plot.title = angles ? say::plot_angles_while_data_arrived() : say::plot_translation_while_data_arrived();
  plot.y_label = angles ? say::plot_axis_degrees() : say::plot_axis_metres();
  const double unit = angles ? 180.0 / kPi : 1.0;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    if (calibration::is_angle(parameter) != angles) continue;
    calibration::Curve curve;
    curve.name = calibration::parameter_word(parameter);
    for (const calibration::TrajectorySnapshot& snapshot : history) {
      if (!snapshot.known || !snapshot.sigma[parameter]) continue;
      curve.x.push_back(snapshot.time_s);
      curve.y.push_back(unit * calibration::parameters_of(snapshot.mounting.reference_from_sensor)[parameter]);
      curve.sigma.push_back(unit * *snapshot.sigma[parameter]);
    }
    // What hardly any answer observes makes no curve.
    if (!curve.x.empty() && 10 * curve.x.size() >= history.size()) plot.curves.push_back(std::move(curve));
  }
  return plot;
}

void add_point(const Eigen::Vector3d& at, calibration::Curve& curve) {
  curve.x.push_back(at.x());
  curve.y.push_back(at.y());
  curve.z.push_back(at.z());
}

// Three sigma of the horizontal position, around some of the fixes.
calibration::Curve ellipses(const calibration::TrajectorySession& session) {
  constexpr std::size_t kMost = 25;
  constexpr int kPoints = 24;
  calibration::Curve curve;
  curve.name = say::plot_curve_sigma_of_fixes();
  curve.dots = true;
  std::vector<const calibration::AntennaObservation*> fixes;
  for (const calibration::TrajectoryEpoch& epoch : session.epochs)
    if (epoch.antenna) fixes.push_back(&*epoch.antenna);
  const std::size_t step = std::max<std::size_t>(1, fixes.size() / kMost);
  for (std::size_t k = 0; k < fixes.size(); k += step) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(fixes[k]->covariance_enu_m2.topLeftCorner<2, 2>());
    const Eigen::Matrix2d root = eigen.operatorSqrt();
    for (int i = 0; i < kPoints; ++i) {
      const double angle = 2.0 * kPi * i / kPoints;
      const Eigen::Vector2d at =
          fixes[k]->position_enu_m.head<2>() + 3.0 * root * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      curve.x.push_back(at.x());
      curve.y.push_back(at.y());
      curve.z.push_back(fixes[k]->position_enu_m.z());
    }
  }
  return curve;
}

// What was measured, where the odometry alone would have led from the start, and the aligned trajectory: of the
// antenna where there are fixes, else of the INS.
calibration::Plot trajectory_map(const calibration::TrajectorySession& session, std::size_t index,
                                 const calibration::TrajectoryState& state, bool several) {
  const bool antenna = std::any_of(session.epochs.begin(), session.epochs.end(),
                                   [](const calibration::TrajectoryEpoch& epoch) { return epoch.antenna.has_value(); });
  calibration::Plot plot;
  plot.title = say::plot_trajectory_before_and_after();
  if (several) plot.title = say::plot_of_session_number(plot.title, index + 1);
  plot.x_label = say::plot_axis_east();
  plot.y_label = say::plot_axis_north();
  plot.equal_axes = true;
  calibration::Curve measured, before, after;
  measured.name = antenna ? say::plot_curve_gnss_fixes() : say::plot_curve_ins();
  measured.dots = true;
  before.name = say::plot_curve_laid_odometry();
  after.name = say::plot_curve_aligned();
  const Eigen::Vector3d in_lidar =
      antenna ? state.antenna_in_lidar : Eigen::Vector3d(state.ins_from_lidar.inverse().translation());
  const std::vector<RigidTransform>& poses = state.enu_from_lidar[index];
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const calibration::TrajectoryEpoch& epoch = session.epochs[i];
    if (antenna && epoch.antenna) add_point(epoch.antenna->position_enu_m, measured);
    if (!antenna && epoch.ins) add_point(epoch.ins->enu_from_ins.translation(), measured);
    const RigidTransform laid =
        poses.front() * session.epochs.front().odometry_from_lidar.inverse() * epoch.odometry_from_lidar;
    add_point(laid * in_lidar, before);
    add_point(poses[i] * in_lidar, after);
  }
  plot.curves = {before, after, measured};
  if (antenna) plot.curves.push_back(ellipses(session));
  return plot;
}

}  // namespace

std::vector<calibration::Plot> trajectory_plots(const TrajectoryFeed& feed,
                                                const calibration::TrajectoryOutcome& outcome) {
  constexpr std::size_t kMostMaps = 6, kMostPoints = 2000;  // more show nothing more, however long the drive
  std::vector<calibration::Plot> plots;
  for (const bool angles : {false, true}) {
    calibration::Plot plot = parameters_against_time(feed.history(), angles);
    if (!plot.curves.empty()) plots.push_back(std::move(plot));
  }
  const std::vector<calibration::TrajectorySession>& sessions = feed.problem().sessions;
  const calibration::TrajectoryState& state = outcome.solution.state;
  for (std::size_t s = 0; s < std::min(kMostMaps, sessions.size()) && s < state.enu_from_lidar.size(); ++s)
    if (!state.enu_from_lidar[s].empty()) plots.push_back(trajectory_map(sessions[s], s, state, sessions.size() > 1));
  calibration::thin(plots, kMostPoints);
  return plots;
}

}  // namespace remount::methods
