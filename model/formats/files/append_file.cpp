#include "model/formats/files/append_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/file_lock.h"
#include "model/formats/files/system_call.h"
#include "model/formats/files/system_words.h"

namespace remount::formats {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw Error(ErrorCode::Io, path.string(), say::file_cannot_be_written(system_words(errno)));
}

}  // namespace

AppendFile::AppendFile(std::filesystem::path path) : path_(std::move(path)), active_(path_.string() + ".active") {
  // The lock ends with its process: what a killed one left is written over, what another writes is not.
  LockedFile locked = open_locked(active_);
  if (locked.state == LockedFile::State::Busy)
    throw Error(ErrorCode::Io, active_.string(), say::file_written_by_another());
  file_ = std::move(locked.file);
  if (retry_interrupted([&] { return ::ftruncate(file_.get(), 0); }) == 0) return;
  const int reason = errno;
  ::unlink(active_.c_str());
  errno = reason;
  fail(active_);
}

AppendFile::~AppendFile() {
  if (!finished_) retry_interrupted([&] { return ::unlink(active_.c_str()); });
}

void AppendFile::write_at(std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = retry_interrupted(
        [&] { return ::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset)); });
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
  if (offset + bytes.size() > size_)
    throw Error(ErrorCode::Contract, active_.string(), Message::verbatim("was not written so far yet"));
  write_at(offset, bytes);
}

void AppendFile::finish() {
  // On the disk before it has its name; closed, which ends the lock, when it has it.
  if (retry_interrupted([&] { return ::fsync(file_.get()); }) != 0 ||
      retry_interrupted([&] { return ::rename(active_.c_str(), path_.c_str()); }) != 0)
    fail(path_);
  finished_ = true;
  file_.close();
}

}  // namespace remount::formats
