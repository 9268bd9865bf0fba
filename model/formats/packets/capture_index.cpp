#include "model/formats/packets/capture_index.h"

#include <utility>

#include "algorithms/core/error.h"
#include "model/formats/packets/capture_records.h"
#include "model/formats/packets/lvx_file.h"

namespace remount::formats {

namespace {

class CapturedPackets final : public PacketFile {
 public:
  explicit CapturedPackets(std::shared_ptr<const RandomAccessFile> file) : file_(std::move(file)) {}
  std::filesystem::path name() const override { return file_->name(); }
  void read(const SensorPackets& sensor, std::size_t first, std::size_t last,
            const std::function<void(std::size_t packet, std::string payload)>& take) const override {
    for (std::size_t i = first; i <= last; ++i) {
      const IndexedPacket& packet = sensor.packets[i];
      const DatagramPiece whole{packet.offset, packet.bytes};
      take(i, packet.pieces == 1 ? read_payload(*file_, &whole, 1)
                                 : read_payload(*file_, &sensor.pieces[packet.offset], packet.pieces));
    }
  }

 private:
  std::shared_ptr<const RandomAccessFile> file_;
};

}  // namespace

std::shared_ptr<const PacketFile> captured_packets(std::shared_ptr<const RandomAccessFile> file) {
  return std::make_shared<CapturedPackets>(std::move(file));
}

PacketIndex index_capture(const std::filesystem::path& path, Progress& progress, const IndexStore& store) {
  const auto file = std::make_shared<RandomAccessFile>(path);
  if (is_lvx(path)) return index_lvx(file, progress);
  IndexedCapture capture = index_once(path, *file, store, progress);
  PacketIndex index = capture.indexing.made(true);
  index.file = captured_packets(file);
  index.counts = capture.counts;
  index.remark = std::move(capture.remark);
  return index;
}

PacketIndex index_begin(const std::filesystem::path& path) {
  constexpr std::uint64_t kLookedAt = std::uint64_t{4} << 20U;
  Progress progress;
  if (is_lvx(path)) return index_lvx(std::make_shared<RandomAccessFile>(path), progress, kLookedAt);
  const RandomAccessFile file(path);
  PacketIndexing indexing(path);
  const CaptureCounts counts = visit_datagrams(
      file, [&](const Datagram& datagram) { indexing.take(datagram); }, progress, kLookedAt);
  PacketIndex index = indexing.made(false);
  index.counts = counts;
  return index;
}

std::vector<SensorPackets> sensors_at_begin(const std::filesystem::path& path) { return index_begin(path).sensors; }

bool holds_lidar(const std::filesystem::path& path) {
  if (!is_capture(path)) return false;
  try {
    const PacketIndex index = index_begin(path);
    return !index.sensors.empty() || !index.refused.empty();
  } catch (const Error&) {
    return false;
  }
}

}  // namespace remount::formats
