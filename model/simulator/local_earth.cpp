#include "model/simulator/local_earth.h"

#include <vector>

namespace remount::simulator {

EarthPlace LocalEarth::at(const Eigen::Vector3d& point_in_start_enu) const {
  EarthPlace place;
  double latitude_deg = 0.0, longitude_deg = 0.0;
  std::vector<double> rotation(9);
  start_.Reverse(point_in_start_enu.x(), point_in_start_enu.y(), point_in_start_enu.z(), latitude_deg, longitude_deg,
                 place.height_m, rotation);
  place.latitude_rad = degrees_to_radians(latitude_deg);
  place.longitude_rad = degrees_to_radians(longitude_deg);
  place.start_enu_from_here_enu = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation.data());
  return place;
}

}  // namespace remount::simulator
