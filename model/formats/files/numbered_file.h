// Files that go by their numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>

namespace remount::formats {

/// "000042.bin": the number with zeros in front, `digits` at least.
inline std::filesystem::path numbered_file(const std::filesystem::path& folder, std::size_t number, std::size_t digits,
                                           const char* extension) {
  std::string name = std::to_string(number);
  name.insert(0, digits - std::min(digits, name.size()), '0');
  return folder / (name + extension);
}

}  // namespace remount::formats
