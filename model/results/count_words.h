// Numbers of things in sentences: "1 gap", "2 gaps".
#pragma once

#include <cstddef>
#include <string>

namespace remount::results {

inline std::string signed_of(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace remount::results
