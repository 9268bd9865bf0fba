#include "model/formats/files/time_stamp.h"

#include <array>
#include <chrono>
#include <cstdio>

#include "algorithms/core/index.h"

namespace remount::formats {

namespace {

constexpr std::int64_t kLargestStamp_ns = 8'000'000'000'000'000'000;
constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kGpsEpochUnix_s = 315'964'800;  // 6 January 1980
constexpr std::int64_t kWeek_s = 604'800;

/// Reads up to `most` digits, at least one.
std::optional<int> digits(std::string_view& text, std::size_t most) {
  int value = 0;
  std::size_t count = 0;
  while (count < most && count < text.size() && text[count] >= '0' && text[count] <= '9') {
    value = value * 10 + (text[count] - '0');
    ++count;
  }
  if (count == 0) return std::nullopt;
  text.remove_prefix(count);
  return value;
}

bool separator(std::string_view& text, std::string_view allowed) {
  if (text.empty() || allowed.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<std::int64_t> fraction_ns(std::string_view text) {
  if (text.size() > 9) return std::nullopt;
  std::int64_t value = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    if (i < text.size() && (text[i] < '0' || text[i] > '9')) return std::nullopt;
    value = value * 10 + (i < text.size() ? text[i] - '0' : 0);
  }
  return value;
}

}  // namespace

std::optional<std::int64_t> date_of_parts_ns(const std::array<int, 6>& parts, std::int64_t fraction_ns) {
  using namespace std::chrono;
  const year_month_day date{year{parts[0]}, month{static_cast<unsigned>(parts[1])},
                            day{static_cast<unsigned>(parts[2])}};
  if (!date.ok() || parts[0] < 1970 || parts[0] > 2200 || parts[3] > 23 || parts[4] > 59 || parts[5] > 60)
    return std::nullopt;
  const std::int64_t days = sys_days{date}.time_since_epoch().count();
  return (days * 86400 + parts[3] * 3600 + parts[4] * 60 + parts[5]) * kSecond + fraction_ns;
}

std::optional<std::int64_t> parse_date_ns(std::string_view text) {
  std::array<int, 6> parts{};
  constexpr std::array<std::string_view, 5> kSeparators{"-/", "-/", "- T", ":-", ":-"};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<int> value = digits(text, i == 0 ? 4 : 2);
    if (!value || (i < kSeparators.size() && !separator(text, kSeparators[i]))) return std::nullopt;
    parts[i] = *value;
  }
  std::int64_t fraction = 0;
  if (!text.empty()) {
    if (!separator(text, ".-")) return std::nullopt;
    const std::optional<std::int64_t> value = fraction_ns(text);
    if (!value) return std::nullopt;
    fraction = *value;
  }
  return date_of_parts_ns(parts, fraction);
}

namespace {

/// Walks through a name from where a date may begin.
class NameDateReader {
 public:
  explicit NameDateReader(std::string_view text) : text_(text) {}

  std::optional<std::int64_t> read() {
    const std::size_t run = std::min(text_.find_first_not_of(kDigits), text_.size());
    if (run != 4 && run != 8 && run != 14 && run != 17 && run != 20) return std::nullopt;
    if (!fixed(0, 4)) return std::nullopt;
    const bool of_digits = run > 4;
    const bool day = of_digits ? fixed(1, 2) && fixed(2, 2) : parted(1, "-_./") && parted(2, std::string(1, part_));
    if (!day || (of_digits && (parts_[0] < 1990 || parts_[0] > 2099))) return std::nullopt;
    if (run <= 8 && !separator(text_, "-_ T")) return std::nullopt;
    if (!clock(run > 8) || !rest(run > 8)) return std::nullopt;
    return date_of_parts_ns(parts_, fraction_);
  }

 private:
  static constexpr std::string_view kDigits = "0123456789";

  /// Exactly so many digits.
  bool fixed(std::size_t part, std::size_t count) {
    const std::size_t before = text_.size();
    const std::optional<int> value = digits(text_, count);
    if (!value || before - text_.size() != count) return false;
    parts_[part] = *value;
    return true;
  }
  /// One or two digits behind a separator, which is kept.
  bool parted(std::size_t part, std::string_view by) {
    if (text_.empty()) return false;
    part_ = text_.front();
    if (!separator(text_, by)) return false;
    const std::optional<int> value = digits(text_, 2);
    if (value) parts_[part] = *value;
    return value.has_value();
  }
  bool clock(bool of_digits) {
    if (!fixed(3, 2)) return false;
    if (of_digits || (!text_.empty() && kDigits.find(text_.front()) != std::string_view::npos))
      return fixed(4, 2) && fixed(5, 2);
    return parted(4, "-_:.") && parted(5, std::string(1, part_));
  }
  /// A fraction, and words without numbers.
  bool rest(bool of_digits) {
    const bool point = separator(text_, ".,"), apart = !point && separator(text_, "_-:");
    const std::size_t run = std::min(text_.find_first_not_of(kDigits), text_.size());
    if (run > 0) {
      const bool known = run == 3 || run == 6 || run == 9;
      if (run > 9 || (!point && !known) || (!point && !apart && !of_digits)) return false;
      fraction_ = *fraction_ns(text_.substr(0, run));
    }
    return text_.find_first_of(kDigits, run) == std::string_view::npos;
  }

