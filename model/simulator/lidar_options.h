// Which LiDAR is simulated.
#pragma once

#include "algorithms/core/options.h"
#include "messages/simulation_options.h"
#include "model/simulator/patterns/lidar_models.h"

namespace remount::simulator {

struct SimulatedLidarOptions {
  LidarChoice model{};
  int points_per_scan = 0;
  double field_deg = 70.0;
  bool backwards = false;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"lidar", "", kNoLabel, say::option_simulate_lidar}, self.model, lidar_model_names());
    visitor({"lidar_points_per_scan", "", kNoLabel, say::option_simulate_lidar_points_per_scan, 0, 1000000},
            self.points_per_scan);
    visitor({"lidar_field_deg", "deg", kNoLabel, say::option_simulate_lidar_field_deg, 1.0, 170.0}, self.field_deg);
    visitor({"lidar_backwards", "", kNoLabel, say::option_simulate_lidar_backwards}, self.backwards);
  }
};

}  // namespace remount::simulator
