// Writing files so that a full disk never passes for success.
#pragma once

#include <filesystem>
#include <string_view>

namespace remount::formats {

/// Writes a regular file in one go, as save_atomically does, but does not wait for the disk: one of many, such as
/// scans.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Makes the directory and its parents. Throws Error(Io) naming it.
void make_directories(const std::filesystem::path& path);

}  // namespace remount::formats
