#include "algorithms/messages/quantity_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>

namespace remount {
namespace {

struct UnitOfText {
  std::string_view style;  // as catalogues write it
  double in_base;          // how much of the unit that values are kept in
  std::array<std::string_view, kLanguages> symbol;
};

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr UnitOfText kLengths[] = {{"mm", 1e-3, {" mm", " 毫米"}},
                                   {"cm", 1e-2, {" cm", " 厘米"}},
                                   {"m", 1.0, {" m", " 米"}},
                                   {"km", 1e3, {" km", " 公里"}}};
constexpr UnitOfText kAngles[] = {{"deg", kDegree, {" deg", " 度"}}, {"rad", 1.0, {" rad", " 弧度"}}};
constexpr UnitOfText kDurations[] = {{"us", 1e-6, {" us", " 微秒"}}, {"ms", 1e-3, {" ms", " 毫秒"}},
                                     {"s", 1.0, {" s", " 秒"}},      {"min", 60.0, {" min", " 分钟"}},
                                     {"h", 3600.0, {" h", " 小时"}}, {"d", 86400.0, {" days", " 天"}}};
constexpr UnitOfText kSpeeds[] = {{"mps", 1.0, {" m/s", " 米/秒"}}, {"kmh", 1.0 / 3.6, {" km/h", " 公里/小时"}}};
constexpr UnitOfText kTurnRates[] = {{"degps", kDegree, {" deg/s", " 度/秒"}}, {"radps", 1.0, {" rad/s", " 弧度/秒"}}};
constexpr UnitOfText kAccelerations[] = {{"mps2", 1.0, {" m/s2", " 米/秒²"}}};
constexpr UnitOfText kFrequencies[] = {{"Hz", 1.0, {" Hz", " Hz"}}};
constexpr UnitOfText kShares[] = {{"pc", 1e-2, {" %", "%"}}};
constexpr UnitOfText kSizes[] = {{"B", 1.0, {" bytes", " 字节"}},
                                 {"kB", 1e3, {" kB", " kB"}},
                                 {"MB", 1e6, {" MB", " MB"}},
                                 {"GB", 1e9, {" GB", " GB"}}};
constexpr UnitOfText kNumbers[] = {{"", 1.0, {"", ""}}};

std::span<const UnitOfText> units_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::Length:
      return kLengths;
    case Dimension::Angle:
      return kAngles;
    case Dimension::Duration:
      return kDurations;
    case Dimension::Speed:
      return kSpeeds;
    case Dimension::TurnRate:
      return kTurnRates;
    case Dimension::Acceleration:
      return kAccelerations;
    case Dimension::Frequency:
      return kFrequencies;
    case Dimension::Share:
      return kShares;
    case Dimension::Bytes:
      return kSizes;
    case Dimension::Number:
      break;
  }
  return kNumbers;
}

/// The style that suits a value of that size.
std::string_view usual_style(const Quantity& quantity) {
  const double size = std::abs(quantity.value);
  switch (quantity.dimension) {
    case Dimension::Length:
      return size < 0.01 ? "mm.1" : size < 1.0 ? "cm.1" : size < 1e3 ? "m.2" : "km.1";
    case Dimension::Angle:
      return size < 0.01 * kDegree ? "deg.4" : size < kDegree ? "deg.3" : "deg.2";
    case Dimension::Duration:
      return size < 1.0 ? "ms.1" : size < 120.0 ? "s.2" : size < 7200.0 ? "min.1" : "h.1";
    case Dimension::Speed:
      return "mps.1";
    case Dimension::TurnRate:
      return "degps.2";
    case Dimension::Acceleration:
      return "mps2.2";
    case Dimension::Frequency:
      return "Hz.1";
    case Dimension::Share:
      return size < 0.1 ? "pc.1" : "pc.0";
    case Dimension::Bytes:
      return size < 1e3 ? "B.0" : size < 1e6 ? "kB.1" : size < 1e9 ? "MB.1" : "GB.1";
    case Dimension::Number:
      break;
  }
  return "g3";
}

struct Style {
  const UnitOfText* unit = nullptr;  // null where the style is none
  bool with_sign = false;
  bool significant = false;
  int digits = 0;
};

Style parse_style(Dimension dimension, std::string_view text) {
  Style style;
  style.with_sign = text.starts_with('+');
  if (style.with_sign) text.remove_prefix(1);
  const std::size_t mark = text.find_last_of(".g");
  if (mark == std::string_view::npos || mark + 2 != text.size() || text.back() < '0' || text.back() > '9') return {};
  style.significant = text[mark] == 'g';
  style.digits = text.back() - '0';
  for (const UnitOfText& unit : units_of(dimension))
    if (unit.style == text.substr(0, mark)) style.unit = &unit;
  return style;
}

}  // namespace

bool is_quantity_style(Dimension dimension, std::string_view style) {
  return style.empty() || parse_style(dimension, style).unit != nullptr;
}

QuantityText quantity_text(const Quantity& quantity, std::string_view style_text, Language language) {
  Style style = parse_style(quantity.dimension, style_text);
  if (style.unit == nullptr) style = parse_style(quantity.dimension, usual_style(quantity));
  const double value = quantity.value / style.unit->in_base;
  std::array<char, 400> buffer;  // a double has 309 digits before the point at most
  const auto format = style.significant ? std::chars_format::general : std::chars_format::fixed;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, style.digits);
  std::string digits(buffer.data(), end.ptr);
  if (digits.starts_with('-') && digits.find_first_not_of("-0.") == std::string::npos)
    digits = digits.substr(1);  // no "-0.00"
  if (style.with_sign && !digits.starts_with('-')) digits = '+' + digits;
  return {std::move(digits), style.unit->symbol[static_cast<std::size_t>(language)]};
}

}  // namespace remount
