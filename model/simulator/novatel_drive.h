// Simulated drives as the logs of a NovAtel SPAN.
#pragma once

#include <vector>

#include "model/simulator/simulator.h"

namespace remount::simulator {

/// What a log says of one sample of the INS, beside its place: in NovAtel's axes, x right, y forward, z up.
struct NovatelMoment {
  double roll_deg = 0.0, pitch_deg = 0.0, azimuth_deg = 0.0;
  Eigen::Vector3d velocity_enu_mps = Eigen::Vector3d::Zero();  ///< between the neighbouring samples
  Eigen::Vector3d position_sigma_enu_m = Eigen::Vector3d::Zero();
  double attitude_sigma_deg = 0.0;  ///< of each angle
};
/// One for each sample of `ins`; errors that the drive does not declare are zero.
std::vector<NovatelMoment> novatel_moments(const drive::Session& session);

/// A sample every second, after which errors are written beside INSPVA.
bool begins_second(const drive::Session& session, std::size_t sample);

// Each makes a log and the LiDAR's poses in `folder`, which is there and empty. The log's INS axes are x right, y
// forward, z up.

/// INSPVAXA of every sample.
void write_novatel_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                         Progress& progress);
/// INSPVAA of every sample, INSSTDEVA once a second.
void write_novatel_ascii_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                               Progress& progress);
/// In binary: INSPVAS of every sample, which has a short header, and INSSTDEV once a second, which has a long one.
void write_novatel_binary_drive(const SimulatedDrive& drive, const std::filesystem::path& folder, int threads,
                                Progress& progress);

}  // namespace remount::simulator
