// Scans of a sensor's packets: the packets in their order, each once, and cut where a turn ends.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/drive/finding.h"
#include "model/formats/packets/packet_index.h"

namespace remount::formats {

/// Brings packets into the order of their times and leaves out what comes twice; says so, and how many are missing:
/// "capture-repeated", "capture-missing". Where places fall (PacketSequence::falls) they are counted from the other end
/// of the turn from then on, so that they rise.
/// @param places in a turn
/// @return what the packets tell together, for PacketDecoder::tune
PacketSequence order_packets(std::vector<IndexedPacket>& packets, std::uint32_t places, const std::string& where,
                             std::vector<drive::Finding>& findings);

/// A turn, or a frame: packets [first, last], of the first one from a column on, of the last one up to a column.
struct PacketScan {
  std::uint32_t first = 0, last = 0;
  std::uint32_t first_column = 0, end_column = PacketDecoder::kAllColumns;
  std::int64_t stamp_ns = 0;  ///< of its first column
};

/// Cut where places begin anew (where frames are numbered: where another begins), and where nothing came for a tenth of
/// a second. What is much shorter than others is left out: the first and the last turn are seldom whole. @param places
/// in a turn
std::vector<PacketScan> cut_scans(const std::vector<IndexedPacket>& packets, std::uint32_t places);

}  // namespace remount::formats
