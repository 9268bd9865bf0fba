#include "model/drive/finding.h"

namespace remount {

std::string_view to_string(Severity severity) {
  constexpr std::array<std::string_view, 3> kNames{"note", "warning", "problem"};
  return kNames.at(static_cast<std::size_t>(severity));
}

}  // namespace remount
