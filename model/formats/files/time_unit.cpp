#include "model/formats/files/time_unit.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace remount::formats {
namespace {

/// The first name of each is the short one.
constexpr std::pair<std::string_view, std::int64_t> kTimeUnits[] = {{"s", 1'000'000'000},
                                                                    {"sec", 1'000'000'000},
                                                                    {"secs", 1'000'000'000},
                                                                    {"second", 1'000'000'000},
                                                                    {"seconds", 1'000'000'000},
                                                                    {"秒", 1'000'000'000},
                                                                    {"ms", 1'000'000},
                                                                    {"msec", 1'000'000},
                                                                    {"msecs", 1'000'000},
                                                                    {"milliseconds", 1'000'000},
                                                                    {"millisecond", 1'000'000},
                                                                    {"millis", 1'000'000},
                                                                    {"毫秒", 1'000'000},
                                                                    {"us", 1'000},
                                                                    {"\xc2\xb5s", 1'000},
                                                                    {"\xce\xbcs", 1'000},
                                                                    {"usec", 1'000},
                                                                    {"usecs", 1'000},
                                                                    {"microseconds", 1'000},
                                                                    {"microsecond", 1'000},
                                                                    {"micros", 1'000},
                                                                    {"微秒", 1'000},
                                                                    {"ns", 1},
                                                                    {"nsec", 1},
                                                                    {"nsecs", 1},
                                                                    {"nanosec", 1},
                                                                    {"nanosecs", 1},
                                                                    {"nanosecond", 1},
                                                                    {"nanos", 1},
                                                                    {"纳秒", 1},
                                                                    {"nanoseconds", 1}};

}  // namespace

std::optional<std::int64_t> time_unit_named_ns(std::string_view name) {
  const auto* found = std::ranges::find(kTimeUnits, name, &std::pair<std::string_view, std::int64_t>::first);
  return found == std::end(kTimeUnits) ? std::nullopt : std::optional(found->second);
}

std::string_view time_unit_name(std::int64_t unit_ns) {
  const auto* found = std::ranges::find(kTimeUnits, unit_ns, &std::pair<std::string_view, std::int64_t>::second);
  return found == std::end(kTimeUnits) ? std::string_view() : found->first;
}

}  // namespace remount::formats
