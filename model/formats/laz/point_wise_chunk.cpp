#include <algorithm>
#include <memory>
#include <optional>

#include "model/formats/files/number_bytes.h"
#include "model/formats/laz/coordinate_decoder.h"
#include "model/formats/laz/laz_chunks.h"
#include "model/formats/laz/time_decoder.h"

namespace remount::formats {
namespace {

/// Kinds of returns, by the count of returns (row) and the number of this one, in hexadecimal: what writers and readers
/// agree on, also for numbers that no pulse has.
constexpr std::string_view kKindsOfReturns[8] = {"fedcba98", "e0136aa9", "d1247bba", "c3458ccb",
                                                 "b6789ddc", "aabcdeed", "9abcdefe", "89abcdef"};

unsigned digit_value(char digit) { return static_cast<unsigned>(digit <= '9' ? digit - '0' : digit - 'a' + 10); }

/// A model for each value that came before.
class ChainedBytes {
 public:
  std::uint8_t next(EntropyDecoder& decoder, std::uint8_t before) {
    std::unique_ptr<SymbolModel>& model = models_[before];
    if (!model) model = std::make_unique<SymbolModel>(256);
    return static_cast<std::uint8_t>(decoder.symbol(*model));
  }

 private:
  std::array<std::unique_ptr<SymbolModel>, 256> models_;
};

/// What all points have: 20 bytes.
class Point10Decoder {
 public:
  explicit Point10Decoder(std::string_view first)
      : flags_(byte_at(first, 14)),
        class_(byte_at(first, 15)),
        user_(byte_at(first, 17)),
        coordinates_({little_number<std::int32_t>(first, 0), little_number<std::int32_t>(first, 4),
                      little_number<std::int32_t>(first, 8)},
                     0) {}

  void next(EntropyDecoder& decoder, LasRecord& record) {
    const unsigned changed = decoder.symbol(changed_);
    if ((changed & 32U) != 0) flags_ = flag_bytes_.next(decoder, flags_);
    const unsigned number = flags_ & 7U, count = flags_ >> 3 & 7U;
    const unsigned kind = digit_value(kKindsOfReturns[count][number]);
    if ((changed & 16U) != 0)
      intensity_[kind] = static_cast<std::uint16_t>(intensities_.next(decoder, intensity_[kind], std::min(kind, 3U)));
    pass_over(decoder, changed);
    coordinates_.next_xy(decoder, kind, count == 1);
    coordinates_.next_z(decoder, number > count ? number - count : count - number, count == 1);
    record.xyz = coordinates_.xyz();
    record.intensity = intensity_[kind];
  }

 private:
  void pass_over(EntropyDecoder& decoder, unsigned changed) {
    if ((changed & 8U) != 0) class_ = class_bytes_.next(decoder, class_);
    if ((changed & 4U) != 0) decoder.symbol(scan_angles_[flags_ >> 6 & 1U]);
    if ((changed & 2U) != 0) user_ = user_bytes_.next(decoder, user_);
    if ((changed & 1U) != 0) sources_.next(decoder, 0);
  }

  SymbolModel changed_{64};
  std::uint8_t flags_, class_, user_;
  ChainedBytes flag_bytes_, class_bytes_, user_bytes_;
  std::array<SymbolModel, 2> scan_angles_{SymbolModel(256), SymbolModel(256)};
  IntegerDecoder intensities_{16, 4}, sources_{16};
  std::array<std::uint16_t, 16> intensity_{};
  CoordinateDecoder coordinates_;
};

/// A part that no scan needs: how many symbols it has depends on these alone.
class PassedPart {
 public:
  virtual ~PassedPart() = default;
  virtual void pass(EntropyDecoder& decoder) = 0;
};

class PassedColour final : public PassedPart {
 public:
  void pass(EntropyDecoder& decoder) override {
    const unsigned changed = decoder.symbol(changed_);
    const auto pass_if = [&](unsigned part) {
      if ((changed >> part & 1U) != 0) decoder.symbol(parts_[part]);
    };
    constexpr unsigned kNotGrey = 6;
    pass_if(0), pass_if(1);
    if ((changed >> kNotGrey & 1U) == 0) return;
    for (const unsigned part : {2U, 4U, 3U, 5U}) pass_if(part);
  }

 private:
  SymbolModel changed_{128};
  std::vector<SymbolModel> parts_ = std::vector<SymbolModel>(6, SymbolModel(256));
};

class PassedWavePacket final : public PassedPart {
 public:
  void pass(EntropyDecoder& decoder) override {
    decoder.symbol(index_);
    way_ = decoder.symbol(ways_[way_]);
    constexpr unsigned kStepFollows = 2, kPlaceFollows = 3;
    if (way_ == kStepFollows) steps_.next(decoder, 0);
    if (way_ == kPlaceFollows) decoder.number(32), decoder.number(32);
    sizes_.next(decoder, 0);
    return_points_.next(decoder, 0);
    for (unsigned axis = 0; axis < 3; ++axis) directions_.next(decoder, 0, axis);
  }

 private:
  SymbolModel index_{256};
  std::vector<SymbolModel> ways_ = std::vector<SymbolModel>(4, SymbolModel(4));
  unsigned way_ = 0;
  IntegerDecoder steps_{32}, sizes_{32}, return_points_{32}, directions_{32, 3};
};

class PassedBytes final : public PassedPart {
 public:
  explicit PassedBytes(std::size_t count) : models_(count, SymbolModel(256)) {}
  void pass(EntropyDecoder& decoder) override {
    for (SymbolModel& model : models_) decoder.symbol(model);
  }

 private:
  std::vector<SymbolModel> models_;
};

/// In the place of the time stands nothing.
std::unique_ptr<PassedPart> passed_part(const LazItem& item) {
  switch (item.part) {
    case LazPart::Rgb12:
      return std::make_unique<PassedColour>();
    case LazPart::WavePacket13:
      return std::make_unique<PassedWavePacket>();
    case LazPart::Bytes:
      return std::make_unique<PassedBytes>(item.bytes);
    default:
      return nullptr;
  }
}

LasRecord record_at(std::string_view first) {
  return {{little_number<std::int32_t>(first, 0), little_number<std::int32_t>(first, 4),
           little_number<std::int32_t>(first, 8)},
          little_number<std::uint16_t>(first, 12)};
}

}  // namespace

void unpack_point_wise(const ChunkBytes& chunk, const LazLayout& layout, const TakeRecord& take) {
  LasRecord record = record_at(chunk.bytes);
  std::optional<TimeDecoder> times;
  std::vector<std::unique_ptr<PassedPart>> parts;
  std::size_t first_bytes = layout.items.front().bytes;
  for (std::size_t i = 1; i < layout.items.size(); first_bytes += layout.items[i++].bytes) {
    parts.push_back(passed_part(layout.items[i]));
    if (parts.back()) continue;
    record.time = little_number<double>(chunk.bytes, first_bytes);
    times.emplace(TimeCodes::PointWise, record.time);
  }
  take(record);
  if (chunk.points == 1) return;
  Point10Decoder points(chunk.bytes);
  EntropyDecoder decoder(chunk.bytes.substr(first_bytes), chunk.where);
  for (std::size_t i = 1; i < chunk.points; ++i) {
    points.next(decoder, record);
    for (const std::unique_ptr<PassedPart>& part : parts)
      if (part)
        part->pass(decoder);
      else
        record.time = times->next(decoder, chunk.where);
    take(record);
  }
}

}  // namespace remount::formats
