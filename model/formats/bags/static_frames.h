// Where sensors sit to each other, as a bag's static transforms say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/formats/bags/ros_messages.h"

namespace remount::bags {

/// to_from_from: takes coordinates of frame `from` to frame `to`, along the transforms in either direction. Nothing
/// where they do not connect the two. Of several transforms of one child the last counts.
std::optional<RigidTransform> find_transform(const std::vector<PoseMessage>& parent_from_child, const std::string& to,
                                             const std::string& from);

}  // namespace remount::bags
