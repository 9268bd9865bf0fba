// From the level about the start of a simulated drive to the Earth.
#pragma once

#include <GeographicLib/LocalCartesian.hpp>

#include "model/simulator/simulation_options.h"

namespace remount::simulator {

struct EarthPlace {
  double latitude_rad = 0.0, longitude_rad = 0.0, height_m = 0.0;
  Eigen::Matrix3d start_enu_from_here_enu = Eigen::Matrix3d::Identity();
};

class LocalEarth {
 public:
  explicit LocalEarth(const SimulationOptions& options)
      : start_(options.latitude_deg, options.longitude_deg, options.height_m) {}

  EarthPlace at(const Eigen::Vector3d& point_in_start_enu) const;

 private:
  GeographicLib::LocalCartesian start_;
};

}  // namespace remount::simulator
