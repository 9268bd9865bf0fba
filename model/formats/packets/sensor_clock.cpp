#include "model/formats/packets/sensor_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "messages/captures.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/packets/packet_times.h"

namespace remount::formats {

namespace {

constexpr std::int64_t kNear_ns = 2'000'000'000;

/// The value of `time` plus whole periods that is nearest to another.
std::int64_t nearest(std::int64_t time, std::int64_t to, std::int64_t period_ns) {
  if (period_ns == 0) return time;
  const std::int64_t apart = to - time;
  const std::int64_t periods = (apart + (apart >= 0 ? period_ns / 2 : -period_ns / 2)) / period_ns;
  return time + periods * period_ns;
}

/// By the packet before and what the host says has passed since.
void unwrap(std::vector<IndexedPacket>& packets) {
  for (std::size_t i = 0; i < packets.size(); ++i) {
    const bool begins = i == 0 || packets[i].clock_period_s != packets[i - 1].clock_period_s;
    const std::int64_t expected =
        begins ? packets[i].host_ns : packets[i - 1].time_ns + (packets[i].host_ns - packets[i - 1].host_ns);
    packets[i].time_ns = nearest(packets[i].time_ns, expected, packets[i].clock_period_s * kSecond_ns);
  }
}

/// Where the clock counts otherwise from here on, as once a receiver is found. A host that stalls hands packets on
/// late, but all of them: the sensor's steps are then as usual.
bool jumps(const IndexedPacket& before, const IndexedPacket& packet) {
  constexpr std::int64_t kUsual_ns = 100'000'000, kJump_ns = 500'000'000;
  const std::int64_t step_ns = packet.time_ns - before.time_ns, host_step_ns = packet.host_ns - before.host_ns;
  return before.clock_period_s != packet.clock_period_s ||
         (std::abs(step_ns) > kUsual_ns && std::abs(step_ns - host_step_ns) > kJump_ns);
}

using PacketIterator = std::vector<IndexedPacket>::iterator;

std::int64_t median_behind_ns(PacketIterator first, PacketIterator last) {
  std::vector<std::int64_t> behind_ns;
  behind_ns.reserve(static_cast<std::size_t>(last - first));
  for (auto packet = first; packet != last; ++packet) behind_ns.push_back(packet->host_ns - packet->time_ns);
  return median_of(std::move(behind_ns));
}

/// Whether the sensor's clock follows a receiver, at most times between two: a capture may have as many states as times
/// that are asked for.
class LockedTimes {
 public:
  explicit LockedTimes(std::vector<SensorReceiver::State> states) : states_(std::move(states)), locked_{0} {
    std::ranges::stable_sort(states_, {}, &SensorReceiver::State::host_ns);
    for (const SensorReceiver::State& state : states_) locked_.push_back(locked_.back() + state.clock_locked);
  }

  /// By the states in between; where there is none, by those nearby.
  bool mostly(std::int64_t from_ns, std::int64_t to_ns) const {
    return share(from_ns, to_ns).value_or(share(from_ns - kNear_ns, to_ns + kNear_ns).value_or(0.0)) > 0.5;
  }

 private:
  std::optional<double> share(std::int64_t from_ns, std::int64_t to_ns) const {
    const auto place = [](auto found, const auto& states) { return static_cast<std::size_t>(found - states.begin()); };
    const std::size_t first =
        place(std::ranges::lower_bound(states_, from_ns, {}, &SensorReceiver::State::host_ns), states_);
    const std::size_t end =
        place(std::ranges::upper_bound(states_, to_ns, {}, &SensorReceiver::State::host_ns), states_);
    if (first >= end) return std::nullopt;
    return static_cast<double>(locked_[end] - locked_[first]) / static_cast<double>(end - first);
  }

