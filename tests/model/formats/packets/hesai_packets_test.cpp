#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "tests/model/formats/packets/capture_sessions.h"
#include "tests/model/formats/packets/hesai_bytes.h"

namespace remount::formats {
namespace {

constexpr char kHesaiRoute[] = "a.pcap: 192.168.1.201:2368";

std::unique_ptr<PacketDecoder> hesai_decoder(const std::string& payload, const TemporaryFolder& folder) {
  auto decoder = recognised(payload, kHesaiRoute);
  if (decoder) decoder->look_beside({folder.path() / "a.pcap", {0xc0a801c9, 2368}}, payload, kHesaiRoute);
  return decoder;
}

cloud::PointCloud hesai_points(const HesaiPacket& packet,
                               const PacketColumns& columns = {0, PacketDecoder::kAllColumns}) {
  const TemporaryFolder folder;
  const std::string payload = packet.bytes();
  cloud::PointCloud cloud;
  const auto decoder = hesai_decoder(payload, folder);
  EXPECT_TRUE(decoder && decoder->glance(payload));
  if (decoder) decoder->decode(payload, columns, {}, cloud);
  return cloud;
}

std::vector<std::uint16_t> block_azimuths(std::size_t blocks, int first, int step, std::size_t returns = 1) {
  std::vector<std::uint16_t> azimuths;
  for (std::size_t i = 0; i < blocks; ++i)
    azimuths.push_back(static_cast<std::uint16_t>((first + static_cast<int>(i / returns) * step) % 36000));
  return azimuths;
}

auto only_return(std::size_t block, std::size_t channel, std::uint16_t range = 2500) {
  return [=](std::size_t b, std::size_t c) {
    return std::pair<std::uint16_t, std::uint8_t>{b == block && c == channel ? range : std::uint16_t{0}, 77};
  };
}

/// A point 10 m away, clockwise from y; its time from the packet's stamp on.
void expect_return(const HesaiPacket& packet, double elevation_deg, double azimuth_deg, double after_stamp_us, int ring,
                   const TemporaryFolder& folder = TemporaryFolder()) {
  const std::string payload = packet.bytes();
  const auto decoder = hesai_decoder(payload, folder);
  ASSERT_TRUE(decoder);
  const auto glance = decoder->glance(payload);
  ASSERT_TRUE(glance);
  cloud::PointCloud cloud;
  const std::int64_t stamp_ns = kHesaiDate_ns + packet.stamp_us * std::int64_t{1000};
  decoder->decode(payload, {0, PacketDecoder::kAllColumns},
                  {.time_from_stamp_s = 1e-9 * static_cast<double>(glance->sensor_time_ns - stamp_ns)}, cloud);
  ASSERT_EQ(cloud.size(), 1U);
  const double up = degrees_to_radians(elevation_deg), around = degrees_to_radians(azimuth_deg);
  const Eigen::Vector3d expected(10.0 * std::cos(up) * std::sin(around), 10.0 * std::cos(up) * std::cos(around),
                                 10.0 * std::sin(up));
  EXPECT_LT((cloud.points[0].cast<double>() - expected).norm(), 1e-4) << cloud.points[0].transpose();
  EXPECT_NEAR(cloud.time_from_stamp_s[0], 1e-6 * after_stamp_us, 3e-9) << decoder->model();
  EXPECT_EQ(cloud.ring[0], ring);
  EXPECT_EQ(cloud.intensity[0], 77.0f);
}

// 600 turns a minute are 0.0036 degrees a microsecond.
TEST(hesai_packets, points_of_each_model_as_its_manual_computes_them) {
  HesaiPacket packet = HesaiPacket::pandar40();
  packet.azimuths = block_azimuths(10, 9000, 20);
  packet.returns = only_return(9, 0);
  expect_return(packet, 15.0, 91.8 - 1.042 - 0.0036 * 42.22, -28.58 - 42.22, 39);
  packet.returns = only_return(0, 39);
  expect_return(packet, -25.0, 90.0 - 1.042 - 0.0036 * 3.62, -28.58 - 9 * 55.56 - 3.62, 0);

  packet = HesaiPacket::pandar64();
  packet.azimuths = block_azimuths(6, 9000, 20);
  packet.returns = only_return(2, 8);
  expect_return(packet, 1.522, 90.4 + 5.208 - 0.0036 * 7.532, -42.58 - 3 * 55.56 - 7.532, 55);

  packet = HesaiPacket::qt64();
  packet.azimuths = block_azimuths(4, 9000, 60);
  packet.returns = only_return(3, 63);
  expect_return(packet, 52.133, 91.8 - 7.892 + 0.0036 * 146.45, 25.71 + 500.0 + 146.45, 63);

  packet = HesaiPacket();
  packet.azimuths = block_azimuths(8, 9000, 18);
  packet.returns = only_return(0, 31);
  expect_return(packet, -16.0, 90.0 + 0.0036 * 47.24, 5.632 - 350.0 + 0.368 + 31 * 1.512, 0);

  packet = HesaiPacket::xt16();
  packet.azimuths = block_azimuths(8, 9000, 18);
  packet.returns = only_return(7, 15);
  expect_return(packet, -15.0, 91.26 + 0.0036 * 45.728, 5.632 + 0.368 + 15 * 3.024, 0);

  packet = HesaiPacket::xt32m();
  packet.azimuths = block_azimuths(6, 9000, 18);
  packet.returns = only_return(5, 17);
  expect_return(packet, -2.6, 90.9 + 0.0036 * (0.368 + 2.888), 5.632 + 0.368 + 2.888, 14);
}

/// Of 128 channels, a quarter of a degree apart.
std::string angles_of_128() {
  std::string table = "Channel,Elevation,Azimuth\n";
  for (int channel = 0; channel < 128; ++channel)
    table += std::to_string(channel + 1) + "," + std::to_string(14.0 - 0.25 * channel) + ",1.5\n";
  return table;
}

TEST(hesai_packets, channels_of_a_pandar128_fire_by_states_and_ranges) {
  const TemporaryFolder folder;
  folder.write("a.csv", angles_of_128());
  HesaiPacket packet = HesaiPacket::pandar128();
  packet.azimuths = block_azimuths(2, 9000, 10);
  packet.returns = only_return(0, 0);
  expect_return(packet, 14.0, 91.5 + 0.0036 * 4.436, 3.148 - 27.778 + 4.436, 127, folder);
  packet.states = 1 << 12;  // of the second block
  packet.returns = only_return(1, 5);
  expect_return(packet, 12.75, 91.6 + 0.0036 * 2.781, 3.148 + 2.781, 122, folder);
  packet.state_mode = 2;  // every other block is left out
  packet.states = 0;
  packet.returns = only_return(0, 0);
  expect_return(packet, 14.0, 91.5 + 0.0036 * 4.436, 3.148 - 2 * 27.778 + 4.436, 127, folder);
  // What may stand in a packet beside that.
  packet.holds = 0x1f;
  expect_return(packet, 14.0, 91.5 + 0.0036 * 4.436, 3.148 - 2 * 27.778 + 4.436, 127, folder);
  packet.returns = only_return(0, 0, 700);  // 2.8 m, near
  cloud::PointCloud cloud;
  hesai_decoder(packet.bytes(), folder)->decode(packet.bytes(), {0, 2}, {}, cloud);
  ASSERT_EQ(cloud.size(), 1U);
  EXPECT_NEAR(cloud.time_from_stamp_s[0], 5.201e-6, 1e-9);
  packet.version = 130;  // an OT128
  packet.state_mode = 0, packet.states = 1 << 12;
  packet.returns = only_return(1, 4);
  expect_return(packet, 13.0, 91.6 + 0.0036 * 12.578, 12.578, 123, folder);
  EXPECT_EQ(hesai_decoder(packet.bytes(), folder)->model(), "OT128");
  packet.version = 140;
  EXPECT_ERROR(
      hesai_decoder(packet.bytes(), folder),
      "holds packets of a Hesai with 128 channels of version 140, which is not known. Play the recording");  // a JT128
  packet.version = 130, packet.state_mode = 0x10;  // what stands above the state is not of it
  packet.returns = only_return(1, 4);
  expect_return(packet, 13.0, 91.6 + 0.0036 * 12.578, 12.578, 123, folder);
  packet.state_mode = 3;
  EXPECT_ERROR(
      hesai_decoder(packet.bytes(), folder),
      "holds packets of a Hesai with 128 channels in operation state 3, which is not known of version 130. Set");
}

// Which channels fire in a block was seen in packets of a sensor: 33 to 64 where the packet's mode is 1, else 1 to 32.
TEST(hesai_packets, two_sets_of_channels_of_a_qt128_take_turns) {
  HesaiPacket packet = HesaiPacket::qt128();
  packet.azimuths = block_azimuths(2, 9000, 40);
  packet.returns = only_return(0, 34);
  expect_return(packet, -16.627, 90.0 - 6.157 + 0.0036 * 2.312, 9.0 + 2.312, 34);
  packet.returns = only_return(1, 0);
  expect_return(packet, -52.627, 90.4 + 10.108 + 0.0036 * 2.312, 9.0 + 111.11 + 2.312, 0);
  packet.loop = 0, packet.mode = 0x39;  // blocks of two returns are of one time
  packet.azimuths = block_azimuths(2, 9000, 0);
  packet.returns = only_return(1, 30);
  expect_return(packet, -20.056, 90.0 + 6.285 + 0.0036 * 100.52, 9.0 + 100.52, 30);
  packet.returns = only_return(0, 98);
  expect_return(packet, 20.926, 90.0 - 6.323 + 0.0036 * 1.456, 9.0 + 1.456, 82);
  packet.holds = 0;  // without confidences
  expect_return(packet, 20.926, 90.0 - 6.323 + 0.0036 * 1.456, 9.0 + 1.456, 82);
}

TEST(hesai_packets, mirrors_of_an_at128_turn_its_beams) {
  const TemporaryFolder folder;
  folder.write("angles.dat", mirror_bytes());
  HesaiPacket packet = HesaiPacket::at128();
  packet.azimuths = {5380, 5400};
  packet.returns = only_return(1, 3);
  expect_return(packet, -12.2 - 0.1, 2 * 30.005 - 2.0 + 0.2, -50.915 + 4.112, 3, folder);
  packet.azimuths = {18380, 18400};  // of the next mirror
  packet.returns = only_return(0, 3);
  expect_return(packet, -12.2 - 0.1, 2 * 39.805 - 2.0 + 0.2, -50.915 - 41.666 + 4.112, 3, folder);
  packet.azimuths = {14395, 14405};  // from one to the next
  const auto glance = hesai_decoder(packet.bytes(), folder)->glance(packet.bytes());
  ASSERT_TRUE(glance);
  EXPECT_EQ(glance->cut_column, 1U);
  EXPECT_NEAR(glance->first_place, 11'995.5, 1.0);
  EXPECT_NEAR(glance->last_place, 5.5, 1.0);
  packet.mode = 0x39;
  packet.returns = nullptr;
  packet.azimuths = {5400, 5400};
  EXPECT_TRUE(hesai_decoder(packet.bytes(), folder)->glance(packet.bytes()));
}

TEST(hesai_packets, those_whose_angles_differ_too_much_need_their_file) {
  const TemporaryFolder folder;
  HesaiPacket packet = HesaiPacket::pandar128();
  packet.azimuths = block_azimuths(2, 0, 10);
  EXPECT_ERROR(hesai_decoder(packet.bytes(), folder), "beside the recording as a.csv");
  HesaiPacket mirrored = HesaiPacket::at128();
  mirrored.azimuths = {5400, 5410};
  EXPECT_ERROR(hesai_decoder(mirrored.bytes(), folder), "beside the recording as a.dat");
  folder.write("a.dat", mirror_bytes().substr(0, 1000));
  EXPECT_ERROR(hesai_decoder(mirrored.bytes(), folder), "a.dat: holds 1000 bytes");
  std::string other = mirror_bytes();
  other[3] = 3;
  folder.write("a.dat", other);
  EXPECT_ERROR(hesai_decoder(mirrored.bytes(), folder), "version 1.3, expected 1.5");
  other[3] = 5, other[1100] = 0x7f;
  folder.write("a.dat", mirror_bytes());
  folder.write("b.dat", other);
  EXPECT_TRUE(hesai_decoder(mirrored.bytes(), folder)) << "that of the capture's name";
}

TEST(hesai_packets, a_packet_without_a_number_at_its_end_is_one) {
  for (HesaiPacket packet : {HesaiPacket::pandar40(), HesaiPacket::pandar64(), HesaiPacket::qt64(), HesaiPacket()}) {
    packet.azimuths = block_azimuths(packet.blocks, 0, 20);
    packet.counted = false;
    EXPECT_EQ(hesai_points(packet).size(), packet.blocks * packet.channels);
  }
}

TEST(hesai_packets, blocks_of_several_returns_are_of_one_time) {
  HesaiPacket packet;
  packet.mode = 0x39;
  packet.azimuths = block_azimuths(8, 9000, 18, 2);
  packet.returns = [](std::size_t block, std::size_t channel) {
    const std::uint16_t range = channel == 0 ? 2500 : channel == 1 ? (block % 2 == 0 ? 2500 : 1000) : 0;
    return std::pair<std::uint16_t, std::uint8_t>{range, 50};
  };
  const cloud::PointCloud two = hesai_points(packet);
  ASSERT_EQ(two.size(), 4U * 3U) << "a second one that is the same is left out";
  EXPECT_EQ(two.time_from_stamp_s[1], two.time_from_stamp_s[2]);
  EXPECT_NEAR(two.time_from_stamp_s[3], 50e-6, 1e-9);
  packet = HesaiPacket::xt32m();
  packet.mode = 0x3d;
  packet.azimuths = block_azimuths(6, 9000, 18, 3);
  packet.returns = [](std::size_t block, std::size_t channel) {
    return std::pair<std::uint16_t, std::uint8_t>{channel == 5 ? 1000 + 100 * (block % 3) : 0, 50};
  };
  EXPECT_EQ(hesai_points(packet).size(), 6U);
  packet = HesaiPacket::qt64();
  packet.mode = 0x05;
  packet.azimuths = block_azimuths(4, 9000, 60, 2);
  packet.returns = only_return(2, 0);
  EXPECT_NEAR(hesai_points(packet).time_from_stamp_s.at(0), 166.667e-6, 1e-8);
}

TEST(hesai_packets, angles_of_the_sensor_are_taken_from_beside_the_capture) {
  HesaiPacket packet = HesaiPacket::xt16();
  packet.rpm = 0;
  packet.azimuths = block_azimuths(8, 0, 18);
  packet.returns = only_return(0, 3);
  const std::string payload = packet.bytes();
  const auto elevation = [&](const TemporaryFolder& folder) {
    cloud::PointCloud cloud;
    hesai_decoder(payload, folder)->decode(payload, {0, PacketDecoder::kAllColumns}, {}, cloud);
    return radians_to_degrees(std::asin(cloud.points.at(0).z() / cloud.points.at(0).norm()));
  };
  const auto table = [](double by_deg, int channels = 16) {
    std::string text = "EEFF,1\nLaser id,Elevation,Azimuth\r\n";
    for (int i = 0; i < channels; ++i)
      text += std::to_string(i + 1) + "," + std::to_string(15 - 2 * i + by_deg) + ",0.5\r\n";
    return text + std::string(64, 'a') + "\r\n";
  };
  const TemporaryFolder folder;
  EXPECT_NEAR(elevation(folder), 9.0, 1e-4);
  EXPECT_TRUE(contains(english(hesai_decoder(payload, folder)->remark()), "data sheet"));
  folder.write("of_an_xt32.csv", table(0.1, 32));
  folder.write("notes.csv", "a,b\n1,2\n");
  EXPECT_NEAR(elevation(folder), 9.0, 1e-4);
  folder.write("angles.csv", table(0.1));
  EXPECT_NEAR(elevation(folder), 9.1, 1e-4);
  EXPECT_TRUE(hesai_decoder(payload, folder)->remark().empty());
  EXPECT_EQ(hesai_decoder(payload, folder)->sources_beside().at(0).name.filename(), "angles.csv");
  folder.write("more.csv", table(0.2));
  EXPECT_ERROR(hesai_decoder(payload, folder), "angles.csv and more.csv");
  folder.write("a.csv", table(0.3));
  EXPECT_NEAR(elevation(folder), 9.3, 1e-4);
  const TemporaryFolder broken;
  broken.write("angles.csv", "Channel,Elevation,Azimuth\n1,15,0\n3,13,0\n");
  EXPECT_ERROR(hesai_decoder(payload, broken), "angles.csv:3");
  broken.write("angles.csv", "Channel,Elevation,Azimuth\n1,95,0\n");
  EXPECT_ERROR(hesai_decoder(payload, broken), "angles.csv:2");
}

TEST(hesai_packets, dates_are_those_of_the_protocol) {
  const TemporaryFolder folder;
  HesaiPacket packet = HesaiPacket::xt16();
  packet.azimuths = block_azimuths(8, 0, 18);
  const auto stamp = [&] {
    const auto glance = hesai_decoder(packet.bytes(), folder)->glance(packet.bytes());
    return glance ? glance->sensor_time_ns - 250'000'000 + 344'000 : -1;
  };
  EXPECT_EQ(stamp(), kHesaiDate_ns);
  packet.date = {0, 0, 0x65, 0x53, 0xf1, 0x00};  // seconds since 1970
  EXPECT_EQ(stamp(), kHesaiDate_ns);
  packet.date = {123, 13, 14, 22, 13, 20};
  EXPECT_EQ(stamp(), -1);
  for (const std::uint8_t year : {23, 123}) {
    HesaiPacket old = HesaiPacket::pandar64();
    old.azimuths = block_azimuths(6, 0, 20);
    old.date[0] = year;
    const auto glance = hesai_decoder(old.bytes(), folder)->glance(old.bytes());
    ASSERT_TRUE(glance) << int{year};
    EXPECT_EQ((glance->sensor_time_ns + 500'000) / 1'000'000, kHesaiDate_ns / 1'000'000 + 250) << int{year};
  }
}

TEST(hesai_packets, a_turn_ends_within_a_packet) {
  HesaiPacket packet;
  packet.azimuths = block_azimuths(8, 35950, 18);
  const TemporaryFolder folder;
  const auto glance = hesai_decoder(packet.bytes(), folder)->glance(packet.bytes());
  ASSERT_TRUE(glance);
  EXPECT_EQ(glance->first_place, 35950U);
  EXPECT_EQ(glance->cut_column, 3U);
  EXPECT_EQ(glance->cut_after_ns, 150'000U);
  EXPECT_EQ(glance->last_place, 76U);
  EXPECT_EQ(hesai_points(packet, {0, 3}).size() + hesai_points(packet, {3, 8}).size(), 256U);
}

TEST(hesai_packets, a_sensor_may_turn_the_other_way) {
  HesaiPacket packet;
  packet.azimuths.clear();
  for (int i = 0; i < 8; ++i) packet.azimuths.push_back(static_cast<std::uint16_t>((36'030 - 18 * i) % 36'000));
  packet.returns = only_return(0, 31);
  expect_return(packet, -16.0, 0.3 - 0.0036 * 47.24, 5.632 - 350.0 + 0.368 + 31 * 1.512, 0);
  const TemporaryFolder folder;
  const auto glance = hesai_decoder(packet.bytes(), folder)->glance(packet.bytes());
  ASSERT_TRUE(glance);
  EXPECT_EQ(glance->first_place, 35'969U) << "places rise all the same";
  EXPECT_EQ(glance->cut_column, 2U);
  EXPECT_EQ(glance->last_place, 95U);
}

TEST(hesai_packets, what_is_not_decoded_is_named) {
  const TemporaryFolder folder;
  HesaiPacket packet;
  packet.azimuths = block_azimuths(8, 0, 18);
  std::string payload = packet.bytes();
  const auto decoder = hesai_decoder(payload, folder);
  EXPECT_EQ(decoder->model(), "PandarXT-32");
  EXPECT_FALSE(decoder->glance(HesaiPacket::xt16().azimuths.empty() ? std::string(568, '\0') : payload));
  EXPECT_FALSE(decoder->glance(payload + "x"));
  payload[2] = 3, payload[3] = 2;
  EXPECT_EQ(hesai_decoder(payload, folder), nullptr) << "of another size than its protocol says";
  payload[2] = 7;
  EXPECT_ERROR(hesai_decoder(payload, folder), "FT120");
  HesaiPacket chosen = HesaiPacket::qt128();
  chosen.azimuths = block_azimuths(2, 0, 40);
  chosen.holds |= 0x40;
  EXPECT_ERROR(hesai_decoder(chosen.bytes(), folder), "channels somebody chose");
  payload[2] = 9;
  EXPECT_EQ(hesai_decoder(payload, folder), nullptr);
  EXPECT_EQ(hesai_decoder(std::string("\xee\xff"), folder), nullptr);
  packet.azimuths[4] = 40000;
  EXPECT_FALSE(decoder->glance(packet.bytes()));
  packet.azimuths[4] = 72, packet.mode = 0x77;
  EXPECT_FALSE(decoder->glance(packet.bytes()));
  EXPECT_ERROR(
      hesai_decoder(packet.bytes(), folder),
      "holds packets of a Hesai with 32 channels and 8 blocks, in return mode 119, which is not known of them. Set");
  packet.mode = 0x36;  // the fourth return
  EXPECT_EQ(hesai_points(packet).size(), 256U);
  packet.mode = 0x3d;  // three returns do not go into eight blocks
  EXPECT_ERROR(hesai_decoder(packet.bytes(), folder),
               "32 channels and 8 blocks, in return mode 61, which is not known of them. Set");
  packet.mode = 0x37;
  payload = packet.bytes();
  payload[9] = 0;
  EXPECT_ERROR(hesai_decoder(payload, folder),
               "holds packets of a Hesai with 32 channels, whose distances count units of 0 mm. Play");
  HesaiPacket other = HesaiPacket::xt16();
  other.blocks = 10;
  other.azimuths = block_azimuths(10, 0, 18);
  EXPECT_ERROR(hesai_decoder(other.bytes(), folder),
               "holds packets of a Hesai with 16 channels and 10 blocks, which are not known together. Play");
  EXPECT_EQ(hesai_decoder(other.bytes() + "x", folder), nullptr) << "something else by its size";
}

}  // namespace
}  // namespace remount::formats
