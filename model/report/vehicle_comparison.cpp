#include "model/report/vehicle_comparison.h"

#include <algorithm>

#include "messages/rig.h"

namespace remount::report {
namespace {

/// As a result, so that it is compared as results are.
calibration::CalibrationResult result_of(const results::RelativeRecord& two) {
  calibration::CalibrationResult result;
  result.status = calibration::Status::Ok;
  result.mounting.reference_from_sensor = two.lidar_a_from_lidar_b;
  result.covariance.setZero();
  calibration::ParameterSet observed;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    const int row = calibration::row_of(parameter);
    const double sigma = two.sigma[parameter].value_or(0.0);
    result.covariance(row, row) = sigma * sigma;
    if (two.sigma[parameter]) observed.insert(parameter);
  }
  result.set_observed(observed, {});
  return result;
}

const results::RelativeRecord* relative_of(const results::VehicleFile& vehicle, const std::string& a,
                                           const std::string& b) {
  const auto found = std::ranges::find_if(
      vehicle.relatives, [&](const results::RelativeRecord& two) { return two.lidar_a == a && two.lidar_b == b; });
  return found == vehicle.relatives.end() ? nullptr : &*found;
}

/// Whether two LiDARs are known to sit against each other as before.
bool sit_as_before(const NamedVehicle& first, const NamedVehicle& second, const std::string& a, const std::string& b) {
  const results::RelativeRecord *then = relative_of(first.file, a, b), *now = relative_of(second.file, a, b);
  if (!then || !now) return false;
  const auto largest = calibration::largest_difference(calibration::difference_of(result_of(*then), result_of(*now)));
  return largest && largest->sigmas <= calibration::kDiffer_sigma;
}

/// The most LiDARs of those that differ that sit as before against one of them, with that one.
std::vector<std::string> still_together(const NamedVehicle& first, const NamedVehicle& second,
                                        const std::vector<std::string>& names) {
  std::vector<std::string> most;
  for (const std::string& one : names) {
    std::vector<std::string> together;
    for (const std::string& other : names)
      if (other == one || sit_as_before(first, second, one, other) || sit_as_before(first, second, other, one))
        together.push_back(other);
    if (together.size() > most.size()) most = std::move(together);
  }
  return most;
}

std::vector<std::string> names_only_in(const results::VehicleFile& vehicle, const results::VehicleFile& other) {
  std::vector<std::string> names;
  for (const results::LidarResult& lidar : vehicle.lidars)
    if (!results::find_lidar(other, lidar.name)) names.push_back(lidar.name);
  return names;
}

void find_what_moved(const NamedVehicle& first, const NamedVehicle& second, ComparedVehicles& compared) {
  std::size_t known = 0;
  for (const ComparedLidar& lidar : compared.lidars) {
    if (lidar.compared) ++known;
    if (lidar.results.contradict) compared.moved.push_back(lidar.name);
  }
  if (compared.moved.size() < 2 || compared.moved.size() < known) return;
  const std::vector<std::string> together = still_together(first, second, compared.moved);
  compared.ins_moved = together.size() >= 2 && 2 * together.size() > known;
  if (compared.ins_moved)
    std::erase_if(compared.moved, [&](const std::string& name) { return std::ranges::count(together, name) > 0; });
}

void find_words(const NamedVehicle& first, const NamedVehicle& second, ComparedVehicles& compared) {
  if (!compared.only_first.empty()) compared.words.push_back(say::compared_only_in(first.name, compared.only_first));
  if (!compared.only_second.empty()) compared.words.push_back(say::compared_only_in(second.name, compared.only_second));
  if (compared.ins_moved)
    compared.words.push_back(compared.moved.empty() ? say::compared_ins_moved()
                                                    : say::compared_ins_and_lidars_moved(compared.moved));
  else if (compared.moved.size() > 1 && compared.moved.size() == compared.lidars.size())
    compared.words.push_back(say::compared_all_moved());
  else if (!compared.moved.empty() && compared.lidars.size() > 1)
    compared.words.push_back(say::compared_lidars_moved(compared.moved));
}

}  // namespace

bool ComparedVehicles::agree() const {
  return !lidars.empty() && std::ranges::all_of(lidars, [](const ComparedLidar& lidar) {
    return lidar.compared && !lidar.results.contradict;
  });
}

ComparedVehicles compare_vehicles(const NamedVehicle& first, const NamedVehicle& second) {
  ComparedVehicles compared;
  for (const results::LidarResult& lidar : first.file.lidars) {
    const results::LidarResult* other = results::find_lidar(second.file, lidar.name);
    if (!other) continue;
    const std::vector<ComparedResults> two =
        compare_results({{first.name + " " + lidar.name, lidar.file}, {second.name + " " + lidar.name, other->file}});
    const bool known = calibration::largest_difference(two.front().difference).has_value();
    compared.lidars.push_back({lidar.name, two.front(), known});
  }
  compared.only_first = names_only_in(first.file, second.file);
  compared.only_second = names_only_in(second.file, first.file);
  find_what_moved(first, second, compared);
  find_words(first, second, compared);
  return compared;
}

}  // namespace remount::report
