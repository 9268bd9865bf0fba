// Streams that do not meet in time, and clocks of the host against GPS.
#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"
#include "model/conventions/clock_hint.h"

namespace remount::checks {
namespace {

template <class Items>
conventions::TimeSpan span_of(const Items& items) {
  return items.empty() ? conventions::TimeSpan{0, -1}
                       : conventions::TimeSpan{items.front().stamp_ns, items.back().stamp_ns};
}

conventions::TimeSpan lidar_span(const drive::Session& session) {
  if (session.scans && session.scans->size() > 0)
    return {session.scans->stamp_ns(0), session.scans->stamp_ns(session.scans->size() - 1)};
  return span_of(session.odometry_from_lidar);
}

bool is_empty(const conventions::TimeSpan& span) { return span.last_ns < span.first_ns; }
bool apart(const conventions::TimeSpan& a, const conventions::TimeSpan& b) {
  return !is_empty(a) && !is_empty(b) && (a.last_ns < b.first_ns || a.first_ns > b.last_ns);
}

void look_at_clocks(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  const drive::Session& session = checked.session;
  const conventions::TimeSpan lidar = lidar_span(session), ins = span_of(checked.poses);
  if (apart(lidar, ins))
    findings.push_back({drive::Severity::Problem, "clocks-apart", session.name,
                        say::clocks_apart(conventions::time_spans_apart(lidar, ins))});
  else if (const Message shifted =
               is_empty(lidar) || is_empty(ins) ? Message() : conventions::shifted_by_leap_seconds(lidar, ins);
           !shifted.empty())
    findings.push_back({drive::Severity::Warning, "clock-leap-seconds", session.name, shifted});
  const conventions::TimeSpan& reference = is_empty(ins) ? lidar : ins;
  const std::pair<Message, conventions::TimeSpan> others[] = {{say::place_imu(), span_of(session.imu)},
                                                              {say::place_gnss(), span_of(session.gnss)},
                                                              {say::place_wheels(), span_of(session.wheels)},
                                                              {say::place_barometer(), span_of(session.barometer)}};
  for (const auto& [name, span] : others)
    if (apart(span, reference))
      findings.push_back({drive::Severity::Warning, "sensor-clock", name,
                          say::sensor_clock(conventions::clock_difference(span, reference))});
}

}  // namespace

DataCheck clock_check() {
  return {.kinds = {{"clocks-apart", say::clocks_apart_meaning, say::clocks_apart_remedy},
                    {"clock-leap-seconds", say::clock_leap_seconds_meaning, say::clock_leap_seconds_remedy},
                    {"clock-far", say::clock_far_meaning, say::clock_far_remedy},
                    {"gps-week-rollover", say::gps_week_rollover_meaning, say::gps_week_rollover_remedy},
                    {"sensor-clock", say::sensor_clock_meaning, say::sensor_clock_remedy},
                    {"host-clock", say::host_clock_meaning, say::host_clock_remedy},
                    {"host-stamps-rounded", say::host_stamps_rounded_meaning, say::host_stamps_rounded_remedy},
                    {"clock-ambiguous", say::clock_ambiguous_meaning, say::clock_ambiguous_remedy},
                    {"clock-moved", say::clock_moved_meaning, say::clock_moved_remedy},
                    {"point-clock", say::point_clock_meaning, say::point_clock_remedy},
                    {"clock-aligned", say::clock_aligned_meaning, say::clock_aligned_remedy}},
          .look = look_at_clocks};
}

}  // namespace remount::checks
