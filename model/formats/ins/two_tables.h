// Positions and attitudes of one INS that stand in tables of their own, at other rates.
#pragma once

#include <string>
#include <vector>

#include "model/drive/finding.h"
#include "model/formats/ins/samples_between_fixes.h"

namespace remount::formats {

struct JoinedMotion {
  std::vector<motion::InsSample> ins;
  std::vector<std::int64_t> fix_stamps_ns;  ///< as in SamplesBetweenFixes
  double position_lag_sigma_s = 0.0;        ///< see position_lag_prior.h
};

/// Samples at the positions, with attitudes that are turned between two; where positions are slow, samples at attitudes
/// between them as well, and where attitudes are the slower ones, at these alone. What has nothing beside it in the
/// other table is left out, and a finding counts it. Throws Error(Format) where the tables have no time in common.
/// @param positions ascending stamps, not empty; of which the attitudes are not used
/// @param attitudes ascending stamps, not empty
/// @param where for messages
JoinedMotion join_tables(std::vector<motion::InsSample> positions, const std::vector<StampedAttitude>& attitudes,
                         const std::string& where, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
