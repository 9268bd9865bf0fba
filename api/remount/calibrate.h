// From sessions, or from motions that were computed elsewhere, to a result.
#pragma once

#include <optional>
#include <vector>

#include "remount/progress.h"
#include "remount/result.h"
#include "remount/session.h"
#include "remount/settings.h"

namespace remount::api {

struct CalibrateOptions {
  Settings settings;
  /// Where the LiDAR is about; nothing: as the sessions declare it, if they do. In another frame than the INS's for a
  /// method that finds the LiDAR in that.
  std::optional<Matrix4> nominal_ins_from_lidar;
  bool ignore_declared_nominal = false;
  bool hash_inputs = true;  ///< a result names the files that it is of with their hashes
  int threads = 0;          ///< 0: one per core; the result does not depend on it
};

/// Sessions of one LiDAR on one vehicle, by the method of the settings. Throws Error(Contract) for none, for settings
/// out of range and for a nominal outside the search range; Error(Unsupported) for what the method cannot use.
Result calibrate(const std::vector<Session>& sessions, const CalibrateOptions& options = {},
                 const Progress& progress = Progress());

/// A motion of the INS and one of the LiDAR between the same two moments.
struct MotionPair {
  Matrix4 ins_b_from_ins_a = Matrix4::Identity();      ///< P
  Matrix4 lidar_b_from_lidar_a = Matrix4::Identity();  ///< Q
  /// Numbers of the two moments, by which pairs share the errors of their poses; nothing: each stands for itself.
  std::optional<std::size_t> a, b;
};

/// Solves P X = X Q. Throws Error(Contract) for none and for a nominal outside the search range, Error(Format) that
/// names the pair for what is no rigid transform.
Result solve(const std::vector<MotionPair>& pairs, const CalibrateOptions& options = {},
             const Progress& progress = Progress());

}  // namespace remount::api
