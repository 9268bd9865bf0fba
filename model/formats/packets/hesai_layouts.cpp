// Where things stand in the packets of Hesai's sensors.
#include <cmath>

#include "messages/captures.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/hesai_models.h"

namespace remount::formats {

namespace {

/// 0: a mode that is not known.
std::size_t returns_of_mode(std::uint8_t mode) {
  switch (mode) {
    case 0x00:  // of a PandarQT
    case 0x33:  // first to fourth, strongest, last
    case 0x34:
    case 0x35:
    case 0x36:
    case 0x37:
    case 0x38:
      return 1;
    case 0x05:  // of a PandarQT
    case 0x39:
    case 0x3a:
    case 0x3b:
    case 0x3c:
    case 0x3e:
      return 2;
    case 0x3d:
      return 3;
    default:
      return 0;
  }
}

/// A packet's layout, with what it says that may not be known: then it has no model, returns or unit.
struct SaidLayout : HesaiLayout {
  std::uint8_t mode = 0;                     ///< of returns
  std::optional<std::uint8_t> state = {};    ///< of 128 channels: in which they take turns
  std::optional<std::uint8_t> version = {};  ///< likewise, of the sensor, behind that of the protocol
  bool own_channels = false;                 ///< of a QT128: chosen by somebody, and told by no packet
};

/// Where things stand in what follows the blocks.
struct HesaiTail {
  std::size_t bytes = 0, mode_at = 0, speed_at = 0, stamp_at = 0, date_at = 0;
};

/// Fills in what the tail of a packet says. Without returns where its mode is not known, or does not divide the blocks.
void take_tail(SaidLayout& layout, const HesaiTail& tail, std::size_t at, std::string_view payload) {
  layout.mode = byte_at(payload, at + tail.mode_at);
  layout.returns = returns_of_mode(layout.mode);
  if (layout.returns != 0 && (layout.blocks == 0 || layout.blocks % layout.returns != 0)) layout.returns = 0;
  if (layout.model != nullptr) layout.block_step_us = layout.model->block_step_us;
  layout.speed_at = at + tail.speed_at, layout.stamp_at = at + tail.stamp_at, layout.date_at = at + tail.date_at;
}

/// The layout with what its tail says; nothing where the size does not fit.
std::optional<SaidLayout> with_tail(SaidLayout layout, const HesaiTail& tail, std::string_view payload) {
  constexpr std::size_t kNumberBytes = 4;  // counts packets where that is set
  const std::size_t at = layout.blocks_at + layout.blocks * layout.block_bytes;
  if (payload.size() != at + tail.bytes && payload.size() != at + tail.bytes + kNumberBytes) return std::nullopt;
  take_tail(layout, tail, at, payload);
  return layout;
}

/// The oldest, without a header: each block begins with a mark of its own.
std::optional<SaidLayout> layout_of_40(std::string_view payload) {
  constexpr std::size_t kBlocks40 = 10, kChannels40 = 40, kUnit40 = 3;
  SaidLayout layout{{.model = &pandar40(),
                     .blocks = kBlocks40,
                     .channels = kChannels40,
                     .block_bytes = 4 + kChannels40 * kUnit40,
                     .azimuth_at = 2,
                     .units_at = 4,
                     .unit_bytes = kUnit40,
                     .years_from_2000 = true}};
  if (payload.size() < layout.blocks * layout.block_bytes) return std::nullopt;
  for (std::size_t block = 0; block < layout.blocks; ++block)
    if (payload.substr(block * layout.block_bytes, 2) != "\xff\xee") return std::nullopt;
  return with_tail(layout, {.bytes = 22, .mode_at = 14, .speed_at = 8, .stamp_at = 10, .date_at = 16}, payload);
}

std::optional<SaidLayout> layout_of_64(std::string_view payload) {
  constexpr std::size_t kUnit64 = 3;
  SaidLayout layout{{.model = &pandar64(),
                     .blocks = byte_at(payload, 3),
                     .channels = 64,
                     .blocks_at = 8,
                     .block_bytes = 2 + 64 * kUnit64,
                     .units_at = 2,
                     .unit_bytes = kUnit64,
                     .unit_m = 1e-3 * byte_at(payload, 5),
                     .years_from_2000 = true}};
  return with_tail(layout, {.bytes = 22, .mode_at = 14, .speed_at = 8, .stamp_at = 10, .date_at = 16}, payload);
}

/// What may stand in a packet beside its blocks and its tail, as a byte of the header says.
constexpr std::uint8_t kNumbered = 1, kWithImu = 2, kWithSafety = 4, kSigned = 8;
constexpr std::size_t kCheckBytes = 4, kSafetyBytes = 17, kNumberBytes128 = 4, kImuBytes = 22, kSignatureBytes = 32;

/// The same of a packet with 128 channels, whose tail stands behind a checksum of the blocks.
std::optional<SaidLayout> with_checked_tail(SaidLayout layout, const HesaiTail& tail, std::string_view payload) {
  const std::uint8_t holds = byte_at(payload, 11);
  const auto of = [&](std::uint8_t what, std::size_t bytes) { return (holds & what) != 0 ? bytes : 0; };
  const std::size_t at =
      layout.blocks_at + layout.blocks * layout.block_bytes + kCheckBytes + of(kWithSafety, kSafetyBytes);
  if (payload.size() != at + tail.bytes + of(kNumbered, kNumberBytes128) + of(kWithImu, kImuBytes) + kCheckBytes +
                            of(kSigned, kSignatureBytes))
    return std::nullopt;
  take_tail(layout, tail, at, payload);
  return layout;
}

constexpr std::uint8_t kFirstOtherOf128 = 137;  ///< version of a sensor that is neither Pandar128 nor OT128

/// Pandar128 and OT128: returns of as many bytes as the header says, and states in which channels take turns.
std::optional<SaidLayout> layout_of_128(std::string_view payload) {
  constexpr HesaiTail kTail{.bytes = 26, .mode_at = 12, .speed_at = 13, .stamp_at = 21, .date_at = 15};
  constexpr std::size_t kStatesAt = 9, kModeAt = 11, kMostBlocks = 8;
  constexpr std::uint8_t kFirstOt = 128;
  constexpr std::uint8_t kStateBits = 0x0f;
  const std::uint8_t version = byte_at(payload, 4), holds = byte_at(payload, 11);
  SaidLayout layout{{.model = version < kFirstOt ? &pandar128() : &ot128(),
                     .blocks = byte_at(payload, 7),
                     .channels = byte_at(payload, 6),
                     .blocks_at = 12,
                     .units_at = 2,
                     .unit_m = 1e-3 * byte_at(payload, 9)}};
  if (layout.channels != layout.model->channels || layout.blocks > kMostBlocks) return std::nullopt;
  layout.unit_bytes = 3;
  for (const std::uint8_t more : {0x10, 0x20, 0x40}) layout.unit_bytes += (holds & more) != 0 ? 1 : 0;
  layout.block_bytes = 2 + layout.channels * layout.unit_bytes;
  auto whole = with_checked_tail(layout, kTail, payload);
  if (!whole) return std::nullopt;
  const std::size_t tail_at = whole->speed_at - kTail.speed_at;
  const std::uint8_t state = byte_at(payload, tail_at + kModeAt) & kStateBits;
  whole->state = state, whole->version = version;
  whole->states_at = tail_at + kStatesAt;
  const bool known = state == 0 || state == 2 || (state == 3 && version < kFirstOt);
  if (!known || version >= kFirstOtherOf128) whole->model = nullptr;
  whole->first_state = state == 0 ? 0 : state == 2 ? 4 : 6;
  if (state != 0) whole->block_step_us *= 2.0;
  return whole;
}

std::optional<SaidLayout> layout_of_at128(std::string_view payload) {
  SaidLayout layout{{.model = &at128(),
                     .blocks = byte_at(payload, 7),
                     .channels = byte_at(payload, 6),
                     .blocks_at = 12,
                     .units_at = 3,
                     .unit_bytes = 4,
                     .unit_m = 1e-3 * byte_at(payload, 9)}};
  if (layout.channels != layout.model->channels) return std::nullopt;
  layout.block_bytes = layout.units_at + layout.channels * layout.unit_bytes;
  return with_checked_tail(layout, {.bytes = 32, .mode_at = 24, .speed_at = 18, .stamp_at = 20, .date_at = 26},
                           payload);
}

/// The QT128: two sets of channels take turns, from block to block.
std::optional<SaidLayout> layout_of_qt128(std::string_view payload) {
  constexpr HesaiTail kTail{.bytes = 26, .mode_at = 12, .speed_at = 13, .stamp_at = 21, .date_at = 15};
  constexpr std::size_t kLoopAt = 5;
  constexpr std::uint8_t kConfidence = 0x10, kOwnChannels = 0x40;
  const std::uint8_t holds = byte_at(payload, 11);
  SaidLayout layout{{.model = &qt128(),
                     .blocks = byte_at(payload, 7),
                     .channels = byte_at(payload, 6),
                     .blocks_at = 12,
                     .units_at = 2,
                     .unit_bytes = (holds & kConfidence) != 0 ? std::size_t{4} : std::size_t{3},
                     .unit_m = 1e-3 * byte_at(payload, 9)}};
  layout.block_bytes = layout.units_at + layout.channels * layout.unit_bytes;
  auto whole = with_checked_tail(layout, kTail, payload);
  if (!whole) return std::nullopt;
  whole->loop_at = whole->speed_at - kTail.speed_at + kLoopAt;
  whole->own_channels = (holds & kOwnChannels) != 0;
  if (whole->own_channels || layout.channels != layout.model->channels) whole->model = nullptr;
  return whole;
}

/// Headers of 12 bytes with the version of the protocol.
std::optional<SaidLayout> layout_by_version(std::string_view payload) {
  constexpr std::size_t kUnitBytes = 4;
  constexpr HesaiTail kQtTail{.bytes = 24, .mode_at = 16, .speed_at = 10, .stamp_at = 12, .date_at = 18},
      kXtTail{.bytes = 24, .mode_at = 10, .speed_at = 11, .stamp_at = 19, .date_at = 13};
  SaidLayout layout{{.blocks = byte_at(payload, 7),
                     .channels = byte_at(payload, 6),
                     .blocks_at = 12,
                     .units_at = 2,
                     .unit_bytes = kUnitBytes,
                     .unit_m = 1e-3 * byte_at(payload, 9)}};
  layout.block_bytes = 2 + layout.channels * kUnitBytes;
  const std::uint8_t major = byte_at(payload, 2), minor = byte_at(payload, 3);
  if (major == 1 && minor == 4) return layout_of_128(payload);
  if (major == 4 && (minor == 1 || minor == 3)) return layout_of_at128(payload);
  if (major == 3 && minor == 2) return layout_of_qt128(payload);
  if (major == 3 && minor == 1) {
    if (layout.channels == 64) layout.model = &pandar_qt();
    return with_tail(layout, kQtTail, payload);
  }
  if (major == 6 && minor == 1) {
    layout.model = pandar_xt(layout.channels, layout.blocks);
    return with_tail(layout, kXtTail, payload);
  }
  return std::nullopt;
}

constexpr std::size_t kLeastHesaiBytes = 500;

}  // namespace

double HesaiLayout::column_us(std::size_t column) const {
  const auto apart = static_cast<double>(model->stamp_of_first ? column : columns() - 1 - column);
  return model->stamp_step_us + (model->stamp_of_first ? 1.0 : -1.0) * apart * block_step_us;
}

double HesaiLayout::azimuth_deg(std::string_view payload, std::size_t column) const {
  const std::size_t at = block_at(column, 0) + azimuth_at;
  const double hundredths = little_number<std::uint16_t>(payload, at);
  return 0.01 * (model->mirrored ? hundredths + byte_at(payload, at + 2) / 256.0 : hundredths);
}

bool HesaiLayout::falls(std::string_view payload) const {
  constexpr double kLongestStep_deg = 2.0;  // more is a field of view that ends and begins
  int falling = 0;
  for (std::size_t column = 1; column < columns(); ++column) {
    const double step_deg = std::remainder(azimuth_deg(payload, column) - azimuth_deg(payload, column - 1), 360.0);
    if (std::abs(step_deg) <= kLongestStep_deg) falling += step_deg < 0.0 ? 1 : step_deg > 0.0 ? -1 : 0;
  }
  return falling > 0;
}

std::size_t HesaiLayout::times_set(std::string_view payload, std::size_t column) const {
  if (loop_at != 0) return (byte_at(payload, loop_at) + column + 1) % 2;
  if (states_at == 0) return 0;
  const std::uint16_t states = little_number<std::uint16_t>(payload, states_at);
  const std::size_t of_column = states >> (14U - 2U * (column * returns)) & (first_state == 0 ? 3U : 1U);
  return (first_state + of_column) * (model->near_m > 0.0 ? 2 : 1);
}

namespace {

/// By mark, protocol and size alone.
std::optional<SaidLayout> sized_layout(std::string_view payload) {
  if (payload.size() < kLeastHesaiBytes) return std::nullopt;
  if (payload.starts_with("\xff\xee")) return layout_of_40(payload);
  if (!payload.starts_with("\xee\xff")) return std::nullopt;
  return byte_at(payload, 2) == 64 ? layout_of_64(payload) : layout_by_version(payload);
}

bool is_known(const HesaiLayout& layout) {
  return layout.model != nullptr && layout.returns != 0 && layout.unit_m > 0.0;
}

}  // namespace

std::optional<HesaiLayout> hesai_layout(std::string_view payload) {
  const std::optional<SaidLayout> layout = sized_layout(payload);
  return layout && is_known(*layout) ? std::optional<HesaiLayout>(*layout) : std::nullopt;
}

Message unknown_hesai(std::string_view payload) {
  const std::optional<SaidLayout> said = sized_layout(payload);
  if (!said || is_known(*said)) return {};
  if (said->own_channels) return say::capture_hesai_own_channels();
  if (said->model == nullptr && said->version && *said->version >= kFirstOtherOf128)
    return say::capture_hesai_unknown_version(said->channels, *said->version);
  if (said->model == nullptr && said->state)
    return say::capture_hesai_unknown_state(said->channels, *said->state, said->version.value_or(0));
  if (said->model == nullptr) return say::capture_hesai_unknown_blocks(said->channels, said->blocks);
  if (said->returns == 0) return say::capture_hesai_unknown_mode(said->channels, said->blocks, said->mode);
  return say::capture_hesai_unknown_unit(said->channels);
}

std::string_view unread_hesai(std::string_view payload) {
  struct Version {
    std::uint8_t major, minor;
    std::string_view name;
  };
  constexpr Version kUnread[] = {{1, 8, "JT16"}, {4, 7, "ATX"}, {5, 1, "ET25"}, {7, 2, "FT120"}};
  if (payload.size() < kLeastHesaiBytes || !payload.starts_with("\xee\xff")) return {};
  for (const Version& version : kUnread)
    if (byte_at(payload, 2) == version.major && byte_at(payload, 3) == version.minor) return version.name;
  return {};
}

}  // namespace remount::formats
