#include "model/formats/bags/bag_clocks.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "messages/bags.h"
#include "model/conventions/clock_hint.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"

namespace remount::bags {
namespace {

constexpr double kSameClock_s = 0.5;  // delays of recorders are shorter, clocks that were not set are further apart
constexpr double kDelay_s = 0.1;      // what messages are late by beside the time that they take to be measured
constexpr double kNoClock_s = 4e9;    // apart like that are stamps that are no times

struct LidarClock {
  double behind_s = 0.0;
  double ends_after_s = 0.0;
};

LidarClock lidar_clock(const BagStreams& streams) {
  if (!streams.scans.clock.readings.empty()) return {streams.scans.clock.behind_s(), streams.scans.ends_after_s};
  // An odometry has a pose when the scan has ended that it is stamped by.
  return {streams.lidar_poses.clock.behind_s(),
          std::clamp(drive::median_period_s(streams.lidar_poses.world_from_child), 0.0, 2.0)};
}

/// How much further behind the recorder's clock a stream is than the LiDAR's, beside what a scan takes to be recorded:
/// it comes when it has ended, and its stamp is of its beginning.
double clocks_apart_s(const StreamClock& stream, const LidarClock& lidar) {
  return stream.behind_s() - lidar.behind_s + lidar.ends_after_s;
}

/// By how much a stream is to be moved, 0 where it shares the LiDAR's clock.
std::int64_t shift_ns(const StreamClock& stream, const LidarClock& lidar) {
  if (stream.readings.empty()) return 0;
  const double apart_s = clocks_apart_s(stream, lidar);
  // Drivers that stamp scans by their ends, too, share the clock.
  const double unexplained_s = apart_s > 0.0 ? std::max(0.0, apart_s - lidar.ends_after_s) : apart_s;
  return std::abs(unexplained_s) > kSameClock_s && std::abs(apart_s) < kNoClock_s ? std::llround(apart_s * 1e9) : 0;
}

void report_shift(std::int64_t by_ns, const StreamClock& stream, const StreamClock& lidar, const std::string& where,
                  std::vector<drive::Finding>& findings) {
  const double apart_s = static_cast<double>(by_ns) * 1e-9;
  findings.push_back(drive::make_finding(
      drive::Severity::Warning, "clock-moved", where,
      Message::sequence({say::bag_clock_moved(Duration{apart_s}),
                         conventions::cause_of_apart_clocks(lidar.readings.front().stamp_ns,
                                                            stream.readings.front().stamp_ns, apart_s)})));
}

double period_s(const StreamClock& stream) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < stream.readings.size(); ++i)
    steps_s.push_back(seconds(stream.readings[i].log_time_ns - stream.readings[i - 1].log_time_ns));
  return steps_s.empty() ? 0.0 : median_of(std::move(steps_s));
}

/// Too little to be moved, too much for delays.
void report_offset(const StreamClock& stream, const LidarClock& lidar, const std::string& where,
                   std::vector<drive::Finding>& findings) {
  const double apart_s = clocks_apart_s(stream, lidar);
  if (apart_s > -kDelay_s && apart_s < lidar.ends_after_s + period_s(stream) + kDelay_s) return;
  if (std::abs(apart_s) >= kNoClock_s) return;
  findings.push_back(
      drive::make_finding(drive::Severity::Warning, "host-clock", where, say::bag_host_clock(Duration{apart_s})));
}

}  // namespace

void share_lidar_clock(const BagFile& bag, const TopicRoles& roles, BagStreams& s,
                       std::vector<drive::Finding>& findings) {
  if (s.scans.clock.readings.empty() && s.lidar_poses.clock.readings.empty()) return;
  const LidarClock lidar = lidar_clock(s);
  const StreamClock& lidar_stream = s.scans.clock.readings.empty() ? s.lidar_poses.clock : s.scans.clock;
  const std::int64_t poses = shift_ns(s.ins_poses.clock, lidar), inspvax = shift_ns(s.inspvax.clock, lidar),
                     device = shift_ns(s.attitude.clock, lidar), gnss = shift_ns(s.gnss.clock, lidar),
                     imu = shift_ns(s.imu.clock, lidar);
  s.ins_moved_ns = poses + inspvax + device;  // one of these at most is there
  for (motion::StampedPose& pose : s.ins_poses.world_from_child) pose.stamp_ns += poses;
  for (InspvaxStream* stream : {&s.inspvax, &s.inspvax_beside})
    for (InspvaxMessage& message : stream->messages) message.sample.stamp_ns += inspvax;
  for (formats::StampedSigma& error : s.insstdev.messages) error.stamp_ns += inspvax;
  // Fixes and attitudes of one device have one clock: moved apart they would not be of one moment any more.
  for (ImuMessage& message : s.attitude.messages) message.header.stamp_ns += device;
  for (FixMessage& message : s.position.messages) message.header.stamp_ns += device;
  for (FixMessage& message : s.gnss.messages) message.header.stamp_ns += gnss;
  for (ImuMessage& message : s.imu.messages) message.header.stamp_ns += imu;
  const auto report = [&](const std::optional<std::size_t>& topic, const StreamClock& stream, std::int64_t by_ns) {
    if (!topic || stream.readings.empty()) return;
    const std::string where = bag.files().front().string() + ": " + bag.topics()[*topic].name;
    if (by_ns != 0)
      report_shift(by_ns, stream, lidar_stream, where, findings);
    else
      report_offset(stream, lidar, where, findings);
  };
  // One of these at most is there.
  report(roles.ins, s.ins_poses.clock, poses);
  report(roles.ins, s.inspvax.clock, inspvax);
  report(roles.ins, s.attitude.clock, device);
  if (roles.gnss != roles.ins_position) report(roles.gnss, s.gnss.clock, gnss);
  if (roles.imu != roles.ins) report(roles.imu, s.imu.clock, imu);
}

}  // namespace remount::bags
