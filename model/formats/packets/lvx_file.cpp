#include "model/formats/packets/lvx_file.h"

#include <algorithm>
#include <map>
#include <string>

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "messages/stages.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/packets/capture_index.h"
#include "model/formats/packets/livox_packets.h"

namespace remount::formats {

namespace {

constexpr std::string_view kLvxSignature = "livox_tech";
constexpr std::size_t kPublicHead = 24, kVersionAt = 16;
/// More is no frame: the fastest sensors fill less in a second.
constexpr std::uint64_t kMostFrameOfFile = std::uint64_t{64} << 20U;
/// No viewer shows more; ids beyond are of a damaged file.
constexpr std::size_t kMostDevices = 256;

/// How the versions lay out their parts.
struct LvxLayout {
  LivoxHead head = LivoxHead::Lvx2;
  std::size_t private_head = 5;  ///< in front of the devices; its last byte is how many there are
  std::size_t device = 63, device_type = 37;
  std::size_t frame_head = 24;
  std::size_t packet_at = 0;  ///< in a package: behind the number of the device
};

LvxLayout lvx_layout(const std::string& head, const std::string& where) {
  const auto major = static_cast<std::uint8_t>(head[kVersionAt]),
             minor = static_cast<std::uint8_t>(head[kVersionAt + 1]);
  if (major == 2) return {};
  if (major == 1 && minor == 0) return {LivoxHead::Lvx, 1, 58, 33, 32, 1};
  if (major == 1 && minor == 1) return {LivoxHead::Sdk1, 5, 59, 33, 24, 1};
  throw Error(ErrorCode::Unsupported, where, say::lvx_version(major, minor));
}

std::string livox_model(std::uint8_t device_type) {
  switch (device_type) {
    case 1:
      return "Livox Mid-40";
    case 2:
      return "Livox Tele-15";
    case 3:
      return "Livox Horizon";
    case 6:
      return "Livox Mid-70";
    case 7:
      return "Livox Avia";
    case 9:
    case 35:
      return "Livox Mid-360";
    case 10:
    case 15:
      return "Livox HAP";
    default:
      return "Livox";
  }
}

/// Goes through the frames of a recording and sorts packages by their sensors.
class LvxIndexing {
 public:
  LvxIndexing(std::shared_ptr<const RandomAccessFile> file, std::uint64_t most_bytes)
      : file_(std::move(file)), most_bytes_(most_bytes) {}

  PacketIndex index(Progress& progress);

 private:
  struct Device {
    std::string name, model;
  };

  void read_devices();
  bool read_frame();
  std::size_t take_packages(std::string_view frame, std::uint64_t at);
  void take(std::uint32_t device, std::string_view packet, std::uint64_t at);
  std::int64_t frame_begins_ns() const { return frames_ * frame_ns_; }

