#include "model/formats/files/calendar_text.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kMinute_ns = std::int64_t{60} * 1'000'000'000, kHour_ns = 60 * kMinute_ns;

bool is_decimal(char c) { return c >= '0' && c <= '9'; }

std::size_t leading_digits(std::string_view text, std::size_t most) {
  std::size_t count = 0;
  while (count < most && count < text.size() && is_decimal(text[count])) ++count;
  return count;
}

/// "2023" of "2023", and of "23" where nothing else can be meant; empty where it is no year.
std::string whole_year(std::string_view year, DateOrder order, char apart, std::string_view second) {
  if (year.size() == 4) return std::string(year);
  const bool month_cannot_be_second = second.size() == 2 && second > "12";
  const bool sure = order == DateOrder::DayFirst ? apart == '.' : apart == '/' && month_cannot_be_second;
  constexpr std::string_view kFirstOfLastCentury = "80";
  if (year.size() != 2 || !sure) return {};
  return (year >= kFirstOfLastCentury ? "19" : "20") + std::string(year);
}

/// "2023-11-14 22:13" of "14.11.2023 22:13"; nothing where the year does not come last.
std::optional<std::string> with_year_first(std::string_view text, DateOrder order) {
  std::array<std::string_view, 3> parts;
  char apart = '\0';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t count = leading_digits(text, i == 2 ? 4 : 2);
    if (count == 0) return std::nullopt;
    parts[i] = text.substr(0, count);
    text.remove_prefix(count);
    if (i == 2) break;
    if (text.empty() || std::string_view("./-").find(text.front()) == std::string_view::npos) return std::nullopt;
    if (apart != '\0' && text.front() != apart) return std::nullopt;
    apart = text.front();
    text.remove_prefix(1);
  }
  const std::string year = whole_year(parts[2], order, apart, parts[1]);
  if (year.empty()) return std::nullopt;
  const bool day_first = order == DateOrder::DayFirst;
  return year + "-" + std::string(parts[day_first ? 1 : 0]) + "-" + std::string(parts[day_first ? 0 : 1]) +
         std::string(text);
}

/// How much later than UTC the clock is; taken from the end. Nothing where no zone stands there.
std::int64_t take_zone_ns(std::string_view& text) {
  const auto take = [&](std::size_t count) { text = trim(text.substr(0, text.size() - count)); };
  for (const std::string_view zone : {"Z", "UTC", "GMT"})
    if (text.size() > zone.size() && text.ends_with(zone)) {
      take(zone.size());
      return 0;
    }
  const std::size_t sign = text.find_last_of("+-");
  if (sign == std::string_view::npos || std::ranges::count(text.substr(0, sign), ':') < 2) return 0;
  std::string digits(text.substr(sign + 1));
  if (digits.size() == 5 && digits[2] == ':') digits.erase(2, 1);
  if (digits.size() == 2 && text[sign] == '+') digits += "00";
  if (digits.size() != 4 || !std::ranges::all_of(digits, is_decimal)) return 0;
  const std::int64_t hours = 10 * (digits[0] - '0') + digits[1] - '0',
                     minutes = 10 * (digits[2] - '0') + digits[3] - '0';
  if (hours > 14 || minutes % 15 != 0 || minutes > 45) return 0;
  const std::int64_t size_ns = hours * kHour_ns + minutes * kMinute_ns, later = text[sign] == '-' ? -1 : 1;
  take(text.size() - sign);
  return later * size_ns;
}

enum class HalfDay { None, Morning, Afternoon };

HalfDay take_half(std::string_view& text) {
  constexpr std::size_t kLetters = 2;
  if (text.size() <= kLetters) return HalfDay::None;
  const std::string end = lower_case(text.substr(text.size() - kLetters));
  if (end != "am" && end != "pm") return HalfDay::None;
  text = trim(text.substr(0, text.size() - kLetters));
  return end == "am" ? HalfDay::Morning : HalfDay::Afternoon;
}

/// What is to be added to a clock of twelve hours; nothing where it shows no such hour.
std::optional<std::int64_t> half_ns(HalfDay half, std::int64_t shown_ns) {
  if (half == HalfDay::None) return 0;
  const std::int64_t hour = shown_ns / kHour_ns % 24;
  if (hour < 1 || hour > 12) return std::nullopt;
  if (half == HalfDay::Morning) return hour == 12 ? -12 * kHour_ns : 0;
  return hour == 12 ? 0 : 12 * kHour_ns;
}

/// With a point before the fraction, which has nine digits at most; nothing where it is none.
std::optional<std::string> with_short_fraction(std::string_view text) {
  std::size_t at = text.find_last_of(".,");
  constexpr std::size_t kMilliseconds = 3;
  if (at == std::string_view::npos && std::ranges::count(text, ':') == 3 &&
      text.size() - text.rfind(':') == kMilliseconds + 1)
    at = text.rfind(':');
  if (at == std::string_view::npos) return std::string(text);
  if (!std::ranges::all_of(text.substr(at + 1), is_decimal)) return std::nullopt;
  std::string mended(text.substr(0, at + 10));
  mended[at] = '.';
  return mended;
}

}  // namespace

std::optional<std::int64_t> parse_calendar_ns(std::string_view text, DateOrder order) {
  text = trim(text);
  std::optional<std::string> turned;
  if (order != DateOrder::YearFirst) {
    turned = with_year_first(text, order);
    if (!turned) return std::nullopt;
    text = *turned;
  }
  const std::int64_t zone_ns = take_zone_ns(text);
  const HalfDay half = take_half(text);
  const auto plain = with_short_fraction(text);
  const auto shown_ns = plain ? parse_date_ns(*plain) : std::nullopt;
  const auto more_ns = shown_ns ? half_ns(half, *shown_ns) : std::nullopt;
  return more_ns ? std::optional(*shown_ns + *more_ns - zone_ns) : std::nullopt;
}

}  // namespace remount::formats