  std::string_view text_;
  std::array<int, 6> parts_{};
  std::int64_t fraction_ = 0;
  char part_ = '-';
};

}  // namespace

std::optional<std::int64_t> date_in_name_ns(std::string_view stem) {
  const auto is_digit = [&](std::size_t at) { return stem[at] >= '0' && stem[at] <= '9'; };
  for (std::size_t at = 0; at < stem.size(); ++at)
    if (is_digit(at) && (at == 0 || !is_digit(at - 1)))
      if (const auto date = NameDateReader(stem.substr(at)).read()) return date;
  return std::nullopt;
}

std::string format_date_ns(std::int64_t stamp_ns) {
  using namespace std::chrono;
  const sys_time<nanoseconds> time{nanoseconds{stamp_ns}};
  const auto midnight = floor<days>(time);
  const year_month_day date{midnight};
  const hh_mm_ss clock{time - midnight};
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u %02d:%02d:%02d.%09lld", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()), static_cast<long long>(clock.subseconds().count()));
  return text.data();
}

int leap_seconds_at_gps_s(std::int64_t gps_s) {
  // Unix times (UTC) at which GPS minus UTC became 1, 2, ... seconds: 1981-07-01 to 2017-01-01.
  constexpr std::array<std::int64_t, 18> kSince{362793600, 394329600,  425865600,  489024000,  567993600,  631152000,
                                                662688000, 709948800,  741484800,  773020800,  820454400,  867715200,
                                                915148800, 1136073600, 1230768000, 1341100800, 1435708800, 1483228800};
  int leap = 0;
  while (leap < static_cast<int>(kSince.size()) && gps_s + kGpsEpochUnix_s - (leap + 1) >= kSince[index_at(leap)])
    ++leap;
  return leap;
}

bool is_stamp(std::int64_t ns) { return -kLargestStamp_ns <= ns && ns <= kLargestStamp_ns; }

std::optional<std::int64_t> moved_ns(std::int64_t stamp_ns, std::int64_t by_ns) {
  const double sum_ns = static_cast<double>(stamp_ns) + static_cast<double>(by_ns);  // never beyond its range
  return std::abs(sum_ns) > static_cast<double>(kLargestStamp_ns) ? std::nullopt : std::optional(stamp_ns + by_ns);
}

std::int64_t unix_ns_from_gps_ns(std::int64_t gps_ns) {
  return gps_ns + (kGpsEpochUnix_s - leap_seconds_at_gps_s(gps_ns / kSecond)) * kSecond;
}

std::optional<std::int64_t> unix_ns_from_gps_week(std::int64_t week, std::int64_t time_of_week_ns) {
  if (week < 0 || week > 9999 || time_of_week_ns < 0 || time_of_week_ns > kWeek_s * kSecond) return std::nullopt;
  return unix_ns_from_gps_ns(week * kWeek_s * kSecond + time_of_week_ns);
}

std::int64_t gps_ns_from_unix_ns(std::int64_t stamp_ns) {
  const std::int64_t without_leap_ns = stamp_ns - kGpsEpochUnix_s * kSecond;
  // The table is by GPS time, which is ahead by what is looked for.
  const int leap = leap_seconds_at_gps_s(without_leap_ns / kSecond);
  return without_leap_ns + leap_seconds_at_gps_s(without_leap_ns / kSecond + leap) * kSecond;
}

std::string utc_text(std::int64_t stamp_ns) {
  using namespace std::chrono;
  const sys_time<nanoseconds> time{nanoseconds(stamp_ns)};
  const auto day = floor<days>(time);
  const year_month_day date(day);
  const hh_mm_ss clock(floor<milliseconds>(time - day));
  char text[64];
  std::snprintf(text, sizeof(text), "%04d-%02u-%02u %02d:%02d:%02d.%03d UTC", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()), static_cast<int>(clock.subseconds().count()));
  return text;
}

}  // namespace remount::formats
