#include "model/formats/bags/bag_week_rollover.h"

#include <algorithm>
#include <limits>

#include "model/conventions/week_rollover.h"

namespace remount::bags {
namespace {

/// By how much a stream is off against the recorder's clock, which every stream of a bag has beside its own.
std::int64_t off_by_ns(const StreamClock& clock, bool from_gps_time) {
  conventions::TimeSpan own{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()},
      recorded = own;
  const auto widen = [](conventions::TimeSpan& span, std::int64_t stamp_ns) {
    span = {std::min(span.first_ns, stamp_ns), std::max(span.last_ns, stamp_ns)};
  };
  for (const ClockReading& reading : clock.readings) {
    widen(own, reading.stamp_ns);
    widen(recorded, reading.log_time_ns);
  }
  return clock.readings.empty() ? 0 : conventions::week_rollover_ns(own, recorded, from_gps_time);
}

template <class Items, class StampOf>
void move_by(std::int64_t by_ns, StreamClock& clock, Items& items, StampOf&& stamp_of) {
  for (ClockReading& reading : clock.readings) reading.stamp_ns += by_ns;
  for (auto& item : items) stamp_of(item) += by_ns;
}

}  // namespace

void mend_week_rollovers(const BagFile& bag, const TopicRoles& roles, BagStreams& s,
                         std::vector<drive::Finding>& findings) {
  const auto own_stamp = [](auto& item) -> std::int64_t& { return item.stamp_ns; };
  const auto header_stamp = [](auto& message) -> std::int64_t& { return message.header.stamp_ns; };
  const auto sample_stamp = [](InspvaxMessage& message) -> std::int64_t& { return message.sample.stamp_ns; };
  std::vector<std::size_t> told;  // a topic of two roles is two streams
  const auto report = [&](std::int64_t by_ns, const std::optional<std::size_t>& topic) {
    if (by_ns == 0 || !topic || std::find(told.begin(), told.end(), *topic) != told.end()) return;
    told.push_back(*topic);
    findings.push_back(
        conventions::week_rollover_finding(by_ns, bag.files().front().string() + ": " + bag.topics()[*topic].name));
  };
  const auto mend = [&](StreamClock& clock, auto& items, bool from_gps_time, const std::optional<std::size_t>& topic,
                        auto& stamp_of) {
    const std::int64_t by_ns = off_by_ns(clock, from_gps_time);
    move_by(by_ns, clock, items, stamp_of);
    report(by_ns, topic);
    return by_ns;
  };
  mend(s.ins_poses.clock, s.ins_poses.world_from_child, false, roles.ins, own_stamp);
  // What stands beside INSPVA is of the same receiver, and told with it.
  const std::int64_t novatel_ns = mend(s.inspvax.clock, s.inspvax.messages, true, roles.ins, sample_stamp);
  move_by(novatel_ns, s.inspvax_beside.clock, s.inspvax_beside.messages, sample_stamp);
  move_by(novatel_ns, s.insstdev.clock, s.insstdev.messages, own_stamp);
  mend(s.attitude.clock, s.attitude.messages, false, roles.ins, header_stamp);
  mend(s.position.clock, s.position.messages, false, roles.ins_position, header_stamp);
  mend(s.gnss.clock, s.gnss.messages, false, roles.gnss, header_stamp);
  mend(s.imu.clock, s.imu.messages, false, roles.imu, header_stamp);
}

}  // namespace remount::bags
