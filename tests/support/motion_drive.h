// Simulated drives of which only the motion matters.
#pragma once

#include "model/simulator/simulator.h"

namespace remount::testing {

/// With scans of hardly any points, which cost nothing, and an IMU as fast as the INS.
inline simulator::SimulationOptions motion_options(simulator::ScenarioKind scenario, double duration_s,
                                                   double ins_rate_hz) {
  simulator::SimulationOptions options;
  options.scenario = scenario;
  options.duration_s = duration_s;
  options.beams = 1;
  options.azimuth_steps = 16;
  options.ins_rate_hz = options.imu.rate_hz = ins_rate_hz;
  return options;
}

}  // namespace remount::testing
