#include "model/io/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "algorithms/core/error.h"
#include "model/io/system_call.h"

namespace remount {

namespace {

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  return S_ISSOCK(mode) ? "a socket" : "something else";
}

}  // namespace

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
  if (descriptor < 0 || ::close(descriptor) == 0) return 0;
  return errno == EINTR ? 0 : -1;  // interrupted or not, Linux has given the descriptor back: never again
}

FileDescriptor open_regular_file(const std::filesystem::path& path) {
  // Without O_NONBLOCK the call itself would wait for a writer where the path is a FIFO.
  FileDescriptor file(uninterrupted([&] { return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); }));
  if (file.get() < 0)
    throw Error(ErrorCode::Io, path.string(), std::string("cannot be opened: ") + std::strerror(errno));
  struct stat status {};
  if (uninterrupted([&] { return ::fstat(file.get(), &status); }) != 0)
    throw Error(ErrorCode::Io, path.string(), std::string("cannot be examined: ") + std::strerror(errno));
  if (!S_ISREG(status.st_mode))
    throw Error(ErrorCode::Io, path.string(),
                std::string("is ") + kind_of(status.st_mode) + ", expected a regular file");
  return file;
}

std::optional<struct stat> status_of(const std::filesystem::path& path) {
  struct stat status {};
  if (uninterrupted([&] { return ::stat(path.c_str(), &status); }) == 0) return status;
  if (errno == ENOENT || errno == ENOTDIR || errno == ENAMETOOLONG || errno == ELOOP) return std::nullopt;
  throw Error(ErrorCode::Io, path.string(), std::string("cannot be examined: ") + std::strerror(errno));
}

}  // namespace remount
