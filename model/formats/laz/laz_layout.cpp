// As LASzip's specification has it (M. Isenburg, "LASzip: lossless compression of LiDAR data", 2013, and the record
// that says how a file is compressed).
#include "model/formats/laz/laz_layout.h"

#include <algorithm>
#include <optional>

#include "algorithms/core/error.h"
#include "messages/laz.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/laz/integer_decoder.h"

namespace remount::formats {
namespace {

constexpr std::uint32_t kVaryingChunks = 0xffff'ffffU;

/// How points are compressed, by the numbers that stand for it.
enum Compressor : std::uint16_t { kPointWise = 1, kPointWiseChunked = 2, kLayeredChunked = 3 };

std::string laz_place(const LazFile& file, std::size_t byte) { return file.path + ", byte " + std::to_string(byte); }

[[noreturn]] void refuse_laz(const LazFile& file, std::size_t byte, Message what) {
  throw Error(ErrorCode::Format, laz_place(file, byte), std::move(what));
}

/// What is known of a part: the version of its compression that is read, and its bytes; 0: any number.
struct KnownPart {
  LazPart part;
  std::uint16_t version, newer_version;
  std::size_t bytes;
};
constexpr KnownPart kKnownParts[] = {
    {LazPart::Bytes, 2, 2, 0},   {LazPart::Point10, 2, 2, 20},      {LazPart::GpsTime11, 2, 2, 8},
    {LazPart::Rgb12, 2, 2, 6},   {LazPart::WavePacket13, 1, 1, 29}, {LazPart::Point14, 3, 4, 30},
    {LazPart::Rgb14, 3, 4, 6},   {LazPart::RgbNir14, 3, 4, 8},      {LazPart::WavePacket14, 3, 4, 29},
    {LazPart::Bytes14, 3, 4, 0},
};

/// The record that says how points are compressed.
class LayoutRecord {
 public:
  explicit LayoutRecord(const LazFile& file) : file_(file), at_(find()) {}

  std::uint16_t compressor() const { return number<std::uint16_t>(0); }
  std::uint32_t chunk_points() const { return number<std::uint32_t>(12); }

  std::vector<LazItem> items() const {
    const auto count = number<std::uint16_t>(32);
    if (count == 0 || bytes_ < kFixed + count * kItem) refuse_laz(file_, at_ + 32, say::laz_items(count));
    std::vector<LazItem> items;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      items.push_back(item(kFixed + i * kItem));
      sum += items.back().bytes;
    }
    const LazPart first = file_.format < 6 ? LazPart::Point10 : LazPart::Point14;
    if (sum != file_.record_bytes || items.front().part != first)
      refuse_laz(file_, at_ + kFixed, say::laz_other_points(Bytes{sum}, Bytes{file_.record_bytes}));
    return items;
  }

  std::size_t at() const { return at_; }

 private:
  static constexpr std::size_t kFixed = 34, kItem = 6;

  std::size_t find() {
    constexpr std::size_t kHead = 54;
    constexpr std::string_view kOwner = "laszip encoded";
    constexpr std::uint16_t kId = 22204;
    std::size_t at = file_.header_bytes;
    for (std::size_t i = 0; i < file_.header_records && at + kHead <= file_.points_at; ++i) {
      bytes_ = little_number<std::uint16_t>(file_.bytes, at + 20);
      if (bytes_ > file_.points_at - at - kHead) break;
      if (file_.bytes.substr(at + 2, kOwner.size()) == kOwner &&
          little_number<std::uint16_t>(file_.bytes, at + 18) == kId && bytes_ >= kFixed)
        return at + kHead;
      at += kHead + bytes_;
    }
    refuse_laz(file_, file_.header_bytes, say::laz_no_record());
  }

  template <class T>
  T number(std::size_t at) const {
    return little_number<T>(file_.bytes, at_ + at);
  }

  LazItem item(std::size_t at) const {
    const auto type = number<std::uint16_t>(at), bytes = number<std::uint16_t>(at + 2),
               version = number<std::uint16_t>(at + 4);
    const auto known = std::ranges::find(kKnownParts, static_cast<LazPart>(type), &KnownPart::part);
    if (known == std::end(kKnownParts)) throw Error(ErrorCode::Unsupported, place(at), say::laz_unknown_part(type));
    if (version == 1 && known->version > 1) throw Error(ErrorCode::Unsupported, place(at), say::laz_first_version());
    if (version != known->version && version != known->newer_version)
      throw Error(ErrorCode::Unsupported, place(at), say::laz_other_version(version, type));
    if (bytes == 0 || (known->bytes != 0 && bytes != known->bytes))
      refuse_laz(file_, at_ + at, say::laz_part_bytes(type, Bytes{std::size_t{bytes}}));
    // Each has a model of its own, a kilobyte and more: no file that is a scan has so many.
    constexpr std::size_t kMostExtraBytes = 256;
    if (known->bytes == 0 && bytes > kMostExtraBytes)
      throw Error(ErrorCode::Unsupported, place(at), say::laz_many_bytes(Bytes{std::size_t{bytes}}, kMostExtraBytes));
    return {known->part, bytes};
  }

