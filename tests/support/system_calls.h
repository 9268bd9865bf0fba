// Which arguments of a system call say what file it is about.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace remount::testing {

struct SystemCall {
  long number;
  std::string_view name;
  /// Indices of arguments; -1: none. A path without a folder is relative to the working directory.
  int descriptor = -1, folder = -1, path = -1, other_folder = -1, other_path = -1;
  int size = -1;  ///< of those that write: how many bytes
};

/// Null for calls that concern no file.
const SystemCall* find_system_call(std::uint64_t number);

}  // namespace remount::testing
