#include "model/project/holder_lock.h"

#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <system_error>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/file_lock.h"
#include "model/formats/files/sha256.h"
#include "model/formats/files/system_call.h"

namespace remount::project {
namespace {

constexpr std::string_view kLockFormat = "remount-lock/1";
constexpr std::size_t kLongestNote = 4096;

std::string user_name() {
  std::array<char, 4096> room{};
  passwd entry{};
  passwd* found = nullptr;
  if (::getpwuid_r(::getuid(), &entry, room.data(), room.size(), &found) == 0 && found != nullptr)
    return found->pw_name;
  return "user " + std::to_string(::getuid());
}

/// A line of the system's, in a form that does not give it away; empty where there is none.
std::string digest_of(const char* path) {
  const formats::FileDescriptor file(formats::retry_interrupted([&] { return ::open(path, O_RDONLY | O_CLOEXEC); }));
  std::array<char, 128> line{};
  const ssize_t size =
      file.get() < 0 ? -1 : formats::retry_interrupted([&] { return ::read(file.get(), line.data(), line.size()); });
  if (size <= 0) return {};
  formats::Sha256 digest;
  digest.update(std::string_view(line.data(), static_cast<std::size_t>(size)));
  return digest.finish().substr(0, 16);
}

std::string record_of(const LockHolder& holder) {
  formats::DocumentNode root = formats::DocumentNode::map();
  root.add("format", formats::DocumentNode::string(kLockFormat));
  root.add("user", formats::DocumentNode::string(holder.user));
  root.add("host", formats::DocumentNode::string(holder.host));
  root.add("process", formats::DocumentNode::integer(holder.process));
  root.add("since_s", formats::DocumentNode::integer(holder.since_s));
  root.add("machine", formats::DocumentNode::string(holder.machine));
  root.add("boot", formats::DocumentNode::string(holder.boot));
  return formats::to_yaml(root);
}

/// Nothing where the file is empty, as one that was just made is, or holds something else.
std::optional<LockHolder> read_holder(const formats::FileDescriptor& file) {
  std::array<char, kLongestNote> room{};
  const ssize_t size = formats::retry_interrupted([&] { return ::pread(file.get(), room.data(), room.size(), 0); });
  if (size <= 0) return std::nullopt;
  try {
    const formats::DocumentNode document =
        formats::parse_yaml(std::string_view(room.data(), static_cast<std::size_t>(size)), "lock");
    const formats::DocumentView root(document, "lock");
    if (root.at("format").string() != kLockFormat) return std::nullopt;
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    return LockHolder{root.at("user").string(),
                      root.at("host").string(),
                      root.at("machine").string(),
                      root.at("boot").string(),
                      root.at("process").integer(1, std::numeric_limits<pid_t>::max()),
                      root.at("since_s").integer(-kMost, kMost)};
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// How long ago the file at `path` was renewed, both ends by the clock of its file system: a file that is made and
/// removed shows what it says now. 0 where that cannot be found out.
std::int64_t age_s(const formats::FileDescriptor& file, const std::filesystem::path& path) {
  const std::string beside = path.string() + "." + std::to_string(::getpid());
  const formats::FileDescriptor made(formats::retry_interrupted(
      [&] { return ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600); }));
  struct stat then {};
  struct stat now {};
  const bool known = made.get() >= 0 && ::fstat(file.get(), &then) == 0 && ::fstat(made.get(), &now) == 0;
  if (made.get() >= 0) formats::retry_interrupted([&] { return ::unlink(beside.c_str()); });
  return known ? std::int64_t{now.st_mtim.tv_sec} - std::int64_t{then.st_mtim.tv_sec} : 0;
}

bool same_computer(const LockHolder& a, const LockHolder& b) { return a.host == b.host && a.machine == b.machine; }

/// Whether a holder that the kernel does not vouch for is to be believed.
bool may_live(const LockHolder& holder, const LockHolder& self, const formats::LockedFile& locked,
              const std::filesystem::path& path) {
  if (same_computer(holder, self)) {
    if (locked.state == formats::LockedFile::State::Ours || holder.boot != self.boot) return false;
    return ::kill(static_cast<pid_t>(holder.process), 0) == 0 || errno == EPERM;
  }
  // A time in the future is no sign of life either: that clock was set back.
  return std::abs(age_s(locked.file, path)) < HolderLock::kStale_s;
}

}  // namespace

std::filesystem::path lock_path_of(const std::filesystem::path& file) {
  constexpr std::size_t kLongestName = 200;  // with what is added, less than any file system takes
  std::error_code unknown;
  std::filesystem::path path = std::filesystem::weakly_canonical(file, unknown);
  if (unknown) path = std::filesystem::absolute(file, unknown).lexically_normal();
  if (unknown) path = file;  // the folder one is in was removed
  std::string name = path.filename().string();
  if (name.size() > kLongestName) {
    formats::Sha256 digest;
    digest.update(name);
    name = digest.finish();
  }
  return path.parent_path() / ("." + name + ".lock");
}

LockHolder this_holder() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {user_name(),
          formats::this_host(),
          digest_of("/etc/machine-id"),
          digest_of("/proc/sys/kernel/random/boot_id"),
          ::getpid(),
          std::chrono::duration_cast<std::chrono::seconds>(now).count()};
}

Message holder_words(const LockHolder& holder) {
  if (holder.user.empty()) return say::lock_holder_unknown();
  std::array<char, 40> since{};
  const std::time_t time = static_cast<std::time_t>(holder.since_s);
  std::tm parts{};
  if (::gmtime_r(&time, &parts) == nullptr || std::strftime(since.data(), since.size(), "%F %H:%M UTC", &parts) == 0)
    since[0] = '?';
  return say::lock_holder(holder.user, holder.host, holder.process, since.data());
}

HolderLock::Attempt HolderLock::take(const std::filesystem::path& path, bool by_force) try {
  // On a file of our own a lock of the kernel's is ours, whoever holds one on the file that lay there.
  if (by_force) formats::retry_interrupted([&] { return ::unlink(path.c_str()); });
  formats::LockedFile locked = formats::open_locked(path);
  const LockHolder self = this_holder();
  const std::optional<LockHolder> holder = read_holder(locked.file);
  const bool busy = locked.state == formats::LockedFile::State::Busy;
  if (busy || (holder && may_live(*holder, self, locked, path))) {
    Attempt held;
    held.holder = holder.value_or(LockHolder{});
    held.on_another_computer = holder && !same_computer(*holder, self);
    return held;
  }
  // What another user left can be read and locked, but not written: it is replaced.
  if (!formats::write_holder(locked.file, record_of(self)) && !by_force) return take(path, true);
  Attempt ours;
  ours.lock.reset(new HolderLock(path, std::move(locked.file), self));
  return ours;
} catch (const Error& error) {
  Attempt none;
  none.why_none = error.what_happened();
  return none;
}

HolderLock::~HolderLock() {
  if (formats::lies_at(file_, path_) && read_holder(file_) == self_) ::unlink(path_.c_str());
}

std::optional<LockHolder> HolderLock::beat() const {
  const formats::FileDescriptor there(
      formats::retry_interrupted([&] { return ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); }));
  if (const std::optional<LockHolder> holder = there.get() < 0 ? std::nullopt : read_holder(there);
      holder && (holder != self_ || !formats::lies_at(file_, path_)))
    return holder;
  ::futimens(file_.get(), nullptr);
  return std::nullopt;
}

}  // namespace remount::project
