// Dates as packets spell them out.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "model/formats/files/number_bytes.h"

namespace remount::formats {

constexpr std::int64_t kSecond_ns = 1'000'000'000, kMicrosecond_ns = 1000;

/// A day and a time of it, UTC.
struct PacketDate {
  int year = 0;
  unsigned month = 0, day = 0, hour = 0, minute = 0, second = 0;
};

/// Unix time. Nothing for what no calendar has.
inline std::optional<std::int64_t> unix_ns(const PacketDate& date) {
  using namespace std::chrono;
  const year_month_day day{year{date.year}, month{date.month}, std::chrono::day{date.day}};
  constexpr unsigned kLastSecond = 60;  // a leap second
  if (!day.ok() || date.hour > 23 || date.minute > 59 || date.second > kLastSecond) return std::nullopt;
  return nanoseconds(sys_days{day}.time_since_epoch() + hours{date.hour} + minutes{date.minute} +
                     std::chrono::seconds{date.second})
      .count();
}

/// Six bytes of seconds since 1970 and four of a part of a second that counts units of `unit_ns`, most significant
/// first. Nothing for what is no such time.
/// @param bytes hold all ten
inline std::optional<std::int64_t> seconds_and_part_ns(std::string_view bytes, std::size_t at,
                                                       std::int64_t unit_ns = kMicrosecond_ns) {
  constexpr std::uint64_t kMostSeconds = 4'100'000'000;  // year 2099: differences of times do not overflow
  const std::uint64_t seconds =
      std::uint64_t{network_number<std::uint16_t>(bytes, at)} << 32U | network_number<std::uint32_t>(bytes, at + 2);
  const std::int64_t part_ns = unit_ns * network_number<std::uint32_t>(bytes, at + 6);
  if (seconds > kMostSeconds || part_ns >= kSecond_ns) return std::nullopt;
  return static_cast<std::int64_t>(seconds) * kSecond_ns + part_ns;
}

/// Whether a clock of Unix time has been set: one that has not counts from 1970, or from 2000, since it was switched
/// on.
constexpr bool has_date(std::int64_t time_ns) { return time_ns > 1'000'000'000'000'000'000; }

}  // namespace remount::formats
