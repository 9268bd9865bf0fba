// Between the public types and those that do the work.
#pragma once

#include <exception>
#include <mutex>
#include <stop_token>
#include <string>
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
  std::exception_ptr failure;  ///< of the callback

  void tell(const ProgressUpdate& update);
};

inline Matrix4 matrix_of(const RigidTransform& a_from_b) { return a_from_b.matrix(); }

/// Throws remount::Error(Format) at `where` for what is no rigid transform.
RigidTransform rigid_of_matrix(const Matrix4& a_from_b, const std::string& where);

std::vector<Text> texts_of(const std::vector<Message>& messages);
std::vector<Finding> findings_of(const std::vector<drive::Finding>& findings);
Error told(const remount::Error& error);

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
    auto out = work(inner);
    if (state.failure) std::rethrow_exception(state.failure);
    return out;
  });
}

}  // namespace remount::api
