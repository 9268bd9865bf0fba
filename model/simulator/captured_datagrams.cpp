#include "model/simulator/captured_datagrams.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/core/parallel.h"

namespace remount::simulator {

std::string little_bytes(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xffU));
  return bytes;
}

std::string network_bytes(std::uint64_t value, std::size_t count) {
  const std::string bytes = little_bytes(value, count);
  return {bytes.rbegin(), bytes.rend()};
}

std::string capture_head() {
  return little_bytes(0xa1b2c3d4, 4) + little_bytes(2, 2) + little_bytes(4, 2) + little_bytes(0, 8) +
         little_bytes(65535, 4) + little_bytes(1, 4);
}

std::uint16_t port_of_points(const std::vector<SentDatagram>& sent) {
  std::map<std::uint16_t, std::size_t> counts;
  for (const SentDatagram& one : sent) ++counts[one.port];
  const auto most = std::ranges::max_element(counts, {}, [](const auto& port) { return port.second; });
  return most == counts.end() ? std::uint16_t{0} : most->first;
}

std::string captured_datagram(std::int64_t time_ns, std::uint16_t port, const std::string& payload) {
  constexpr std::uint32_t kSensor = 0xc0a801c9;  // 192.168.1.201
  const std::string udp =
      network_bytes(port, 2) + network_bytes(port, 2) + network_bytes(payload.size() + 8, 2) + network_bytes(0, 2);
  const std::string ip = network_bytes(0x4500, 2) + network_bytes(20 + udp.size() + payload.size(), 2) +
                         network_bytes(0, 4) + network_bytes(0x4011, 2) + network_bytes(0, 2) +
                         network_bytes(kSensor, 4) + network_bytes(0xffffffff, 4);
  const std::string frame =
      std::string(6, '\xff') + network_bytes(0x607688000000, 6) + network_bytes(0x0800, 2) + ip + udp + payload;
  return little_bytes(static_cast<std::uint64_t>(time_ns / 1'000'000'000), 4) +
         little_bytes(static_cast<std::uint64_t>(time_ns % 1'000'000'000 / 1000), 4) + little_bytes(frame.size(), 4) +
         little_bytes(frame.size(), 4) + frame;
}

std::vector<std::string> pieces_of_capture(std::size_t count, int threads, const Progress& progress,
                                           const std::function<std::string(std::size_t piece)>& make) {
  std::vector<std::string> pieces(count);
  parallel_for(count, threads, [&](std::size_t piece) {
    if (!progress.cancelled()) pieces[piece] = make(piece);
  });
  return pieces;
}

std::optional<std::uint64_t> range_units(double range_m, double unit_m, double most) {
  const double units = std::round(range_m / unit_m);
  if (units < 1.0 || units > most) return std::nullopt;
  return static_cast<std::uint64_t>(units);
}

std::uint64_t light_byte(float reflectance) {
  return static_cast<std::uint64_t>(std::lround(255.0 * std::min(1.0f, reflectance)));
}

std::int64_t lidar_stamp_ns(const Scene& scene, double time_s) {
  return kDriveStart_ns + std::llround((time_s - scene.options().lidar_clock_offset_s) * 1e9);
}

}  // namespace remount::simulator
