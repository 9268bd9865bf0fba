#include "model/formats/bags/static_frames.h"

#include <map>

namespace remount::bags {

std::optional<RigidTransform> find_transform(const std::vector<PoseMessage>& parent_from_child, const std::string& to,
                                             const std::string& from) {
  std::map<std::string, const PoseMessage*> of_child;
  for (const PoseMessage& transform : parent_from_child) of_child[transform.child_frame] = &transform;
  std::multimap<std::string, const PoseMessage*> of_frame;
  for (const auto& [child, transform] : of_child) {
    of_frame.emplace(child, transform);
    of_frame.emplace(transform->header.frame, transform);
  }
  // Breadth first from `to`, so that cycles of wrong transforms end.
  std::map<std::string, RigidTransform> to_from_frame{{to, RigidTransform::Identity()}};
  std::vector<std::string> waiting{to};
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    const std::string frame = waiting[i];
    if (frame == from) return to_from_frame.at(frame);
    const auto [begin, end] = of_frame.equal_range(frame);
    for (auto step = begin; step != end; ++step) {
      const PoseMessage& transform = *step->second;
      const bool down = transform.header.frame == frame;
      const std::string& next = down ? transform.child_frame : transform.header.frame;
      const RigidTransform frame_from_next =
          down ? transform.world_from_child : RigidTransform(transform.world_from_child.inverse());
      if (to_from_frame.emplace(next, to_from_frame.at(frame) * frame_from_next).second) waiting.push_back(next);
    }
  }
  return std::nullopt;
}

}  // namespace remount::bags
