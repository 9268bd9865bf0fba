#include "model/formats/files/random_access_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/system_call.h"
#include "model/formats/files/system_words.h"

namespace remount::formats {

RandomAccessFile::RandomAccessFile(const std::filesystem::path& path, std::filesystem::path name)
    : name_(std::move(name)), file_(open_regular_file(path)) {
  struct stat status {};
  if (retry_interrupted([&] { return ::fstat(file_.get(), &status); }) != 0)
    throw Error(ErrorCode::Io, name_.string(), say::file_cannot_be_examined(system_words(errno)));
  size_ = static_cast<std::uint64_t>(status.st_size);
}

std::string RandomAccessFile::place(std::uint64_t offset) const {
  return name_.string() + ": byte " + std::to_string(offset);
}

std::string RandomAccessFile::read(std::uint64_t offset, std::uint64_t count) const {
  if (offset > size_ || count > size_ - offset)
    throw Error(ErrorCode::Format, place(offset), say::file_ends_early(Bytes{count}, size_));
  std::string bytes(count, '\0');
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = retry_interrupted([&] {
      return ::pread(file_.get(), bytes.data() + filled, bytes.size() - filled, static_cast<off_t>(offset + filled));
    });
    if (got < 0) throw Error(ErrorCode::Io, place(offset), say::file_cannot_be_read(system_words(errno)));
    if (got == 0) throw Error(ErrorCode::Io, place(offset), say::file_became_shorter());
    filled += static_cast<std::size_t>(got);
  }
  return bytes;
}

}  // namespace remount::formats
