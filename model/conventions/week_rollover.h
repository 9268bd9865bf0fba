// Receivers that count the weeks of GPS from the wrong turn of their ten bits: 1024 weeks off.
#pragma once

#include <cstdint>
#include <string>

#include "model/conventions/clock_hint.h"
#include "model/drive/session.h"

namespace remount::conventions {

/// By how much a stream is to be moved so that it meets another that it should share its clock with; 0 where they are
/// not a whole number of turns of the GPS week apart, to within a minute. A driver that made the stamps of GPS time
/// took the leap seconds of the wrong year with them, one whose receiver counts in UTC did not: what covers more of the
/// other is taken, and where both do, what `from_gps_time` says.
std::int64_t week_rollover_ns(const TimeSpan& stream, const TimeSpan& other, bool from_gps_time);

inline constexpr const char* kWeekRollover = "gps-week-rollover";
drive::Finding week_rollover_finding(std::int64_t moved_ns, const std::string& where);

/// Moves INS, IMU, GNSS, wheels and barometer of a session to the LiDAR's turn of the week; without a LiDAR the others
/// to the INS's. Finding "gps-week-rollover" for each. An INS whose week is open is placed first (place_in_week).
void mend_week_rollover(drive::Session& session);

}  // namespace remount::conventions
