#include "model/conventions/week_of_log.h"

#include <cmath>

#include "messages/ins_logs.h"
#include "messages/places.h"
#include "model/conventions/stream_spans.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/time_stamp.h"

namespace remount::conventions {
namespace {

template <class Place>
void move_ins(drive::Session& session, Place&& place) {
  for (motion::InsSample& sample : session.ins) sample.stamp_ns = place(sample.stamp_ns);
  for (std::int64_t& stamp_ns : session.ins_fix_stamps_ns) stamp_ns = place(stamp_ns);
}

void tell_week(drive::Session& session, Message words) {
  session.findings.push_back(
      drive::make_finding(drive::Severity::Note, "ins-week", say::place_ins(), std::move(words)));
}

/// Seconds of the week that are no dates either.
bool has_dates(const TimeSpan& other) { return middle_ns(other) >= formats::kFirstRecording_ns; }

}  // namespace

std::int64_t placed_in_week_ns(std::int64_t stamp_ns, const TimeSpan& ins, const TimeSpan& dated) {
  const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(stamp_ns);
  if (!has_dates(dated)) return gps_ns;
  const std::int64_t apart_ns =
      formats::gps_ns_from_unix_ns(middle_ns(dated)) - formats::gps_ns_from_unix_ns(middle_ns(ins));
  const auto weeks = static_cast<std::int64_t>(
      std::llround(static_cast<double>(apart_ns) / static_cast<double>(formats::kGpsWeek_ns)));
  return formats::unix_ns_from_gps_ns(gps_ns + weeks * formats::kGpsWeek_ns);
}

void place_in_week(drive::Session& session) {
  if (!session.ins_week_open || session.ins.empty()) return;
  const TimeSpan lidar = span_of_lidar(session);
  const TimeSpan other = is_empty(lidar) ? span_of_items(session.gnss) : lidar;
  if (is_empty(other)) return tell_week(session, say::ins_week_unknown());
  session.ins_week_open = false;
  const TimeSpan ins = span_of_items(session.ins);
  move_ins(session, [&](std::int64_t stamp_ns) { return placed_in_week_ns(stamp_ns, ins, other); });
  if (!has_dates(other)) {
    session.ins_stamps_from_gps = false;
    return tell_week(session, say::ins_week_of_no_date());
  }
  const std::int64_t week =
      formats::gps_ns_from_unix_ns(session.ins.front().stamp_ns) / formats::kGpsWeek_ns;  // of the first sample
  tell_week(session, say::ins_week_taken(week, formats::utc_text(session.ins.front().stamp_ns)));
}

}  // namespace remount::conventions
