// In which frames the INS of a session speaks.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/drive/session.h"

namespace remount::drive {

/// The INS axes that all sessions declare, or that the direction of travel tells of one, which the others then have as
/// well; nothing where one does not say or there is none.
std::optional<InsAxes> common_axes(const std::vector<std::shared_ptr<const Session>>& sessions);

/// Turns INS axes into x forward, y left, z up: for what is given about the vehicle, such as its outline. Identity for
/// axes that are not known.
RigidTransform forward_left_up_from(const std::optional<InsAxes>& axes);
/// The same for the axes that all sessions have in common.
RigidTransform vehicle_from_ins(const std::vector<std::shared_ptr<const Session>>& sessions);

/// Poses of the INS in a metric frame: east, north, up of the first sample, positions and attitudes alike, or the poses
/// of the file.
std::vector<motion::StampedPose> metric_poses(const Session& session);

}  // namespace remount::drive
