// What the tests of LiDARs' packets share.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "model/formats/packets/capture_index.h"
#include "model/formats/packets/capture_scans.h"
#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

/// The decoder of the make whose packet this is; null where it is of none.
inline std::unique_ptr<PacketDecoder> recognised(const std::string& payload, const std::string& where) {
  for (const PacketFormat& format : packet_formats())
    if (auto decoder = format.recognise(payload, where)) return decoder;
  return nullptr;
}

/// @param asked of the sensors in the capture, "" where it is of one
inline drive::Session scans_of(const std::vector<TimedFrame>& frames, const std::string& asked = "") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.pcap", pcap(frames));
  Progress progress;
  PacketIndex index = index_capture(file, progress);
  drive::Session session;
  take_scans(index, choose_sensor(index, asked, file.string()), session);
  return session;
}

/// Expects that a packet is none of the decoder's sensor once it is changed.
template <class Packet, class Change>
void expect_passed_over(const PacketDecoder& decoder, Packet packet, const char* what, const Change& change) {
  ASSERT_TRUE(decoder.glance(packet.bytes())) << what;
  change(packet);
  EXPECT_FALSE(decoder.glance(packet.bytes())) << what;
}

}  // namespace remount::formats
