// Which LiDARs a recording has, before a session is made of one of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "model/drive/topic_choice.h"

namespace remount::drive {

inline constexpr std::size_t kMostLidars = 64, kLongestLidarName = 64;  ///< of one vehicle

/// Whether LiDARs may be called so where people name them: names become those of folders, topics and frames. "all" and
/// "none" mean something else where LiDARs are chosen.
inline bool can_name_lidar(std::string_view name) {
  const auto usual = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (name == "all" || name == "none") return false;
  return !name.empty() && name.size() <= kLongestLidarName && std::all_of(name.begin(), name.end(), usual);
}

/// One LiDAR of a recording. A session is what one LiDAR recorded together with the INS: a recording of several is
/// opened once for each.
struct LidarOffer {
  std::string name;                  ///< Session::lidar_name of the session that `choice` opens
  TopicChoice choice;                ///< with it open_session opens this LiDAR; empty where there is but one
  std::optional<std::size_t> scans;  ///< as far as that is known without opening it
  /// Its scans come at less than a sixth of the rate of another's, as maps do that are published now and then: it is
  /// offered, but likely is no sensor.
  bool rare = false;
};

}  // namespace remount::drive
