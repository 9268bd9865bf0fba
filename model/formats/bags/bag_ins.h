// The INS of a session from the streams of a bag.
#pragma once

#include "model/formats/bags/bag_streams.h"

namespace remount::bags {

/// Fills `ins` or `world_from_ins`, `ins_axes`, `gnss` and `imu` of the session. An orientation with fixes gives
/// samples at the stamps of the fixes; what has no orientation or no fix beside it is left out, with a finding. Throws
/// Error where a stream that was chosen holds nothing usable.
void add_ins(const BagFile& bag, const ChosenTopics& chosen, BagStreams& streams, drive::Session& session);

}  // namespace remount::bags
