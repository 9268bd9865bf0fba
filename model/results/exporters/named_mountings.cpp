#include "model/results/exporters/named_mountings.h"

#include <algorithm>

#include "model/results/exporters/lidar_names.h"

namespace remount::results {

const NamedMounting* find_mounting(const std::vector<NamedMounting>& mountings, const std::string& lidar,
                                   const std::vector<std::string>& lidars) {
  const auto found = std::ranges::find_if(
      mountings, [&](const NamedMounting& one) { return is_called_after(one.name, lidar, lidars); });
  return found == mountings.end() ? nullptr : &*found;
}

}  // namespace remount::results
