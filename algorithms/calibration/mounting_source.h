// Where a mounting that is listed beside others comes from.
#pragma once

#include <string>
#include <string_view>

#include "algorithms/messages/message.h"
#include "algorithms/motion/pair.h"

namespace remount::calibration {

struct MountingSource {
  enum Kind {
    Result,
    Nominal,
    Refined,      ///< the least squares over all accepted pairs
    JointClouds,  ///< the same after pairs were registered anew, all clouds together
    OnePair,
    TwoPairs,
    ParkMartin,
    DualQuaternion,
    JointQuadratic,
    CertifiedOptimum,
    BestInRange,  ///< of a search that was not proved to the end
    Unknown,      ///< of a file that another version wrote
  };
  Kind kind = Unknown;
  motion::PairIndex first, second;  ///< of OnePair the first, of TwoPairs both
  std::string unknown;              ///< of Unknown, as the file has it

  MountingSource() = default;
  MountingSource(Kind of) : kind(of) {}  // NOLINT(google-explicit-constructor): most have nothing else
  static MountingSource pair(motion::PairIndex number);
  static MountingSource pairs(motion::PairIndex first, motion::PairIndex second);

  friend bool operator==(const MountingSource&, const MountingSource&) = default;
};

/// "pair 12", "pairs 3 + 17", "all pairs: Park-Martin", "refined": as files have them.
std::string to_string(const MountingSource& source);
/// Never fails: what it does not know is Unknown.
MountingSource mounting_source_from_string(std::string_view text);

Message in_words(const MountingSource& source);

}  // namespace remount::calibration
