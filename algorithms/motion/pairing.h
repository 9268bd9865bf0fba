// Which two keyframes make a pair, judged by motion; shared objects are judged in cloud/objects.h.
// docs/maths/pairwise.md (P2)
#pragma once

#include <functional>
#include <vector>

#include "algorithms/core/options.h"
#include "algorithms/motion/motion_track.h"
#include "algorithms/motion/pair.h"
#include "messages/options.h"

namespace remount::motion {

enum class PairLimit { Time, Distance, Either };

/// Whether pairs are left out that would hardly make X better.
enum class PairChoice { Auto, All };

struct PairingOptions {
  PairLimit limit = PairLimit::Either;
  double max_gap_s = 1.5;
  double max_distance_m = 10.0;
  double min_distance_m = 0.3;
  double min_rotation_deg = 1.0;
  int max_partners = 8;
  int min_shared_objects = 3;
  PairChoice choice = PairChoice::Auto;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"limit", "", say::option_pairing_limit, say::option_pairing_limit_help}, self.limit,
                   {"time", "distance", "either"});
    visitor({"max_gap_s", "s", say::option_pairing_max_gap_s, say::option_pairing_max_gap_s_help, 0.01, 3600.0},
            self.max_gap_s);
    visitor({"max_distance_m", "m", say::option_pairing_max_distance_m, say::option_pairing_max_distance_m_help, 0.1,
             1000.0},
            self.max_distance_m);
    visitor({"min_distance_m", "m", say::option_pairing_min_distance_m, say::option_pairing_min_distance_m_help, 0.0,
             100.0},
            self.min_distance_m);
    visitor({"min_rotation_deg", "deg", say::option_pairing_min_rotation_deg, say::option_pairing_min_rotation_deg_help,
             0.0, 90.0},
            self.min_rotation_deg);
    visitor({"max_partners", "", say::option_pairing_max_partners, say::option_pairing_max_partners_help, 1, 100},
            self.max_partners);
    visitor({"min_shared_objects", "", say::option_pairing_min_shared_objects,
             say::option_pairing_min_shared_objects_help, 0, 1000},
            self.min_shared_objects);
    visitor.choice({"choice", "", say::option_pairing_choice, say::option_pairing_choice_help}, self.choice,
                   {"auto", "all"});
  }
};

/// Pairs of keyframes of the same session that are close enough and have moved or turned. For each keyframe at most
/// `max_partners` later ones, spread evenly over those allowed, so that short and long gaps are both present.
/// @param ins_poses local_from_ins of each keyframe
/// @param may_share whether two keyframes can see the same at all; nothing: all can
std::vector<Pair> propose_pairs(const std::vector<Keyframe>& keyframes, const std::vector<RigidTransform>& ins_poses,
                                const PairingOptions& options, const std::function<bool(const Pair&)>& may_share = {});

/// Those that some pair names, ascending. @param keyframe_count how many there are
std::vector<KeyframeIndex> keyframes_of(const std::vector<Pair>& pairs, std::size_t keyframe_count);

/// Names the keyframes of all pairs by their places in `kept`, which is ascending and holds all of them.
void renumber_keyframes(const std::vector<KeyframeIndex>& kept, std::vector<Pair>& pairs);

}  // namespace remount::motion
