#include "model/conventions/week_rollover.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "messages/checks.h"
#include "model/conventions/stream_spans.h"
#include "model/conventions/week_of_log.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"

namespace remount::conventions {
namespace {

constexpr std::int64_t kTurn_ns = formats::kGpsWeeksOfTurn * formats::kGpsWeek_ns;
constexpr std::int64_t kSlack_ns = 60'000'000'000;

/// What two spans have in common; negative where they are apart.
std::int64_t common_ns(const TimeSpan& a, const TimeSpan& b) {
  return std::min(a.last_ns, b.last_ns) - std::max(a.first_ns, b.first_ns);
}

TimeSpan shift(const TimeSpan& span, std::int64_t by_ns) { return {span.first_ns + by_ns, span.last_ns + by_ns}; }

/// Returns by how much.
template <class Items>
std::int64_t move_to(const TimeSpan& other, bool from_gps_time, const char* stream, Items& items,
                     std::vector<drive::Finding>& findings) {
  const std::int64_t by_ns = week_rollover_ns(span_of_items(items), other, from_gps_time);
  const auto can_move = [&](const auto& item) { return formats::moved_ns(item.stamp_ns, by_ns).has_value(); };
  if (by_ns == 0 || !std::ranges::all_of(items, can_move)) return 0;
  for (auto& item : items) item.stamp_ns += by_ns;
  findings.push_back(week_rollover_finding(by_ns, stream));
  return by_ns;
}

}  // namespace

std::int64_t week_rollover_ns(const TimeSpan& stream, const TimeSpan& other, bool from_gps_time) {
  constexpr std::int64_t kMostTurns = 2, kAlike_ns = 500'000'000;
  if (is_empty(stream) || is_empty(other)) return 0;
  const double apart_ns = static_cast<double>(middle_ns(other)) - static_cast<double>(middle_ns(stream));
  const auto turns = static_cast<std::int64_t>(std::llround(apart_ns / static_cast<double>(kTurn_ns)));
  if (turns == 0 || std::abs(turns) > kMostTurns) return 0;
  const std::int64_t in_utc = turns * kTurn_ns;
  const std::int64_t in_gps =
      formats::unix_ns_from_gps_ns(formats::gps_ns_from_unix_ns(middle_ns(stream)) + in_utc) - middle_ns(stream);
  const std::int64_t common_in_utc = common_ns(shift(stream, in_utc), other),
                     common_in_gps = common_ns(shift(stream, in_gps), other);
  if (std::max(common_in_utc, common_in_gps) < -kSlack_ns) return 0;
  if (std::abs(common_in_utc - common_in_gps) < kAlike_ns) return from_gps_time ? in_gps : in_utc;
  return common_in_gps > common_in_utc ? in_gps : in_utc;
}

drive::Finding week_rollover_finding(std::int64_t moved_ns, const std::string& where) {
  const std::int64_t weeks =
      formats::kGpsWeeksOfTurn * std::abs(std::llround(static_cast<double>(moved_ns) / static_cast<double>(kTurn_ns)));
  return drive::make_finding(drive::Severity::Warning, kWeekRollover, where,
                             moved_ns > 0 ? say::weeks_early(weeks) : say::weeks_late(weeks));
}

void mend_week_rollover(drive::Session& session) {
  place_in_week(session);
  const TimeSpan lidar = span_of_lidar(session);
  const std::int64_t ins_ns = move_to(lidar, session.ins_stamps_from_gps, "INS", session.ins, session.findings);
  for (std::int64_t& stamp_ns : session.ins_fix_stamps_ns) stamp_ns += ins_ns;
  move_to(lidar, false, "INS", session.world_from_ins, session.findings);
  const TimeSpan other = !is_empty(lidar)       ? lidar
                         : !session.ins.empty() ? span_of_items(session.ins)
                                                : span_of_items(session.world_from_ins);
  move_to(other, false, "IMU", session.imu, session.findings);
  move_to(other, false, "GNSS", session.gnss, session.findings);
  move_to(other, false, "wheels", session.wheels, session.findings);
  move_to(other, false, "barometer", session.barometer, session.findings);
}

}  // namespace remount::conventions
