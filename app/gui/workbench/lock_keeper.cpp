#include "app/gui/workbench/lock_keeper.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace remount::gui {

LockKeeper::LockPtr LockKeeper::keep(LockPtr lock) {
  if (!lock) return lock;
  const project::HolderLock* const plain = lock.get();
  return {plain, [this, lock = std::move(lock)](const project::HolderLock*) mutable { release(std::move(lock)); }};
}

void LockKeeper::release(LockPtr lock) {
  const std::scoped_lock guard(mutex_);
  releases_.remove_if([](const Release& release) { return release.done; });
  Release& release = releases_.emplace_back();
  release.path = lock->path();
  try {
    release.thread = std::jthread([this, &release, lock = std::move(lock)]() mutable {
      give_back_(std::move(lock));
      lock.reset();
      const std::scoped_lock ended(mutex_);
      release.done = true;
      changed_.notify_all();
    });
  } catch (const std::system_error&) {
    release.done = true;  // no thread can be started: the lock went with what was to be its task
  }
}

void LockKeeper::await(const std::filesystem::path& path) {
  std::unique_lock guard(mutex_);
  changed_.wait(guard, [&] {
    return std::none_of(releases_.begin(), releases_.end(),
                        [&](const Release& release) { return !release.done && release.path == path; });
  });
}

}  // namespace remount::gui
