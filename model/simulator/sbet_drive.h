// Simulated drives as Applanix' POSPac exports them.
#pragma once

#include "model/simulator/simulator.h"

namespace remount::simulator {

/// SBET of every sample of the INS, SMRMSG once a second where the drive declares errors, and the LiDAR's poses, in
/// `folder`, which is there and empty. Platform headings are off the true ones by a wander angle that grows, as those
/// of a platform that does not turn to north.
void write_sbet_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                      Progress& progress);

}  // namespace remount::simulator
