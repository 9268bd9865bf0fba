#include "model/formats/bags/bag_ins.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/messages/render.h"
#include "messages/bags.h"
#include "messages/general.h"
#include "model/conventions/clock_hint.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/bags/bag_driver_axes.h"
#include "model/formats/bags/bag_nmea.h"
#include "model/formats/bags/bag_novatel.h"
#include "model/formats/bags/correction_status.h"
#include "model/formats/bags/ins_messages.h"
#include "model/formats/ins/position_lag_prior.h"
#include "model/formats/ins/samples_between_fixes.h"

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

Eigen::Vector3d sigma_of(const Eigen::Vector3d& variance) {
  return variance.minCoeff() > 0.0 ? Eigen::Vector3d(variance.cwiseSqrt())
                                   : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

/// Nothing but the identity is a field that nobody fills in.
bool all_are_default(const ImuStream& stream) {
  return std::none_of(stream.messages.begin(), stream.messages.end(),
                      [](const ImuMessage& message) { return message.orientation && !message.orientation_is_default; });
}

std::vector<formats::StampedAttitude> attitudes_of(const ImuStream& stream, const std::string& where,
                                                   std::vector<drive::Finding>& findings) {
  std::vector<formats::StampedAttitude> attitudes;
  if (all_are_default(stream)) return attitudes;
  std::size_t without = 0, before = 0;
  for (const ImuMessage& message : stream.messages) {
    if (!message.orientation) {
      ++without;
      before += attitudes.empty();
      continue;
    }
    // Glitches of the clock would make neighbours of what is far apart.
    if (!attitudes.empty() && message.header.stamp_ns <= attitudes.back().stamp_ns) continue;
    attitudes.push_back({message.header.stamp_ns, *message.orientation, sigma_of(message.orientation_variance_rad2)});
  }
  if (without > 0)  // a driver that publishes before the INS has aligned is as it should be
    findings.push_back(drive::make_finding(without == before ? drive::Severity::Note : drive::Severity::Warning,
                                           "no-orientation", where, say::bag_without_orientation(without, before)));
  return attitudes;
}

constexpr double kAssumedSigma_m = 1.0;  ///< of a fix that does not say

motion::GnssFix gnss_of(const FixMessage& message) {
  motion::GnssFix fix{message.header.stamp_ns, message.latitude_rad, message.longitude_rad, message.height_m, {}};
  fix.covariance_enu_m2 =
      message.covariance_enu_m2.value_or(kAssumedSigma_m * kAssumedSigma_m * Eigen::Matrix3d::Identity());
  return fix;
}

void add_gnss(const FixStream& stream, const std::string& where, drive::Session& session) {
  std::size_t unknown = 0, without_fix = 0;
  for (const FixMessage& message : stream.messages) {
    if (message.status < 0) {
      ++without_fix;
      continue;
    }
    unknown += !message.covariance_enu_m2;
    session.gnss.push_back(gnss_of(message));
  }
  if (without_fix > 0)
    session.findings.push_back(
        drive::make_finding(drive::Severity::Note, "no-fix", where, say::bag_without_fix(without_fix)));
  if (unknown > 0)
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "gnss-covariance-unknown", where,
                                                   say::bag_covariance_unknown(unknown, Length{kAssumedSigma_m})));
  drive::keep_near(session.gnss, where, session.findings);
  if (!session.gnss.empty()) drive::keep_ascending(session.gnss, "gnss", where, session.findings);
}

