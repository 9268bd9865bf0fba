// What the simulator needs to know about single scenarios.
#pragma once

#include "algorithms/core/options.h"

namespace remount {

enum class SlewRecording { Ground, ArmSweep, FullTurn };

/// An excavator that stands in a yard; its LiDAR is on the upper body.
struct SlewYardOptions {
  SlewRecording recording = SlewRecording::FullTurn;
  double arc_deg = 360.0;
  double slope_deg = 0.0;
  double uneven_deg = 0.0;
  bool arm = true;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"slew_recording", "",
                    "Of the excavator: it stands still, sweeps its arm up and down, or turns its upper body."},
                   self.recording, {"ground", "arm-sweep", "full-turn"});
    visitor({"slew_arc_deg", "deg", "How far the upper body turns in the drive; negative: clockwise.", -3600.0, 3600.0},
            self.arc_deg);
    visitor({"yard_slope_deg", "deg", "Slope of the yard; the machine stands square on it.", -20.0, 20.0},
            self.slope_deg);
    visitor({"yard_uneven_deg", "deg", "Angle between the yard's ground and what the machine stands on.", -20.0, 20.0},
            self.uneven_deg);
    visitor({"slew_arm", "", "The excavator has an arm; off: nothing of it is seen."}, self.arm);
  }
};

}  // namespace remount
