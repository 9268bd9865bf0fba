// What the simulated vehicle's GNSS/INS reports.
#pragma once

#include <vector>

#include "algorithms/motion/ins_sample.h"
#include "model/simulator/scene.h"

namespace remount::simulator {

/// Samples from half a second before the drive to half a second after it, with the noise and the bias of the options.
/// Attitude is relative to the local level where the vehicle is, not where it started.
std::vector<motion::InsSample> simulate_ins(const Scene& scene);

}  // namespace remount::simulator
