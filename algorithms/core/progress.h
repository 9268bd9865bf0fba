// Progress reports and cancellation, passed to every long call.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <stop_token>
#include <utility>

#include "algorithms/messages/message.h"

namespace remount {

/// What is being done: a maker of messages/stages.h. Its message is made where somebody reads it, for items are
/// reported by the thousand; those who tell stages apart compare the makers.
using Stage = Message (*)();

struct ProgressUpdate {
  Stage stage = nullptr;
  std::size_t done = 0;
  std::size_t total = 0;  ///< 0 where the amount is not known
};

/// A stop token and a callback. Safe to use from several workers: the callback is called under a lock.
class Progress {
 public:
  using Callback = std::function<void(const ProgressUpdate&)>;

  Progress() = default;
  explicit Progress(std::stop_token stop, Callback callback = {})
      : stop_(std::move(stop)), callback_(std::move(callback)) {}

  /// For one of several tasks whose counts would mix: it can be cancelled like this one, and says nothing.
  Progress without_reports() const { return Progress(stop_); }

  bool cancelled() const { return stop_.stop_requested(); }

  void report(Stage stage, std::size_t done, std::size_t total) {
    if (!callback_) return;
    const std::scoped_lock lock(mutex_);
    callback_({stage, done, total});
  }

 private:
  std::stop_token stop_;
  Callback callback_;
  std::mutex mutex_;
};

}  // namespace remount
