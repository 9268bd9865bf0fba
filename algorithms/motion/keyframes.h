// Which scans become keyframes. docs/maths/pairwise.md (P1)
#pragma once

#include <vector>

#include "algorithms/core/options.h"
#include "algorithms/motion/motion_track.h"
#include "algorithms/motion/pair.h"
#include "messages/options.h"

namespace remount::motion {

enum class KeyframeMode { Distance, Time };

/// Whether the scans around a keyframe are gathered to one.
enum class Gathering { Auto, Off, Frames };

struct KeyframeOptions {
  KeyframeMode mode = KeyframeMode::Distance;
  double distance_m = 1.0;
  double rotation_deg = 5.0;
  double interval_s = 0.5;
  int minimum = 40;
  int maximum = 2000;
  Gathering gather = Gathering::Auto;
  int gather_frames = 5;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"mode", "", say::option_keyframes_mode, say::option_keyframes_mode_help}, self.mode,
                   {"distance", "time"});
    visitor({"distance_m", "m", say::option_keyframes_distance_m, say::option_keyframes_distance_m_help, 0.01, 1000.0},
            self.distance_m);
    visitor({"rotation_deg", "deg", say::option_keyframes_rotation_deg, say::option_keyframes_rotation_deg_help, 0.1,
             180.0},
            self.rotation_deg);
    visitor({"interval_s", "s", say::option_keyframes_interval_s, say::option_keyframes_interval_s_help, 0.01, 1000.0},
            self.interval_s);
    visitor({"minimum", "", say::option_keyframes_minimum, say::option_keyframes_minimum_help, 2, 10000}, self.minimum);
    visitor({"maximum", "", say::option_keyframes_maximum, say::option_keyframes_maximum_help, 2, 100000},
            self.maximum);
    visitor.choice({"gather", "", say::option_keyframes_gather, say::option_keyframes_gather_help}, self.gather,
                   {"auto", "off", "frames"});
    visitor({"gather_frames", "", say::option_keyframes_gather_frames, say::option_keyframes_gather_frames_help, 2, 50},
            self.gather_frames);
  }
};

/// How many scans a keyframe is made of: its own, and those before and after it.
struct GatheredFrames {
  std::size_t count = 1;

  std::size_t before() const { return (count - 1) / 2; }
  std::size_t after() const { return count / 2; }
};

/// Chooses keyframes among the scans of one session. Scans whose time the trajectory does not cover are left out.
/// @param scan_stamps_ns ascending, lidar clock
/// @param offset_s t_ins = t_lidar + offset
/// @param frames that are gathered to a keyframe: no two keyframes have one in common, for it would be aligned with
///        itself and agree whatever the mounting
std::vector<Keyframe> select_keyframes(SessionIndex session, const std::vector<std::int64_t>& scan_stamps_ns,
                                       const MotionTrack& track, double offset_s, const KeyframeOptions& options,
                                       GatheredFrames frames = {});

}  // namespace remount::motion
