// Where the vehicle drives: a smooth line in the plane, and the vehicle standing on the ground along it.
#pragma once

#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "model/simulator/ground.h"
#include "model/simulator/simulation_options.h"

namespace remount::simulator {

/// The road's centre line in the road frame: it starts at the origin towards +x; z is up. Its direction swings as
/// yaw(s) = amplitude * sin(2 pi s / period), which meanders for amplitudes up to 2 rad and closes to a figure of eight
/// at the first zero of the Bessel function J0, 2.4048 rad. The line repeats, so any length of drive needs one period
/// of memory.
class Road {
 public:
  Road(ScenarioKind scenario, double speed_mps);

  double yaw_rad(double along_m) const;
  Eigen::Vector2d point_in_road(double along_m) const;
  /// Beside the line: `left_m` is positive to the left.
  Eigen::Vector2d point_in_road(double along_m, double left_m) const;
  bool closed() const { return closed_; }
  double period_m() const { return period_m_; }

 private:
  Eigen::Vector2d integral(double from_m, double to_m) const;

  double amplitude_rad_ = 0.0;
  double period_m_ = 100.0;
  bool closed_ = false;
  std::vector<Eigen::Vector2d> knots_;
};

/// The ground of a scenario; the seed chooses the phases of its waves.
Ground scenario_ground(ScenarioKind scenario, int seed);

/// Vehicle frame: middle of the rear axle on the ground, x forward, y left, z up. Its attitude follows the ground under
/// its four wheels.
RigidTransform road_from_vehicle(const Road& road, const Ground& ground, double along_m);

/// Between the middles of the wheels of an axle.
inline constexpr double kTrack_m = 1.6;

/// Where the INS is fitted: on the floor of a car, beside the cab on the upper body of an excavator.
inline RigidTransform vehicle_from_ins(ScenarioKind scenario = ScenarioKind::Street) {
  const bool excavator = scenario == ScenarioKind::SlewYard;
  return make_rigid(Eigen::Matrix3d::Identity(),
                    excavator ? Eigen::Vector3d(-0.3, -1.0, 2.2) : Eigen::Vector3d(0.4, 0.0, 0.8));
}

}  // namespace remount::simulator
