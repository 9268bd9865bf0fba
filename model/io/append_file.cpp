#include "model/io/append_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "algorithms/core/error.h"

namespace remount {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw Error(ErrorCode::Io, path.string(), std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace

AppendFile::AppendFile(std::filesystem::path path) : path_(std::move(path)), active_(path_.string() + ".active") {
  file_ = FileDescriptor(::open(active_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file_.get() < 0) fail(active_);
}

AppendFile::~AppendFile() {
  if (!finished_) ::unlink(active_.c_str());
}

void AppendFile::write_at(std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail(active_);
    bytes.remove_prefix(static_cast<std::size_t>(count));
    offset += static_cast<std::uint64_t>(count);
  }
}

void AppendFile::append(std::string_view bytes) {
  write_at(size_, bytes);
  size_ += bytes.size();
}

void AppendFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  if (offset + bytes.size() > size_) throw Error(ErrorCode::Contract, active_.string(), "was not written so far yet");
  write_at(offset, bytes);
}

void AppendFile::finish() {
  if (file_.close() != 0 || ::rename(active_.c_str(), path_.c_str()) != 0) fail(path_);
  finished_ = true;
}

}  // namespace remount
