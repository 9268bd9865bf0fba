// Unix time of packets whose sensor counts from the full hour, or from when it was switched on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/drive/finding.h"
#include "model/formats/packets/packet_index.h"

namespace remount::formats {

/// Decides what the times of a sensor count whose packets leave that open (SecondPart): nanoseconds where most of them
/// cannot be microseconds, which of a sensor that counts those only broken times are not. Leaves such broken ones out.
/// @return how many those are
std::size_t settle_second_parts(std::vector<IndexedPacket>& packets);

/// Turns times of the sensor's clock into Unix time. The hour is that of the host's clock; wraps are mended. A clock
/// that follows a receiver, as the sensor says, or is within two seconds of the host's, is believed. Any other counts
/// from when the sensor was switched on: what it is apart from the host's is taken off, by the packets that were
/// captured soonest, each when it was complete, with its drift; finding "capture-clock". A clock that jumps (once the
/// receiver is found, for example), or counts otherwise from a packet on, is judged apart before and behind.
/// A clock with the date (`clock_period_s` 0) may be ahead by the seconds that TAI is ahead of UTC, as PTP has it:
/// where the host's says so, they are taken off ("capture-tai"). It is not believed before it has a date, whatever it
/// is said to follow.
/// @param packets in the order in which they were captured
void settle_clock(std::vector<IndexedPacket>& packets, const std::vector<SensorReceiver::State>& receiver,
                  const std::string& where, std::vector<drive::Finding>& findings);

}  // namespace remount::formats
