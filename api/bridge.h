// Between the public types and those that do the work.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "algorithms/core/error.h"
#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"
#include "model/drive/finding.h"
#include "remount/error.h"
#include "remount/matrices.h"
#include "remount/progress.h"
#include "remount/session.h"

namespace remount::api {

struct Progress::State {
  std::stop_source stop;
  Callback callback;
  std::mutex mutex;
  std::exception_ptr failure;            ///< of the callback
  std::atomic<std::thread::id> telling;  ///< which thread is in the callback

  void tell(const ProgressUpdate& update);
  /// What the callback threw is thrown once.
  void rethrow_failure();
};

inline Matrix4 matrix_of(const RigidTransform& a_from_b) { return a_from_b.matrix(); }

/// Throws remount::Error(Format) at `where` for what is no rigid transform.
RigidTransform rigid_of_matrix(const Matrix4& a_from_b, const std::string& where);

std::vector<Text> texts_of(const std::vector<Message>& messages);
std::vector<Finding> findings_of(const std::vector<drive::Finding>& findings);
Error told(const remount::Error& error);
remount::ErrorCode inner_code(ErrorCode code);
Error cancelled_at(const std::string& where);

/// Errors as the interface tells them.
template <class Work>
auto guarded(const Work& work) {
  try {
    return work();
  } catch (const remount::Error& error) {
    throw told(error);
  }
}

/// Runs `work` with the progress of its caller. What the caller's callback throws is thrown here.
template <class Work>
auto with_progress(const Progress& progress, const Work& work) {
  Progress::State& state = progress.state();
  remount::Progress::Callback callback;
  if (state.callback) callback = [&state](const ProgressUpdate& update) { state.tell(update); };
  remount::Progress inner(state.stop.get_token(), std::move(callback));
  return guarded([&] {
    progress.refuse_within_callback();
    try {
      auto out = work(inner);
      state.rethrow_failure();
      return out;
    } catch (...) {
      state.rethrow_failure();  // it is why the work was cancelled
      throw;
    }
  });
}

/// The same for what has no status that could say that it was cancelled: throws Error(Cancelled) then.
template <class Work>
auto to_the_end(const Progress& progress, const std::string& where, const Work& work) {
  try {
    auto out = with_progress(progress, work);
    if (!progress.cancelled()) return out;
  } catch (const Error&) {
    if (!progress.cancelled()) throw;
  }
  throw cancelled_at(where);
}

}  // namespace remount::api
