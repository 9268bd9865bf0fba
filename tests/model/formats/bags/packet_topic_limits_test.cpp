// What is read of the packets of a bag, and how much of it.
#include <chrono>
#include <cmath>
#include <iostream>

#include "model/formats/bags/bag_packets.h"
#include "tests/model/formats/bags/packet_topics.h"
#include "tests/support/findings.h"
#include "tests/support/sanitized.h"

namespace remount::bags {
namespace {

/// Descriptions of an RS-Helios whose lasers look so many hundredths of a degree higher.
RecordedPacket description_of_helios(int higher, std::int64_t time_ns) {
  formats::DifopPacket description;
  description.angles = formats::even_angles(100);
  for (auto& [up, offset] : description.angles) up += higher;
  return {time_ns, 7788, description.bytes()};
}

TEST_F(packet_topics, of_several_descriptions_the_first_counts_as_in_a_capture) {
  const std::vector<RecordedPacket> packets = helios_packets(700, 0, kTenHours_us),
                                    points(packets.begin() + 1, packets.end());
  const std::int64_t first_ns = points.front().time_ns;
  // The lower one is first, and the topic of the higher one: as numbers and as places in the bag they are the others.
  for (const int first : {0, 700}) {
    fs::remove(path());
    PacketBag made = bag();
    made.add_packets("/rslidar_info", kRslidarType, {description_of_helios(700 - first, first_ns + 20'000'000)});
    made.add_packets("/rslidar_difop", kRslidarType, {description_of_helios(first, first_ns + 10'000'000)});
    made.add_packets("/rslidar_packets", kRslidarType, points);
    made.finish();
    const drive::Session session = opened(path());
    EXPECT_TRUE(formats::contains(testing::said_of(session.findings, "capture-angles"), "several sensors"));
    float lowest_rad = 1.0f;
    for (const Eigen::Vector3f& point : session.scans->load(0).points)
      lowest_rad = std::min(lowest_rad, std::asin(point.z() / point.norm()));
    EXPECT_NEAR(lowest_rad, degrees_to_radians(0.01 * first - 8.0), 0.01) << first;
  }
}

/// Counts what is read of a bag.
class CountingBag final : public BagFile {
 public:
  explicit CountingBag(std::shared_ptr<const BagFile> bag) : bag_(std::move(bag)) {
    topics_ = bag_->topics();
    files_ = bag_->files();
  }
  std::string message(const BagEntry& entry, std::size_t at_most) const override {
    ++read;
    return bag_->message(entry, at_most);
  }
  mutable std::size_t read = 0;

 private:
  std::shared_ptr<const BagFile> bag_;
};

TEST_F(packet_topics, whose_sensor_never_says_the_same_twice_are_not_listened_to_for_ever) {
  constexpr int kDescriptions = 500;
  const std::vector<RecordedPacket> packets = helios_packets(100, 0, kTenHours_us);
  std::vector<RecordedPacket> descriptions;
  for (int i = 0; i < kDescriptions; ++i)
    descriptions.push_back(description_of_helios(i, packets.front().time_ns + i * 1'000'000));
  PacketBag made = bag();
  made.add_packets("/rslidar_difop", kRslidarType, descriptions);
  made.add_packets("/rslidar_packets", kRslidarType, {packets.begin() + 1, packets.end()});
  made.finish();
  const auto counting = std::make_shared<CountingBag>(open_quietly(path()));
  const PacketTopics topics = examine_packets(*counting, Progress());
  std::cout << counting->read << " messages read of " << kDescriptions << " descriptions\n";
  EXPECT_EQ(topics.lidars.size(), 1U);
  EXPECT_LT(counting->read, 100U);
}

TEST_F(packet_topics, of_more_lidars_than_there_can_be_are_not_compared) {
  for (const std::size_t lidars : {kMostPacketLidars, kMostPacketLidars + 1}) {
    fs::remove(path());
    PacketBag made = bag();
    const std::vector<RecordedPacket> packets = puck_packets(80, kTenHours_ns, 0.0);
    for (std::size_t i = 0; i < lidars; ++i) {
      // The first goes on for a second, in which the cloud comes but twice.
      made.add_packets("/lidar" + std::to_string(i) + "/packets", kScanType,
                       i == 0 ? puck_packets(760, kTenHours_ns, 0.0) : packets, 76, "lidar" + std::to_string(i));
    }
    add_clouds(made, "/preview", {"map", 2, 500'000'000});
    made.finish();
    EXPECT_EQ(opened(path(), {{"ins", std::string(drive::kNoTopic)}}).lidar_name,
              lidars == kMostPacketLidars ? "/lidar0/packets" : "/preview");
  }
}

TEST_F(packet_topics, by_the_thousand_do_not_take_long) {
  constexpr std::size_t kTopics = 50'000;
  PacketTopics topics;
  for (std::size_t i = 0; i < kTopics; ++i) {
    topics.found[i].model = "VLP-16";
    topics.lidars.push_back(i);
  }
  bag().finish();
  const auto file = open_quietly(path());
  const auto began = std::chrono::steady_clock::now();
  std::size_t own = 0;
  for (const std::size_t lidar : topics.lidars) own += topics.of_lidar(*file, lidar).size();
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  std::cout << kTopics << " topics in " << took_s << " s\n";
  EXPECT_EQ(own, kTopics);
  EXPECT_LT(took_s, 1.0 * testing::kSanitizerSlowdown);
}

TEST_F(packet_topics, are_looked_at_once) {
  PacketBag made = bag();
  for (const char* topic : {"/front/packets", "/rear/packets", "/left/packets"})
    made.add_packets(topic, kScanType, puck_packets(760, kTenHours_ns, 0.0), 76);
  made.finish();
  const auto counting = std::make_shared<CountingBag>(open_quietly(path()));
  const PacketTopics topics = examine_packets(*counting, Progress());
  const std::size_t looked_at = counting->read;
  EXPECT_EQ(topics.found.size(), 3U);
  EXPECT_EQ(looked_at, 3U) << "the first message of each says what it is";
  PacketStream stream(*counting, topics, topics.found.begin()->first);
  EXPECT_EQ(counting->read, looked_at);
  const BagTopic& own = counting->topics()[topics.found.begin()->first];
  for (std::size_t i = 0; i < own.entries.size(); ++i) {
    const std::string bytes = static_cast<const BagFile&>(*counting).message(own.entries[i]);
    MessageReader reader(bytes, own.encoding, "drive.bag");
    stream.take(topics.found.begin()->first, own.entries[i], i, reader);
  }
  EXPECT_EQ(stream.made(counting).sensors.size(), 3U);
  EXPECT_EQ(counting->read, looked_at + own.entries.size()) << "others are not read again";
}

}  // namespace
}  // namespace remount::bags
