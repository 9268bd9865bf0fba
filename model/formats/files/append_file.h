// Large files that are written piece by piece and appear under their name when they are whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "model/formats/files/regular_file.h"

namespace remount::formats {

/// Writes beside `path`, under its name with ".active" at the end, until finish() renames it; what was not finished is
/// removed. Throws Error(Io) naming the path where writing fails.
class AppendFile {
 public:
  explicit AppendFile(std::filesystem::path path);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  std::uint64_t size() const { return size_; }
  void append(std::string_view bytes);
  /// Over bytes that were written before.
  void overwrite(std::uint64_t offset, std::string_view bytes);
  void finish();

 private:
  void write_at(std::uint64_t offset, std::string_view bytes);

  std::filesystem::path path_, active_;
  FileDescriptor file_;
  std::uint64_t size_ = 0;
  bool finished_ = false;
};

}  // namespace remount::formats
