// What is done with a pair whose alignment is doubtful: other transforms around its start are tried.
#pragma once

#include "algorithms/registration/registration.h"

namespace remount::registration {

/// An alignment with how well the surfaces agree under it.
struct JudgedAlignment {
  RegistrationResult result;
  double agreement = 0.0;  ///< AlignmentEquations::agreement
};

/// Whether an alignment may have ended in a wrong minimum: surfaces miss each other, or it moved far from its start, or
/// did not converge, without fitting well. From a good start hardly any pair is.
bool is_doubtful(const JudgedAlignment& alignment, const RigidTransform& target_from_source_start,
                 const RegistrationOptions& options);

/// Whether two transforms are farther apart than a good start and its alignment.
bool moved_far(const RigidTransform& from, const RigidTransform& to);

/// The start and the alignments of the coarse modes around it, refined and compared.
struct AroundSearch {
  RigidTransform target_from_source = RigidTransform::Identity();  ///< where surfaces agree best
  bool better = false;                                             ///< than the alignment that was doubtful
  Message ambiguity;                                               ///< empty, or that another transform fits as well
};
AroundSearch search_around(const PreparedCloud& source, const PreparedCloud& target,
                           const RigidTransform& target_from_source_start, const JudgedAlignment& doubtful,
                           const RegistrationOptions& options, const Progress& progress);

}  // namespace remount::registration
