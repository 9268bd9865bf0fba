// Logs that count the seconds of a GPS week and do not say of which: the LiDAR's dates tell.
#pragma once

#include "model/conventions/clock_hint.h"
#include "model/drive/session.h"

namespace remount::conventions {

/// Moves samples of the INS whose week is open (Session::ins_week_open) into the week in which the LiDAR recorded, or,
/// without a LiDAR, the GNSS receiver of the same drive; stamps are UTC then, with the leap seconds of that week. Where
/// these have no dates, they may count the seconds of the week as well: the samples do so then, without leap seconds.
/// Finding "ins-week" says which it was. Where nothing tells, the samples stay in week 0.
void place_in_week(drive::Session& session);

/// Where that moves a time of such a log, of which `ins` is the first and the last, beside scans at `dated`.
std::int64_t placed_in_week_ns(std::int64_t stamp_ns, const TimeSpan& ins, const TimeSpan& dated);

}  // namespace remount::conventions
