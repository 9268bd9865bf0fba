// What the readers say of tables, poses, sessions and files of scans: a part of model_phrases().
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& reader_phrases();

}  // namespace remount
