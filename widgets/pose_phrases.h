// What is said of positions, poses and frames on the earth: a part of model_phrases().
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& pose_phrases();

}  // namespace remount
