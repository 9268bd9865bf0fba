#include "model/io/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "algorithms/core/error.h"

namespace remount {

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  if (this != &other) {
    close();
    descriptor_ = other.release();
  }
  return *this;
}

int FileDescriptor::release() { return std::exchange(descriptor_, -1); }

int FileDescriptor::close() {
  const int descriptor = release();
  return descriptor < 0 ? 0 : ::close(descriptor);
}

FileDescriptor open_regular_file(const std::filesystem::path& path, std::size_t& size) {
  // Without O_NONBLOCK the call itself would wait for a writer where the path is a FIFO.
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0)
    throw Error(ErrorCode::Io, path.string(), std::string("cannot be opened: ") + std::strerror(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0)
    throw Error(ErrorCode::Io, path.string(), std::string("cannot be examined: ") + std::strerror(errno));
  if (!S_ISREG(status.st_mode))
    throw Error(ErrorCode::Io, path.string(),
                S_ISDIR(status.st_mode) ? "is a folder, a file was expected" : "is not a regular file");
  size = static_cast<std::size_t>(status.st_size);
  return file;
}

std::string read_regular_file(const std::filesystem::path& path, std::size_t max_bytes) {
  std::size_t size = 0;
  const FileDescriptor file = open_regular_file(path, size);
  if (size > max_bytes)
    throw Error(
        ErrorCode::Format, path.string(),
        "is " + std::to_string(size) + " bytes long, at most " + std::to_string(max_bytes) + " are expected here");
  std::string bytes(size, '\0');
  std::size_t filled = 0;
  while (filled < size) {
    const ssize_t count = ::read(file.get(), bytes.data() + filled, size - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw Error(ErrorCode::Io, path.string(), std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace remount
