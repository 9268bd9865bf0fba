// What a Livox sends, as somebody captured it or its viewer recorded it, beside an INS's log.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "algorithms/core/parallel.h"
#include "model/formats/files/output_file.h"
#include "model/simulator/captured_datagrams.h"
#include "model/simulator/drive_formats.h"
#include "model/simulator/stand_in.h"

namespace remount::simulator {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kShotsInPacket = 96, kShotBytes = 14;
constexpr std::uint32_t kLivoxAddress = 0xc0a80103;  // 192.168.1.3
constexpr std::uint32_t kViewerMagic = 0xac0ea767;
constexpr char kSerial[] = "3JEDK0000012345";

/// Those that may be simulated, and what the viewer calls them by.
constexpr std::array<std::string_view, 6> kLivoxModels{"mid-360", "mid-40", "mid-70", "avia", "hap", "rosette"};
constexpr std::array<std::uint8_t, 6> kLivoxTypes{9, 1, 6, 7, 10, 1};

/// The shots of all scans one after the other, at even steps.
struct LivoxShots {
  std::string points;  ///< 14 bytes each, zeros where nothing came back
  double first_s = 0.0, step_s = 0.0;
  double clock_offset_s = 0.0;
  std::uint8_t device_type = 0;

  std::size_t packets() const { return points.size() / (kShotBytes * kShotsInPacket); }
  std::string points_of(std::size_t packet) const {
    return points.substr(packet * kShotBytes * kShotsInPacket, kShotBytes * kShotsInPacket);
  }
  std::int64_t stamp_ns(std::size_t packet) const {
    const double time_s = first_s + step_s * static_cast<double>(packet * kShotsInPacket);
    return kDriveStart_ns + std::llround((time_s - clock_offset_s) * 1e9);
  }
};

std::string shot_bytes(const cloud::PointCloud& cloud, std::size_t i) {
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis) {
    const long millimetres = std::lround(1000.0 * static_cast<double>(cloud.points[i][axis]));
    bytes += little_bytes(static_cast<std::uint32_t>(static_cast<std::int32_t>(millimetres)), 4);
  }
  const auto light = std::lround(255.0f * std::min(1.0f, cloud.intensity[i]));
  return bytes + little_bytes(static_cast<std::uint64_t>(light), 1) + little_bytes(0, 1);
}

LivoxShots livox_shots(const SimulatedDrive& drive, int threads, const Progress& progress) {
  const SimulatedScanSource source = scans_of_model(drive, kLivoxModels, "livox");
  const SimulationOptions& options = source.options();
  const std::size_t in_scan = source.pattern().firings(0).size();
  LivoxShots shots;
  shots.first_s = scan_time_s(options, 0);
  shots.step_s = 1.0 / (options.scan_rate_hz * static_cast<double>(in_scan));
  shots.clock_offset_s = options.lidar_clock_offset_s;
  const auto model = std::find(kLivoxModels.begin(), kLivoxModels.end(), lidar_model(options.lidar.model).id);
  shots.device_type = kLivoxTypes[static_cast<std::size_t>(model - kLivoxModels.begin())];
  shots.points.resize(source.size() * in_scan * kShotBytes);
  parallel_for(source.size(), threads, [&](std::size_t scan) {
    if (progress.cancelled()) return;
    const cloud::PointCloud cloud = source.load(scan);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto shot =
          static_cast<std::size_t>(std::llround(static_cast<double>(cloud.time_from_stamp_s[i]) / shots.step_s));
      const std::string bytes = shot_bytes(cloud, i);
      std::copy(bytes.begin(), bytes.end(),
                shots.points.begin() + static_cast<std::ptrdiff_t>((scan * in_scan + shot) * kShotBytes));
    }
  });
  return shots;
}

std::string sdk2_packet(const LivoxShots& shots, std::size_t packet) {
  constexpr std::uint8_t kReceiver = 2, kMillimetres = 1;
  const std::string points = shots.points_of(packet);
  const auto taken = static_cast<std::uint64_t>(std::llround(1e7 * shots.step_s * kShotsInPacket));
  return little_bytes(0, 1) + little_bytes(36 + points.size(), 2) + little_bytes(taken, 2) +
         little_bytes(kShotsInPacket, 2) + little_bytes(packet, 2) + little_bytes(0, 1) +
         little_bytes(kMillimetres, 1) + little_bytes(kReceiver, 1) + little_bytes(0, 12) + little_bytes(0, 4) +
         little_bytes(static_cast<std::uint64_t>(shots.stamp_ns(packet)), 8) + points;
}

