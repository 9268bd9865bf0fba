#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "algorithms/core/error.h"
#include "messages/laz.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/laz/coordinate_decoder.h"
#include "model/formats/laz/laz_chunks.h"
#include "model/formats/laz/time_decoder.h"

namespace remount::formats {
namespace {

/// Kinds of returns, by the count of returns (row) and the number of this one: what writers and readers agree on, also
/// for numbers that no pulse has.
constexpr std::string_view kSixKindsOfReturns[16] = {
    "0123453445555555", "1013333333333333", "2124444444433333", "3345444444444444",
    "4344544444444444", "5344454444444444", "3344445444444444", "4344444544444444",
    "4344444454444444", "5344444445444444", "5344444444544444", "5334444444455444",
    "5334444444455544", "5334444444445554", "5334444444444555", "5334444444444455"};

/// The layers of the first part of a point, in their order; behind them those of the other parts.
enum Layer : std::size_t { kXy, kZ, kClass, kFlags, kIntensity, kScanAngle, kUser, kSource, kTime, kOwnLayers };

std::size_t layers_of(const LazItem& item) {
  switch (item.part) {
    case LazPart::Point14:
      return kOwnLayers;
    case LazPart::RgbNir14:
      return 2;
    case LazPart::Bytes14:
      return item.bytes;
    default:
      return 1;
  }
}

/// Of a point: how many returns its pulse had, and which one this is.
struct Returns {
  unsigned number = 0, count = 0;

  bool first() const { return number == 1; }
  bool last() const { return number >= count; }
  unsigned kind() const { return static_cast<unsigned>(kSixKindsOfReturns[count][number] - '0'); }
  unsigned level() const { return std::min(number > count ? number - count : count - number, 7U); }
};

/// The last point of one channel of the scanner, and what is expected of its next one.
struct ChannelState {
  ChannelState(const LasRecord& record, Returns last)
      : last_record(record),
        returns(last),
        coordinates(record.xyz, record.xyz[2]),
        times(TimeCodes::Layered, record.time) {
    intensity.fill(record.intensity);
  }

  LasRecord last_record;
  Returns returns;
  bool time_changed = false;
  std::vector<SymbolModel> changed = std::vector<SymbolModel>(8, SymbolModel(128));
  SymbolModel channel{3}, number_at_same_time{13};
  std::array<std::optional<SymbolModel>, 16> counts, numbers;  ///< by the one before
  CoordinateDecoder coordinates;
  IntegerDecoder intensities{16, 4};
  std::array<std::uint16_t, 8> intensity;
  TimeDecoder times;
};

/// A layer that is left out stays as it is in the first point.
class LayeredPoints {
 public:
  LayeredPoints(const ChunkBytes& chunk, const LazLayout& layout, std::size_t point_bytes)
      : where_(chunk.where), first_(chunk.bytes) {
    std::size_t layers = 0;
    for (const LazItem& item : layout.items) layers += layers_of(item);
    const std::size_t sizes_at = point_bytes + 4;
    std::size_t at = sizes_at + 4 * layers;
    if (at > chunk.bytes.size() || little_number<std::uint32_t>(chunk.bytes, point_bytes) != chunk.points)
      throw Error(ErrorCode::Format, where_, say::laz_damaged());
    for (std::size_t layer = 0; layer < kOwnLayers; ++layer) {
      const std::size_t size = little_number<std::uint32_t>(chunk.bytes, sizes_at + 4 * layer);
      if (size > chunk.bytes.size() - at) throw Error(ErrorCode::Format, where_, say::laz_damaged());
      if (size > 0) decoders_[layer].emplace(chunk.bytes.substr(at, size), where_);
      at += size;
    }
    if (chunk.points > 1 && !decoders_[kXy]) throw Error(ErrorCode::Format, where_, say::laz_damaged());
  }

