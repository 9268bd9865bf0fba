// Keyframes, pairs of keyframes, and what is known about each pair.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algorithms/core/index.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"

namespace remount::motion {

using SessionIndex = Index<struct SessionTag>;  ///< among all that a calibration is of
using ScanIndex = Index<struct ScanTag>;        ///< among the scans of its session
using LidarIndex = Index<struct LidarTag>;      ///< among the LiDARs of the vehicle

/// A scan chosen for calibration.
struct Keyframe {
  SessionIndex session;
  ScanIndex scan;
  std::int64_t stamp_ns = 0;  ///< of the scan, on the lidar clock
  double travelled_m = 0.0;   ///< along the trajectory since the session's start
};
using KeyframeIndex = Index<Keyframe>;  ///< among all of a calibration

/// How a registered motion moves with each error of the beams (cloud::BeamErrors), under `perturb`; a column each. None
/// at all where nobody asked, for most pairs of a long drive are never registered; of a file, up to the last that moves
/// it.
using BeamResponse = Eigen::Matrix<float, 6, Eigen::Dynamic>;

/// How a registration went.
struct RegistrationQuality {
  bool attempted = false;
  bool converged = false;
  int iterations = 0;
  double rmse_m = 0.0;   ///< of the inlier residuals along the normals
  double overlap = 0.0;  ///< share of source points with an inlier neighbour, 0..1
  /// Information (inverse covariance) of lidar_b_from_lidar_a under `perturb` (translation first, axes of lidar b).
  Matrix6d information = Matrix6d::Zero();
  BeamResponse beam_response = BeamResponse(6, 0);  ///< of lidar_b_from_lidar_a
  Message failure;                                  ///< empty, or why there is no usable transform
  /// Directions that the surfaces in common do not determine (UndeterminedDirections::words); empty: all are.
  Message undetermined;
};

/// Screw invariants of P X = X Q that hold for every X.
struct ScrewTest {
  double rotation_difference_rad = 0.0;   ///< theta_P - theta_Q
  double translation_difference_m = 0.0;  ///< a_P . t_P - a_Q . t_Q; 0 where the rotation is too small for an axis
  double score = 0.0;                     ///< the larger of the two over its own sigma (dimensionless)
  bool passed = true;
};

enum class PairState { Proposed, Accepted, Rejected };
enum class DecidedBy { Nobody, Program, User };

/// Two keyframes a and b that see the same objects. The motion equation is P X = X Q with
/// P = ins_b_from_ins_a, Q = lidar_b_from_lidar_a and X = ins_from_lidar.
struct Pair {
  KeyframeIndex keyframe_a, keyframe_b;
  double gap_s = 0.0;
  double baseline_m = 0.0;
  double rotation_rad = 0.0;  ///< angle of P
  int shared_objects = 0;
  int moving_objects = 0;
  RigidTransform ins_b_from_ins_a = RigidTransform::Identity();
  RigidTransform lidar_b_from_lidar_a = RigidTransform::Identity();
  RegistrationQuality registration;
  ScrewTest screw;
  double residual_rotation_rad = 0.0;   ///< of P X = X Q under the result
  double residual_translation_m = 0.0;  ///< likewise
  double weight = 0.0;                  ///< robust weight in the solution, 0..1
  PairState state = PairState::Proposed;
  DecidedBy decided_by = DecidedBy::Nobody;
  Message reason;  ///< why it was rejected (or by whom accepted), in words
};
using PairIndex = Index<Pair>;  ///< among all of a calibration

/// Why no solution can use the pair, in words; empty where it can. A registration may converge and still have failed:
/// what it found is then no motion to rely on, so that such a pair is never accepted.
Message unusable_reason(const Pair& pair);

/// Whether a registration was stopped.
bool is_cancelled(const RegistrationQuality& quality);

/// Whether a pair is rejected because a cancelled calibration never came to it: it says nothing, for or against.
bool is_not_reached(const Pair& pair);

/// Whether a pair is rejected because it stands in a list a second time: it says nothing new.
bool repeats_another(const Pair& pair);

}  // namespace remount::motion
