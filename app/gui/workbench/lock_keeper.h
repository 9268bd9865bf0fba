// Locks that are given back in the background.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <thread>

#include "model/project/holder_lock.h"

namespace remount::gui {

/// Giving a lock back removes its file, which on a network folder that does not answer takes as long as that. Whoever
/// lets go of a kept lock does not wait for it. Safe to use from several threads.
class LockKeeper {
 public:
  using LockPtr = std::shared_ptr<const project::HolderLock>;

  /// `give_back` lets go of a lock; tests put one in its place that takes its time.
  explicit LockKeeper(std::function<void(LockPtr)> give_back = [](LockPtr) {}) : give_back_(std::move(give_back)) {}
  ~LockKeeper() = default;  ///< waits for those that are being given back
  LockKeeper(const LockKeeper&) = delete;
  LockKeeper& operator=(const LockKeeper&) = delete;

  /// The same lock, given back by a thread of its own when the last pointer is gone; null stays null. Must not outlive
  /// this.
  LockPtr keep(LockPtr lock);
  /// Until no lock in the file at `path` is being given back: it would seem to be held by somebody else. For a worker.
  void await(const std::filesystem::path& path);

 private:
  struct Release {
    std::filesystem::path path;
    bool done = false;
    std::jthread thread;
  };
  void release(LockPtr lock);

  std::function<void(LockPtr)> give_back_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Release> releases_;  // last: its threads end before anything they use is gone
};

}  // namespace remount::gui
