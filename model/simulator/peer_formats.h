// Simulated drives in the formats of others, as far as those go.
#pragma once

#include "model/simulator/simulator.h"

namespace remount::simulator {

// Each makes its files in `folder`, which is there and empty. What a format has no place for (sensors, rings, noise) is
// left out. Return early where `progress` is cancelled.

/// INS poses as lines of a stamp and 12 numbers, scans as PCD files named by their stamps. Stamps are of milliseconds:
/// a drive with others, or with distorted scans without the time of each point, is Error(Contract).
void write_opencalib_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                           Progress& progress);

/// Two TUM files: poses of the INS, and of the LiDAR as an exact odometry from its first scan on.
void write_pose_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                      Progress& progress);

/// `NAME_Input.txt` with the mean speed of the rear wheels and the turn rates in vehicle axes, `NAME_GT.txt` with the
/// true positions of the GNSS antenna at the same times, which count from the first. There is no place for a LiDAR, an
/// INS and fixes: a drive without wheels or without IMU is Error(Contract), for it would be empty.
void write_smartloc_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                          Progress& progress);

}  // namespace remount::simulator
