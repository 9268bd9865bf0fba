#include "model/results/source_words.h"

#include <cstdio>

#include "algorithms/messages/render.h"
#include "messages/sources.h"

namespace remount {

Message source_words(const std::string& source) {
  for (const auto& made : {say::source_result, say::source_nominal, say::source_refined, say::source_joint_clouds,
                           say::source_park_martin, say::source_dual_quaternion, say::source_joint_quadratic,
                           say::source_certified_optimum, say::source_best_in_range})
    if (english(made()) == source) return made();
  int first = 0, second = 0, end = 0;
  const int size = static_cast<int>(source.size());
  if (std::sscanf(source.c_str(), "pair %d%n", &first, &end) == 1 && end == size) return say::source_pair(first);
  if (std::sscanf(source.c_str(), "pairs %d + %d%n", &first, &second, &end) == 2 && end == size)
    return say::source_pairs(first, second);
  return Message::verbatim(source);
}

}  // namespace remount
