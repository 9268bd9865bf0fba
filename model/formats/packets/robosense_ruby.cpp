// RS-Ruby and RS-Ruby Plus, of 128, 80 and 48 lasers.
#include <array>

#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/robosense_models.h"

namespace remount::formats {

namespace {

/// Of both halves of an RS-Ruby four lasers fire at once, every 3.236 us.
constexpr std::array<double, 128> kRuby128_us = [] {
  std::array<double, 128> times{};
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = 3.236 * static_cast<double>(i % 64 / 4);
  return times;
}();
constexpr double kRuby80_us[] = {
    0.0,    0.0,    0.0,    3.236,  3.236,  6.472,  6.472,  6.472,  6.472,  9.708,  9.708,  9.708,  12.944, 12.944,
    12.944, 16.18,  16.18,  16.18,  19.416, 19.416, 19.416, 22.652, 22.652, 25.888, 25.888, 29.124, 29.124, 32.36,
    32.36,  35.596, 35.596, 38.832, 38.832, 42.068, 42.068, 45.304, 45.304, 48.54,  48.54,  48.54,  0.0,    0.0,
    0.0,    3.236,  3.236,  3.236,  6.472,  6.472,  6.472,  9.708,  9.708,  12.944, 12.944, 12.944, 12.944, 16.18,
    16.18,  19.416, 19.416, 19.416, 22.652, 22.652, 22.652, 25.888, 25.888, 29.124, 29.124, 32.36,  32.36,  35.596,
    35.596, 35.596, 38.832, 38.832, 42.068, 45.304, 45.304, 48.54,  48.54,  48.54};
constexpr double kRuby48_us[] = {0.0,    3.236,  6.472,  9.708,  12.944, 12.944, 16.18,  16.18,  19.416, 19.416,
                                 22.652, 22.652, 25.888, 29.124, 32.36,  35.596, 38.832, 38.832, 42.068, 42.068,
                                 45.304, 45.304, 48.54,  48.54,  0.0,    3.236,  6.472,  9.708,  12.944, 12.944,
                                 16.18,  16.18,  19.416, 19.416, 22.652, 22.652, 25.888, 29.124, 32.36,  35.596,
                                 38.832, 38.832, 42.068, 42.068, 45.304, 45.304, 48.54,  48.54};
constexpr double kPlus128_us[] = {
    0.0,   0.0,   0.0,   0.0,   1.13,  1.13,  1.13,  1.13,  2.13,  2.13,  2.13,  2.13,  3.26,  3.26,  3.26,  3.26,
    4.26,  4.26,  4.26,  4.26,  5.38,  5.38,  5.38,  5.38,  6.38,  6.38,  6.38,  6.38,  7.51,  7.51,  7.51,  7.51,
    8.51,  8.51,  8.51,  8.51,  10.01, 10.01, 10.01, 10.01, 11.38, 11.38, 11.38, 11.38, 13.31, 13.31, 13.31, 13.31,
    15.11, 15.11, 15.11, 15.11, 17.04, 17.04, 17.04, 17.04, 18.85, 18.85, 18.85, 18.85, 21.14, 21.14, 21.14, 21.14,
    21.14, 23.31, 23.31, 23.31, 23.31, 25.61, 25.61, 25.61, 25.61, 27.78, 27.78, 27.78, 27.78, 30.07, 30.07, 30.07,
    30.07, 32.24, 32.24, 32.24, 32.24, 34.54, 34.54, 34.54, 34.54, 36.7,  36.7,  36.7,  36.7,  38.64, 38.64, 38.64,
    38.64, 40.44, 40.44, 40.44, 40.44, 41.94, 41.94, 41.94, 41.94, 43.3,  43.3,  43.3,  43.3,  44.8,  44.8,  44.8,
    44.8,  46.17, 46.17, 46.17, 46.17, 47.66, 47.66, 47.66, 47.66, 49.03, 49.03, 49.03, 49.03, 50.53, 50.53, 53.771};
constexpr double kPlus80_us[] = {
    0.0,    0.0,    0.0,    0.0,    1.217,  1.217,  1.217,  1.217,  2.434,  2.434,  3.652,  3.652,  3.652,  4.869,
    4.869,  6.086,  6.086,  7.304,  7.304,  8.521,  8.521,  9.739,  9.739,  11.323, 11.323, 12.907, 12.907, 14.924,
    14.924, 16.941, 16.941, 16.941, 16.941, 18.959, 18.959, 18.959, 18.959, 20.976, 20.976, 20.976, 20.976, 23.127,
    23.127, 23.127, 23.127, 25.278, 25.278, 25.278, 25.278, 27.428, 27.428, 27.428, 27.428, 29.579, 29.579, 29.579,
    29.579, 31.963, 31.963, 31.963, 31.963, 34.347, 34.347, 34.347, 34.347, 36.498, 36.498, 36.498, 36.498, 38.648,
    38.648, 40.666, 40.666, 42.683, 50.603, 52.187, 52.187, 52.187, 53.771, 53.771};
/// When the lasers of an 80V fire, four at once; those of a 48 are two at once at the same times.
constexpr double kPlusSteps_us[] = {0.0,    1.217,  2.434,  3.652,  4.869,  6.086,  7.304,  8.521,
                                    9.739,  11.323, 12.907, 14.924, 16.941, 18.959, 20.976, 23.127,
                                    25.278, 27.428, 29.579, 31.963, 34.347, 36.498, 38.648, 40.666};
template <std::size_t lasers>
constexpr std::array<double, lasers> plus_us(std::size_t at_once) {
  std::array<double, lasers> times{};
  for (std::size_t i = 0; i < lasers; ++i) times[i] = kPlusSteps_us[i / at_once];
  return times;
}
constexpr std::array<double, 80> kPlus80v_us = plus_us<80>(4);
constexpr std::array<double, 48> kPlus48_us = plus_us<48>(2);

constexpr MsopLayout ruby_layout(std::size_t blocks, std::size_t lasers, std::size_t bytes = 1248) {
  return {.bytes = bytes,
          .head = 80,
          .time_at = 10,
          .blocks = blocks,
          .returns = lasers,
          .block_mark = 0xfe,
          .mark_bytes = 1,
          .described = 128};
}
constexpr MsopLayout kLayout128 = ruby_layout(3, 128), kLayout80 = ruby_layout(4, 80),
                     kLayout48 = ruby_layout(8, 48, 1268);

constexpr RobosenseModel ruby_of(std::string_view name, const MsopLayout& layout, double round_us,
                                 std::span<const double> firing_us, double lens_x_m) {
  return {.name = name,
          .layout = layout,
          .lasers = layout.returns,
          .round_us = round_us,
          .firing_us = firing_us,
          .lens_x_m = lens_x_m,
          .counted_nanoseconds = true};
}
constexpr double kRubyLens_m = 0.03615, kPlusLens_m = 0.02892;
constexpr RobosenseModel kRuby128 = ruby_of("RS-Ruby-128", kLayout128, 55.55, kRuby128_us, kRubyLens_m),
                         kRuby80 = ruby_of("RS-Ruby-80", kLayout80, 55.552, kRuby80_us, kRubyLens_m),
                         kRuby48 = ruby_of("RS-Ruby-48", kLayout48, 55.552, kRuby48_us, kRubyLens_m),
                         kPlus128 = ruby_of("RS-Ruby-Plus-128", kLayout128, 55.56, kPlus128_us, kPlusLens_m),
                         kPlus80 = ruby_of("RS-Ruby-Plus-80", kLayout80, 55.56, kPlus80_us, kPlusLens_m),
                         kPlus80v = ruby_of("RS-Ruby-Plus-80V", kLayout80, 55.56, kPlus80v_us, kPlusLens_m),
                         kPlus48 = ruby_of("RS-Ruby-Plus-48", kLayout48, 55.56, kPlus48_us, kPlusLens_m);

/// Which Ruby Plus it is; 0: none. The manual has its type a byte behind where the driver has it.
std::uint8_t plus_variant(std::string_view payload) {
  constexpr std::size_t kTypeAt = 30;
  constexpr std::uint8_t kPlus = 5, kMostVariants = 4;
  for (const std::size_t at : {kTypeAt + 1, kTypeAt})
    if (const std::uint8_t variant = byte_at(payload, at + 1); byte_at(payload, at) == kPlus && variant > 0)
      return variant <= kMostVariants ? variant : std::uint8_t{0};
  return 0;
}

bool begins_blocks(const MsopLayout& layout, std::string_view payload) {
  for (std::size_t block = 0; block < layout.blocks; ++block)
    if (byte_at(payload, layout.head + block * layout.block_bytes()) != layout.block_mark) return false;
  return true;
}

}  // namespace

const RobosenseModel* robosense_ruby(std::string_view payload) {
  constexpr std::string_view kMark("\x55\xaa\x05\x5a", 4), kBlockOfOthers("\xff\xee", 2);
  if (payload.size() != kLayout128.bytes && payload.size() != kLayout48.bytes) return nullptr;
  if (!payload.starts_with(kMark) || payload.substr(MsopLayout().head).starts_with(kBlockOfOthers)) return nullptr;
  const std::uint8_t variant = plus_variant(payload);
  const bool plus = variant != 0;
  constexpr std::uint8_t kVariant80v = 3;
  if (payload.size() == kLayout48.bytes)
    return !begins_blocks(kLayout48, payload) ? nullptr : plus ? &kPlus48 : &kRuby48;
  if (begins_blocks(kLayout128, payload)) return plus ? &kPlus128 : &kRuby128;
  if (!begins_blocks(kLayout80, payload)) return nullptr;
  return !plus ? &kRuby80 : variant == kVariant80v ? &kPlus80v : &kPlus80;
}

}  // namespace remount::formats
