#include "model/drive/finding.h"

#include "algorithms/core/index.h"

namespace remount::drive {

std::string_view to_string(Severity severity) {
  constexpr std::array<std::string_view, 3> kNames{"note", "warning", "problem"};
  return kNames.at(index_of(severity));
}

}  // namespace remount::drive
