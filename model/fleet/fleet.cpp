#include "model/fleet/fleet.h"

#include <algorithm>
#include <map>
#include <span>

#include "algorithms/core/error.h"
#include "messages/fleet.h"
#include "model/fleet/lidar_keys.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/sha256.h"
#include "model/results/exporters/exporter.h"
#include "model/results/topic_document.h"
#include "model/settings/settings_file.h"

namespace remount::fleet {
namespace {

constexpr std::string_view kFormat = "remount-fleet/1";
constexpr formats::DocumentLimits kLimits{16U << 20U, 1000000, 16};
constexpr const char* kNoNominal = "none";
constexpr std::size_t kMostJobs = 100000;
constexpr std::size_t kLongestName = 80;  ///< bytes; names become file names

std::string path_text(const formats::DocumentView& view) {
  const std::string text = view.string();
  if (text.empty()) view.fail(say::fleet_path_empty());
  if (text.find('\0') != std::string::npos) view.fail(say::fleet_path_zero_byte());
  return text;
}

std::filesystem::path resolve(const formats::DocumentView& view, const std::filesystem::path& folder) {
  return (folder / path_text(view)).lexically_normal();
}

double positive(const formats::DocumentView& view, bool zero_too) {
  const double value = view.number();
  if (value < 0.0 || (value == 0.0 && !zero_too))
    view.fail(zero_too ? say::fleet_number_below_zero(formats::shortest(value))
                       : say::fleet_number_not_above_zero(formats::shortest(value)));
  return value;
}

DriftLimits drift_from(const formats::DocumentView& view) {
  view.allow_only({"sigmas", "translation_m", "rotation_deg"});
  DriftLimits limits;
  if (view.has("sigmas")) limits.sigmas = positive(view.at("sigmas"), false);
  if (view.has("translation_m")) limits.translation_m = positive(view.at("translation_m"), true);
  if (view.has("rotation_deg")) limits.rotation_deg = positive(view.at("rotation_deg"), true);
  return limits;
}

/// A vehicle's name is a folder's name, and a cell of a table.
std::string vehicle_name(const formats::DocumentView& view) {
  const std::string name = view.string();
  const bool control = std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 32; });
  if (name.empty() || name.size() > kLongestName || name.front() == '.' || control ||
      name.find_first_of("/\\") != std::string::npos)
    view.fail(say::fleet_vehicle_name(name.substr(0, kLongestName), Bytes{kLongestName}));
  return name;
}

/// As `--nominal` takes it: six numbers, a file, FORMAT:FILE, or "none".
std::string nominal_from(const formats::DocumentView& view, const std::filesystem::path& folder) {
  if (!view.is_sequence()) {
    const std::string text = path_text(view);
    if (text == kNoNominal) return text;
    for (const auto& format : results::exporters())
      if (const std::string id(format->id()); text.starts_with(id + ":"))
        return id + ":" + (folder / text.substr(id.size() + 1)).lexically_normal().string();
    return (folder / text).lexically_normal().string();
  }
  std::string text;
  for (const double value : view.numbers(6)) text += (text.empty() ? "" : ",") + formats::shortest(value);
  return text;
}

/// By the names of LiDARs.
void add_nominals(const formats::DocumentView& view, const std::filesystem::path& folder, FleetVehicle& vehicle) {
  for (const auto& [lidar, value] : view.entries()) {
    check_lidar_name(value, lidar);
    std::string nominal = nominal_from(value, folder);
    if (nominal == kNoNominal) value.fail(say::fleet_none_is_of_all());
    vehicle.nominal_of_lidars.emplace(lidar, std::move(nominal));
  }
}

EarlierFiles earlier_from(const formats::DocumentView& view, const std::filesystem::path& folder) {
  if (!view.is_map()) return {resolve(view, folder), {}};
  EarlierFiles files;
  for (const auto& [lidar, value] : view.entries()) {
    check_lidar_name(value, lidar);
    files.of_lidars.emplace(lidar, resolve(value, folder));
  }
  return files;
}