void add_imu(const ImuStream& stream, const std::string& where, drive::Session& session) {
  const Eigen::Vector3d unknown = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::size_t denied = 0, without = 0;
  for (const ImuMessage& message : stream.messages) {
    if (!message.angular_rate_radps) {
      ++without;
      continue;
    }
    denied += message.denied;
    session.imu.push_back(
        {message.header.stamp_ns, *message.angular_rate_radps, message.acceleration_mps2.value_or(unknown)});
  }
  if (denied > 0)
    session.findings.push_back(
        drive::make_finding(drive::Severity::Note, "rates-denied", where, say::bag_rates_denied(denied)));
  if (without > 0)
    session.findings.push_back(
        drive::make_finding(drive::Severity::Note, "no-rates", where, say::bag_without_rates(without)));
  if (!session.imu.empty()) return drive::keep_ascending(session.imu, "imu", where, session.findings);
  if (session.topic_choice.contains("imu") && !stream.messages.empty())
    throw Error(ErrorCode::Format, where, say::bag_no_rates());
}

/// Of the positions that there are: what has no fix is counted elsewhere.
void report_lost_corrections(const FixStream& stream, const std::string& where, std::vector<drive::Finding>& findings) {
  std::vector<CorrectionStatus> positions;
  for (const FixMessage& message : stream.messages)
    if (message.status >= 0) positions.push_back(correction_status(message));
  report_lost_corrections(positions, where, findings);
}

