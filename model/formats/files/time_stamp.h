// Time stamps as logs write them, to Unix nanoseconds (UTC).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace remount::formats {

/// 6 January 1980, from which GPS time counts, in Unix nanoseconds.
inline constexpr std::int64_t kGpsEpoch_ns = std::int64_t{315'964'800} * 1'000'000'000;

/// "2011-09-26 13:02:25.964389445" (KITTI) or "2021-10-26-16-21-29-468" (OpenCalib), read as UTC. The fraction may have
/// any number of digits up to 9 and may be missing. Nothing where the text is no date.
std::optional<std::int64_t> parse_date_ns(std::string_view text);

/// Year, month, day, hour, minute and second, and nanoseconds; nothing where there is no such time.
std::optional<std::int64_t> date_of_parts_ns(const std::array<int, 6>& parts, std::int64_t fraction_ns);

/// No LiDAR recorded before 1990: times below count from something else than 1970.
inline constexpr std::int64_t kFirstRecording_ns = std::int64_t{631'152'000} * 1'000'000'000;

/// A date and time that stand in the name of a file, with whatever words before and behind them:
/// "lidar_2023-11-14T22-13-20.050Z", "20231114_221320_050", "20231114221320050". Of digits alone the year is from 1990
/// to 2099, and three or six of them behind the seconds are their fraction. Nothing where other numbers follow.
std::optional<std::int64_t> date_in_name_ns(std::string_view stem);

/// The inverse, as KITTI writes it: "2011-09-26 13:02:25.964389445".
std::string format_date_ns(std::int64_t stamp_ns);

/// For people: "2011-09-26 13:02:25.951 UTC".
std::string utc_text(std::int64_t stamp_ns);

/// False beyond the times that files may hold (8e18 ns, to 2223): behind them is room for the differences between time
/// scales.
bool is_stamp(std::int64_t ns);

/// The sum; nothing where it is no stamp.
std::optional<std::int64_t> moved_ns(std::int64_t stamp_ns, std::int64_t by_ns);

/// GPS minus UTC at a GPS time, whole seconds: the table of leap seconds to 2017 (18 s), none announced since.
int leap_seconds_at_gps_s(std::int64_t gps_s);

/// Unix nanoseconds from GPS time since 6 January 1980 (which has no leap seconds).
std::int64_t unix_ns_from_gps_ns(std::int64_t gps_ns);

/// As above, from week and time of week. Nothing where week or time of week is out of its range.
std::optional<std::int64_t> unix_ns_from_gps_week(std::int64_t week, std::int64_t time_of_week_ns);

/// GPS time since 6 January 1980 from Unix nanoseconds.
std::int64_t gps_ns_from_unix_ns(std::int64_t stamp_ns);

}  // namespace remount::formats
