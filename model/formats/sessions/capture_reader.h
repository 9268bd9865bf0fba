// Sessions of captured network packets: the LiDAR's scans as its packets have them, and the INS's log beside them.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens a capture (pcap, pcapng), or a folder with one and, where there is any, one log of the INS: NovAtel's INSPVAX,
/// NMEA, GPX or poses. Fixes of position packets are GNSS where they have heights (GGA). Several sensors are told apart
/// by address and port; one of them is chosen as the topic for `lidar`.
class CaptureReader final : public SessionReader {
 public:
  std::string_view id() const override { return "lidar-capture"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
  drive::Session open_topics(const std::filesystem::path& path, const drive::TopicChoice& topics,
                             Progress& progress) const override;
  std::optional<drive::TopicOffer> offer_topics(const std::filesystem::path& path, Progress& progress) const override;
  std::vector<drive::LidarOffer> offer_lidars(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount::formats
