#include "algorithms/calibration/pairwise/moved_within.h"

#include <algorithm>
#include <optional>
#include <set>

#include "algorithms/calibration/pairwise/robust_start.h"

namespace remount::calibration {
namespace {

struct Part {
  std::size_t count = 0, accepted = 0;

  double share() const { return count == 0 ? 0.0 : static_cast<double>(accepted) / static_cast<double>(count); }
};

struct Split {
  double time_s = 0.0;
  bool behind = false;   ///< hardly a pair is accepted behind it, else before it
  std::size_t told = 0;  ///< pairs that are as they are where it moved then
};

struct TimedPair {
  motion::PairIndex place;
  double from_s = 0.0, until_s = 0.0;
  bool accepted = false;
};

std::vector<TimedPair> pairs_of_session(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                        const std::vector<motion::PairIndex>& usable, motion::SessionIndex session) {
  std::vector<TimedPair> timed;
  for (const motion::PairIndex i : usable) {
    const motion::Pair& pair = pairs[i];
    const JointNode &a = input.nodes[pair.keyframe_a], &b = input.nodes[pair.keyframe_b];
    if (a.session != session || pair.decided_by == motion::DecidedBy::User) continue;
    timed.push_back(
        {i, std::min(a.time_s, b.time_s), std::max(a.time_s, b.time_s), pair.state == motion::PairState::Accepted});
  }
  return timed;
}

bool lies_in(const TimedPair& pair, double time_s, bool behind) {
  return behind ? pair.from_s >= time_s : pair.until_s < time_s;
}

Part part_of(const std::vector<TimedPair>& timed, double time_s, bool behind) {
  Part part;
  for (const TimedPair& pair : timed) {
    if (!lies_in(pair, time_s, behind)) continue;
    ++part.count;
    part.accepted += pair.accepted ? 1 : 0;
  }
  return part;
}

// The one that tells most pairs.
std::optional<Split> find_split(const std::vector<TimedPair>& timed) {
  constexpr std::size_t kFewest = 12;
  constexpr double kHardlyAny = 0.1, kMost = 0.5, kLeastShare = 0.1;
  std::set<double> times_s;
  for (const TimedPair& pair : timed) times_s.insert(pair.from_s);
  std::optional<Split> best;
  for (const double time_s : times_s)
    for (const bool behind : {false, true}) {
      const Part rejected = part_of(timed, time_s, behind), kept = part_of(timed, time_s, !behind);
      if (rejected.count < kFewest || kept.count < kFewest || rejected.share() > kHardlyAny || kept.share() < kMost ||
          static_cast<double>(rejected.count) < kLeastShare * static_cast<double>(timed.size()))
        continue;
      const std::size_t told = rejected.count - rejected.accepted + kept.accepted;
      if (!best || told > best->told) best = Split{time_s, behind, told};
    }
  return best;
}

}  // namespace

std::vector<MovedWithin> find_moved_within(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                           const std::vector<motion::PairIndex>& usable, const NoiseModel& expected,
                                           const Progress& progress) {
  // Against the expected noise: pairs of one mounting fit each other about as well as the noise says.
  constexpr double kCoherentScale = 5.0;
  const PairTilts tilts_rad = assumed_tilts_rad(input, pairs);
  std::vector<MovedWithin> found;
  for (motion::SessionIndex s; s < input.sessions.size() && !progress.cancelled(); ++s) {
    const std::vector<TimedPair> timed = pairs_of_session(input, pairs, usable, s);
    const std::optional<Split> split = find_split(timed);
    if (!split) continue;
    std::vector<motion::PairIndex> apart;
    for (const TimedPair& pair : timed)
      if (lies_in(pair, split->time_s, split->behind)) apart.push_back(pair.place);
    const RobustStart own =
        robust_start(pairs, apart, expected, std::nullopt, {}, Eigen::Vector3d::Zero(), progress, tilts_rad);
    if (own.noise_scale < kCoherentScale) found.push_back({s, split->time_s});
  }
  return found;
}

}  // namespace remount::calibration
