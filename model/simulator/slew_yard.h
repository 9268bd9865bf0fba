// An excavator in a yard: what stands around it, how its upper body and its arm move.
#pragma once

#include <vector>

#include "model/simulator/simulation_options.h"
#include "model/simulator/world.h"

namespace remount::simulator {

/// Containers, sheds and posts around the origin, none of them within reach of the arm.
World yard_world(int seed);

/// The upper body, which is the vehicle frame of this scenario: origin on the slew axis and on the ground, x ahead in
/// the plane of the arm, z along the slew axis. It turns evenly, but for a sixth of the drive at either end.
RigidTransform road_from_upper_body(const SlewYardOptions& options, double duration_s, double time_s);

/// Boom, stick and bucket in the road frame. They move in the plane y = 0 of the upper body; in an arm sweep the boom
/// rises and falls twice in a drive. Empty without an arm.
std::vector<TiltedBox> arm_boxes(const SlewYardOptions& options, double duration_s, double time_s);

}  // namespace remount::simulator
