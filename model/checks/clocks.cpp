// Streams that do not meet in time, and clocks of the host against GPS.
#include "model/checks/builtin.h"
#include "model/checks/check_text.h"
#include "model/clock_hint.h"

namespace remount {
namespace {

template <class Items>
TimeSpan span_of(const Items& items) {
  return items.empty() ? TimeSpan{0, -1} : TimeSpan{items.front().stamp_ns, items.back().stamp_ns};
}

TimeSpan lidar_span(const Session& session) {
  if (session.scans && session.scans->size() > 0)
    return {session.scans->stamp_ns(0), session.scans->stamp_ns(session.scans->size() - 1)};
  return span_of(session.odometry_from_lidar);
}

bool is_empty(const TimeSpan& span) { return span.last_ns < span.first_ns; }
bool apart(const TimeSpan& a, const TimeSpan& b) {
  return !is_empty(a) && !is_empty(b) && (a.last_ns < b.first_ns || a.first_ns > b.last_ns);
}

void look_at_clocks(const CheckedSession& checked, std::vector<Finding>& findings, const Progress&) {
  const Session& session = checked.session;
  const TimeSpan lidar = lidar_span(session), ins = span_of(checked.poses);
  if (apart(lidar, ins))
    findings.push_back({Severity::Problem, "clocks-apart", session.name,
                        "the INS data do not cover the scans' times: " + time_spans_apart(lidar, ins)});
  else if (const std::string shifted = is_empty(lidar) || is_empty(ins) ? "" : shifted_by_leap_seconds(lidar, ins);
           !shifted.empty())
    findings.push_back({Severity::Warning, "clock-leap-seconds", session.name, shifted});
  const TimeSpan& reference = is_empty(ins) ? lidar : ins;
  const std::pair<const char*, TimeSpan> others[] = {{"IMU", span_of(session.imu)},
                                                     {"GNSS", span_of(session.gnss)},
                                                     {"wheels", span_of(session.wheels)},
                                                     {"barometer", span_of(session.barometer)}};
  for (const auto& [name, span] : others)
    if (apart(span, reference))
      findings.push_back({Severity::Warning, "sensor-clock", name,
                          "its times do not meet those of the INS or the LiDAR: " + clock_difference(span, reference)});
}

}  // namespace

DataCheck clock_check() {
  return {
      .kinds =
          {{"clocks-apart", "Scans and INS have no instant in common: there is nothing to compare.",
            "Give data of the same drive, on one clock; declare the time scale (UTC, GPS) of each."},
           {"clock-leap-seconds", "Scans are compared with the motion of another instant: no pair fits.",
            "Declare the time scale (UTC, GPS, TAI) of each log, or subtract the difference from the stamps of one."},
           {"clock-far", "Scans are compared with the motion of another instant: no pair fits, or X is off.",
            "Move the stamps of the LiDAR by that much, and see why the clocks differ: one that is not synchronised, "
            "another time scale, stamps of arrival. The next calibration estimates what is left."},
           {"gps-week-rollover",
            "The receiver counts a wrong number of weeks; that is mended, and nothing is lost by it.",
            "Update the firmware of the receiver: other programs take its stamps as they are."},
           {"sensor-clock", "The stream cannot be used: no sample of it belongs to the drive.",
            "Declare its time scale (UTC, GPS) and unit, or leave it out."},
           {"host-clock", "Whatever else is stamped by the host's clock is off by as much against the INS.",
            "Synchronise the host with GPS (PTP, NTP, chrony); stamp scans by GPS time (PPS) where the LiDAR can."},
           {"host-stamps-rounded", "The host's clock cannot be judged.", "Export the log again with all digits."},
           {"clock-ambiguous", "Poses and INS may belong to different instants.",
            "Look at the clock offset of the result; where it has none, record a drive with several turns, on one "
            "clock."},
           {"clock-moved", "The clocks were brought together by the recorder's, as well as it took messages down.",
            "Synchronise the clocks before the next drive; look at the clock offset of the result."},
           {"point-clock", "Within a scan, points may be compensated for the motion of another instant.",
            "Have the driver stamp scans and points by one clock."},
           {"clock-aligned", "The clocks were brought together by the turns of the drive, to some milliseconds.",
            "Synchronise the clocks before the next drive."}},
      .look = look_at_clocks};
}

}  // namespace remount
