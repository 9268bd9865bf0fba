// From when to when the streams of a session are.
#pragma once

#include "model/conventions/clock_hint.h"
#include "model/drive/session.h"

namespace remount::conventions {

inline bool is_empty(const TimeSpan& span) { return span.last_ns < span.first_ns; }
inline std::int64_t middle_ns(const TimeSpan& span) { return span.first_ns + (span.last_ns - span.first_ns) / 2; }

template <class Items>
TimeSpan span_of_items(const Items& items) {
  return items.empty() ? TimeSpan{0, -1} : TimeSpan{items.front().stamp_ns, items.back().stamp_ns};
}

/// Of its scans, or of its poses where it has no scans.
inline TimeSpan span_of_lidar(const drive::Session& session) {
  if (session.scans && session.scans->size() > 0)
    return {session.scans->stamp_ns(0), session.scans->stamp_ns(session.scans->size() - 1)};
  return span_of_items(session.odometry_from_lidar);
}

}  // namespace remount::conventions
