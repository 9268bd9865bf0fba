#include "model/report/vehicle_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "algorithms/geometry/rotation.h"
#include "messages/report.h"
#include "messages/rig.h"
#include "model/results/lidar_names.h"
#include "model/results/relative_record.h"

namespace remount::report {
namespace {

/// Whether two LiDARs are known to sit against each other as before.
bool sit_as_before(const NamedVehicle& first, const NamedVehicle& second, const std::string& a, const std::string& b) {
  const std::optional<results::RelativeRecord> then = results::relative_record(first.file, a, b),
                                               now = results::relative_record(second.file, a, b);
  if (!then || !now) return false;
  const auto was = calibration::parameters_of(then->lidar_a_from_lidar_b),
             is = calibration::parameters_of(now->lidar_a_from_lidar_b);
  bool any = false;
  for (const calibration::Parameter parameter : calibration::kParameters) {
    if (!then->sigma[parameter] || !now->sigma[parameter]) continue;
    const double apart = calibration::is_angle(parameter) ? wrap_angle_rad(is[parameter] - was[parameter])
                                                          : is[parameter] - was[parameter];
    const double sigma = std::hypot(*then->sigma[parameter], *now->sigma[parameter]);
    if (std::abs(apart) > calibration::kDiffer_sigma * sigma) return false;
    any = true;
  }
  return any;
}

/// The most LiDARs of those that differ that sit as before against one of them, with that one.
std::vector<std::string> still_together(const NamedVehicle& first, const NamedVehicle& second,
                                        const std::vector<std::string>& names) {
  std::vector<std::string> most;
  for (const std::string& one : names) {
    std::vector<std::string> together;
    for (const std::string& other : names)
      if (other == one || sit_as_before(first, second, one, other)) together.push_back(other);
    if (together.size() > most.size()) most = std::move(together);
  }
  return most;
}

/// Called as the first vehicle calls its LiDARs, where it is clear which is which.
results::VehicleFile called_as_in(const results::VehicleFile& first, results::VehicleFile second,
                                  std::map<std::string, std::string>& names) {
  std::map<std::string, std::string> same =
      results::same_lidars(results::lidar_names(first), results::lidar_names(second));
  const auto rename = [&](std::string& lidar) {
    if (const auto own = same.find(lidar); own != same.end()) lidar = own->second;
  };
  for (results::LidarResult& lidar : second.lidars) rename(lidar.name);
  for (results::RelativeRecord& two : second.relatives) rename(two.lidar_a), rename(two.lidar_b);
  for (const auto& [other, own] : same) names[own] = other;
  return second;
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

/// Whether no LiDAR of either is left of which it is not known how it sits.
bool compared_all(const ComparedVehicles& compared) {
  return compared.only_first.empty() && compared.only_second.empty() &&
         std::ranges::all_of(compared.lidars, &ComparedLidar::compared);
}

void find_words(const NamedVehicle& first, const NamedVehicle& second, ComparedVehicles& compared) {
  // Where none could be compared, its names are the likeliest reason.
  if (compared.lidars.empty() && !compared.only_first.empty() && !compared.only_second.empty())
    compared.words.push_back(say::compared_no_names_alike());
  if (!compared.only_first.empty()) compared.words.push_back(say::compared_only_in(first.name, compared.only_first));
  if (!compared.only_second.empty()) compared.words.push_back(say::compared_only_in(second.name, compared.only_second));
  if (compared.ins_moved)
    compared.words.push_back(words_of_ins(compared));
  else if (compared.moved.size() > 1 && compared.moved.size() == compared.lidars.size())
    compared.words.push_back(say::compared_all_moved());
  else if (!compared.moved.empty() && compared.lidars.size() > 1)
    compared.words.push_back(compared_all(compared) ? say::compared_lidars_moved(compared.moved)
                                                    : say::compared_lidars_moved_of_those_known(compared.moved));
}

}  // namespace

bool ComparedVehicles::agree() const {
  return !lidars.empty() && std::ranges::all_of(lidars, [](const ComparedLidar& lidar) {
    return lidar.compared && !lidar.results.contradict;
  });
}

bool ComparedVehicles::moved_with_ins(const ComparedLidar& lidar) const {
  return ins_moved && lidar.results.contradict && std::ranges::find(moved, lidar.name) == moved.end();
}

Message words_of_most(const ComparedResults& results, const std::string& first, const std::string& second) {
  const auto largest = calibration::largest_difference(results.difference);
  if (!largest) return {};
  return say::compared_at_most(first, second, words_of_largest(results.difference, *largest));
}

Message words_of_ins(const ComparedVehicles& compared) {
  if (!compared.ins_moved) return {};
  return compared.moved.empty() ? say::compared_ins_moved() : say::compared_ins_and_lidars_moved(compared.moved);
}

ComparedVehicles compare_vehicles(const NamedVehicle& first, const NamedVehicle& second_as_named) {
  ComparedVehicles compared;
  std::map<std::string, std::string> names;
  const NamedVehicle second{second_as_named.name, called_as_in(first.file, second_as_named.file, names)};
  for (const results::LidarResult& lidar : first.file.lidars) {
    const results::LidarResult* other = results::find_lidar(second.file, lidar.name);
    if (!other) continue;
    const auto named = names.find(lidar.name);
    const std::string other_name = named == names.end() ? "" : named->second;
    const std::string of_first = first.name + " " + lidar.name,
                      of_second = second.name + " " + (other_name.empty() ? lidar.name : other_name);
    ComparedResults two = compare_results({{of_first, lidar.file}, {of_second, other->file}}).front();
    const bool known = calibration::largest_difference(two.difference).has_value();
    compared.lidars.push_back({lidar.name, other_name, std::move(two), known});
    if (!other_name.empty())
      compared.notes.push_back(say::compared_taken_for(lidar.name, first.name, other_name, second.name));
  }
  compared.only_first = names_only_in(first.file, second.file);
  compared.only_second = names_only_in(second.file, first.file);
  find_what_moved(first, second, compared);
  for (ComparedLidar& lidar : compared.lidars)
    if (compared.moved_with_ins(lidar)) {
      const std::string& other = lidar.other_name.empty() ? lidar.name : lidar.other_name;
      lidar.results.words = words_of_most(lidar.results, first.name + " " + lidar.name, second.name + " " + other);
    }
  find_words(first, second, compared);
  return compared;
}

}  // namespace remount::report
