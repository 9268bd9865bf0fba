// Bags with packets of LiDARs beside clouds and descriptions.
#pragma once

#include <gtest/gtest.h>

#include "tests/model/formats/bags/packet_bags.h"
#include "tests/model/formats/packets/robosense_bytes.h"

namespace remount::bags {

inline constexpr const char *kScanType = "velodyne_msgs/VelodyneScan", *kHeadType = "ouster_ros/PacketMsg",
                            *kRslidarType = "rslidar_msg/RslidarPacket", *kFrameType = "hesai_ros_driver/UdpFrame";

/// Of what a driver makes of packets.
struct CloudsOfDriver {
  std::string frame;
  int count = 10;
  std::int64_t period_ns = 100'000'000;
  bool timed = true;
};

class packet_topics : public packets_in_a_bag {
 protected:
  static void add_clouds(PacketBag& made, const std::string& topic, const CloudsOfDriver& clouds) {
    for (int i = 0; i < clouds.count; ++i) {
      cloud::PointCloud cloud;
      for (int k = 0; k < 30; ++k) {
        cloud.points.emplace_back(static_cast<float>(k + 1), 1.0f, 1.0f);
        if (clouds.timed) cloud.time_from_stamp_s.push_back(0.003f * static_cast<float>(k));
      }
      const std::int64_t stamp_ns = kTenHours_ns + i * clouds.period_ns;
      made.add(stamp_ns + 95'000'000, topic, "sensor_msgs/PointCloud2",
               cloud_message(cloud, stamp_ns, clouds.frame, made.encoding()));
    }
  }
  std::vector<std::string> offered() const {
    Progress progress;
    std::vector<std::string> names;
    for (const drive::LidarOffer& offer : formats::offer_lidars(path(), progress)) names.push_back(offer.name);
    return names;
  }
  using Names = std::vector<std::string>;
};

/// Packets of an RS-Helios. @param described the place of its description among them; beyond: it gives none
inline std::vector<RecordedPacket> helios_packets(std::size_t count, std::size_t described, std::int64_t sensor_us) {
  const formats::TemporaryFolder folder;
  std::vector<RecordedPacket> packets =
      packets_of_capture(folder.write("a.pcap", formats::pcap(formats::helios_drive(count, kTenHours_ns, sensor_us))));
  RecordedPacket description = packets.front();
  packets.erase(packets.begin());
  if (described >= packets.size()) return packets;
  description.time_ns = packets[described].time_ns;
  packets.insert(packets.begin() + static_cast<std::ptrdiff_t>(described), description);
  return packets;
}
inline constexpr std::int64_t kTenHours_us = kTenHours_ns / 1000;

}  // namespace remount::bags
