#include "model/results/exporters/named_mountings.h"

#include <algorithm>
#include <string_view>

#include "model/results/exporters/several_exporter.h"

namespace remount::results {
namespace {

/// Whether a frame is called as a part of a topic.
bool is_part_of(std::string_view frame, std::string_view topic) {
  for (const std::string_view ending : {"_base_link", "_link"})
    if (frame.ends_with(ending)) {
      frame.remove_suffix(ending.size());
      break;
    }
  while (!frame.empty()) {
    const std::size_t end = topic.find('/');
    if (topic.substr(0, end) == frame) return true;
    if (end == std::string_view::npos) return false;
    topic.remove_prefix(end + 1);
  }
  return false;
}

bool is_of(const NamedMounting& one, const std::string& lidar, const std::vector<std::string>& lidars) {
  const auto has_part = [&](const std::string& other) { return is_part_of(one.name, other); };
  return is_frame_of(one.name, lidar) || (has_part(lidar) && std::ranges::count_if(lidars, has_part) == 1);
}

}  // namespace

const NamedMounting* find_mounting(const std::vector<NamedMounting>& mountings, const std::string& lidar,
                                   const std::vector<std::string>& lidars) {
  const auto found =
      std::ranges::find_if(mountings, [&](const NamedMounting& one) { return is_of(one, lidar, lidars); });
  return found == mountings.end() ? nullptr : &*found;
}

}  // namespace remount::results
