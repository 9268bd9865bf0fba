// A lock between processes that ends with its holder, however that ends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "model/formats/files/regular_file.h"

namespace remount::formats {

/// A regular file that was opened to be locked (flock).
struct LockedFile {
  enum class State {
    Ours,
    Busy,        ///< another holds the lock
    Impossible,  ///< the file system knows no locks
  };
  FileDescriptor file;  ///< open, whatever the state; for reading alone where it belongs to another user
  State state = State::Busy;
};

/// Opens a file, makes it where there is none, and locks it until the descriptor is closed. The lock is on the file
/// that lies at `path` when this returns, also where holders remove it. Throws Error(Io) where it cannot be opened or
/// is no regular file.
LockedFile open_locked(const std::filesystem::path& path);

/// True where `file` is still what lies at `path`. Never throws.
bool lies_at(const FileDescriptor& file, const std::filesystem::path& path);

/// Advisory (flock): who does not ask is not held off. The file stays when the lock is given back.
class FileLock {
 public:
  /// Nothing where another process holds it. The file then says who: `holder` is one line for people. Throws Error(Io)
  /// where the file cannot be made or locked, or is no regular file.
  static std::optional<FileLock> take(const std::filesystem::path& path, const std::string& holder);

  /// When it was taken, by the clock of the file system that holds it: ns since 1970.
  std::int64_t taken_ns() const { return taken_ns_; }

 private:
  FileLock(FileDescriptor file, std::int64_t taken_ns) : file_(std::move(file)), taken_ns_(taken_ns) {}

  FileDescriptor file_;
  std::int64_t taken_ns_ = 0;
};

/// What the present or last holder wrote, at most a line; empty where nobody has ever held it.
std::string lock_holder(const std::filesystem::path& path);

/// Replaces what a locked file says by `text`. False where that is not possible; the lock holds without it.
bool write_holder(const FileDescriptor& file, const std::string& text);

/// "process 4711 on HOST".
std::string this_process();
std::string this_host();

}  // namespace remount::formats
