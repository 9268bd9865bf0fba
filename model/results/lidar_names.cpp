#include "model/results/lidar_names.h"

#include <algorithm>

#include "model/drive/lidar_offer.h"

namespace remount::results {
namespace {

/// Whether a frame is called as a part of a topic.
bool is_part_of(std::string_view frame, std::string_view topic) {
  for (const std::string_view ending : {"_base_link", "_link"})
    if (frame.ends_with(ending)) {
      frame.remove_suffix(ending.size());
      break;
    }
  constexpr std::string_view kBefore = "lidar_";
  while (!frame.empty()) {
    const std::size_t end = topic.find('/');
    const std::string_view part = topic.substr(0, end);
    if (part == frame || (part.starts_with(kBefore) && part.substr(kBefore.size()) == frame)) return true;
    if (end == std::string_view::npos) return false;
    topic.remove_prefix(end + 1);
  }
  return false;
}

/// Those of `names` that are not among the others.
std::vector<std::string> without(const std::vector<std::string>& names, const std::vector<std::string>& others) {
  std::vector<std::string> left;
  for (const std::string& name : names)
    if (std::ranges::find(others, name) == others.end()) left.push_back(name);
  return left;
}

/// That of `others` which is the same LiDAR as `name`, whichever of the two is called after the other.
std::string same_lidar(const std::string& name, const std::vector<std::string>& names,
                       const std::vector<std::string>& others) {
  if (std::string meant = lidar_meant_by(name, others); !meant.empty()) return meant;
  std::string same;
  for (const std::string& other : others) {
    if (lidar_meant_by(other, names) != name) continue;
    if (!same.empty()) return {};
    same = other;
  }
  return same;
}

}  // namespace

std::string usual_frame(std::string_view lidar) {
  std::string frame;
  for (const char c : lidar) {
    const std::string_view letter(&c, 1);
    const bool usual = drive::can_name_lidar(letter);
    if (usual || !frame.empty()) frame += usual ? c : '_';
  }
  return frame.empty() ? "lidar" : frame;
}

bool is_frame_of(std::string_view frame, std::string_view lidar) {
  if (frame == lidar) return true;
  const std::string usual = usual_frame(lidar);
  return frame == usual || frame == usual + "_link" || frame == usual + "_base_link";
}

bool is_called_after(std::string_view frame, const std::string& lidar, const std::vector<std::string>& lidars) {
  const auto has_part = [&](const std::string& other) { return is_part_of(frame, other); };
  return is_frame_of(frame, lidar) || (has_part(lidar) && std::ranges::count_if(lidars, has_part) == 1);
}

std::string lidar_meant_by(const std::string& name, const std::vector<std::string>& lidars) {
  if (std::ranges::find(lidars, name) != lidars.end()) return name;
  std::string meant;
  for (const std::string& lidar : lidars) {
    if (!is_called_after(name, lidar, lidars)) continue;
    if (!meant.empty()) return {};
    meant = lidar;
  }
  return meant;
}

std::map<std::string, std::string> same_lidars(const std::vector<std::string>& lidars,
                                               const std::vector<std::string>& others) {
  const std::vector<std::string> own = without(lidars, others), theirs = without(others, lidars);
  std::map<std::string, std::string> same;
  for (const std::string& lidar : own)
    if (const std::string other = same_lidar(lidar, own, theirs); !other.empty()) same[other] = lidar;
  std::erase_if(same, [&](const auto& two) { return same_lidar(two.first, theirs, own) != two.second; });
  return same;
}

}  // namespace remount::results
