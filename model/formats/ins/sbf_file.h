// The binary log of a Septentrio (SBF), with or without an INS.
#pragma once

#include <filesystem>
#include <vector>

#include "algorithms/motion/sensor_samples.h"
#include "model/formats/ins/ins_log.h"

namespace remount::formats {

/// From the first bytes: two blocks, or one that is used. Never throws.
bool recognise_sbf(const std::filesystem::path& path);

/// Samples of INSNavGeod or INSNavCart, whichever has more; where there are none, of AttEuler at the times of
/// PVTGeodetic, with the errors of AttCovEuler and PosCovGeodetic of these times. Two antennas tell no roll: it is
/// taken to be zero, with a finding ("roll-assumed"). Throws Error as InsLogKind::read says.
InsLog read_sbf(const std::filesystem::path& path, std::vector<drive::Finding>& findings);

/// The receiver's positions (PVTGeodetic), with the errors of PosCovGeodetic or of the block itself; what states none
/// is left out. Throws Error(Io), Error(Format) where there is none.
std::vector<motion::GnssFix> read_sbf_fixes(const std::filesystem::path& path, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
