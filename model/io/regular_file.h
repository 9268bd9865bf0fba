// Reads whole small files, and nothing but regular files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace remount {

/// The bytes of a regular file of at most `max_bytes`. Throws Error(Io) for what is missing, cannot be read, or is no
/// regular file (a directory, a FIFO or a device would hang or never end), Error(Format) for what is larger.
std::string read_regular_file(const std::filesystem::path& path, std::size_t max_bytes);

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
  /// 0, or what close(2) returned: on some file systems the first report of a failed write.
  int close();

 private:
  int descriptor_ = -1;
};

/// Opens a regular file for reading; errors as read_regular_file. `size` receives its length in bytes.
FileDescriptor open_regular_file(const std::filesystem::path& path, std::size_t& size);

}  // namespace remount
