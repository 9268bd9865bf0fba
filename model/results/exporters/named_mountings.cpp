#include "model/results/exporters/named_mountings.h"

#include <algorithm>
#include <set>

#include "algorithms/core/error.h"
#include "messages/rig.h"
#include "model/results/lidar_names.h"

namespace remount::results {
namespace {

void require_names_once(const std::vector<NamedMounting>& mountings, const std::string& file) {
  std::set<std::string> seen;
  for (const NamedMounting& one : mountings)
    if (!one.name.empty() && !seen.insert(one.name).second)
      throw Error(ErrorCode::Contract, file, say::rig_nominal_twice(one.name));
}

}  // namespace

const NamedMounting* find_mounting(const std::vector<NamedMounting>& mountings, const std::string& lidar,
                                   const std::vector<std::string>& lidars) {
  const auto found = std::ranges::find_if(
      mountings, [&](const NamedMounting& one) { return is_called_after(one.name, lidar, lidars); });
  return found == mountings.end() ? nullptr : &*found;
}

MountingsOfLidars mountings_of_lidars(const std::vector<NamedMounting>& mountings,
                                      const std::vector<std::string>& lidars, const std::string& file) {
  require_names_once(mountings, file);
  MountingsOfLidars found;
  std::set<const NamedMounting*> used;
  for (const std::string& lidar : lidars)
    if (const NamedMounting* own = find_mounting(mountings, lidar, lidars)) {
      require_ins_frame(own->mounting, file);
      used.insert(own);
      found.of.emplace(lidar, own->mounting);
    }
  for (const NamedMounting& one : mountings)
    if (!used.contains(&one)) found.others.push_back(one.name);
  return found;
}

void no_lidar_is_named(const std::vector<NamedMounting>& mountings, const std::vector<std::string>& lidars,
                       const std::string& file) {
  std::vector<std::string> found;
  for (const NamedMounting& one : mountings) found.push_back(one.name.empty() ? "-" : one.name);
  throw Error(ErrorCode::Contract, file, say::rig_nominal_matches_none(std::move(found), lidars));
}

void require_ins_frame(const ReadMounting& mounting, const std::string& where) {
  if (const Message problem = not_in_ins_frame(mounting.frames); !problem.empty())
    throw Error(ErrorCode::Contract, where, problem);
}

}  // namespace remount::results
