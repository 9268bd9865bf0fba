// What the readers say of bags: a part of model_phrases().
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& bag_phrases();

}  // namespace remount
