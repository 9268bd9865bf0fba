// A first X that gross outliers cannot pull.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/calibration/noise_model.h"
#include "algorithms/calibration/pairwise/pair_judgement.h"
#include "algorithms/core/progress.h"
#include "algorithms/motion/pair.h"
#include "algorithms/search/candidates.h"

namespace remount::calibration {

struct RobustStart {
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  /// Typical size of the residuals against the noise model: 1 where the model holds, larger where it is too optimistic.
  double noise_scale = 1.0;
  int passes = 0;  ///< how often all pairs were gone through
};

/// What settles a rotation that the motion hardly determines (roll about the track of a straight drive): pairs overrule
/// it where their truncated cost, the wrong ones' constant share included, is less than `allowance` of that without it.
struct RotationReference {
  std::optional<Eigen::Matrix3d> ins_from_lidar;  ///< the nominal mounting, or an earlier estimate
  std::optional<Eigen::Vector3d> up_in_lidar;     ///< away from the ground, unit length: used where there is no nominal
  double allowance = 0.9;                         ///< less where many pairs overlap and err alike
};

/// Tries the nominal (where known), the global minimum of the quadratic form over screw-consistent pairs and its
/// reweighted successors, each also turned to the reference; keeps the X with the least truncated cost, then refines it
/// with a redescending kernel whose width follows the residuals, held by the weak prior about that rotation and
/// `near_m` where many pairs err alike. Where `progress` is cancelled, what is known until then.
/// @param near_m position of the LiDAR in the INS frame that is likely: the nominal's, or its origin
RobustStart robust_start(const std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& usable,
                         const NoiseModel& noise, const std::optional<RigidTransform>& nominal,
                         const RotationReference& reference, const Eigen::Vector3d& near_m,
                         const Progress& progress = {}, const PairTilts& tilts_rad = {});

}  // namespace remount::calibration
