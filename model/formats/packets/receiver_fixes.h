// The receiver that a LiDAR hangs on as the GNSS of a drive: its sentences stand in the LiDAR's packets.
#pragma once

#include <string>

#include "model/drive/session.h"
#include "model/formats/packets/packet_index.h"

namespace remount::formats {

/// Adds the fixes of the receiver where the session has none. Most sensors hand on RMC alone, which has no height:
/// where the sentences cannot serve and nothing else tells the motion, a finding says why ("capture-position").
/// @param where the recording, for messages
void take_receiver(const SensorReceiver& receiver, const std::filesystem::path& where, drive::Session& session);

}  // namespace remount::formats
