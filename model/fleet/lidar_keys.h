// What a fleet's file says of several LiDARs.
#pragma once

#include <string>
#include <vector>

#include "model/fleet/fleet.h"
#include "model/formats/documents/document.h"

namespace remount::fleet {

/// The value of a key `lidars` as `--lidars` takes it: "all", or names with commas in between; empty for null, which is
/// one LiDAR as the sessions suggest it. Throws Error(Format).
std::string lidars_from(const formats::DocumentView& view);

/// A name of a LiDAR, which may be a topic. Throws Error(Format) for what can be none.
void check_lidar_name(const formats::DocumentView& view, const std::string& name);

/// "one", "all", or the names.
Message lidars_in_words(const std::string& lidars);

/// Throws Error(Format) at `view` where what the vehicle says does not go with the LiDARs of the job.
void check_lidars_of(const FleetVehicle& vehicle, const FleetJob& job, const formats::DocumentView& view);

/// Whether a job calibrates all LiDARs, or one of this name.
bool may_have_lidar(const FleetJob& job, const std::string& lidar);

}  // namespace remount::fleet
