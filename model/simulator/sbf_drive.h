// Simulated drives as a Septentrio with an INS records them.
#pragma once

#include "model/simulator/simulator.h"

namespace remount::simulator {

/// SBF with INSNavGeod of every sample of the INS, its errors where the drive declares them, and the LiDAR's poses, in
/// `folder`, which is there and empty. Times are of whole milliseconds, angles floats of degrees.
void write_sbf_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads, Progress& progress);

}  // namespace remount::simulator