  std::vector<SensorReceiver::State> states_;
  std::vector<std::size_t> locked_;  // of the first so many
};

/// From the first column of a packet to that of the next; the host has it when it is complete.
std::int64_t usual_step_ns(PacketIterator first, PacketIterator last) {
  constexpr std::int64_t kMost_ns = 10'000'000;  // beyond, packets are missing
  std::vector<std::int64_t> steps_ns;
  for (auto packet = first; packet + 1 < last; ++packet)
    if (const std::int64_t step_ns = (packet + 1)->time_ns - packet->time_ns; step_ns > 0 && step_ns <= kMost_ns)
      steps_ns.push_back(step_ns);
  return steps_ns.empty() ? 0 : median_of(std::move(steps_ns));
}

/// How far the host's clock is behind the sensor's time at each time of it: a straight line.
struct ClockLine {
  std::int64_t from_ns = 0, behind_ns = 0;
  double drift = 0.0;
  std::int64_t at(std::int64_t time_ns) const {
    return behind_ns + std::llround(drift * static_cast<double>(time_ns - from_ns));
  }
};

/// Through what comes soonest in every second: packets are held up, but none comes early.
ClockLine fit_clock(PacketIterator first, PacketIterator last) {
  constexpr std::int64_t kWindow_ns = 1'000'000'000;
  constexpr std::size_t kFewestWindows = 30;
  ClockLine line{first->time_ns, std::numeric_limits<std::int64_t>::max(), 0.0};
  std::vector<std::pair<double, double>> soonest;  // seconds since the first, ns behind the least so far
  std::int64_t window = std::numeric_limits<std::int64_t>::min(), least_ns = 0;
  std::vector<std::pair<std::int64_t, std::int64_t>> windows;
  for (auto packet = first; packet != last; ++packet) {
    const std::int64_t behind_ns = packet->host_ns - packet->time_ns;
    line.behind_ns = std::min(line.behind_ns, behind_ns);
    const std::int64_t its = (packet->time_ns - line.from_ns) / kWindow_ns;
    if (its != window) windows.emplace_back(its, behind_ns), window = its, least_ns = behind_ns;
    if (behind_ns < least_ns) windows.back().second = least_ns = behind_ns;
  }
  if (windows.size() < kFewestWindows) return line;
  for (const auto& [its, behind_ns] : windows)
    soonest.emplace_back(static_cast<double>(its) + 0.5, static_cast<double>(behind_ns - line.behind_ns));
  double mean_s = 0.0, mean_ns = 0.0, across = 0.0, along = 0.0;
  const auto count = static_cast<double>(soonest.size());
  for (const auto& [s, ns] : soonest) mean_s += s / count, mean_ns += ns / count;
  for (const auto& [s, ns] : soonest) across += (s - mean_s) * (ns - mean_ns), along += (s - mean_s) * (s - mean_s);
  constexpr double kMostDrift = 1e-3;  // more is no clock, but a host's that was set meanwhile
  if (along <= 0.0 || std::abs(across / along) > kMostDrift * 1e9) return line;
  line.drift = across / along * 1e-9;
  line.behind_ns += std::llround(mean_ns - across / along * mean_s);
  return line;
}

/// Unix time of a clock that counts from 1970 as atomic clocks do, without leap seconds.
std::int64_t unix_ns_from_tai_ns(std::int64_t tai_ns) {
  constexpr std::int64_t kGpsBegins_ns = 315'964'800'000'000'000, kTaiAheadOfGps_ns = 19'000'000'000;
  return unix_ns_from_gps_ns(tai_ns - kGpsBegins_ns - kTaiAheadOfGps_ns);
}

/// Takes off what TAI is ahead of UTC where the host's clock says that it is in the packets' times.
bool take_off_tai(PacketIterator first, PacketIterator last) {
  const std::int64_t ahead_ns = first->time_ns - unix_ns_from_tai_ns(first->time_ns);
  if (!has_date(first->time_ns) || std::abs(median_behind_ns(first, last) + ahead_ns) > kNear_ns) return false;
  for (auto packet = first; packet != last; ++packet) packet->time_ns -= ahead_ns;
  return true;
}

void note_clock(std::vector<drive::Finding>& findings, const char* code, const std::string& where, Message what) {
  findings.push_back(drive::make_finding(drive::Severity::Note, code, where, std::move(what)));
}

}  // namespace

std::size_t settle_second_parts(std::vector<IndexedPacket>& packets) {
  const auto are = [&](SecondPart part) {
    return static_cast<std::size_t>(std::ranges::count(packets, part, &IndexedPacket::second_part));
  };
  const std::size_t nanoseconds = are(SecondPart::Nanoseconds);
  if (nanoseconds <= are(SecondPart::Either))
    return std::erase_if(packets, [](const IndexedPacket& its) { return its.second_part == SecondPart::Nanoseconds; });
  for (IndexedPacket& packet : packets) {
    const std::int64_t past_ns = packet.time_ns % kSecond_ns;
    if (packet.second_part == SecondPart::Either) packet.time_ns += past_ns / kMicrosecond_ns - past_ns;
    packet.second_part = SecondPart::Known;
  }
  return 0;
}

void settle_clock(std::vector<IndexedPacket>& packets, const std::vector<SensorReceiver::State>& receiver,
                  const std::string& where, std::vector<drive::Finding>& findings) {
  unwrap(packets);
  const LockedTimes receiver_times(receiver);
  std::size_t moved = 0, most = 0, tai = 0;
  std::int64_t apart_ns = 0, believed_apart_ns = 0;
  bool believed_date = false;
  for (auto first = packets.begin(); first != packets.end();) {
    auto last = first + 1;
    while (last != packets.end() && !jumps(*(last - 1), *last)) ++last;
    const auto count = static_cast<std::size_t>(last - first);
    const bool dated = first->clock_period_s == 0;
    if (dated && take_off_tai(first, last)) tai += count;
    const std::int64_t behind_ns = median_behind_ns(first, last);
    const bool follows =
        (!dated || has_date(first->time_ns)) && receiver_times.mostly(first->host_ns, (last - 1)->host_ns);
    if (std::abs(behind_ns) > kNear_ns && follows) {
      if (std::abs(behind_ns) > std::abs(believed_apart_ns)) believed_apart_ns = behind_ns, believed_date = dated;
    } else if (std::abs(behind_ns) > kNear_ns) {
      const ClockLine line = fit_clock(first, last);
      const std::int64_t complete_after_ns = usual_step_ns(first, last);
      for (auto packet = first; packet != last; ++packet)
        packet->time_ns += line.at(packet->time_ns) - complete_after_ns;
      if (count > most) most = count, apart_ns = behind_ns;
      moved += count;
    }
    first = last;
  }
  if (moved > 0)
    findings.push_back(
        drive::make_finding(drive::Severity::Warning, "capture-clock", where,
                            say::capture_clock_of_host(Duration{seconds(std::abs(apart_ns))}, moved, packets.size())));
  const Duration believed_apart{seconds(std::abs(believed_apart_ns))};
  if (believed_apart_ns != 0)
    note_clock(findings, "capture-clock", where,
               believed_date ? say::capture_clock_set(believed_apart) : say::capture_clock_of_sensor(believed_apart));
  if (tai > 0) note_clock(findings, "capture-tai", where, say::capture_clock_tai(tai, packets.size()));
}

}  // namespace remount::formats
