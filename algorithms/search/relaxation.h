// Lower bounds of the quadratic form over a part of the rotations and a box of translations.
#pragma once

#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/search/scoring.h"

namespace remount::search {

/// What holds in a region of X = [R t]: half-spaces h . [vec R; t; 1] >= 0 and products of two of these (by index),
/// which keep what the linear conditions alone lose. Every entry of t must be bounded by a pair of half-spaces whose
/// product is listed.
struct RelaxedRegion {
  std::vector<QuadraticForm::Vector13d> half_spaces;
  std::vector<std::pair<int, int>> products;
  Eigen::Vector3d t_half_width_m = Eigen::Vector3d::Ones();  ///< of the box of translations, > 0: sets the scale
};

struct RelaxedMinimum {
  double lower_bound = 0.0;                             ///< no X of the region scores less
  RigidTransform nearest = RigidTransform::Identity();  ///< a rotation and translation near the relaxed minimum
  int steps = 0;
};

/// Bound by semidefinite relaxation (Shor 1987): X is replaced by the moments of [vec R; t; 1], of which only the
/// twenty quadratic equations of a rotation matrix and the region's conditions are kept. Every step of the dual barrier
/// method is a valid bound; it stops as soon as the bound reaches `target`, or cannot. Computed around `centre` (best
/// the best X known): there the bound is accurate to far less than the rounding of the form's entries.
/// @param form of [vec R; t; 1], positive semidefinite
RelaxedMinimum relaxed_minimum(const QuadraticForm::Matrix13d& form, const RelaxedRegion& region,
                               const RigidTransform& centre, double target, const Progress& progress);

}  // namespace remount::search
