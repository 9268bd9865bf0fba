// A lock between processes that ends with its holder, however that ends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "model/io/regular_file.h"

namespace remount {

/// Advisory (flock): who does not ask is not held off. The file stays when the lock is given back, for removing it
/// would let two hold a lock of one name.
class FileLock {
 public:
  /// Nothing where another process holds it. The file then says who: `holder` is one line for people. Throws Error(Io)
  /// where the file cannot be made or is no regular file.
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

/// "process 4711 on HOST".
std::string this_process();

}  // namespace remount
