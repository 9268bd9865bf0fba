// Files that were compressed as a whole (Zstandard), as ROS 2 does with databases.
#pragma once

#include <filesystem>
#include <string_view>

#include "algorithms/core/progress.h"
#include "model/io/regular_file.h"

namespace remount {

/// True where the file begins as a frame of Zstandard does.
bool is_zstd(std::string_view head);

/// The unpacked file, in the folder for temporary files, until this object goes. What a killed process left there is
/// removed by the next that unpacks one: a lock says whose process lives.
class UnpackedFile {
 public:
  /// Unpacks in pieces; returns early where `progress` is cancelled. Throws Error(Format) naming `packed` where it is
  /// damaged or would become more than a hundred times as large, and Error(Io) that says what to do where there is no
  /// room.
  UnpackedFile(const std::filesystem::path& packed, Progress& progress);
  ~UnpackedFile();
  UnpackedFile(const UnpackedFile&) = delete;
  UnpackedFile& operator=(const UnpackedFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  void unpack(const std::filesystem::path& packed, Progress& progress) const;

  FileDescriptor file_;  ///< locked
  std::filesystem::path path_;
};

}  // namespace remount