/// A name that no job of the vehicle can have is most often a typing error. @param jobs of the vehicle
void check_names_are_used(std::span<const FleetJob> jobs, const formats::DocumentView& vehicle) {
  for (const char* key : {"nominal", "last", "reference"}) {
    if (!vehicle.has(key) || !vehicle.at(key).is_map()) continue;
    for (const auto& [lidar, value] : vehicle.at(key).entries()) {
      const auto has = [&name = lidar](const FleetJob& job) { return may_have_lidar(job, name); };
      if (std::ranges::none_of(jobs, has)) value.fail(say::fleet_no_such_lidar());
    }
  }
}

/// What is only letters that any file system and any shell takes as they are.
std::string slug(const std::string& text) {
  std::string kept;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                       c == '.' || static_cast<unsigned char>(c) >= 0x80;
    if (plain || (!kept.empty() && kept.back() != '-')) kept += plain ? c : '-';
  }
  while (!kept.empty() && (kept.front() == '.' || kept.front() == '-')) kept.erase(kept.begin());
  if (kept.size() > 2 * kLongestName) kept.erase(0, kept.size() - 2 * kLongestName);
  while (!kept.empty() && (static_cast<unsigned char>(kept.front()) & 0xc0) == 0x80) kept.erase(kept.begin());
  return kept;
}

/// Reads the jobs of one vehicle. A job's files are named by its sessions alone, so that they stay its own when jobs
/// are added before it.
class JobReader {
 public:
  /// @param lidars of jobs that do not say themselves which they calibrate
  JobReader(Fleet& fleet, std::filesystem::path folder, std::string lidars)
      : fleet_(fleet), folder_(std::move(folder)), lidars_(std::move(lidars)) {}

  void add(const formats::DocumentView& view) {
    if (!view.is_map()) return add(view, view, lidars_);
    view.allow_only({"sessions", "lidars"});
    add(view, view.at("sessions"), view.has("lidars") ? lidars_from(view.at("lidars")) : lidars_);
  }

 private:
  void add(const formats::DocumentView& view, const formats::DocumentView& sessions, const std::string& lidars) {
    FleetJob job;
    job.vehicle = fleet_.vehicles.size() - 1;
    job.lidars = lidars;
    check_lidars_of(fleet_.vehicles.back(), job, view);
    std::string written;
    const std::vector<formats::DocumentView> paths = sessions.is_sequence() ? sessions.items() : std::vector{sessions};
    if (paths.empty()) view.fail(say::fleet_job_empty());
    for (const formats::DocumentView& path : paths) {
      job.sessions.push_back(resolve(path, folder_));
      job.name += (job.name.empty() ? "" : " + ") + path.string();
      written += path.string() + '\n';
    }
    if (const auto [first, added] = seen_.emplace(written, view.line()); !added)
      view.fail(say::fleet_job_twice(first->second));
    formats::Sha256 hash;
    hash.update(written);
    const std::string stem = slug(job.name) + "-" + hash.finish().substr(0, 8);
    const std::filesystem::path made = fleet_.results / fleet_.vehicles.back().name / stem;
    job.result = made.string() + ".yaml";
    job.failure = made.string() + ".failed";
    job.log = made.string() + ".log";
    job.lock = made.string() + ".lock";
    fleet_.jobs.push_back(std::move(job));
    if (fleet_.jobs.size() > kMostJobs) view.fail(say::fleet_too_many_jobs(fleet_.jobs.size(), kMostJobs));
  }

  Fleet& fleet_;
  std::filesystem::path folder_;
  std::string lidars_;
  std::map<std::string, int> seen_;
};

/// What the fleet says for all of its vehicles.
struct FleetDefaults {
  settings::Settings settings;
  drive::TopicChoice topics;
  std::string lidars;
};

