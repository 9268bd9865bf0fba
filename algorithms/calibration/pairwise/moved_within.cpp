#include "algorithms/calibration/pairwise/moved_within.h"

#include <algorithm>
#include <optional>
#include <set>

#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/noise_prior.h"
#include "algorithms/calibration/pairwise/pair_judgement.h"
#include "algorithms/calibration/pairwise/robust_start.h"
#include "algorithms/core/median.h"
#include "messages/calibration.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {

constexpr std::size_t kFewestPairs = 12;
constexpr std::size_t kFewestKeyframes = 6;  // one bad scan has a pair with each of its neighbours

struct Part {
  std::size_t count = 0, accepted = 0;

  double share() const { return count == 0 ? 0.0 : static_cast<double>(accepted) / static_cast<double>(count); }
};

struct TimedPair {
  motion::PairIndex place;
  double from_s = 0.0, until_s = 0.0;
  bool accepted = false;
};

struct Split {
  double time_s = 0.0;
  bool behind = false;   ///< hardly a pair is accepted behind it, else before it
  std::size_t told = 0;  ///< pairs that are as they are where it moved then
};

std::vector<TimedPair> pairs_of_session(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                        motion::SessionIndex session) {
  std::vector<TimedPair> timed;
  for (motion::PairIndex i; i < pairs.size(); ++i) {
    const motion::Pair& pair = pairs[i];
    const JointNode &a = input.nodes[pair.keyframe_a], &b = input.nodes[pair.keyframe_b];
    if (a.session != session || pair.decided_by == motion::DecidedBy::User || !motion::unusable_reason(pair).empty())
      continue;
    timed.push_back(
        {i, std::min(a.time_s, b.time_s), std::max(a.time_s, b.time_s), pair.state == motion::PairState::Accepted});
  }
  return timed;
}

bool lies_in(const TimedPair& pair, double time_s, bool behind) {
  return behind ? pair.from_s >= time_s : pair.until_s < time_s;
}

// The one that tells most pairs. Times ascend, so that each pair is counted once.
std::optional<Split> find_split(const std::vector<TimedPair>& timed) {
  constexpr double kHardlyAny = 0.1, kMost = 0.5, kLeastShare = 0.1;
  std::vector<TimedPair> by_begin = timed, by_end = timed;
  std::ranges::sort(by_begin, {}, &TimedPair::from_s);
  std::ranges::sort(by_end, {}, &TimedPair::until_s);
  Part behind, before;
  for (const TimedPair& pair : timed) ++behind.count, behind.accepted += pair.accepted ? 1U : 0U;
  std::optional<Split> best;
  auto ended = by_end.begin();
  for (const TimedPair& at : by_begin) {
    for (; ended != by_end.end() && ended->until_s < at.from_s; ++ended)
      ++before.count, before.accepted += ended->accepted ? 1U : 0U;
    for (const bool rejected_behind : {false, true}) {
      const Part &rejected = rejected_behind ? behind : before, &kept = rejected_behind ? before : behind;
      const std::size_t told = rejected.count - rejected.accepted + kept.accepted;
      const auto least = kLeastShare * static_cast<double>(timed.size());
      if (rejected.count >= kFewestPairs && kept.count >= kFewestPairs &&
          static_cast<double>(rejected.count) >= least && rejected.share() <= kHardlyAny && kept.share() >= kMost &&
          (!best || told > best->told))
        best = Split{at.from_s, rejected_behind, told};
    }
    --behind.count, behind.accepted -= at.accepted ? 1U : 0U;  // those that begin later are left
  }
  return best;
}

std::vector<motion::PairIndex> places_in(const std::vector<TimedPair>& timed, double time_s, bool behind) {
  std::vector<motion::PairIndex> places;
  for (const TimedPair& pair : timed)
    if (lies_in(pair, time_s, behind)) places.push_back(pair.place);
  return places;
}

bool has_few_keyframes(const std::vector<motion::Pair>& pairs, const std::vector<motion::PairIndex>& places) {
  std::set<motion::KeyframeIndex> keyframes;
  for (const motion::PairIndex i : places) keyframes.insert({pairs[i].keyframe_a, pairs[i].keyframe_b});
  return keyframes.size() < kFewestKeyframes;
}

}  // namespace

std::vector<MovedWithin> find_moved_within(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                                           const RigidTransform& ins_from_lidar, const Progress& progress) {
  // Pairs that were rejected for other reasons, as in a tunnel or where the INS is bad, fit no other X much better.
  constexpr double kBetter = 4.0;
  const NoiseModel noise = noise_prior(input).expected;
  const PairTilts tilts_rad = assumed_tilts_rad(input, pairs);
  std::vector<MovedWithin> found;
  for (motion::SessionIndex s; s < input.sessions.size() && !progress.cancelled(); ++s) {
    const std::vector<TimedPair> timed = pairs_of_session(input, pairs, s);
    const std::optional<Split> split = find_split(timed);
    if (!split) continue;
    const std::vector<motion::PairIndex> apart = places_in(timed, split->time_s, split->behind),
                                         rest = places_in(timed, split->time_s, !split->behind);
    if (has_few_keyframes(pairs, apart) || has_few_keyframes(pairs, rest)) continue;
    const RobustStart own =
        robust_start(pairs, apart, noise, std::nullopt, {}, Eigen::Vector3d::Zero(), progress, tilts_rad);
    const auto distance = [&](const std::vector<motion::PairIndex>& places, const RigidTransform& x) {
      return std::sqrt(median_of(distances2(noisy_pairs(pairs, places, noise, tilts_rad), x)));
    };
    if (distance(apart, ins_from_lidar) > kBetter * distance(apart, own.ins_from_lidar) &&
        distance(rest, own.ins_from_lidar) > kBetter * distance(rest, ins_from_lidar))
      found.push_back({s, split->time_s});
  }
  return found;
}

void report_moved_within(const PairwiseInput& input, const std::vector<motion::Pair>& pairs, const Progress& progress,
                         CalibrationResult& result) {
  if (!is_solved(result.status)) return;
  const std::vector<MovedWithin> moved = find_moved_within(input, pairs, result.mounting.ins_from_lidar(), progress);
  if (moved.empty()) return;
  std::vector<std::size_t> accepted(input.sessions.size(), 0);
  for (const motion::Pair& pair : pairs)
    accepted[input.nodes[pair.keyframe_a].session] += pair.state == motion::PairState::Accepted ? 1 : 0;
  for (const MovedWithin& one : moved) accepted[one.session] = 0;
  const bool borne_out = std::ranges::any_of(accepted, [](std::size_t count) { return count >= kFewestPairs; });
  for (const MovedWithin& one : moved) {
    const Message title = title_of_session(input, one.session);
    result.advice.push_back(say::calibrate_parts_apart(title, Duration{one.time_s}));
    if (borne_out) continue;
    result.conclude(Status::Inconsistent, say::moved_within_session(title, Duration{one.time_s}));
    claim_nothing(say::unknown_moved_within(), result);
  }
}

}  // namespace remount::calibration
