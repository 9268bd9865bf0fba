// Files that are read in pieces, at any place, by several threads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "model/formats/files/regular_file.h"

namespace remount::formats {

/// A regular file that is open for reading. Thread-safe. Everything is measured by the size that the file had when it
/// was opened.
class RandomAccessFile {
 public:
  /// Throws Error(Io) as open_regular_file does.
  explicit RandomAccessFile(const std::filesystem::path& path) : RandomAccessFile(path, path) {}
  /// @param name the file is called in messages, where it stands for another
  RandomAccessFile(const std::filesystem::path& path, std::filesystem::path name);

  const std::filesystem::path& name() const { return name_; }
  std::uint64_t size() const { return size_; }

  /// `count` bytes from `offset` on. Throws Error(Format) with the place where the file does not hold them, before
  /// memory is taken, and Error(Io) where it cannot be read.
  std::string read(std::uint64_t offset, std::uint64_t count) const;

  /// "path: byte 123", for messages.
  std::string place(std::uint64_t offset) const;

 private:
  std::filesystem::path name_;
  FileDescriptor file_;
  std::uint64_t size_ = 0;
};

}  // namespace remount::formats
