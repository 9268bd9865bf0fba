// The clocks of a bag's streams against that of its LiDAR.
#pragma once

#include "model/formats/bags/bag_streams.h"

namespace remount::bags {

/// Moves what comes from INS, GNSS and IMU to the clock of the LiDAR where they are more than half a second apart. The
/// recorder's clock tells: each stream is as far behind it as its clock is off and its messages are late, a scan by its
/// own duration after its stamp, which is taken off. What is apart by less, but by more than the delays of a
/// recording, is left alone and becomes a finding "host-clock".
void share_lidar_clock(const BagFile& bag, const TopicRoles& roles, BagStreams& streams,
                       std::vector<drive::Finding>& findings);

}  // namespace remount::bags
