// Which scans become keyframes. docs/maths/pairwise.md (P1)
#pragma once

#include <vector>

#include "algorithms/core/options.h"
#include "algorithms/motion/motion_track.h"
#include "algorithms/motion/pair.h"

namespace remount {

enum class KeyframeMode { Distance, Time };

struct KeyframeOptions {
  KeyframeMode mode = KeyframeMode::Distance;
  double distance_m = 1.0;
  double rotation_deg = 5.0;
  double interval_s = 0.5;
  int minimum = 40;
  int maximum = 2000;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"mode", "", "Take a keyframe after a travelled distance or after a time."}, self.mode,
                   {"distance", "time"});
    visitor({"distance_m", "m", "Travelled distance between keyframes (mode distance).", 0.01, 1000.0},
            self.distance_m);
    visitor({"rotation_deg", "deg", "Turn after which a keyframe is taken even without distance (mode distance).", 0.1,
             180.0},
            self.rotation_deg);
    visitor({"interval_s", "s", "Time between keyframes (mode time).", 0.01, 1000.0}, self.interval_s);
    visitor({"minimum", "", "A short drive takes keyframes closer together until it has this many, or all its scans.",
             2, 10000},
            self.minimum);
    visitor({"maximum", "", "At most this many keyframes a session; beyond it they are spread evenly.", 2, 100000},
            self.maximum);
  }
};

/// Chooses keyframes among the scans of one session. Scans whose time the trajectory does not cover are left out.
/// @param scan_stamps_ns ascending, lidar clock
/// @param offset_s t_ins = t_lidar + offset
std::vector<Keyframe> select_keyframes(int session, const std::vector<std::int64_t>& scan_stamps_ns,
                                       const MotionTrack& track, double offset_s, const KeyframeOptions& options);

}  // namespace remount