  std::string place(std::size_t at) const { return laz_place(file_, at_ + at); }

  const LazFile& file_;
  std::size_t bytes_ = 0;
  std::size_t at_;
};

/// The list of chunks, whose place stands before them, or at the end of files that were written in one go.
class ChunkTable {
 public:
  ChunkTable(const LazFile& file, std::uint32_t chunk_points) : file_(file), chunk_points_(chunk_points) {
    constexpr std::size_t kPlace = 8;
    if (file_.bytes.size() - file_.points_at < kPlace) refuse(file_.points_at);
    begin_ = file_.points_at + kPlace;
    auto at = little_number<std::uint64_t>(file_.bytes, file_.points_at);
    if (at == ~std::uint64_t{0}) at = little_number<std::uint64_t>(file_.bytes, file_.bytes.size() - kPlace);
    if (at < begin_ || at > file_.bytes.size() - kHead) refuse(file_.points_at);
    at_ = static_cast<std::size_t>(at);
  }

  std::vector<LazChunk> chunks() const {
    const auto count = little_number<std::uint32_t>(file_.bytes, at_ + 4);
    if (little_number<std::uint32_t>(file_.bytes, at_) != 0) refuse(at_);
    if (count > (at_ - begin_) / file_.record_bytes || chunk_points_ == 0) refuse(at_ + 4);
    const std::string where = laz_place(file_, at_);
    EntropyDecoder decoder(file_.bytes.substr(at_ + kHead), where);
    IntegerDecoder numbers(32, 2);
    std::vector<LazChunk> list;
    list.reserve(count);
    std::int32_t points = 0, bytes = 0;
    std::size_t at = begin_, left = file_.points;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (chunk_points_ == kVaryingChunks) points = numbers.next(decoder, points, 0);
      bytes = numbers.next(decoder, bytes, 1);
      const std::size_t has = chunk_points_ == kVaryingChunks ? static_cast<std::uint32_t>(points)
                                                              : std::min<std::size_t>(chunk_points_, left);
      const std::size_t takes = static_cast<std::uint32_t>(bytes);
      if (has > left || takes > at_ - at || takes < file_.record_bytes) refuse(at_);
      if (has > 0) list.push_back({at, takes, has});
      at += takes;
      left -= has;
    }
    if (left > 0) refuse_laz(file_, at_, say::laz_points_missing(file_.points - left, file_.points));
    return list;
  }

 private:
  static constexpr std::size_t kHead = 8;

  [[noreturn]] void refuse(std::size_t byte) const { refuse_laz(file_, byte, say::laz_no_table()); }

  const LazFile& file_;
  std::uint32_t chunk_points_;
  std::size_t begin_ = 0, at_ = 0;
};

/// What takes less has been made to take memory: points of a scan differ.
void refuse_promises(const LazFile& file) {
  constexpr std::size_t kMostOfAByte = 2;
  const std::size_t bytes = file.bytes.size() - file.points_at;
  if (file.points / kMostOfAByte > bytes)
    refuse_laz(file, file.points_at, say::laz_promises(file.points, Bytes{bytes}));
}

}  // namespace

LazLayout read_laz_layout(const LazFile& file) {
  const LayoutRecord record(file);
  const std::uint16_t compressor = record.compressor();
  if (compressor < kPointWise || compressor > kLayeredChunked || (compressor == kLayeredChunked) != (file.format >= 6))
    throw Error(ErrorCode::Unsupported, laz_place(file, record.at()), say::laz_compressor(file.format, compressor));
  LazLayout layout{compressor == kLayeredChunked, record.items(), {}};
  if (file.points == 0) return layout;
  refuse_promises(file);
  if (compressor != kPointWise) {
    layout.chunks = ChunkTable(file, record.chunk_points()).chunks();
    return layout;
  }
  const std::size_t bytes = file.bytes.size() - file.points_at;
  if (bytes < file.record_bytes) refuse_laz(file, file.points_at, say::laz_points_missing(0, file.points));
  layout.chunks.push_back({file.points_at, bytes, file.points});
  return layout;
}

}  // namespace remount::formats
