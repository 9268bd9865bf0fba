#include "tests/model/formats/sample_recordings.h"

#include <vector>

#include "tests/fuzz/readers.h"
#include "tests/model/formats/bags/record_bags.h"
#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/packets/livox_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"

namespace remount::formats {

namespace {

constexpr std::int64_t kCaptured_ns = 1'700'000'000'000'000'000;

std::string captured_helios() { return pcap(helios_drive(4, kCaptured_ns, kCaptured_ns / 1000)); }

/// Few shots a packet, so that many packets are short.
std::string captured_livox() {
  std::vector<TimedFrame> frames;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto time_ns = static_cast<std::uint64_t>(kCaptured_ns) + 30'000'000 * i;
    const std::string points = i % 2 == 0 ? numbered_shots(i, 4) : repeated(spherical({9'000, 6'000, 3'000}, true), 4);
    frames.push_back({static_cast<std::int64_t>(time_ns) + 400'000,
                      ethernet_udp(sdk2_packet(1, i % 2 == 0 ? 1 : 3, time_ns, 200, 4, points), {.port = 56301})});
  }
  return pcap(frames);
}

std::string captured_former_livox() {
  std::vector<TimedFrame> frames;
  const std::string two = repeated(spherical_returns({0, 6'000, 3'000}, {9'000, 12'000}), 48);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string spelt =
        little(23, 1) + little(11, 1) + little(14, 1) + little(22, 1) + little(800'000'000 + 50'000 * i, 4);
    frames.push_back({kCaptured_ns + static_cast<std::int64_t>(i) * 50'000'000,
                      ethernet_udp(sdk1_packet(3, 5, spelt, two), {.port = 56000})});
  }
  return pcap(frames);
}

std::string captured_m1() {
  const auto points = [](std::size_t block, std::size_t) {
    return std::array<int, 3>{2000, 100, static_cast<int>(block)};
  };
  std::vector<TimedFrame> frames;
  for (std::uint16_t i = 629; i < 633; ++i)
    frames.push_back({kCaptured_ns + i, ethernet_udp(m1_packet(static_cast<std::uint16_t>(1 + i % 630), 2,
                                                               kCaptured_ns / 1000 + 158 * i, points),
                                                     {.port = 6699})});
  return pcap(frames);
}

std::string captured_rs16() {
  MsopPacket packet;
  packet.former = true, packet.legacy_type = 1, packet.type = packet.variant = 0;
  packet.time = big(23, 1) + big(11, 1) + big(14, 1) + big(22, 1) + big(13, 1) + big(20, 1) + big(123, 2) + big(456, 2);
  packet.azimuths = msop_azimuths(35'800, 40);
  return pcap({{kCaptured_ns, ethernet_udp(packet.bytes(), {.port = 6699})}});
}

std::string recorded_lvx(int minor) {
  std::vector<std::string> frames;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::uint64_t time_ns = static_cast<std::uint64_t>(kCaptured_ns) + 50'000'000 * i;
    if (minor < 0)
      frames.push_back(lvx2_package(3, 1, 1, time_ns, numbered_shots(i, 3)) +
                       lvx2_package(3, 1, 2, time_ns, repeated(cartesian({100, 200, 300}, 2, true), 3)));
    else
      frames.push_back(little(0, 1) + (minor == 1 ? sdk1_packet(1, 6, little(time_ns, 8), std::string(24, 'i'))
                                                  : sdk1_packet(1, 0, little(time_ns, 8),
                                                                repeated(metres(1.0f, 2.0f, 3.0f, 4), 100))));
    if (minor == 1) frames.back() += little(0, 1) + sdk1_packet(1, 2, little(time_ns, 8), numbered_shots(i, 96));
  }
  return lvx(minor, {{"47MDL1B0010008", 3, 9}, {"0TFDG3U99102431", 7, 10}}, frames);
}

/// Everything that is read of a record, from a scan on. @param compensated scans of a compensator alone
std::string record_of_apollo(int from, bool compensated) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "drive.record";
  bags::RecordMaker record(path);
  if (!compensated) record.add_clouds("/apollo/sensor/front/PointCloud2", 4, 6, "front");
  record.add_clouds("/apollo/sensor/rear/compensator/PointCloud2", 4, 6, "rear");
  compensated ? record.add_estimates(12) : record.add_gps(12);
  motion::GnssFix fix{0, 0.0, 0.0, 0.0, 0.0004 * Eigen::Matrix3d::Identity()};
  for (int i = from; i < from + 3; ++i) {
    const motion::InsSample sample = bags::BagMaker::on_circle(i);
    fix.stamp_ns = sample.stamp_ns, fix.latitude_rad = sample.latitude_rad, fix.longitude_rad = sample.longitude_rad;
    record.add(sample.stamp_ns, "/fix", bags::kApolloFix, bags::apollo_fix_message(fix, 50));
    record.add(sample.stamp_ns, "/stat", bags::kApolloStat, bags::apollo_status_message(sample.stamp_ns, 56));
  }
  bags::PoseMessage transform{{0, compensated ? "localization" : "novatel"}, "front", RigidTransform::Identity()};
  record.add(bags::kStart_ns, "/tf_static", bags::kApolloTransforms, bags::apollo_transforms_message({transform}));
  record.finish();
  return bytes_of(path);
}

}  // namespace

std::vector<Sample> recorded_samples() {
  return {
      {"lidar-capture", "livox", captured_livox()},
      {"lidar-capture", "livox-sdk1", captured_former_livox()},
      {"lidar-capture", "helios", captured_helios()},
      {"lidar-capture", "rs16", captured_rs16()},
      {"lidar-capture", "m1", captured_m1()},
      {"lvx", "1.0", recorded_lvx(0)},
      {"lvx", "1.1", recorded_lvx(1)},
      {"lvx", "2", recorded_lvx(-1)},
      {"record", "drive", record_of_apollo(0, false)},
      {"record", "compensated", record_of_apollo(0, true)},
      {"record-parts", "drive",
       pack_files({{"d.record.00000", record_of_apollo(0, false)}, {"d.record.00002", record_of_apollo(3, true)}})}};
}

}  // namespace remount::formats
