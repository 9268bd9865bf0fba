// What the simulator needs to know about single scenarios.
#pragma once

#include "algorithms/core/options.h"
#include "messages/simulation_options.h"

namespace remount::simulator {

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
    visitor.choice({"slew_recording", "", kNoLabel, say::option_simulate_slew_recording}, self.recording,
                   {"ground", "arm-sweep", "full-turn"});
    visitor({"slew_arc_deg", "deg", kNoLabel, say::option_simulate_slew_arc_deg, -3600.0, 3600.0}, self.arc_deg);
    visitor({"yard_slope_deg", "deg", kNoLabel, say::option_simulate_yard_slope_deg, -20.0, 20.0}, self.slope_deg);
    visitor({"yard_uneven_deg", "deg", kNoLabel, say::option_simulate_yard_uneven_deg, -20.0, 20.0}, self.uneven_deg);
    visitor({"slew_arm", "", kNoLabel, say::option_simulate_slew_arm}, self.arm);
  }
};

}  // namespace remount::simulator
