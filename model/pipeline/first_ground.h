// The ground in the first scans of a drive.
#pragma once

#include <optional>

#include "model/drive/session.h"

namespace remount::pipeline {

/// Away from the ground in the LiDAR frame, unit length, from the first of some scans that shows one: settles roll on a
/// drive without turns. Scans that cannot be read are passed over.
std::optional<Eigen::Vector3d> up_of_first_scans(const drive::Session& session);

}  // namespace remount::pipeline
