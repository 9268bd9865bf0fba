#include "model/formats/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/system_call.h"
#include "model/formats/files/system_words.h"

namespace remount::formats {
namespace {

[[noreturn]] void fail_to_lock(const std::filesystem::path& path) {
  throw Error(ErrorCode::Io, path.string(), say::lock_failed(system_words(errno)));
}

}  // namespace

bool lies_at(const FileDescriptor& file, const std::filesystem::path& path) {
  struct stat ours {};
  struct stat there {};
  return retry_interrupted([&] { return ::fstat(file.get(), &ours); }) == 0 &&
         retry_interrupted([&] { return ::stat(path.c_str(), &there); }) == 0 && ours.st_dev == there.st_dev &&
         ours.st_ino == there.st_ino;
}

LockedFile open_locked(const std::filesystem::path& path) {
  constexpr int kTries = 100;  // each fails only where a holder removed its file in between
  for (int i = 0; i < kTries; ++i) {
    FileDescriptor file(
        retry_interrupted([&] { return ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666); }));
    if (file.get() < 0 && errno == EACCES) {  // another user's, or not allowed to be made
      file = FileDescriptor(retry_interrupted([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); }));
      if (file.get() < 0) errno = EACCES;
    }
    struct stat status {};
    if (file.get() < 0 || retry_interrupted([&] { return ::fstat(file.get(), &status); }) != 0) fail_to_lock(path);
    if (!S_ISREG(status.st_mode)) throw Error(ErrorCode::Io, path.string(), say::lock_not_regular());
    if (retry_interrupted([&] { return ::flock(file.get(), LOCK_EX | LOCK_NB); }) != 0) {
      if (errno == EWOULDBLOCK) return {std::move(file), LockedFile::State::Busy};
      return {std::move(file), LockedFile::State::Impossible};
    }
    if (lies_at(file, path)) return {std::move(file), LockedFile::State::Ours};
  }
  throw Error(ErrorCode::Io, path.string(), say::lock_unsteady());
}

bool write_holder(const FileDescriptor& file, const std::string& text) {
  return retry_interrupted([&] { return ::ftruncate(file.get(), 0); }) == 0 &&
         retry_interrupted([&] { return ::pwrite(file.get(), text.data(), text.size(), 0); }) ==
             static_cast<ssize_t>(text.size());
}

std::optional<FileLock> FileLock::take(const std::filesystem::path& path, const std::string& holder) {
  LockedFile locked = open_locked(path);
  if (locked.state == LockedFile::State::Busy) return std::nullopt;
  if (locked.state == LockedFile::State::Impossible) throw Error(ErrorCode::Io, path.string(), say::lock_impossible());
  write_holder(locked.file, holder + "\n");
  struct stat status {};
  if (retry_interrupted([&] { return ::fstat(locked.file.get(), &status); }) != 0) fail_to_lock(path);
  return FileLock(std::move(locked.file), std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec);
}

std::string lock_holder(const std::filesystem::path& path) {
  try {
    const std::string text = read_file_head(path, 200);
    return text.substr(0, text.find('\n'));
  } catch (const Error&) {
    return {};
  }
}

std::string this_host() {
  std::array<char, 256> host{};
  return ::gethostname(host.data(), host.size() - 1) == 0 ? host.data() : "?";
}

std::string this_process() { return "process " + std::to_string(::getpid()) + " on " + this_host(); }

}  // namespace remount::formats
