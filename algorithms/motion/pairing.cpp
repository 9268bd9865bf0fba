#include "algorithms/motion/pairing.h"

#include <algorithm>

#include "algorithms/core/stamps.h"

namespace remount::motion {
namespace {

bool close_enough(double gap_s, double distance_m, const PairingOptions& options) {
  const bool in_time = gap_s <= options.max_gap_s, in_distance = distance_m <= options.max_distance_m;
  switch (options.limit) {
    case PairLimit::Time:
      return in_time;
    case PairLimit::Distance:
      return in_distance;
    case PairLimit::Either:
      return in_time || in_distance;
  }
  return false;
}

}  // namespace

std::vector<Pair> propose_pairs(const std::vector<Keyframe>& keyframes, const std::vector<RigidTransform>& ins_poses,
                                const PairingOptions& options, const std::function<bool(const Pair&)>& may_share) {
  std::vector<Pair> pairs;
  std::vector<Pair> partners;
  for (KeyframeIndex a; a < keyframes.size(); ++a) {
    partners.clear();
    for (KeyframeIndex b(a + 1); b < keyframes.size() && keyframes[b].session == keyframes[a].session; ++b) {
      Pair pair;
      pair.keyframe_a = a;
      pair.keyframe_b = b;
      pair.gap_s = seconds(keyframes[b].stamp_ns - keyframes[a].stamp_ns);
      pair.ins_b_from_ins_a = ins_poses[b].inverse() * ins_poses[a];
      pair.baseline_m = (ins_poses[b].translation() - ins_poses[a].translation()).norm();
      pair.rotation_rad = so3_log(pair.ins_b_from_ins_a.linear()).norm();
      // Travelled distance only grows, so nothing later can be close once both limits are passed by far.
      if (pair.gap_s > options.max_gap_s &&
          keyframes[b].travelled_m - keyframes[a].travelled_m > 3.0 * options.max_distance_m)
        break;
      const bool moved = pair.baseline_m >= options.min_distance_m ||
                         pair.rotation_rad >= degrees_to_radians(options.min_rotation_deg);
      if (moved && close_enough(pair.gap_s, pair.baseline_m, options) && (!may_share || may_share(pair)))
        partners.push_back(pair);
    }
    const std::size_t wanted = std::min<std::size_t>(partners.size(), static_cast<std::size_t>(options.max_partners));
    for (std::size_t i = 0; i < wanted; ++i)
      pairs.push_back(partners[wanted == 1 ? 0 : i * (partners.size() - 1) / (wanted - 1)]);
  }
  return pairs;
}

std::vector<KeyframeIndex> keyframes_of(const std::vector<Pair>& pairs, std::size_t keyframe_count) {
  std::vector<bool> named(keyframe_count, false);
  for (const Pair& pair : pairs) named[pair.keyframe_a] = named[pair.keyframe_b] = true;
  std::vector<KeyframeIndex> kept;
  for (KeyframeIndex k; k < keyframe_count; ++k)
    if (named[k]) kept.push_back(k);
  return kept;
}

void renumber_keyframes(const std::vector<KeyframeIndex>& kept, std::vector<Pair>& pairs) {
  const auto place_of = [&](KeyframeIndex keyframe) {
    return KeyframeIndex(static_cast<std::size_t>(std::ranges::lower_bound(kept, keyframe) - kept.begin()));
  };
  for (Pair& pair : pairs) {
    pair.keyframe_a = place_of(pair.keyframe_a);
    pair.keyframe_b = place_of(pair.keyframe_b);
  }
}

}  // namespace remount::motion
