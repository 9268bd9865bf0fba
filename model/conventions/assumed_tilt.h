// Roll and pitch that nobody measured.
#pragma once

#include <vector>

#include "algorithms/geometry/rotation.h"
#include "algorithms/motion/ins_sample.h"
#include "model/drive/session.h"

namespace remount::conventions {

/// 1-sigma of roll and pitch of a vehicle whose log has neither, about level. Roads climb by 1.5 degrees in the mean
/// square where the land is not flat, and fall by 1.4 (2.5 %) to the side; a vehicle leans by 1 to 1.5 as it brakes,
/// bends and is loaded, and antennas stand on it within 1 or 2: together 3. Nearly all of it lasts for as long as a
/// slope, a bend or a load does.
inline constexpr double kAssumedTilt_rad = 0.05236;

/// 1-sigma of a heading by two antennas that state none.
inline constexpr double kAntennaHeading_rad = 0.5 * kPi / 180.0;
/// Of an attitude by two antennas, which tell no roll: that is assumed, and what of the others is not stated is known
/// as well as a heading.
/// @param sigma_rad roll, pitch, heading; NaN: not stated
void assume_roll(Eigen::Vector3d& sigma_rad);

/// Of the samples of one INS: the 1-sigma that they state for roll and pitch where roll is level in every one of them
/// and stated no better than a guess (a degree); 0 where it was measured. Where pitch alone is known it is not relied
/// on.
double assumed_tilt_sigma_rad(const std::vector<motion::InsSample>& ins);
/// Of a session's samples or, where it has poses instead, of these (see plane_poses.h).
double assumed_tilt_sigma_rad(const drive::Session& session);

}  // namespace remount::conventions
