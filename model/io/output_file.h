// Writing files so that a full disk never passes for success.
#pragma once

#include <filesystem>
#include <string_view>

namespace remount {

/// Writes a regular file in one go: to a temporary name in the same directory, then renamed. Throws Error(Io) naming
/// the path where a write, the close or the rename fails; the file that was there is then left as it was.
/// @param durable also waits until the bytes are on the disk (a project, a result; not each of a thousand scans)
void write_file(const std::filesystem::path& path, std::string_view bytes, bool durable = false);

/// Makes the directory and its parents. Throws Error(Io) naming it.
void make_directories(const std::filesystem::path& path);

}  // namespace remount
