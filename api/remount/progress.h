// Progress reports and cancellation of every long call.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "remount/text.h"

namespace remount::api {

struct Step {
  Text stage;             ///< what is being done: "Registering pairs"
  std::size_t done = 0;   ///< of `total`
  std::size_t total = 0;  ///< 0 where the amount is not known
};

/// Copies are of the same call. The callback is called from any thread, never from two at once; what it throws cancels
/// the call, which throws it then, once. Calls of the callback's own need a Progress of their own: with this one they
/// throw Error(Contract). One that was cancelled stays so.
class Progress {
 public:
  using Callback = std::function<void(const Step&)>;

  Progress();
  explicit Progress(Callback callback);

  /// From any thread, the callback's as well. The call returns soon; its result has the status Cancelled. Calls that
  /// open, make or write something throw Error(Cancelled); a folder that was written is empty then.
  void cancel() const;
  bool cancelled() const;
  /// Throws Error(Contract) where this thread is in the callback, as every call does that is given this progress: for
  /// those that make the call on another thread.
  void refuse_within_callback() const;

  struct State;
  State& state() const { return *state_; }  ///< for Remount itself

 private:
  std::shared_ptr<State> state_;
};

}  // namespace remount::api
