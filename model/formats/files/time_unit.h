// Units of time as headers of tables name them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace remount::formats {

/// "ms", "msec", "milliseconds": 1'000'000. In small letters, without brackets; nothing where it is no unit of time.
std::optional<std::int64_t> time_unit_named_ns(std::string_view name);

/// "s", "ms", "us" or "ns"; empty for other units.
std::string_view time_unit_name(std::int64_t unit_ns);

}  // namespace remount::formats
