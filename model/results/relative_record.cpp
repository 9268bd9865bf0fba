#include "model/results/relative_record.h"

#include <cmath>
#include <utility>

namespace remount::results {
namespace {

std::optional<RelativeRecord> turned_round(const RelativeRecord& two) {
  double places = 0.0, turns = 0.0;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    if (!two.sigma[parameter]) return {};
    double& sum = calibration::is_angle(parameter) ? turns : places;
    sum = std::hypot(sum, *two.sigma[parameter]);
  }
  RelativeRecord turned = two;
  std::swap(turned.lidar_a, turned.lidar_b);
  turned.lidar_a_from_lidar_b = two.lidar_a_from_lidar_b.inverse();
  turned.height_m = -two.height_m;
  for (const calibration::Parameter parameter : calibration::kParameters)
    turned.sigma[parameter] = calibration::is_angle(parameter)
                                  ? turns
                                  : std::hypot(places, turns * two.lidar_a_from_lidar_b.translation().norm());
  return turned;
}

}  // namespace

std::optional<RelativeRecord> relative_record(const VehicleFile& vehicle, std::string_view lidar_a,
                                              std::string_view lidar_b) {
  for (const RelativeRecord& two : vehicle.relatives) {
    if (two.lidar_a == lidar_a && two.lidar_b == lidar_b) return two;
    if (two.lidar_a == lidar_b && two.lidar_b == lidar_a) return turned_round(two);
  }
  return {};
}

}  // namespace remount::results
