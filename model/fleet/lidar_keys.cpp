#include "model/fleet/lidar_keys.h"

#include <algorithm>
#include <set>

#include "algorithms/calibration/method_details.h"
#include "messages/fleet.h"
#include "messages/rig.h"

namespace remount::fleet {
namespace {

constexpr const char* kAll = "all";
constexpr std::size_t kLongestLidar = 200;  ///< bytes; topics are names as well

/// Six numbers name no LiDAR, and a file whose format is named is of one; paths are absolute.
bool can_name_lidars(const std::string& nominal) {
  return nominal.empty() || nominal == "none" || nominal.front() == '/';
}

}  // namespace

void check_lidar_name(const formats::DocumentView& view, const std::string& name) {
  const bool control = std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < 32; });
  if (name.empty() || name.size() > kLongestLidar || control || name.find_first_of(",=") != std::string::npos ||
      name.front() == ' ' || name.back() == ' ' || name == kAll || name == "none")
    view.fail(say::fleet_lidar_name(name.substr(0, kLongestLidar)));
}

std::string lidars_from(const formats::DocumentView& view) {
  if (view.is_null()) return {};
  if (!view.is_sequence()) {
    if (view.is_map() || view.string() != kAll) view.fail(say::fleet_lidars_expected(view.described()));
    return kAll;
  }
  std::string lidars;
  std::set<std::string> names;
  for (const formats::DocumentView& item : view.items()) {
    const std::string name = item.string();
    check_lidar_name(item, name);
    if (!names.insert(name).second) item.fail(say::rig_named_twice());
    lidars += (lidars.empty() ? "" : ",") + name;
  }
  if (lidars.empty()) view.fail(say::fleet_lidars_expected(view.described()));
  return lidars;
}

Message lidars_in_words(const std::string& lidars) {
  if (lidars.empty()) return say::fleet_one_lidar();
  if (lidars == kAll) return say::fleet_all_lidars();
  std::string names;
  for (const char c : lidars) names += c == ',' ? ", " : std::string(1, c);
  return Message::verbatim(names);
}

void check_lidars_of(const FleetVehicle& vehicle, const FleetJob& job, const formats::DocumentView& view) {
  if (job.lidars.empty()) {
    if (!vehicle.nominal_of_lidars.empty() || !vehicle.last.of_lidars.empty() || !vehicle.reference.of_lidars.empty())
      view.fail(say::fleet_names_without_lidars());
    return;
  }
  if (vehicle.topics.contains("lidar")) view.fail(say::fleet_lidars_or_topic());
  if (!can_name_lidars(vehicle.nominal)) view.fail(say::fleet_nominal_by_names());
  if (vehicle.settings.run.method->id != calibration::kPairwise) view.fail(say::rig_needs_pairwise());
}

bool may_have_lidar(const FleetJob& job, const std::string& lidar) {
  return job.lidars == kAll || ("," + job.lidars + ",").find("," + lidar + ",") != std::string::npos;
}

}  // namespace remount::fleet
