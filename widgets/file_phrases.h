// What the model says of files and of the data in them: a part of model_phrases().
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& file_phrases();

}  // namespace remount
