#include "model/formats/packets/capture_records.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/lvx_file.h"
#include "model/formats/packets/packet_times.h"

namespace remount::formats {

namespace {

constexpr std::uint64_t kWindowBytes = std::uint64_t{1} << 18;
/// No tool captures more of a frame.
constexpr std::uint32_t kMostFrameBytes = 1U << 18;
constexpr std::uint32_t kPcapMicroseconds = 0xa1b2c3d4, kPcapNanoseconds = 0xa1b23c4d;
constexpr std::uint32_t kSection = 0x0a0d0d0a, kByteOrder = 0x1a2b3c4d;
constexpr std::size_t kHeadBytes = 24;

/// Bytes of a file that is read from its beginning to its end.
class FileWindow {
 public:
  explicit FileWindow(const RandomAccessFile& file) : file_(file) {}
  std::uint64_t left_from(std::uint64_t offset) const { return offset < file_.size() ? file_.size() - offset : 0; }
  /// What the file holds: callers look at left_from() first. Until the next call.
  std::string_view bytes(std::uint64_t offset, std::uint64_t count) {
    if (offset < offset_ || offset + count > offset_ + block_.size()) {
      block_ = file_.read(offset, std::min(std::max(count, kWindowBytes), left_from(offset)));
      offset_ = offset;
    }
    return std::string_view(block_).substr(offset - offset_, count);
  }
  const RandomAccessFile& file() const { return file_; }

 private:
  const RandomAccessFile& file_;
  std::uint64_t offset_ = 0;
  std::string block_;
};

/// What both kinds of file share.
class RecordsOfFile : public CaptureRecords {
 public:
  explicit RecordsOfFile(const RandomAccessFile& file) : window_(file) {}
  std::uint64_t unread_bytes() const override { return window_.left_from(offset_); }
  bool cut() const override { return cut_; }
  std::uint64_t position() const override { return offset_; }

 protected:
  bool stop(bool cut) {
    cut_ = cut;
    return false;
  }

  FileWindow window_;
  std::uint64_t offset_ = 0;
  bool cut_ = false;
};

/// A header of the file, then records: <seconds><fraction><captured bytes><bytes on the wire><frame>.
class PcapRecords final : public RecordsOfFile {
 public:
  PcapRecords(const RandomAccessFile& file, bool big) : RecordsOfFile(file), big_(big) {
    const std::string_view head = window_.bytes(0, kHeadBytes);
    const auto version = number_in<std::uint16_t>(head, 4, big_);
    if (version != 2) throw Error(ErrorCode::Unsupported, file.name().string(), say::capture_version(version));
    const bool named = number_in<std::uint32_t>(head, 0, big_) == kPcapNanoseconds;
    link_type_ = number_in<std::uint32_t>(head, 20, big_) & 0xffffU;  // above: how long checksums are
    offset_ = kHeadBytes;
    unit_ns_ = named || holds_nanoseconds() ? 1 : 1000;
  }

  bool next(CapturedFrame& frame) override {
    const std::uint64_t left = window_.left_from(offset_);
    if (left < kRecordHead) return stop(left > 0);
    const std::string_view head = window_.bytes(offset_, kRecordHead);
    const auto captured = number_in<std::uint32_t>(head, 8, big_);
    if (captured > kMostFrameBytes) return stop(false);
    if (captured > left - kRecordHead) return stop(true);
    frame.time_ns = number_in<std::uint32_t>(head, 0, big_) * kSecond_ns +
                    number_in<std::uint32_t>(head, 4, big_) * std::int64_t{unit_ns_};
    frame.offset = offset_ + kRecordHead;
    frame.link_type = link_type_;
    frame.bytes = window_.bytes(frame.offset, captured);
    offset_ = frame.offset + captured;
    return true;
  }

 private:
  static constexpr std::uint64_t kRecordHead = 16;

