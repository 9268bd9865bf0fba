// Opens regular files and nothing else, for reading in pieces.
#pragma once

#include <filesystem>

namespace remount::formats {

/// Closes a file descriptor when it goes out of scope.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor() { close(); }

  int get() const { return descriptor_; }
  int release();
  /// 0, or -1 and errno as close(2): on some file systems the first report of a failed write.
  int close();

 private:
  int descriptor_ = -1;
};

/// Opens a regular file for reading. Throws Error(Io) for what is missing, cannot be read, or is no regular file.
FileDescriptor open_regular_file(const std::filesystem::path& path);

}  // namespace remount::formats
