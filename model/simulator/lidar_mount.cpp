#include "model/simulator/lidar_mount.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

#include "algorithms/core/index.h"
#include "messages/sessions.h"
#include "messages/simulation.h"
#include "model/drive/lidar_offer.h"

namespace remount::simulator {
namespace {

/// Those of the LiDAR whose names do not say so.
constexpr std::array<std::string_view, 9> kOfLidar{"scan_rate_hz",  "beams",   "azimuth_steps", "range_noise_m",
                                                   "max_range_m",   "dropout", "clockwise",     "motion_distortion",
                                                   "per_point_time"};

/// The options of the LiDAR as numbers, in the order in which they describe themselves.
struct LidarOptionTaker {
  std::vector<double>& values;
  template <class T>
  void operator()(const OptionInfo& info, const T& value) {
    if (is_lidar_option(info.name)) values.push_back(static_cast<double>(value));
  }
  template <class T>
  void choice(const OptionInfo& info, const T& value, const std::vector<std::string_view>&) {
    if (is_lidar_option(info.name)) values.push_back(static_cast<double>(index_of(value)));
  }
};

struct LidarOptionPutter {
  const std::vector<double>& values;
  std::size_t next = 0;
  template <class T>
  void operator()(const OptionInfo& info, T& value) {
    if (is_lidar_option(info.name)) value = static_cast<T>(values[next++]);
  }
  template <class T>
  void choice(const OptionInfo& info, T& value, const std::vector<std::string_view>&) {
    if (is_lidar_option(info.name)) value = static_cast<T>(static_cast<int>(values[next++]));
  }
};

/// FNV-1a (Fowler, Noll, Vo) of the seed and the name.
int seed_of_lidar(int seed, const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto take = [&](unsigned char byte) { hash = (hash ^ byte) * 0x100000001b3ULL; };
  for (int byte = 0; byte < 4; ++byte) take(static_cast<unsigned char>(static_cast<unsigned>(seed) >> (8 * byte)));
  for (const char c : name) take(static_cast<unsigned char>(c));
  return static_cast<int>((hash ^ (hash >> 32)) & 0x7fffffffULL);
}

}  // namespace

bool is_lidar_option(std::string_view name) {
  return name.starts_with("lidar") || std::find(kOfLidar.begin(), kOfLidar.end(), name) != kOfLidar.end();
}

SimulationOptions options_of_mount(const SimulationOptions& vehicle, const LidarMount& mount) {
  std::vector<double> values;
  SimulationOptions::visit(mount.options, LidarOptionTaker{values});
  SimulationOptions own = vehicle;
  SimulationOptions::visit(own, LidarOptionPutter{values});
  own.ins_from_lidar = mount.options.ins_from_lidar;
  own.scan_phase_s = mount.options.scan_phase_s;
  own.seed = seed_of_lidar(vehicle.seed, mount.name);
  return own;
}

std::vector<Message> mount_problems(const std::vector<LidarMount>& mounts) {
  std::vector<Message> problems;
  if (mounts.empty() || mounts.size() > drive::kMostLidars)
    problems.push_back(say::simulation_mounts_count(drive::kMostLidars));
  std::set<std::string> names;
  for (const LidarMount& mount : mounts) {
    if (!drive::can_name_lidar(mount.name))
      problems.push_back(say::native_lidar_name(mount.name.substr(0, 80), drive::kLongestLidarName));
    if (!names.insert(mount.name).second) problems.push_back(say::native_lidar_twice(mount.name.substr(0, 80)));
  }
  return problems;
}

}  // namespace remount::simulator