  /// Some programs write nanoseconds behind the mark of microseconds: no second has a million of these.
  bool holds_nanoseconds() {
    constexpr int kLookedAt = 200;
    constexpr std::uint32_t kMicroseconds = 1'000'000, kNanoseconds = 1'000'000'000;
    std::uint64_t at = kHeadBytes;
    for (int looked = 0; looked < kLookedAt && window_.left_from(at) >= kRecordHead; ++looked) {
      const std::string_view head = window_.bytes(at, kRecordHead);
      const auto fraction = number_in<std::uint32_t>(head, 4, big_), captured = number_in<std::uint32_t>(head, 8, big_);
      if (captured > kMostFrameBytes || fraction >= kNanoseconds) return false;
      if (fraction >= kMicroseconds) return true;
      at += kRecordHead + captured;
    }
    return false;
  }

  bool big_;
  std::int32_t unit_ns_ = 1000;
  std::uint32_t link_type_ = 0;
};

/// What a section of a pcapng says of one network card.
struct CaptureInterface {
  std::uint32_t link_type = 0;
  std::uint32_t most_bytes = 0;  ///< of a frame; 0: no limit
  double ticks_per_s = 1e6;
  std::int64_t offset_s = 0;
};

/// Blocks: <type><length><body><length again>.
class PcapngRecords final : public RecordsOfFile {
 public:
  explicit PcapngRecords(const RandomAccessFile& file) : RecordsOfFile(file) {}

  bool next(CapturedFrame& frame) override {
    const std::uint64_t left = window_.left_from(offset_);
    if (left < kLeastBlock) return stop(left > 0);
    const std::string head(window_.bytes(offset_, kLeastBlock));
    const auto raw_type = number_in<std::uint32_t>(head, 0, false);
    if (raw_type == kSection && !begin_section(head)) return stop(false);
    const auto bytes = number_in<std::uint32_t>(head, 4, big_);
    if (bytes < kLeastBlock || bytes % 4 != 0) return stop(false);
    if (bytes > left) return stop(true);
    const std::uint64_t block = offset_;
    offset_ += bytes;
    const auto type = number_in<std::uint32_t>(head, 0, big_);
    if (type == 1) add_interface(block, bytes);
    const bool packet = type == 2 || type == 3 || type == 6;
    frame.other = !packet || !frame_of(type, block, bytes, frame);
    return true;
  }

 private:
  static constexpr std::uint32_t kLeastBlock = 12;

  bool begin_section(std::string_view head) {
    interfaces_.clear();
    big_ = number_in<std::uint32_t>(head, 8, true) == kByteOrder;
    return big_ || number_in<std::uint32_t>(head, 8, false) == kByteOrder;
  }

  void add_interface(std::uint64_t block, std::uint32_t bytes) {
    constexpr std::uint32_t kHead = 16, kMostBytes = 1U << 16;  // of names and remarks
    CaptureInterface added;
    if (bytes >= kHead + 4) {
      const std::string_view body = window_.bytes(block, std::min(bytes, kMostBytes));
      added.link_type = number_in<std::uint16_t>(body, 8, big_);
      added.most_bytes = number_in<std::uint32_t>(body, 12, big_);
      for (std::size_t at = kHead; at + 4 <= body.size();) {
        const auto code = number_in<std::uint16_t>(body, at, big_),
                   length = number_in<std::uint16_t>(body, at + 2, big_);
        if (code == 0 || at + 4 + length > body.size()) break;
        if (code == 9 && length >= 1) added.ticks_per_s = ticks_per_s(static_cast<unsigned char>(body[at + 4]));
        if (code == 14 && length >= 8) added.offset_s = number_in<std::int64_t>(body, at + 4, big_);
        at += 4 + (length + 3U) / 4U * 4U;
      }
    }
    interfaces_.push_back(added);
  }

  static double ticks_per_s(unsigned char resolution) {
    const int power = resolution & 0x7f;
    return resolution & 0x80 ? std::ldexp(1.0, power) : std::pow(10.0, power);
  }

