// Saving that leaves either the old file or the whole new one, never a part.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace remount::formats {

/// What is to outlive a power failure waits for the disk (a project, a result); each of a thousand scans does not.
enum class Flush { ToDisk, Later };

/// Replaces or creates `path` by `bytes`: a temporary file in the same folder is written in full, flushed to the disk
/// and renamed. Where `path` is a symbolic link, its target is replaced. An existing file keeps its permissions. Names
/// and paths may be as long as the file system takes them. Throws Error(Io) that names the path and the reason; the old
/// file is then untouched, but where the error says that the new one is there and the disk did not confirm it. Refuses
/// to replace anything that is not a regular file.
void save_atomically(const std::filesystem::path& path, std::string_view bytes, Flush flush = Flush::ToDisk);

struct BytesToSave {
  std::filesystem::path path;
  std::string_view bytes;
};
/// Files that belong together: none is replaced before all are written in full and on the disk. Throws as
/// save_atomically; an error after some were replaced names them.
void save_together(const std::vector<BytesToSave>& files);

/// Throws now what save_atomically would throw for the path itself, before long work whose result is to be saved there:
/// makes a temporary file beside it and removes it again.
void check_can_save(const std::filesystem::path& path);

/// A slip of the hand must not cost a recording: throws Error(Contract) where `path` is a file that holds something and
/// does not have `mark` within its first 4 KiB.
void check_replaces_its_like(const std::filesystem::path& path, std::string_view mark);

}  // namespace remount::formats
