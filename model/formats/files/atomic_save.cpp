#include "model/formats/files/atomic_save.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <system_error>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/regular_file.h"
#include "model/formats/files/system_call.h"
#include "model/formats/files/system_words.h"

namespace remount::formats {
namespace {

/// @param why makes the message of what the system says
[[noreturn]] void fail(const std::filesystem::path& path, Message (*why)(Message), int number) {
  throw Error(ErrorCode::Io, path.string(), why(system_words(number)));
}

/// What a link leads to, also where nothing lies there yet.
std::filesystem::path resolve(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  for (int i = 0; i < kMostLinks; ++i) {
    struct stat status {};
    if (retry_interrupted([&] { return ::lstat(path.c_str(), &status); }) != 0) {
      if (errno == ENOENT) return path;
      if (errno == ENOTDIR)  // a file where a folder should be: said of the folder
        return path;
      fail(path, say::save_failed, errno);
    }
    if (!S_ISLNK(status.st_mode)) return path;
    std::error_code problem;
    std::filesystem::path target;
    do target = std::filesystem::read_symlink(path, problem);
    while (problem == std::errc::interrupted);
    if (problem) fail(path, say::save_link_unreadable, problem.value());
    path = path.parent_path() / target;
  }
  throw Error(ErrorCode::Io, path.string(), say::save_link_leads_nowhere(system_words(ELOOP)));
}

/// Where the bytes will lie in the end, and with which permissions. Everything is done in the folder by its descriptor:
/// a temporary name never makes a path too long, and a folder that is renamed meanwhile still gets its file.
struct Target {
  FileDescriptor folder;
  std::string name;
  std::optional<mode_t> mode;  ///< of the file that is there; of a new one as the process has it
};

FileDescriptor opened_folder(const std::filesystem::path& path, const std::filesystem::path& folder) {
  FileDescriptor descriptor(
      retry_interrupted([&] { return ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC); }));
  if (descriptor.get() >= 0) return descriptor;
  if (errno == ENOENT || errno == ENOTDIR)
    throw Error(ErrorCode::Io, path.string(), say::save_no_folder(folder.string()));
  fail(path, say::save_folder_unopened, errno);
}

Target examine(const std::filesystem::path& path) {
  if (path.empty() || !path.has_filename()) throw Error(ErrorCode::Io, path.string(), say::save_no_name());
  const std::filesystem::path target = resolve(path);
  FileDescriptor folder = opened_folder(path, target.has_parent_path() ? target.parent_path() : ".");
  std::string name = target.filename().string();
  struct stat existing {};
  const bool exists = retry_interrupted([&] { return ::fstatat(folder.get(), name.c_str(), &existing, 0); }) == 0;
  if (!exists && errno != ENOENT) fail(path, say::save_failed, errno);
  if (exists && !S_ISREG(existing.st_mode))
    throw Error(ErrorCode::Io, path.string(),
                S_ISDIR(existing.st_mode) ? say::save_is_folder() : say::save_not_regular());
  if (exists && retry_interrupted([&] { return ::faccessat(folder.get(), name.c_str(), W_OK, 0); }) != 0)
    fail(path, say::save_failed, errno);
  Target found{std::move(folder), std::move(name), std::nullopt};
  if (exists) found.mode = existing.st_mode & 07777;
  return found;
}

/// Beside `name` and, where that is long, no longer: what the file system takes for the one it takes for the other.
std::string temporary_name(const std::string& name, std::random_device& dice) {
  constexpr std::size_t kShort = 100, kDice = 6;
  std::size_t kept = name.size() <= kShort ? name.size() : name.size() - kDice - 1;
  while (kept < name.size() && kept > 0 && (static_cast<unsigned char>(name[kept]) & 0xC0U) == 0x80U)
    --kept;  // no half of a character: some file systems refuse what is no UTF-8
  std::string temporary = name.substr(0, kept) + ".";
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  for (std::size_t i = 0; i < kDice; ++i) temporary += kLetters[dice() % kLetters.size()];
  return temporary;
}

/// Removes the temporary file unless it was renamed.
class TemporaryFile {
 public:
  TemporaryFile(const Target& target, const std::filesystem::path& path) : folder_(target.folder.get()) {
    constexpr int kTries = 100;
    // The kernel takes the process's mask off: to ask for the mask is to set it, for all threads.
    const mode_t mode = target.mode ? 0600 : 0666;
    std::random_device dice;
    for (int i = 0; i < kTries && file_.get() < 0; ++i) {
      name_ = temporary_name(target.name, dice);
      file_ = FileDescriptor(retry_interrupted(
          [&] { return ::openat(folder_, name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode); }));
      if (file_.get() < 0 && errno != EEXIST) break;
    }
    if (file_.get() < 0) fail(path, say::save_no_temporary, errno);
  }
  ~TemporaryFile() {
    if (!name_.empty()) retry_interrupted([&] { return ::unlinkat(folder_, name_.c_str(), 0); });
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  FileDescriptor& file() { return file_; }
  const char* name() const { return name_.c_str(); }
  void renamed() { name_.clear(); }

 private:
  int folder_;
  std::string name_;
  FileDescriptor file_;
};

void write_in_full(int descriptor, std::string_view bytes, const std::filesystem::path& path) {
  while (!bytes.empty()) {
    const ssize_t count = retry_interrupted([&] { return ::write(descriptor, bytes.data(), bytes.size()); });
    if (count < 0) fail(path, say::save_failed, errno);
    if (count == 0) fail(path, say::save_failed, ENOSPC);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// The rename itself is only on the disk when the folder is. Some file systems cannot flush a folder, and one may be
/// written and not read: the file is complete and in place all the same.
void flush_folder(int folder, const std::filesystem::path& path) {
  const FileDescriptor readable(
      retry_interrupted([&] { return ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
  if (readable.get() >= 0 && retry_interrupted([&] { return ::fsync(readable.get()); }) == 0) return;
  if (errno == EIO || errno == ENOSPC || errno == EDQUOT)
    throw Error(ErrorCode::Io, path.string(), say::save_unconfirmed(system_words(errno)));
}

/// Everything is on the disk, under another name.
class WrittenFile {
 public:
  WrittenFile(const std::filesystem::path& path, std::string_view bytes, Flush flush)
      : path_(path), flush_(flush), target_(examine(path)), temporary_(target_, path) {
    FileDescriptor& file = temporary_.file();
    // The file is ours: only a file system that knows no permissions forbids to set them.
    if (target_.mode && retry_interrupted([&] { return ::fchmod(file.get(), *target_.mode); }) != 0 && errno != EPERM &&
        errno != ENOTSUP)
      fail(path, say::save_no_permissions, errno);
    write_in_full(file.get(), bytes, path);
    if (flush == Flush::ToDisk && retry_interrupted([&] { return ::fsync(file.get()); }) != 0)
      fail(path, say::save_failed, errno);
    if (file.close() != 0) fail(path, say::save_failed, errno);
  }
  void replace() {
    const int folder = target_.folder.get();
    if (retry_interrupted([&] { return ::renameat(folder, temporary_.name(), folder, target_.name.c_str()); }) != 0)
      fail(path_, say::save_failed, errno);
    temporary_.renamed();
    if (flush_ == Flush::ToDisk) flush_folder(folder, path_);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Flush flush_;
  Target target_;
  TemporaryFile temporary_;
};

}  // namespace

void check_can_save(const std::filesystem::path& path) {
  const Target target = examine(path);
  const TemporaryFile removed_at_once(target, path);
}

void check_replaces_its_like(const std::filesystem::path& path, std::string_view mark) {
  constexpr std::size_t kHead = 4096;
  if (!is_file(path)) return;
  const std::string head = read_file_head(path, kHead);
  if (!head.empty() && head.find(mark) == std::string::npos)
    throw Error(ErrorCode::Contract, path.string(), say::save_would_replace(std::string(mark)));
}

void save_atomically(const std::filesystem::path& path, std::string_view bytes, Flush flush) {
  WrittenFile(path, bytes, flush).replace();
}

void save_together(const std::vector<BytesToSave>& files) {
  std::vector<std::unique_ptr<WrittenFile>> written;
  for (const BytesToSave& file : files)
    written.push_back(std::make_unique<WrittenFile>(file.path, file.bytes, Flush::ToDisk));
  std::vector<std::string> replaced;
  for (const auto& file : written) try {
      file->replace();
      replaced.push_back(file->path().string());
    } catch (const Error& error) {
      if (replaced.empty()) throw;
      throw Error(error.code(), error.where(), say::save_replaced_already(error.what_happened(), std::move(replaced)));
    }
}

}  // namespace remount::formats
