// A check of X that does not use the residual: how sharp the scans' accumulated map is under it.
#pragma once

#include <limits>
#include <vector>

#include "algorithms/calibration/mounting_source.h"
#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount::quality {

/// Scans of one place, seen one after the other; maps are not compared with each other.
struct MapScans {
  std::vector<std::vector<Eigen::Vector3f>> points_in_lidar;  ///< m, of each scan, thinned
  std::vector<RigidTransform> local_from_ins;                 ///< of each scan
};

struct MapSharpness {
  /// Mean of the entropy of the points around each point, half the logarithm of det(2 pi e covariance); lower is
  /// sharper. NaN where scans do not overlap. (Mean map entropy; Droeschel and Behnke, IROS 2014.)
  double mean_map_entropy = std::numeric_limits<double>::quiet_NaN();
  /// Root of the mean variance of flat neighbourhoods across their plane, m; lower is sharper.
  double plane_thickness_m = std::numeric_limits<double>::quiet_NaN();
  std::size_t points = 0;  ///< neighbourhoods that were compared
};

/// The sharpness under one X of several.
struct NamedSharpness {
  calibration::MountingSource source;  ///< Result, Nominal, or that of a candidate
  MapSharpness sharpness;
};

struct SharpnessOptions {
  double radius_m = 0.4;  ///< of a neighbourhood
  int least_points = 10;  ///< of a neighbourhood
  int least_scans = 3;    ///< that a neighbourhood must hold: one scan alone is sharp under every X
  int stride = 4;         ///< every such point is the middle of a neighbourhood
};

/// Sharpness under each X, over the neighbourhoods that exist under all of them: otherwise an X that tears scans apart
/// would be judged by what is left. The same for any number of threads. NaN where cancelled.
std::vector<MapSharpness> compare_sharpness(const std::vector<MapScans>& maps,
                                            const std::vector<RigidTransform>& ins_from_lidar,
                                            const SharpnessOptions& options, int threads, const Progress& progress);

enum class SharperUnder { Neither, First, Second, TooFewPlaces };
/// Which of two is clearly sharper: by more than chance, and in enough places.
SharperUnder compare(const MapSharpness& first, const MapSharpness& second);

}  // namespace remount::quality
