// A lock that says who holds it, on any file system that can hold a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "algorithms/messages/message.h"
#include "model/formats/files/regular_file.h"

namespace remount::project {

/// The file beside a file, links followed, in which who works on it holds a lock.
std::filesystem::path lock_path_of(const std::filesystem::path& file);

/// A process that holds a lock.
struct LockHolder {
  std::string user, host;
  std::string machine, boot;  ///< which computer, and which start of it; to be compared, not shown
  std::int64_t process = 0;
  std::int64_t since_s = 0;  ///< by its own clock: s since 1970

  bool operator==(const LockHolder&) const = default;
};
LockHolder this_holder();
/// "alice on ws7 (process 4711), since 2026-11-22 20:15 UTC".
Message holder_words(const LockHolder& holder);

/// The kernel's lock (flock) where the file system has one: it ends with its process, so that nothing is left to block
/// after a crash, and no number of a process can be mistaken for another's. Where it has none, or where the lock does
/// not reach other computers (some network folders), the file says who holds it: a process of this computer that is
/// gone, or an earlier start of it, holds nothing any more; another computer holds it as long as it renews the file's
/// time. Times are compared by the clock of the file system alone.
class HolderLock {
 public:
  /// Without a sign of life for so long, a holder on another computer is gone.
  static constexpr std::int64_t kStale_s = 180;
  static constexpr int kBeat_ms = 60000;  ///< how often beat() is to be called

  struct Attempt;
  /// Takes the lock in the file at `path`, which goes when the lock is given back. Never waits and never throws.
  /// @param by_force takes it from a holder that is there or not, who then learns of it by beat().
  static Attempt take(const std::filesystem::path& path, bool by_force = false);

  ~HolderLock();
  HolderLock(const HolderLock&) = delete;
  HolderLock& operator=(const HolderLock&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// A sign of life. Who has taken the lock by force meanwhile, or nothing: it is ours still, as far as can be seen.
  std::optional<LockHolder> beat() const;

 private:
  HolderLock(std::filesystem::path path, formats::FileDescriptor file, LockHolder self)
      : path_(std::move(path)), file_(std::move(file)), self_(std::move(self)) {}

  std::filesystem::path path_;
  formats::FileDescriptor file_;
  LockHolder self_;
};

/// What came of taking a lock: it is ours, or it is held, or there can be none.
struct HolderLock::Attempt {
  std::shared_ptr<const HolderLock> lock;  ///< ours
  std::optional<LockHolder> holder;        ///< held; without names where the file does not say
  bool on_another_computer = false;        ///< of the holder: it may be gone without our knowing
  Message why_none;                        ///< neither: the file system does not let us
};

}  // namespace remount::project