  std::shared_ptr<const RandomAccessFile> file_;
  std::uint64_t most_bytes_, at_ = 0;
  LvxLayout layout_;
  std::int64_t frame_ns_ = 50'000'000, frames_ = 0;
  std::map<std::uint32_t, Device> devices_;
  std::map<std::uint32_t, SensorPackets> sensors_;
  PacketIndex index_;
};

void LvxIndexing::read_devices() {
  const std::string where = file_->name().string();
  layout_ = lvx_layout(file_->read(0, kPublicHead), where);
  const std::string head = file_->read(kPublicHead, layout_.private_head);
  if (layout_.private_head > 1)
    frame_ns_ = std::int64_t{1'000'000} * std::clamp(little_number<std::uint32_t>(head, 0), 1U, 1000U);
  at_ = kPublicHead + layout_.private_head;
  const auto count = static_cast<std::uint8_t>(head.back());
  for (std::size_t i = 0; i < count; ++i, at_ += layout_.device) {
    constexpr std::size_t kSerialBytes = 16, kIdAt = 32;
    const std::string bytes = file_->read(at_, layout_.device);
    const std::uint32_t id =
        layout_.head == LivoxHead::Lvx2 ? little_number<std::uint32_t>(bytes, kIdAt) : byte_at(bytes, kIdAt);
    const std::string serial = bytes.substr(0, std::min(bytes.find('\0'), kSerialBytes));
    devices_[id] = {printable(serial, LineBreaks::Escaped), livox_model(byte_at(bytes, layout_.device_type))};
  }
}

void LvxIndexing::take(std::uint32_t device, std::string_view packet, std::uint64_t at) {
  const auto found = sensors_.find(device);
  if (found == sensors_.end() && sensors_.size() == kMostDevices) return;
  SensorPackets& sensor = found == sensors_.end() ? sensors_[device] : found->second;
  if (!sensor.decoder) {
    const auto known = devices_.find(device);
    sensor.name = known == devices_.end() || known->second.name.empty() ? std::to_string(device) : known->second.name;
    sensor.decoder = livox_decoder(layout_.head, packet, known == devices_.end() ? "Livox" : known->second.model);
  }
  const auto glance = sensor.decoder ? sensor.decoder->glance(packet) : std::nullopt;
  if (!glance) {
    if (sensor.decoder) count_unused(sensor, packet);
    return;
  }
  IndexedPacket indexed = indexed_packet(*glance, packet.size());
  // What counts from a pulse a second gets its seconds from the frames.
  indexed.host_ns = glance->clock_period_s > 0 ? frame_begins_ns() : indexed.time_ns;
  indexed.offset = at;
  sensor.packets.push_back(indexed);
}

/// @return how many of its bytes are whole packages
std::size_t LvxIndexing::take_packages(std::string_view frame, std::uint64_t at) {
  constexpr std::size_t kIdInLvx2 = 1;
  std::size_t place = 0;
  while (place + layout_.packet_at < frame.size()) {
    const std::string_view packet = frame.substr(place + layout_.packet_at);
    const auto bytes = livox_packet_bytes(layout_.head, packet);
    if (!bytes || *bytes > packet.size()) break;
    const std::uint32_t device =
        layout_.head == LivoxHead::Lvx2 ? little_number<std::uint32_t>(packet, kIdInLvx2) : byte_at(frame, place);
    take(device, packet.substr(0, *bytes), at + place + layout_.packet_at);
    place += layout_.packet_at + *bytes;
  }
  return place;
}

/// False where nothing behind can be read.
bool LvxIndexing::read_frame() {
  const std::uint64_t left = file_->size() - at_;
  if (left < layout_.frame_head) {
    index_.counts.cut = true;
    return false;
  }
  const std::string head = file_->read(at_, layout_.frame_head);
  const auto current = little_number<std::uint64_t>(head, 0), next = little_number<std::uint64_t>(head, 8);
  if (current != at_ || next < at_ + layout_.frame_head || next - at_ > kMostFrameOfFile) return false;
  index_.counts.cut = next > file_->size();
  const std::uint64_t begins = at_ + layout_.frame_head, ends = std::min(next, file_->size());
  const std::size_t whole = take_packages(file_->read(begins, ends - begins), begins);
  ++frames_;
  ++index_.counts.frames;
  at_ = index_.counts.cut ? begins + whole : next;
  if (!index_.counts.cut && whole < ends - begins) ++index_.counts.broken_frames;
  return !index_.counts.cut;
}

PacketIndex LvxIndexing::index(Progress& progress) {
  constexpr std::int64_t kFramesBetweenReports = 64;
  read_devices();
  bool readable = true;
  while (readable && at_ < std::min(most_bytes_, file_->size())) {
    if (frames_ % kFramesBetweenReports == 0) {
      if (progress.cancelled()) break;
      progress.report(say::stage_reading_packets, at_ >> 20U, file_->size() >> 20U);
    }
    readable = read_frame();
  }
  if (!readable) index_.counts.unread_bytes = file_->size() - at_;
  for (auto& [device, sensor] : sensors_)
    if (!sensor.packets.empty()) index_.sensors.push_back(std::move(sensor));
  if (index_.sensors.empty())
    index_.refused.emplace_back(ErrorCode::Format, file_->name().string(), say::lvx_no_points());
  index_.file = captured_packets(file_);
  return std::move(index_);
}

}  // namespace

bool is_lvx(const std::filesystem::path& path) {
  try {
    return is_file(path) && read_file_head(path, kLvxSignature.size()) == kLvxSignature;
  } catch (const Error&) {
    return false;
  }
}

PacketIndex index_lvx(std::shared_ptr<const RandomAccessFile> file, Progress& progress, std::uint64_t most_bytes) {
  return LvxIndexing(std::move(file), most_bytes).index(progress);
}

}  // namespace remount::formats
