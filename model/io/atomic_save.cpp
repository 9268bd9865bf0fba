#include "model/io/atomic_save.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include "algorithms/core/error.h"
#include "model/io/input_file.h"
#include "model/io/regular_file.h"

namespace remount {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& action, int number) {
  throw Error(ErrorCode::Io, path.string(), action + ": " + std::strerror(number) + "; nothing was replaced");
}

/// Removes the temporary file unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& beside) : pattern_(beside.string() + ".XXXXXX") {
    file_ = FileDescriptor(::mkostemp(pattern_.data(), O_CLOEXEC));
    if (file_.get() < 0) fail(beside, "cannot be saved, no temporary file can be made beside it", errno);
  }
  ~TemporaryFile() {
    if (!pattern_.empty()) ::unlink(pattern_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  FileDescriptor& file() { return file_; }
  const char* name() const { return pattern_.c_str(); }
  void renamed() { pattern_.clear(); }

 private:
  std::string pattern_;
  FileDescriptor file_;
};

void write_in_full(int descriptor, std::string_view bytes, const std::filesystem::path& path) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, "cannot be saved", errno);
    if (count == 0) fail(path, "cannot be saved", ENOSPC);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// The rename itself is only on the disk when the folder is.
void flush_folder(const std::filesystem::path& folder) {
  const FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some file systems cannot flush a folder; the file is complete and in place all the same.
  if (descriptor.get() >= 0) ::fsync(descriptor.get());
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::filesystem::path resolved(const std::filesystem::path& path) {
  std::error_code problem;
  if (!std::filesystem::is_symlink(path, problem)) return path;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, problem);
  if (problem)
    throw Error(ErrorCode::Io, path.string(), "cannot be saved, the link leads nowhere: " + problem.message());
  return target;
}

/// Where the bytes will lie in the end, and with which permissions.
struct Target {
  std::filesystem::path path;
  mode_t mode = 0;
};

Target examined(const std::filesystem::path& path) {
  if (path.empty() || !path.has_filename())
    throw Error(ErrorCode::Io, path.string(), "is no name of a file to save to");
  const std::filesystem::path target = resolved(path), folder = folder_of(target);
  std::error_code problem;
  if (!std::filesystem::is_directory(folder, problem))
    throw Error(ErrorCode::Io, path.string(), "cannot be saved, there is no folder " + folder.string());
  struct stat existing {};
  const bool exists = ::stat(target.c_str(), &existing) == 0;
  if (exists && !S_ISREG(existing.st_mode))
    throw Error(
        ErrorCode::Io, path.string(),
        S_ISDIR(existing.st_mode) ? "cannot be saved, it is a folder" : "cannot be saved, it is no regular file");
  if (exists && ::access(target.c_str(), W_OK) != 0) fail(path, "cannot be saved", errno);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return {target, exists ? existing.st_mode & 07777 : 0666 & ~mask};
}

/// Everything is on the disk, under another name.
class WrittenFile {
 public:
  WrittenFile(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), target_(examined(path)), temporary_(target_.path) {
    if (::fchmod(temporary_.file().get(), target_.mode) != 0)
      fail(path, "cannot be saved, its permissions cannot be set", errno);
    write_in_full(temporary_.file().get(), bytes, path);
    if (::fsync(temporary_.file().get()) != 0) fail(path, "cannot be saved", errno);
    if (temporary_.file().close() != 0) fail(path, "cannot be saved", errno);
  }
  void replace() {
    if (::rename(temporary_.name(), target_.path.c_str()) != 0) fail(path_, "cannot be saved", errno);
    temporary_.renamed();
    flush_folder(folder_of(target_.path));
  }

 private:
  std::filesystem::path path_;
  Target target_;
  TemporaryFile temporary_;
};

}  // namespace

void check_can_save(const std::filesystem::path& path) { const TemporaryFile removed_at_once(examined(path).path); }

void check_replaces_its_like(const std::filesystem::path& path, std::string_view mark) {
  constexpr std::size_t kHead = 4096;
  if (!is_file(path)) return;
  const std::string head = read_file_head(path, kHead);
  if (!head.empty() && head.find(mark) == std::string::npos)
    throw Error(ErrorCode::Contract, path.string(),
                "is there and is nothing that this would replace (no \"" + std::string(mark) +
                    "\" in it): name another file, or remove it first");
}

void save_atomically(const std::filesystem::path& path, std::string_view bytes) { save_together({{path, bytes}}); }

void save_together(const std::vector<BytesToSave>& files) {
  std::vector<std::unique_ptr<WrittenFile>> written;
  for (const BytesToSave& file : files) written.push_back(std::make_unique<WrittenFile>(file.path, file.bytes));
  for (const auto& file : written) file->replace();
}

}  // namespace remount
