// Streams of a bag whose receiver counts the weeks of GPS wrongly.
#pragma once

#include <vector>

#include "model/formats/bags/bag_streams.h"

namespace remount::bags {

/// Moves streams of INS, GNSS and IMU that are whole turns of the GPS week (1024 weeks) off the recorder's clock, which
/// each has beside its own. Finding "gps-week-rollover" for each.
void mend_week_rollovers(const BagFile& bag, const TopicRoles& roles, BagStreams& streams,
                         std::vector<drive::Finding>& findings);

}  // namespace remount::bags