  /// Of an enhanced packet (6), a simple one (3) or one as they were before (2). False where it cannot be used.
  bool frame_of(std::uint32_t type, std::uint64_t block, std::uint32_t bytes, CapturedFrame& frame) {
    const std::uint32_t head_bytes = type == 3 ? 12 : 28;
    if (bytes < head_bytes + 4) return false;
    const std::string head(window_.bytes(block, head_bytes));
    std::size_t place = 0;
    if (type == 6) place = number_in<std::uint32_t>(head, 8, big_);
    if (type == 2) place = number_in<std::uint16_t>(head, 8, big_);
    if (place >= interfaces_.size()) return false;
    const CaptureInterface& interface = interfaces_[place];
    auto captured = number_in<std::uint32_t>(head, type == 3 ? 8 : 20, big_);
    if (type == 3 && interface.most_bytes > 0) captured = std::min(captured, interface.most_bytes);
    if (captured > bytes - head_bytes - 4 || captured > kMostFrameBytes) return false;
    if (type != 3) {
      const std::uint64_t ticks =
          std::uint64_t{number_in<std::uint32_t>(head, 12, big_)} << 32U | number_in<std::uint32_t>(head, 16, big_);
      time_ns_ = time_of(interface, ticks);
    }
    frame.time_ns = time_ns_;
    frame.offset = block + head_bytes;
    frame.link_type = interface.link_type;
    frame.bytes = window_.bytes(frame.offset, captured);
    return true;
  }

  /// 0 for what is no time of this century or the next, so that times can be added and subtracted.
  static std::int64_t time_of(const CaptureInterface& interface, std::uint64_t ticks) {
    constexpr double kMost_s = 4.5e9;
    const double whole_s = std::floor(static_cast<double>(ticks) / interface.ticks_per_s);
    if (!(whole_s < kMost_s) || interface.offset_s < 0 || static_cast<double>(interface.offset_s) + whole_s > kMost_s)
      return 0;
    if (interface.ticks_per_s > 9e18)  // no more than two seconds
      return interface.offset_s * kSecond_ns + std::llround(static_cast<double>(ticks) / interface.ticks_per_s * 1e9);
    // Whole seconds are taken off as integers: a double does not hold the ticks of today.
    const auto per_s = static_cast<std::uint64_t>(interface.ticks_per_s);
    return (static_cast<std::int64_t>(ticks / per_s) + interface.offset_s) * kSecond_ns +
           std::llround(static_cast<double>(ticks % per_s) / interface.ticks_per_s * 1e9);
  }

  bool big_ = false;
  std::vector<CaptureInterface> interfaces_;
  std::int64_t time_ns_ = 0;
};

enum class CaptureKind { None, Pcap, PcapBig, Pcapng };

CaptureKind kind_of(std::string_view head) {
  if (head.size() < kHeadBytes) return CaptureKind::None;
  for (const bool big : {false, true}) {
    const auto magic = number_in<std::uint32_t>(head, 0, big);
    if (magic == kPcapMicroseconds || magic == kPcapNanoseconds) return big ? CaptureKind::PcapBig : CaptureKind::Pcap;
  }
  const bool section = number_in<std::uint32_t>(head, 0, false) == kSection;
  const bool ordered =
      number_in<std::uint32_t>(head, 8, false) == kByteOrder || number_in<std::uint32_t>(head, 8, true) == kByteOrder;
  return section && ordered ? CaptureKind::Pcapng : CaptureKind::None;
}

}  // namespace

bool is_capture(const std::filesystem::path& path) {
  try {
    return is_file(path) && (kind_of(read_file_head(path, kHeadBytes)) != CaptureKind::None || is_lvx(path));
  } catch (const Error&) {
    return false;
  }
}

std::unique_ptr<CaptureRecords> read_records(const RandomAccessFile& file) {
  switch (kind_of(file.read(0, std::min<std::uint64_t>(file.size(), kHeadBytes)))) {
    case CaptureKind::Pcap:
      return std::make_unique<PcapRecords>(file, false);
    case CaptureKind::PcapBig:
      return std::make_unique<PcapRecords>(file, true);
    case CaptureKind::Pcapng:
      return std::make_unique<PcapngRecords>(file);
    case CaptureKind::None:
      break;
  }
  throw Error(ErrorCode::Format, file.name().string(), say::capture_none());
}

}  // namespace remount::formats