  LasRecord first() {
    const LasRecord record{{little_number<std::int32_t>(first_, 0), little_number<std::int32_t>(first_, 4),
                            little_number<std::int32_t>(first_, 8)},
                           little_number<std::uint16_t>(first_, 12),
                           little_number<double>(first_, 22)};
    const unsigned returns = byte_at(first_, 14);
    current_ = unsigned{byte_at(first_, 15)} >> 4 & 3U;
    channels_[current_] = std::make_unique<ChannelState>(record, Returns{returns & 15U, returns >> 4U});
    return record;
  }

  const LasRecord& next() {
    const ChannelState& before = *channels_[current_];
    const unsigned context =
        (before.returns.first() ? 1 : 0) + (before.returns.last() ? 2 : 0) + (before.time_changed ? 4 : 0);
    const unsigned changed = xy().symbol(channels_[current_]->changed[context]);
    if ((changed & 64U) != 0) change_channel();
    ChannelState& channel = *channels_[current_];
    channel.time_changed = (changed & 16U) != 0;
    next_returns(channel, changed);
    next_values(channel);
    return channel.last_record;
  }

 private:
  EntropyDecoder& xy() { return *decoders_[kXy]; }

  void change_channel() {
    const ChannelState& before = *channels_[current_];
    current_ = (current_ + xy().symbol(channels_[current_]->channel) + 1) % channels_.size();
    if (!channels_[current_]) channels_[current_] = std::make_unique<ChannelState>(before.last_record, before.returns);
  }

  void next_returns(ChannelState& channel, unsigned changed) {
    const Returns before = channel.returns;
    if ((changed & 4U) != 0) channel.returns.count = next_of(channel.counts[before.count]);
    enum : unsigned { kSame, kOneMore, kOneLess, kOther };
    unsigned& number = channel.returns.number;
    const unsigned way = changed & 3U;
    if (way == kOneMore) number = (before.number + 1) % 16;
    if (way == kOneLess) number = (before.number + 15) % 16;
    if (way == kOther)
      number = channel.time_changed ? next_of(channel.numbers[before.number])
                                    : (before.number + xy().symbol(channel.number_at_same_time) + 2) % 16;
  }

  unsigned next_of(std::optional<SymbolModel>& model) {
    if (!model) model.emplace(16);
    return xy().symbol(*model);
  }

  void next_values(ChannelState& channel) {
    const Returns& returns = channel.returns;
    const unsigned at_new_time = channel.time_changed ? 1 : 0;
    channel.coordinates.next_xy(xy(), returns.kind() << 1 | at_new_time, returns.count == 1);
    if (decoders_[kZ]) channel.coordinates.next_z(*decoders_[kZ], returns.level(), returns.count == 1);
    channel.last_record.xyz = channel.coordinates.xyz();
    if (decoders_[kIntensity]) {
      const unsigned kind = (returns.first() ? 2 : 0) + (returns.last() ? 1 : 0);
      std::uint16_t& last = channel.intensity[kind << 1 | at_new_time];
      last = static_cast<std::uint16_t>(channel.intensities.next(*decoders_[kIntensity], last, kind));
      channel.last_record.intensity = last;
    }
    if (decoders_[kTime] && channel.time_changed)
      channel.last_record.time = channel.times.next(*decoders_[kTime], where_);
  }

  const std::string& where_;
  std::string_view first_;
  std::array<std::optional<EntropyDecoder>, kOwnLayers> decoders_;
  std::array<std::unique_ptr<ChannelState>, 4> channels_;
  unsigned current_ = 0;
};

}  // namespace

void unpack_layered(const ChunkBytes& chunk, const LazLayout& layout, const TakeRecord& take) {
  std::size_t point_bytes = 0;
  for (const LazItem& item : layout.items) point_bytes += item.bytes;
  LayeredPoints points(chunk, layout, point_bytes);
  take(points.first());
  for (std::size_t i = 1; i < chunk.points; ++i) take(points.next());
}

}  // namespace remount::formats
