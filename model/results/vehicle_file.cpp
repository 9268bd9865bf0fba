#include "model/results/vehicle_file.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/rig.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/input_file.h"
#include "model/results/lidar_names.h"

namespace remount::results {

const LidarResult* find_lidar(const VehicleFile& vehicle, std::string_view name) {
  const auto found = std::ranges::find(vehicle.lidars, name, &LidarResult::name);
  return found == vehicle.lidars.end() ? nullptr : &*found;
}

std::vector<std::string> lidar_names(const VehicleFile& vehicle) {
  std::vector<std::string> names;
  for (const LidarResult& lidar : vehicle.lidars) names.push_back(lidar.name);
  return names;
}

Message why_not_joined(const VehicleFile& vehicle, const LidarResult& lidar) {
  if (lidar.joined) return {};
  for (const drive::Finding& finding : vehicle.findings)
    if (finding.code == kLidarsNotJoined ||
        (finding.code == kLidarLeftOut && finding.where == drive::Place(lidar.name)))
      return finding.explanation;
  return {};
}

const LidarResult& lidar_of(const VehicleFile& vehicle, std::string_view name, const std::string& where) {
  const std::vector<std::string> names = lidar_names(vehicle);
  if (const LidarResult* lidar = find_lidar(vehicle, lidar_meant_by(std::string(name), names))) return *lidar;
  throw Error(ErrorCode::Contract, where, say::vehicle_no_such_lidar(std::string(name), names));
}

void keep_lidars(VehicleFile& vehicle, const std::function<bool(const LidarResult&)>& keep) {
  std::erase_if(vehicle.lidars, [&](const LidarResult& lidar) { return !keep(lidar); });
  const auto is_gone = [&](const std::string& name) { return find_lidar(vehicle, name) == nullptr; };
  const auto one_is_gone = [&](const auto& two) { return is_gone(two.lidar_a) || is_gone(two.lidar_b); };
  std::erase_if(vehicle.relatives, one_is_gone);
  std::erase_if(vehicle.agreements, one_is_gone);
  for (std::vector<std::string>& group : vehicle.groups) std::erase_if(group, is_gone);
  std::erase_if(vehicle.groups, [](const auto& group) { return group.empty(); });
}

bool is_vehicle_text(std::string_view text) {
  const std::size_t vehicle = text.find("remount-vehicle/");
  return vehicle != std::string_view::npos && vehicle < text.find("remount-result/");
}

bool is_vehicle_file(const std::filesystem::path& path) {
  constexpr std::size_t kHead = 65536;
  return formats::is_file(path) && is_vehicle_text(formats::read_file_head(path, kHead));
}

void save_vehicle(const VehicleFile& vehicle, const std::filesystem::path& path) {
  const formats::DocumentNode document = vehicle_document(vehicle);
  formats::save_atomically(path, path.extension() == ".json" ? formats::to_json(document) : formats::to_yaml(document));
}

VehicleFile load_vehicle(const std::filesystem::path& path) {
  const formats::DocumentNode document = formats::read_document(path, kVehicleLimits);
  return vehicle_from_document(formats::DocumentView(document, path.string()));
}

VehicleFile load_any_result(const std::filesystem::path& path) {
  if (is_vehicle_file(path)) return load_vehicle(path);
  VehicleFile vehicle;
  vehicle.lidars.push_back({"", false, load_result(path)});
  vehicle.version = vehicle.lidars.front().file.version;
  return vehicle;
}

void check_replaces_result(const std::filesystem::path& path) {
  formats::check_replaces_its_like(path, "remount-result/");
  if (is_vehicle_file(path)) throw Error(ErrorCode::Contract, path.string(), say::vehicle_would_be_replaced());
}

void check_replaces_vehicle(const std::filesystem::path& path) {
  formats::check_replaces_its_like(path, "remount-vehicle/");
}

}  // namespace remount::results
