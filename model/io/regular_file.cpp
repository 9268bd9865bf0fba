#include "model/io/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "algorithms/core/error.h"

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
  return descriptor < 0 ? 0 : ::close(descriptor);
}

FileDescriptor open_regular_file(const std::filesystem::path& path) {
  // Without O_NONBLOCK the call itself would wait for a writer where the path is a FIFO.
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0)
    throw Error(ErrorCode::Io, path.string(), std::string("cannot be opened: ") + std::strerror(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0)
    throw Error(ErrorCode::Io, path.string(), std::string("cannot be examined: ") + std::strerror(errno));
  if (!S_ISREG(status.st_mode))
    throw Error(ErrorCode::Io, path.string(),
                std::string("is ") + kind_of(status.st_mode) + ", expected a regular file");
  return file;
}

}  // namespace remount
