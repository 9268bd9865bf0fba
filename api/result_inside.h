// What a result is made of.
#pragma once

#include <vector>

#include "algorithms/motion/pair.h"
#include "model/drive/finding.h"
#include "model/results/result_file.h"
#include "remount/result.h"

namespace remount::api {

struct Result::Inside {
  results::ResultFile file;
  std::vector<drive::Finding> findings;  ///< all, where a file has those that matter
  // Of a result that was read from a file there are none.
  std::vector<motion::Keyframe> keyframes;
  std::vector<motion::Pair> pairs;  ///< as in the file
};

}  // namespace remount::api
