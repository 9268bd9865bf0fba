// The global optimum of the quadratic cost within the search range, with a proof. docs/maths/search.md (S10) to (S14)
#pragma once

#include <string>

#include "algorithms/calibration/search_range.h"
#include "algorithms/core/progress.h"
#include "algorithms/search/scoring.h"

namespace remount::search {

enum class SearchOutcome {
  Certified,   ///< nothing in the range scores less than `lower_bound`, which is within the gap of `value`
  GapOpen,     ///< stopped at the limit of regions: `lower_bound` still holds, but is too low
  EmptyRange,  ///< a lower limit lies above its upper limit
  NotFinite,   ///< the form or the range holds numbers that are not finite
  Cancelled,
};

struct SearchOptions {
  double relative_gap = 1e-6;  ///< of the optimum's value
  int most_regions = 100;
};

struct SearchResult {
  SearchOutcome outcome = SearchOutcome::NotFinite;
  Message message;  ///< one sentence: what was proved, or why nothing
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  double value = 0.0;        ///< E2 there
  double lower_bound = 0.0;  ///< of E2 in the whole range, at least 0
  /// The gap that counts as closed: relative, but not less than what rounding of the form's entries allows.
  double allowed_gap = 0.0;
  /// False: other X of the range score the same within the gap (planar or straight driving); the one found is near
  /// the start.
  bool unique = true;
  int regions = 0;  ///< examined

  double gap() const { return value - lower_bound; }
  /// 0 where both are too small to tell from rounding.
  double relative_gap() const { return value > allowed_gap ? gap() / value : 0.0; }
};

/// Branch and bound over yaw, pitch and roll. A rotation is in range where its canonical angles (pitch within +-pi/2)
/// are, as outside_range judges; the translation is eliminated under its own limits. Each region is bounded by a
/// semidefinite relaxation, which is exact in most problems of this kind, so that few regions are needed; time does not
/// depend on the number of pairs. Deterministic. A range of an angle of less than a microradian leaves the gap open by
/// what this little costs; a translation may be held exactly.
/// @param near where the search starts, and what settles what the form does not determine
SearchResult certified_search(const QuadraticForm& form, const calibration::SearchRange& range,
                              const RigidTransform& near, const SearchOptions& options, const Progress& progress);

}  // namespace remount::search
