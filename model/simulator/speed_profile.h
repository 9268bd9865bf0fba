// How far along its road the simulated vehicle is.
#pragma once

#include "model/simulator/simulation_options.h"

namespace remount::simulator {

/// Distance along the road at a time of the drive; negative before the start, but for a drive that begins with a
/// standstill.
double along_road_m(const SimulationOptions& options, double time_s);

}  // namespace remount::simulator
