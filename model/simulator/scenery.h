// What stands beside the road, and the cars that drive on it.
#pragma once

#include <vector>

#include "model/simulator/road.h"
#include "model/simulator/world.h"

namespace remount::simulator {

/// Buildings with bays and doorways, poles, tree trunks, parked cars and kerbs along both sides; nothing on the two
/// lanes.
World build_world(const Road& road, const Ground& ground, double length_m, int seed);

/// Body and cabin of a car that stands at a place of the road frame.
std::vector<Box> car_boxes(const Eigen::Vector2d& centre, double yaw_rad, double ground_m);

/// Cars that move along the road: oncoming ones in the other lane, one ahead.
class Traffic {
 public:
  Traffic(const Road& road, const Ground& ground, const SimulationOptions& options);

  /// Boxes of the cars within reach_m of `from` at a time of the drive.
  std::vector<Box> boxes_at(double time_s, const Eigen::Vector2d& from, double reach_m) const;
  /// Middle of each car at a time of the drive, road frame, on the ground.
  std::vector<Eigen::Vector2d> centres_at(double time_s) const;

 private:
  struct Car {
    double start_m = 0.0;  ///< along the road at time 0
    double speed_mps = 0.0;
    double left_m = 0.0;
    double sway_m = 0.0;  ///< how far it falls back and closes up
  };
  double along_m(const Car& car, double time_s) const;
  /// Whether the car comes closer to the own vehicle than cars in two lanes do.
  bool meets_at_crossing(const Car& car, const SimulationOptions& options) const;

  const Road& road_;
  const Ground& ground_;
  std::vector<Car> cars_;
};

}  // namespace remount::simulator
