#include "tests/model/formats/sample_captures.h"

#include "model/formats/files/input_file.h"
#include "model/formats/packets/kept_index.h"
#include "tests/fuzz/readers.h"
#include "tests/model/formats/bags/packet_bags.h"
#include "tests/model/formats/packets/capture_bytes.h"
#include "tests/model/formats/packets/hdl64_calibration.h"
#include "tests/model/formats/packets/hesai_bytes.h"
#include "tests/model/formats/packets/ouster_bytes.h"
#include "tests/model/formats/packets/robosense_bytes.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

namespace {

/// A few packets of a LiDAR and of the receiver it hangs on.
std::vector<TimedFrame> captured_velodyne() {
  constexpr std::int64_t kBegins_ns = 1'700'000'000'000'000'000;
  std::vector<TimedFrame> frames = vlp16_drive(8, kBegins_ns, 800e6);
  const std::string sentence = "$GPRMC,221320.00,A,4846.8000,N,00910.8000,E,0.0,0.0,141123,,,A*6F\r\n";
  frames.push_back({kBegins_ns + 1, ethernet_udp(position_packet(sentence, 2), {.port = 8308})});
  const std::string datagram = frames[0].bytes.substr(14 + 20);
  frames.push_back({kBegins_ns + 2, ethernet(ipv4(datagram.substr(0, 800), {.id = 3}, 0, true), {0x8100})});
  frames.push_back({kBegins_ns + 3, ethernet(ipv4(datagram.substr(800), {.id = 3}, 800))});
  return frames;
}

/// A few packets of an HDL-64E with its calibration.
std::string captured_hdl64(bool yaml) {
  constexpr std::int64_t kBegins_ns = 1'700'000'000'000'000'000;
  std::vector<TimedFrame> frames;
  for (std::uint32_t i = 0; i < 3; ++i) {
    VelodynePacket packet;
    packet.mode = 'V', packet.product = 0x48, packet.stamp_us = 800'000'000 + 288 * i;
    for (std::size_t block = 0; block < 12; ++block) {
      packet.flags[block] = block % 2 == 0 ? 0xeeff : 0xddff;
      packet.azimuths.push_back(static_cast<std::uint16_t>(100 * i + 17 * (block / 2)));
    }
    frames.push_back({kBegins_ns + 288'000 * i, ethernet_udp(packet.bytes())});
  }
  const Hdl64Lasers lasers = [](int laser) {
    return Hdl64Laser{0.5, 2.0 - 0.375 * laser, 120.0, 125.0, 124.0, 20.0, 2.5};
  };
  return pack_files({{yaml ? "drive.yaml" : "drive.xml", yaml ? hdl64_yaml(lasers) : hdl64_xml(lasers)},
                     {"drive.pcap", pcap(frames)}});
}

/// What is kept of it, behind the head.
std::string kept_of_velodyne() {
  const TemporaryFolder folder;
  const RandomAccessFile file(folder.write("drive.pcap", pcap(captured_velodyne())));
  PacketIndexing indexing("drive.pcap");
  Progress progress;
  const CaptureCounts counts = visit_datagrams(
      file, [&](const Datagram& datagram) { indexing.take(datagram); }, progress);
  const PassedPackets& passed = indexing.passed();
  return pack_index({"drive.pcap", file.size(), 1}, counts, passed, known_sensors(passed));
}

std::string captured_pcapng() {
  std::string file = pcapng_section(true) + pcapng_interface(true, 9);
  for (const TimedFrame& frame : captured_velodyne())
    file += pcapng_packet(frame.bytes, static_cast<std::uint64_t>(frame.time_ns), true);
  return file;
}

/// A few packets of an Ouster with its metadata, as a recorder writes them.
std::string captured_ouster(const std::string& profile, bool flat) {
  constexpr std::int64_t kBegins_ns = 1'700'000'000'000'000'000;
  OusterPacket packet;
  packet.profile = profile, packet.fusa = profile.starts_with("FUSA");
  packet.ranges = [](std::size_t column, std::size_t pixel) {
    const auto range_mm = static_cast<std::uint32_t>(4000 + 100 * column + 8 * pixel);
    return std::array{range_mm, 2 * range_mm};
  };
  OusterDescription description;
  description.profile = profile;
  const std::vector<TimedFrame> frames = ouster_drive(3, kBegins_ns, static_cast<std::uint64_t>(kBegins_ns), packet);
  return pack_files({{"drive.json", flat ? description.flat() : description.json()}, {"drive.pcap", pcap(frames)}});
}

/// A few packets of a Hesai with the angles of the sensor.
std::string captured_hesai(HesaiPacket packet) {
  std::string angles = "Laser id,Elevation,Azimuth\n";
  for (std::size_t i = 0; i < packet.channels; ++i)
    angles += std::to_string(i + 1) + "," + std::to_string(15.0 - 0.5 * static_cast<double>(i)) + ",0.25\n";
  std::vector<TimedFrame> frames;
  for (std::uint32_t i = 0; i < 3; ++i) {
    packet.azimuths.clear();
    for (std::size_t block = 0; block < packet.blocks; ++block)
      packet.azimuths.push_back(static_cast<std::uint16_t>(200 * i + 20 * block));
    packet.stamp_us = 250'000 + 500 * i;
    frames.push_back({kHesaiDate_ns + 250'500'000 + 500'000 * std::int64_t{i}, ethernet_udp(packet.bytes())});
  }
  const bool mirrored = packet.kind == HesaiPacket::Kind::At128;
  return pack_files({mirrored ? PackedFile{"drive.dat", mirror_bytes()} : PackedFile{"drive.csv", angles},
                     {"drive.pcap", pcap(frames)}});
}

}  // namespace

std::string bag_of_packets(std::unique_ptr<bags::BagWriter> (*make)(const std::filesystem::path& path)) {
  constexpr std::int64_t kFirst_ns = 1'700'000'000'000'000'000;
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "packets";
  const auto captured = [&](const std::vector<TimedFrame>& frames) {
    return bags::packets_of_capture(folder.write("a.pcap", pcap(frames)));
  };
  bags::PacketBag bag(make(path));
  bag.add_packets("/velodyne_packets", "velodyne_msgs/VelodyneScan", captured(vlp16_drive(8, kFirst_ns, 800e6)), 3);
  bag.add_packets("/ouster/lidar_packets", "ouster_sensor_msgs/PacketMsg",
                  captured(ouster_drive(3, kFirst_ns, static_cast<std::uint64_t>(kFirst_ns))));
  bag.add(kFirst_ns, "/ouster/metadata", "std_msgs/String",
          bags::text_message(OusterDescription().json(), bag.encoding()));
  bag.add_packets("/hesai/packets", "pandar_msgs/PandarScan", captured(hesai_drive(4, kFirst_ns)), 2);
  bag.add(kFirst_ns, "/hesai/corrections", "std_msgs/UInt8MultiArray",
          bags::bytes_message("Laser id,Elevation,Azimuth\n1,15,0\n", bag.encoding()));
  bag.add_packets("/rslidar_packets", "rslidar_msg/RslidarPacket",
                  captured(helios_drive(4, kFirst_ns, kFirst_ns / 1000)));
  bag.finish();
  return read_regular_file(path);
}

std::vector<Sample> captured_samples() {
  std::vector<Sample> samples{{"lidar-capture", "pcap", pcap(captured_velodyne())},
                              {"kept-index", "velodyne", kept_of_velodyne()},
                              {"lidar-capture", "pcapng", captured_pcapng()},
                              {"ouster", "legacy", captured_ouster("LEGACY", true)},
                              {"ouster", "dual", captured_ouster("RNG19_RFL8_SIG16_NIR16_DUAL", false)},
                              {"ouster", "fusa", captured_ouster("FUSA_RNG15_RFL8_NIR8_DUAL", false)}};
  for (const auto& [name, packet] : {std::pair{"pandar40", HesaiPacket::pandar40()},
                                     {"pandar64", HesaiPacket::pandar64()},
                                     {"qt64", HesaiPacket::qt64()},
                                     {"xt32", HesaiPacket()},
                                     {"pandar128", HesaiPacket::pandar128()},
                                     {"at128", HesaiPacket::at128()}})
    samples.push_back({"hesai", name, captured_hesai(packet)});
  for (const bool yaml : {false, true}) samples.push_back({"hdl64", yaml ? "yaml" : "xml", captured_hdl64(yaml)});
  return samples;
}

}  // namespace remount::formats
