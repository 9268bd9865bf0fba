#include "model/io/bag/bag_week_rollover.h"

#include <algorithm>
#include <limits>

#include "model/week_rollover.h"

namespace remount {
namespace {

/// Against the recorder's clock, which every stream of a bag has beside its own.
template <class Items, class StampOf>
void mend_week_rollover_of(StreamClock& clock, Items& items, bool from_gps_time, const std::string& where,
                           StampOf&& stamp_of, std::vector<Finding>& findings) {
  TimeSpan own{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}, recorded = own;
  const auto widen = [](TimeSpan& span, std::int64_t stamp_ns) {
    span = {std::min(span.first_ns, stamp_ns), std::max(span.last_ns, stamp_ns)};
  };
  for (const ClockReading& reading : clock.readings) {
    widen(own, reading.stamp_ns);
    widen(recorded, reading.log_time_ns);
  }
  const std::int64_t by_ns = clock.readings.empty() ? 0 : week_rollover_ns(own, recorded, from_gps_time);
  if (by_ns == 0) return;
  for (ClockReading& reading : clock.readings) reading.stamp_ns += by_ns;
  for (auto& item : items) stamp_of(item) += by_ns;
  findings.push_back(week_rollover_finding(by_ns, where));
}

}  // namespace

void mend_week_rollovers(const BagFile& bag, const TopicRoles& roles, BagStreams& s, std::vector<Finding>& findings) {
  const auto place = [&](const std::optional<std::size_t>& topic) {
    return topic ? bag.files().front().string() + ": " + bag.topics()[*topic].name : std::string();
  };
  const auto own_stamp = [](auto& item) -> std::int64_t& { return item.stamp_ns; };
  const auto header_stamp = [](auto& message) -> std::int64_t& { return message.header.stamp_ns; };
  const auto sample_stamp = [](InspvaxMessage& message) -> std::int64_t& { return message.sample.stamp_ns; };
  mend_week_rollover_of(s.ins_poses.clock, s.ins_poses.world_from_child, false, place(roles.ins), own_stamp, findings);
  mend_week_rollover_of(s.inspvax.clock, s.inspvax.messages, true, place(roles.ins), sample_stamp, findings);
  mend_week_rollover_of(s.attitude.clock, s.attitude.messages, false, place(roles.ins), header_stamp, findings);
  mend_week_rollover_of(s.position.clock, s.position.messages, false, place(roles.ins_position), header_stamp,
                        findings);
  mend_week_rollover_of(s.gnss.clock, s.gnss.messages, false, place(roles.gnss), header_stamp, findings);
  mend_week_rollover_of(s.imu.clock, s.imu.messages, false, place(roles.imu), header_stamp, findings);
}

}  // namespace remount
