#include "model/formats/files/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/system_call.h"
#include "model/formats/files/system_words.h"

namespace remount::formats {

namespace {

Message kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return say::file_kind_directory();
  if (S_ISFIFO(mode)) return say::file_kind_fifo();
  if (S_ISCHR(mode) || S_ISBLK(mode)) return say::file_kind_device();
  return S_ISSOCK(mode) ? say::file_kind_socket() : say::file_kind_other();
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
  FileDescriptor file(retry_interrupted([&] { return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); }));
  if (file.get() < 0) throw Error(ErrorCode::Io, path.string(), say::file_cannot_be_opened(system_words(errno)));
  struct stat status {};
  if (retry_interrupted([&] { return ::fstat(file.get(), &status); }) != 0)
    throw Error(ErrorCode::Io, path.string(), say::file_cannot_be_examined(system_words(errno)));
  if (!S_ISREG(status.st_mode))
    throw Error(ErrorCode::Io, path.string(), say::file_not_regular(kind_of(status.st_mode)));
  return file;
}

std::optional<struct stat> status_of(const std::filesystem::path& path) {
  struct stat status {};
  if (retry_interrupted([&] { return ::stat(path.c_str(), &status); }) == 0) return status;
  if (errno == ENOENT || errno == ENOTDIR || errno == ENAMETOOLONG || errno == ELOOP) return std::nullopt;
  throw Error(ErrorCode::Io, path.string(), say::file_cannot_be_examined(system_words(errno)));
}

}  // namespace remount::formats