/// Of fixes with one stamp the best by what the receiver says of them.
void keep_best_of_each_stamp(FixStream& stream, const std::string& where, std::vector<drive::Finding>& findings) {
  const auto is_better = [](const FixMessage& later, const FixMessage& first) {
    if (later.status != first.status) return later.status > first.status;
    const auto variance_m2 = [](const FixMessage& fix) {
      return fix.covariance_enu_m2 ? fix.covariance_enu_m2->trace() : std::numeric_limits<double>::infinity();
    };
    return 4.0 * variance_m2(later) < variance_m2(first);
  };
  std::size_t repeated = 0;
  std::vector<FixMessage> kept;
  kept.reserve(stream.messages.size());
  for (FixMessage& fix : stream.messages) {
    const bool again = !kept.empty() && kept.back().header.stamp_ns == fix.header.stamp_ns;
    repeated += again;
    if (!again)
      kept.push_back(std::move(fix));
    else if (is_better(fix, kept.back()))
      kept.back() = std::move(fix);
  }
  stream.messages = std::move(kept);
  drive::report_one_stamp(repeated, true, "gnss", where, findings);
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

namespace {

std::vector<motion::InsSample> ins_at_fixes(const FixStream& fixes,
                                            const std::vector<formats::StampedAttitude>& attitudes,
                                            const std::string& where, drive::Session& session) {
  const double longest_gap_s = std::max(0.05, 3.0 * drive::median_period_s(attitudes));
  const bool tells_augmentation = std::ranges::any_of(fixes.messages, [](auto& fix) { return fix.status == 2; });
  std::vector<motion::InsSample> ins;
  std::size_t without_fix = 0, alone = 0, of_one_stamp = 0;
  for (const FixMessage& fix : fixes.messages) {
    if (fix.status < 0) {
      ++without_fix;
      continue;
    }
    const std::int64_t stamp_ns = fix.header.stamp_ns;
    const auto after = std::ranges::lower_bound(attitudes, stamp_ns, {}, &formats::StampedAttitude::stamp_ns);
    const bool exact = after != attitudes.end() && after->stamp_ns == stamp_ns;
    const auto before = exact || after == attitudes.begin() ? after : after - 1;
    if (after == attitudes.end() || (!exact && after == attitudes.begin()) ||
        seconds(after->stamp_ns - before->stamp_ns) > longest_gap_s) {
      ++alone;
      continue;
    }
    const double share = exact ? 0.0
                               : static_cast<double>(stamp_ns - before->stamp_ns) /
                                     static_cast<double>(after->stamp_ns - before->stamp_ns);
    of_one_stamp += exact;
    motion::InsSample sample;
    sample.stamp_ns = stamp_ns;
    sample.latitude_rad = fix.latitude_rad;
    sample.longitude_rad = fix.longitude_rad;
    sample.height_m = fix.height_m;
    sample.enu_from_ins = before->enu_from_ins.slerp(share, after->enu_from_ins).normalized();
    if (fix.covariance_enu_m2) sample.sigma.position_enu_m = fix.covariance_enu_m2->diagonal().cwiseSqrt();
    sample.sigma.attitude_rad = after->sigma_rad;
    if (tells_augmentation) sample.quality = fix.status == 2 ? motion::InsQuality::Good : motion::InsQuality::Degraded;
    ins.push_back(sample);
  }
  session.ins_position_lag_sigma_s = formats::position_lag_sigma_s(ins.size(), of_one_stamp);
  if (without_fix + alone > 0)
    session.findings.push_back(drive::make_finding(drive::Severity::Warning, "ins-incomplete", where,
                                                   say::bag_ins_incomplete(without_fix, alone)));
  return ins;
}

/// Why messages were left out, of each stream; empty where none were.
std::vector<Message> what_was_bad(const std::vector<drive::Finding>& findings) {
  std::vector<Message> why;
  for (const drive::Finding& finding : findings)
    if (finding.code == "bad-messages") why.push_back(say::of_place(finding.where.words(), finding.explanation));
  return why;
}

void report_slow(double period_s, const std::optional<FasterTopic>& faster, const std::string& where,
                 std::vector<drive::Finding>& findings) {
  if (!(period_s > 0.21)) return;
  constexpr Frequency kGoodRate{10.0};
  Message remedy = faster ? say::bag_faster_topic(faster->name, Frequency{faster->rate_hz}, std::string(faster->role))
                          : say::bag_no_faster_topic(kGoodRate);
  findings.push_back(
      drive::make_finding(drive::Severity::Warning, "ins-slow", where,
                          Message::sequence({say::bag_ins_slow(Duration{period_s}), std::move(remedy)})));
}

/// An INS gives the positions of its own origin; a receiver those of its antenna, and how far that is from the origin
/// shows in no residual.
void report_antenna(const BagFile& bag, const TopicRoles& roles, const std::string& where,
                    std::vector<drive::Finding>& findings) {
  if (of_one_device(bag.topics()[*roles.ins_position].name, bag.topics()[*roles.ins].name)) return;
  findings.push_back(
      drive::make_finding(drive::Severity::Warning, "antenna-position", where, say::bag_antenna_position()));
}

/// What a topic that gives no INS lacks; empty where that is not known.
Message what_is_missing(const TopicRoles& roles, const BagStreams& s) {
  const std::vector<ImuMessage>& messages = s.attitude.messages;
  if (messages.empty()) return {};
  if (!std::any_of(messages.begin(), messages.end(), [](const ImuMessage& m) { return m.orientation.has_value(); }))
    return say::bag_none_is_oriented();
  if (all_are_default(s.attitude)) return say::bag_orientation_not_filled();
  return roles.ins_position ? Message() : say::bag_orientation_without_fixes();
}

Message why_no_ins(const TopicRoles& roles, const BagStreams& s, const std::vector<drive::Finding>& findings) {
  Message missing = what_is_missing(roles, s);
  Message why = missing.empty() ? say::bag_no_usable_ins() : say::bag_no_usable_ins_because(std::move(missing));
  std::vector<Message> bad = what_was_bad(findings);
  return bad.empty() ? why : say::bag_ins_and_bad_messages(std::move(why), std::move(bad));
}

}  // namespace

void add_ins(const BagFile& bag, const ChosenTopics& chosen, BagStreams& s, drive::Session& session) {
  const TopicRoles& roles = chosen.roles;
  const std::string file = bag.files().front().string();
  const auto place = [&](std::size_t topic) { return file + ": " + bag.topics()[topic].name; };
  const auto is_sbg_nav = [&](const std::optional<std::size_t>& topic) {
    return topic && message_kind(bag.topics()[*topic].type) == MessageKind::SbgNav;
  };
  std::optional<bool> sbg_enu;  // nothing: not known
  share_lidar_clock(bag, roles, s, session.findings);
  if (roles.ins_position) keep_best_of_each_stamp(s.position, place(*roles.ins_position), session.findings);
  if (roles.gnss) {
    std::vector<drive::Finding> told_already;
    const bool told = roles.gnss == roles.ins_position;
    keep_best_of_each_stamp(s.gnss, place(*roles.gnss), told ? told_already : session.findings);
  }
  if (roles.ins && is_pose(message_kind(bag.topics()[*roles.ins].type))) {
    session.world_from_ins = std::move(s.ins_poses.world_from_child);
    if (message_kind(bag.topics()[*roles.ins].type) != MessageKind::Odometry) session.ins_axes.reset();
    if (!session.world_from_ins.empty())
      drive::keep_ascending(session.world_from_ins, "ins", place(*roles.ins), session.findings);
    report_slow(drive::median_period_s(session.world_from_ins), chosen.faster, place(*roles.ins), session.findings);
  } else if (!s.ins_sentences.empty()) {
    add_nmea_ins(s.ins_sentences, place(*roles.ins), session);
    report_slow(drive::median_period_s(session.ins), chosen.faster, place(*roles.ins), session.findings);
  } else if (roles.ins) {
    const MessageKind kind = message_kind(bag.topics()[*roles.ins].type);
    const bool inspvax = is_solution(kind);
    if (is_inspva(kind)) session.ins_axes = drive::InsAxes::RightForwardUp;
    std::vector<formats::StampedAttitude> attitudes =
        inspvax ? std::vector<formats::StampedAttitude>()
                : attitudes_of(s.attitude, place(*roles.ins), session.findings);
    session.ins = inspvax ? ins_from_inspvax(s, kind, place(*roles.ins), session.findings)
                          : ins_at_fixes(s.position, attitudes, place(*roles.ins), session);
    if (!session.ins.empty()) {
      drive::keep_near(session.ins, place(*roles.ins), session.findings);
      drive::keep_ascending(session.ins, "ins", place(*roles.ins), session.findings);
      std::optional<bool> enu;
      if (has_open_axes(kind)) enu = settle_driver_axes(kind, place(*roles.ins), attitudes, session);
      if (kind == MessageKind::SbgQuat || kind == MessageKind::SbgEuler) sbg_enu = enu;
      if (!inspvax && is_sbg_nav(roles.ins_position)) settle_sbg_errors(sbg_enu, session.ins);
    }
    report_slow(drive::median_period_s(session.ins), chosen.faster, place(*roles.ins), session.findings);
    formats::SamplesBetweenFixes whole = formats::samples_between_fixes(std::move(session.ins), attitudes);
    session.ins = std::move(whole.ins);
    session.ins_fix_stamps_ns = std::move(whole.fix_stamps_ns);
    if (!inspvax && roles.ins_position) report_antenna(bag, roles, place(*roles.ins_position), session.findings);
  }
  if (roles.ins && session.ins.empty() && session.world_from_ins.empty()) {
    Message why = why_no_ins(roles, s, session.findings);
    if (session.topic_choice.contains("ins")) throw Error(ErrorCode::Format, place(*roles.ins), std::move(why));
    // Nobody asked for it: what else the bag has is still worth knowing.
    session.findings.push_back(
        drive::make_finding(drive::Severity::Problem, "ins-unusable", place(*roles.ins), std::move(why)));
  }
  if (roles.ins_position) report_lost_corrections(s.position, place(*roles.ins_position), session.findings);
  if (roles.gnss && roles.gnss != roles.ins_position)
    report_lost_corrections(s.gnss, place(*roles.gnss), session.findings);
  if (is_sbg_nav(roles.gnss)) settle_sbg_errors(sbg_enu, s.gnss);
  if (roles.gnss) add_gnss(s.gnss, place(*roles.gnss), session);
  if (!s.gnss_sentences.empty()) add_nmea_fixes(s.gnss_sentences, place(*roles.gnss), roles.gnss == roles.ins, session);
  if (roles.imu) add_imu(s.imu, place(*roles.imu), session);
}

}  // namespace remount::bags
