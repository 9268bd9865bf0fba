// Saving that leaves either the old file or the whole new one, never a part.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace remount {

/// Replaces or creates `path` by `bytes`: a temporary file in the same folder is written in full, flushed to the disk
/// and renamed. Where `path` is a symbolic link, its target is replaced. An existing file keeps its permissions.
/// Throws Error(Io) that names the path and the reason; the old file is then untouched. Refuses to replace anything
/// that is not a regular file.
void save_atomically(const std::filesystem::path& path, std::string_view bytes);

struct BytesToSave {
  std::filesystem::path path;
  std::string_view bytes;
};
/// Files that belong together: none is replaced before all are written in full and on the disk. Throws as
/// save_atomically.
void save_together(const std::vector<BytesToSave>& files);

/// Throws now what save_atomically would throw for the path itself, before long work whose result is to be saved there:
/// makes a temporary file beside it and removes it again.
void check_can_save(const std::filesystem::path& path);

/// A slip of the hand must not cost a recording: throws Error(Contract) where `path` is a file that holds something and
/// does not have `mark` within its first 4 KiB.
void check_replaces_its_like(const std::filesystem::path& path, std::string_view mark);

}  // namespace remount
