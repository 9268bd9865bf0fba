// Files that cannot be read where they lie: compressed as a whole (Zstandard), as ROS 2 does with databases and MCAPs,
// or a database whose log SQLite must work on in a folder that cannot be written.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "algorithms/core/progress.h"
#include "model/formats/files/regular_file.h"

namespace remount::bags {

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
  /// A copy of a database with its write-ahead log beside it; likewise.
  struct WithLog {
    std::filesystem::path database, log;
  };
  UnpackedFile(const WithLog& files, Progress& progress);
  ~UnpackedFile();
  UnpackedFile(const UnpackedFile&) = delete;
  UnpackedFile& operator=(const UnpackedFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  void make(const std::filesystem::path& source);
  void unpack(const std::filesystem::path& packed, Progress& progress) const;
  void copy(const std::filesystem::path& source, int to, Progress& progress) const;

  formats::FileDescriptor file_;  ///< locked
  std::filesystem::path path_;
};

/// A bag's file as it was given, and where its bytes are.
struct BagInput {
  std::filesystem::path given;                   ///< what messages name
  std::shared_ptr<const UnpackedFile> unpacked;  ///< what came out of it; null where it is read itself
  const std::filesystem::path& path() const { return unpacked ? unpacked->path() : given; }
};

}  // namespace remount::bags
