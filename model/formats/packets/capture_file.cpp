#include "model/formats/packets/capture_file.h"

#include <utility>

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/capture_records.h"

namespace remount::formats {

namespace {

constexpr std::size_t kUdpHeader = 8;

/// Takes the header of UDP off a datagram that is whole. False where its length is not what it says.
bool behind_udp_header(std::string_view udp, std::uint32_t source, Datagram& datagram) {
  if (udp.size() < kUdpHeader) return false;
  const std::size_t length = network_number<std::uint16_t>(udp, 4);
  if (length < kUdpHeader || length > udp.size()) return false;
  datagram.route = {source, network_number<std::uint16_t>(udp, 2)};
  datagram.payload = udp.substr(kUdpHeader, length - kUdpHeader);
  return true;
}

/// Pieces of a payload from those of the datagram with its header.
void take_header_off(std::vector<DatagramPiece>& pieces, std::size_t payload_bytes) {
  pieces.front().offset += kUdpHeader;
  pieces.front().bytes -= kUdpHeader;
  std::size_t left = payload_bytes;
  for (DatagramPiece& piece : pieces) {
    piece.bytes = static_cast<std::uint32_t>(std::min<std::size_t>(piece.bytes, left));
    left -= piece.bytes;
  }
}

/// Makes datagrams of frames, and counts.
class DatagramVisit {
 public:
  DatagramVisit(const RandomAccessFile& file, const std::function<void(const Datagram&)>& take)
      : file_(file), take_(take) {}

  void add(const CapturedFrame& frame) {
    ++counts_.frames;
    UdpPart part;
    switch (find_udp(frame.link_type, frame.bytes, part)) {
      case FrameContent::Udp:
        part.whole() ? add_whole(frame, part) : add_fragment(frame, part);
        break;
      case FrameContent::Truncated:
        ++counts_.truncated;
        break;
      case FrameContent::UnknownLink:
        ++counts_.unknown_link;
        break;
      case FrameContent::Other:
        break;
    }
  }
  CaptureCounts counts() const {
    CaptureCounts counts = counts_;
    counts.incomplete = fragments_.incomplete();
    return counts;
  }

 private:
  void add_whole(const CapturedFrame& frame, const UdpPart& part) {
    datagram_.time_ns = frame.time_ns;
    if (!behind_udp_header(frame.bytes.substr(part.begin, part.bytes), part.source, datagram_)) return;
    datagram_.pieces.assign(
        1, {frame.offset + part.begin + kUdpHeader, static_cast<std::uint32_t>(datagram_.payload.size())});
    hand_on();
  }

  void add_fragment(const CapturedFrame& frame, const UdpPart& part) {
    std::vector<DatagramPiece> pieces = fragments_.add(part, frame.offset + part.begin, frame.time_ns);
    if (pieces.empty() || pieces.front().bytes < kUdpHeader) return;
    const std::string udp = read_payload(file_, pieces.data(), pieces.size());
    datagram_.time_ns = frame.time_ns;
    if (!behind_udp_header(udp, part.source, datagram_)) return;
    take_header_off(pieces, datagram_.payload.size());
    datagram_.pieces = std::move(pieces);
    hand_on();
  }

  void hand_on() {
    ++counts_.datagrams;
    take_(datagram_);
  }

  const RandomAccessFile& file_;
  const std::function<void(const Datagram&)>& take_;
  Fragments fragments_;
  CaptureCounts counts_;
  Datagram datagram_;
};

}  // namespace

CaptureCounts visit_datagrams(const RandomAccessFile& file, const std::function<void(const Datagram&)>& take,
                              Progress& progress, std::uint64_t most_bytes) {
  constexpr std::size_t kFramesBetweenReports = 4096;
  const std::unique_ptr<CaptureRecords> records = read_records(file);
  DatagramVisit visit(file, take);
  CapturedFrame frame;
  bool ended = false;
  for (std::size_t i = 0; records->position() < most_bytes; ++i) {
    if (i % kFramesBetweenReports == 0) {
      if (progress.cancelled()) break;
      progress.report(say::stage_reading_packets, records->position() >> 20U, file.size() >> 20U);
    }
    ended = !records->next(frame);
    if (ended) break;
    if (!frame.other) visit.add(frame);
  }
  CaptureCounts counts = visit.counts();
  if (ended) counts.unread_bytes = records->unread_bytes(), counts.cut = records->cut();
  return counts;
}

std::string read_payload(const RandomAccessFile& file, const DatagramPiece* pieces, std::size_t count) {
  std::string payload = file.read(pieces[0].offset, pieces[0].bytes);
  for (std::size_t i = 1; i < count; ++i) payload += file.read(pieces[i].offset, pieces[i].bytes);
  return payload;
}

void report_counts(const CaptureCounts& counts, const std::string& where, std::vector<drive::Finding>& findings) {
  const auto add = [&](const char* code, Message what) {
    findings.push_back(drive::make_finding(drive::Severity::Warning, code, where, std::move(what)));
  };
  if (counts.unread_bytes > 0)
    add("capture-cut",
        counts.cut ? say::capture_cut(Bytes{counts.unread_bytes}) : say::capture_damaged(Bytes{counts.unread_bytes}));
  if (counts.truncated > 0) add("capture-truncated", say::capture_truncated(counts.truncated));
  if (counts.incomplete > 0) add("capture-fragments", say::capture_fragments(counts.incomplete));
  if (counts.broken_frames > 0) add("lvx-frames", say::lvx_frames(counts.broken_frames));
}

}  // namespace remount::formats
