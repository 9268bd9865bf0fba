// The network packets of an RS-LiDAR-M1, as somebody captured them beside an INS's log.
#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/stand_in.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kM1Lasers = 5, kM1BlocksInPacket = 25, kM1BlockBytes = 47, kM1Header = 32;
constexpr std::uint16_t kM1Port = 6699;

/// Distance, up and left as the sensor counts them, and reflectance.
std::string m1_return(const cloud::PointCloud& cloud, std::size_t i) {
  constexpr double kUnit_m = 0.005;
  constexpr long kAhead = 32768;
  const Eigen::Vector3d point = cloud.points[i].cast<double>();
  const auto hundredths = [](double angle_rad) { return std::lround(100.0 * radians_to_degrees(angle_rad)) + kAhead; };
  const double range_m = point.norm();
  const auto light = std::lround(255.0f * std::min(1.0f, cloud.intensity[i]));
  return network_bytes(static_cast<std::uint64_t>(std::lround(range_m / kUnit_m)), 2) +
         network_bytes(static_cast<std::uint64_t>(hundredths(std::asin(point.z() / range_m))), 2) +
         network_bytes(static_cast<std::uint64_t>(hundredths(std::atan2(point.y(), point.x()))), 2) +
         network_bytes(static_cast<std::uint64_t>(light), 1) + network_bytes(0, 2);
}

/// A frame of packets, each with its time: all five lasers fire at once, block by block.
class M1Frame {
 public:
  M1Frame(const SimulatedScanSource& source, std::size_t scan) : begins_ns_(source.stamp_ns(scan)) {
    const cloud::PointCloud cloud = source.load(scan);
    const std::size_t blocks = source.pattern().firings(scan).size() / kM1Lasers;
    step_s_ = 1.0 / (source.options().scan_rate_hz * static_cast<double>(blocks));
    returns_.resize(blocks);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double time_s = static_cast<double>(cloud.time_from_stamp_s[i]);
      returns_[static_cast<std::size_t>(std::llround(time_s / step_s_))] += m1_return(cloud, i);
    }
  }

  std::string packets() const {
    constexpr std::int64_t kDelay_ns = 200'000;  // of the computer that captures
    std::string captured;
    for (std::size_t packet = 0; packet * kM1BlocksInPacket < returns_.size(); ++packet)
      captured +=
          captured_datagram(time_us((packet + 1) * kM1BlocksInPacket) * 1000 + kDelay_ns, kM1Port, payload(packet));
    return captured;
  }

 private:
  std::int64_t time_us(std::size_t block) const {
    return (begins_ns_ + std::llround(1e9 * step_s_ * static_cast<double>(block)) + 500) / 1000;
  }

  std::string payload(std::size_t packet) const {
    constexpr std::uint8_t kStrongest = 4, kPtp = 2;
    const std::size_t first = packet * kM1BlocksInPacket;
    const std::int64_t begins_us = time_us(first);
    std::string bytes = network_bytes(0x55aa5aa5, 4) + network_bytes(packet + 1, 2) + network_bytes(0, 2) +
                        network_bytes(kStrongest, 1) + network_bytes(kPtp, 1) +
                        network_bytes(static_cast<std::uint64_t>(begins_us / 1'000'000), 6) +
                        network_bytes(static_cast<std::uint64_t>(begins_us % 1'000'000), 4);
    bytes.resize(kM1Header);
    for (std::size_t block = first; block < first + kM1BlocksInPacket; ++block) {
      const bool fired = block < returns_.size();
      bytes += network_bytes(static_cast<std::uint64_t>(fired ? time_us(block) - begins_us : 0), 1) +
               network_bytes(1, 1) + (fired ? returns_[block] : std::string());
      bytes.resize(kM1Header + (block - first + 1) * kM1BlockBytes);
    }
    return bytes + network_bytes(0, 3);
  }

  std::int64_t begins_ns_;
  double step_s_ = 0.0;
  std::vector<std::string> returns_;  // of each block
};

}  // namespace

void write_m1_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  constexpr std::array<std::string_view, 1> kModels{"m1"};
  const SimulatedScanSource source = scans_of_model(drive, kModels, "robosense-m1");
  const std::vector<std::string> frames = pieces_of_capture(
      source.size(), threads, progress, [&](std::size_t scan) { return M1Frame(source, scan).packets(); });
  if (!write_receiver_log(drive, folder, progress)) return;
  std::string capture = capture_head();
  for (const std::string& frame : frames) capture += frame;
  formats::write_file(folder / "capture.pcap", capture);
}

}  // namespace remount::simulator