void add_vehicle(const formats::DocumentView& view, const FleetDefaults& all, const std::filesystem::path& folder,
                 Fleet& fleet) {
  view.allow_only({"name", "lidars", "sessions", "settings", "topics", "nominal", "last", "reference"});
  FleetVehicle vehicle;
  vehicle.name = vehicle_name(view.at("name"));
  for (const FleetVehicle& other : fleet.vehicles)
    if (other.name == vehicle.name) view.at("name").fail(say::fleet_vehicle_twice(vehicle.name));
  vehicle.settings =
      view.has("settings") ? settings::settings_from_document(view.at("settings"), all.settings) : all.settings;
  settings::resolve_paths(folder, vehicle.settings);
  vehicle.topics = view.has("topics") ? results::topic_choice_from_document(view.at("topics"), all.topics) : all.topics;
  if (view.has("nominal") && view.at("nominal").is_map())
    add_nominals(view.at("nominal"), folder, vehicle);
  else if (view.has("nominal"))
    vehicle.nominal = nominal_from(view.at("nominal"), folder);
  if (view.has("last")) vehicle.last = earlier_from(view.at("last"), folder);
  if (view.has("reference")) vehicle.reference = earlier_from(view.at("reference"), folder);
  fleet.vehicles.push_back(std::move(vehicle));
  const std::vector<formats::DocumentView> sessions = view.at("sessions").items();
  if (sessions.empty()) view.at("sessions").fail(say::fleet_no_sessions());
  const std::size_t before = fleet.jobs.size();
  JobReader jobs(fleet, folder, view.has("lidars") ? lidars_from(view.at("lidars")) : all.lidars);
  for (const formats::DocumentView& session : sessions) jobs.add(session);
  check_names_are_used(std::span(fleet.jobs).subspan(before), view);
}

}  // namespace

Fleet load_fleet(const std::filesystem::path& path) {
  const formats::DocumentNode document = formats::read_document(path, kLimits);
  const formats::DocumentView root(document, path.string());
  if (!root.is_map()) root.fail(say::fleet_no_map(std::string(kFormat)));
  const std::string format = root.at("format").string();
  if (format != kFormat) root.at("format").fail(say::fleet_other_format(format.substr(0, 60), std::string(kFormat)));
  root.allow_only({"format", "results", "drift", "settings", "topics", "lidars", "vehicles"});
  Fleet fleet;
  fleet.path = std::filesystem::absolute(path).lexically_normal();
  const std::filesystem::path folder = fleet.path.parent_path();
  fleet.results =
      root.has("results") ? resolve(root.at("results"), folder) : folder / (path.stem().string() + ".results");
  if (root.has("drift")) fleet.drift = drift_from(root.at("drift"));
  FleetDefaults all;
  if (root.has("settings")) all.settings = settings::settings_from_document(root.at("settings"));
  if (root.has("topics")) all.topics = results::topic_choice_from_document(root.at("topics"));
  if (root.has("lidars")) all.lidars = lidars_from(root.at("lidars"));
  const std::vector<formats::DocumentView> vehicles = root.at("vehicles").items();
  if (vehicles.empty()) root.at("vehicles").fail(say::fleet_no_vehicles());
  for (const formats::DocumentView& vehicle : vehicles) add_vehicle(vehicle, all, folder, fleet);
  return fleet;
}

std::string title_of(const Fleet& fleet, const FleetJob& job) {
  return fleet.vehicles.at(job.vehicle).name + ", " + job.name;
}

std::string nominal_text(const FleetVehicle& vehicle) {
  std::string text = vehicle.nominal;
  for (const auto& [lidar, nominal] : vehicle.nominal_of_lidars)
    text += (text.empty() ? "" : "; ") + lidar + "=" + nominal;
  return text;
}

void make_job_folder(const FleetJob& job) { formats::make_directories(job.result.parent_path()); }

}  // namespace remount::fleet
