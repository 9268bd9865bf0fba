// The motion between two scans.
#pragma once

#include "remount/matrices.h"
#include "remount/progress.h"
#include "remount/session.h"
#include "remount/settings.h"
#include "remount/text.h"

namespace remount::api {

struct Registration {
  Matrix4 target_from_source = Matrix4::Identity();
  bool converged = false;
  int iterations = 0;
  double rmse_m = 0.0;   ///< of what matches, along the surfaces' normals
  double overlap = 0.0;  ///< share of points of the source with a neighbour
  /// Inverse covariance of translation (m) and rotation vector (rad), in the axes of the target.
  Matrix6 information = Matrix6::Zero();
  Text failure;       ///< empty, or why there is no usable transform
  Text undetermined;  ///< directions that the surfaces in common do not show; empty: they show all
};

/// By the algorithm of the settings' section "registration", from a start that is off by less than some metres and
/// degrees. Scans are taken as they are: motion within them is not compensated.
Registration register_scans(const Scan& source, const Scan& target, const Matrix4& target_from_source_start,
                            const Settings& settings = Settings(), const Progress& progress = Progress());

}  // namespace remount::api