/// Year, month, day and hour, and microseconds of the hour.
std::string spelt_time(std::int64_t stamp_ns) {
  using namespace std::chrono;
  const sys_time<microseconds> time{microseconds((stamp_ns + 500) / 1000)};
  const auto midnight = floor<days>(time);
  const year_month_day date{midnight};
  const auto hour = floor<hours>(time - midnight);
  return little_bytes(static_cast<std::uint64_t>(static_cast<int>(date.year()) - 2000), 1) +
         little_bytes(static_cast<unsigned>(date.month()), 1) + little_bytes(static_cast<unsigned>(date.day()), 1) +
         little_bytes(static_cast<std::uint64_t>(hour.count()), 1) +
         little_bytes(static_cast<std::uint64_t>((time - midnight - hour).count()), 4);
}

std::string lvx_package(const LivoxShots& shots, std::size_t packet) {
  constexpr std::uint8_t kVersion = 5, kReceiver = 3, kWithTags = 2;
  return little_bytes(0, 1) + little_bytes(kVersion, 1) + little_bytes(0, 1) + little_bytes(1, 1) + little_bytes(0, 5) +
         little_bytes(kReceiver, 1) + little_bytes(kWithTags, 1) + spelt_time(shots.stamp_ns(packet)) +
         shots.points_of(packet);
}

std::string lvx2_package(const LivoxShots& shots, std::size_t packet) {
  constexpr std::uint8_t kPtp = 1, kMillimetres = 1;
  const std::string points = shots.points_of(packet);
  return little_bytes(0, 1) + network_bytes(kLivoxAddress, 4) + little_bytes(0, 1) + little_bytes(kPtp, 1) +
         little_bytes(static_cast<std::uint64_t>(shots.stamp_ns(packet)), 8) + little_bytes(packet, 2) +
         little_bytes(kMillimetres, 1) + little_bytes(points.size(), 4) + little_bytes(0, 5) + points;
}

std::string lvx_head(const LivoxShots& shots, bool second) {
  std::string head = "livox_tech";
  head.resize(16);
  head += second ? little_bytes(2, 4) : little_bytes(0x0101, 4);
  head += little_bytes(kViewerMagic, 4) + little_bytes(50, 4) + little_bytes(1, 1);
  std::string serial = kSerial;
  serial.resize(32);
  head += serial + (second ? network_bytes(kLivoxAddress, 4) + little_bytes(0, 1) : little_bytes(0, 1));
  return head + little_bytes(shots.device_type, 1) + little_bytes(0, 1) + std::string(24, '\0');
}

/// Frames of 50 ms behind the head.
std::string lvx_file(const LivoxShots& shots, bool second) {
  constexpr std::int64_t kFrame_ns = 50'000'000;
  constexpr std::size_t kFrameHead = 24;
  std::string file = lvx_head(shots, second);
  std::size_t packet = 0;
  for (std::uint64_t frame = 0; packet < shots.packets(); ++frame) {
    const std::int64_t ends_ns = (shots.stamp_ns(packet) / kFrame_ns + 1) * kFrame_ns;
    std::string packages;
    for (; packet < shots.packets() && shots.stamp_ns(packet) < ends_ns; ++packet)
      packages += second ? lvx2_package(shots, packet) : lvx_package(shots, packet);
    file += little_bytes(file.size(), 8) + little_bytes(file.size() + kFrameHead + packages.size(), 8) +
            little_bytes(frame, 8) + packages;
  }
  return file;
}

std::string livox_capture(const LivoxShots& shots) {
  constexpr std::uint16_t kPort = 56301;
  constexpr std::int64_t kDelay_ns = 200'000;  // of the computer that captures
  std::string capture = capture_head();
  const std::int64_t taken_ns = std::llround(1e9 * shots.step_s * kShotsInPacket);
  for (std::size_t packet = 0; packet < shots.packets(); ++packet)
    capture += captured_datagram(shots.stamp_ns(packet) + taken_ns + kDelay_ns, kPort, sdk2_packet(shots, packet));
  return capture;
}

void write_livox(const SimulatedDrive& drive, const fs::path& file, int threads, Progress& progress,
                 std::string (*make)(const LivoxShots& shots)) {
  const LivoxShots shots = livox_shots(drive, threads, progress);
  if (write_receiver_log(drive, file.parent_path(), progress)) formats::write_file(file, make(shots));
}

}  // namespace

void write_livox_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  write_livox(drive, folder / "capture.pcap", threads, progress, livox_capture);
}

void write_lvx_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  write_livox(drive, folder / "drive.lvx", threads, progress,
              [](const LivoxShots& shots) { return lvx_file(shots, false); });
}

void write_lvx2_drive(const SimulatedDrive& drive, const fs::path& folder, int threads, Progress& progress) {
  write_livox(drive, folder / "drive.lvx2", threads, progress,
              [](const LivoxShots& shots) { return lvx_file(shots, true); });
}

}  // namespace remount::simulator
