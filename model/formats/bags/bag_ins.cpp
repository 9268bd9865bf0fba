#include "model/formats/bags/bag_ins.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/stamps.h"
#include "algorithms/messages/render.h"
#include "messages/bags.h"
#include "messages/general.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/bags/bag_clocks.h"
#include "model/formats/bags/bag_driver_axes.h"
#include "model/formats/bags/bag_nmea.h"
#include "model/formats/bags/bag_novatel.h"
#include "model/formats/bags/correction_status.h"
#include "model/formats/bags/ins_messages.h"
#include "model/formats/ins/position_lag_prior.h"
#include "model/formats/ins/samples_between_fixes.h"

namespace remount::bags {
namespace {

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

std::vector<motion::InsSample> ins_at_fixes(const FixStream& fixes,
                                            const std::vector<formats::StampedAttitude>& attitudes,
                                            const std::string& where, drive::Session& session) {
  const double longest_s = formats::longest_turn_s(attitudes);
  const bool tells_augmentation = std::ranges::any_of(fixes.messages, [](auto& fix) { return fix.status == 2; });
  std::vector<motion::InsSample> ins;
  std::size_t without_fix = 0, alone = 0, of_one_stamp = 0;
  for (const FixMessage& fix : fixes.messages) {
    if (fix.status < 0) {
      ++without_fix;
      continue;
    }
    const std::int64_t stamp_ns = fix.header.stamp_ns;
    const auto attitude = formats::attitude_at(attitudes, stamp_ns, longest_s);
    if (!attitude) {
      ++alone;
      continue;
    }
    of_one_stamp += attitude->of_this_stamp;
    motion::InsSample sample;
    sample.stamp_ns = stamp_ns;
    sample.latitude_rad = fix.latitude_rad;
    sample.longitude_rad = fix.longitude_rad;
    sample.height_m = fix.height_m;
    sample.enu_from_ins = attitude->enu_from_ins;
    if (fix.covariance_enu_m2) sample.sigma.position_enu_m = fix.covariance_enu_m2->diagonal().cwiseSqrt();
    sample.sigma.attitude_rad = attitude->sigma_rad;
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

/// Gives a session the motion that the chosen topics hold, step by step.
class MotionOfBag {
 public:
  MotionOfBag(const BagFile& bag, const ChosenTopics& chosen, BagStreams& streams, drive::Session& session)
      : bag_(bag), chosen_(chosen), roles_(chosen.roles), s_(streams), session_(session) {}

  void keep_best_fixes() {
    if (roles_.ins_position) keep_best_of_each_stamp(s_.position, place(*roles_.ins_position), session_.findings);
    if (!roles_.gnss) return;
    std::vector<drive::Finding> told_already;
    const bool told = roles_.gnss == roles_.ins_position;
    keep_best_of_each_stamp(s_.gnss, place(*roles_.gnss), told ? told_already : session_.findings);
  }

  void add_motion() {
    if (!roles_.ins) return;
    if (is_pose(kind_of(*roles_.ins)))
      add_poses();
    else if (!s_.ins_sentences.empty())
      add_sentences();
    else
      add_samples();
    if (session_.ins.empty() && session_.world_from_ins.empty()) tell_unusable();
  }

  void add_others() {
    if (roles_.ins_position) report_lost_corrections(s_.position, place(*roles_.ins_position), session_.findings);
    if (roles_.gnss && roles_.gnss != roles_.ins_position)
      report_lost_corrections(s_.gnss, place(*roles_.gnss), session_.findings);
    if (is_sbg_nav(roles_.gnss)) settle_sbg_errors(sbg_enu_, s_.gnss);
    if (roles_.gnss) add_gnss(s_.gnss, place(*roles_.gnss), session_);
    if (!s_.gnss_sentences.empty())
      add_nmea_fixes(s_.gnss_sentences, place(*roles_.gnss), roles_.gnss == roles_.ins, session_);
    if (roles_.imu) add_imu(s_.imu, place(*roles_.imu), session_);
  }

 private:
  std::string place(std::size_t topic) const {
    return bag_.files().front().string() + ": " + bag_.topics()[topic].name;
  }
  MessageKind kind_of(std::size_t topic) const { return message_kind(bag_.topics()[topic].type); }
  bool is_sbg_nav(const std::optional<std::size_t>& topic) const {
    return topic && kind_of(*topic) == MessageKind::SbgNav;
  }
  void tell_slow(double period_s) const {
    report_slow(period_s, chosen_.faster, place(*roles_.ins), session_.findings);
  }

  void add_poses() {
    session_.world_from_ins = std::move(s_.ins_poses.world_from_child);
    const MessageKind kind = kind_of(*roles_.ins);
    if (kind != MessageKind::Odometry) session_.ins_axes.reset();
    if (is_apollo_pose(kind)) session_.ins_axes = drive::InsAxes::RightForwardUp;
    report_lost_corrections(s_.position_types, place(*roles_.ins), session_.findings);
    if (!session_.world_from_ins.empty())
      drive::keep_ascending(session_.world_from_ins, "ins", place(*roles_.ins), session_.findings);
    tell_slow(drive::median_period_s(session_.world_from_ins));
  }

  void add_sentences() {
    add_nmea_ins(s_.ins_sentences, place(*roles_.ins), session_);
    tell_slow(drive::median_period_s(session_.ins));
  }

  /// Of whole solutions, or of attitudes at the fixes of another topic.
  void add_samples() {
    const MessageKind kind = kind_of(*roles_.ins);
    const bool whole = is_solution(kind);
    if (is_inspva(kind)) session_.ins_axes = drive::InsAxes::RightForwardUp;
    std::vector<formats::StampedAttitude> attitudes;
    if (!whole) attitudes = attitudes_of(s_.attitude, place(*roles_.ins), session_.findings);
    session_.ins = whole ? ins_from_inspvax(s_, kind, place(*roles_.ins), session_.findings)
                         : ins_at_fixes(s_.position, attitudes, place(*roles_.ins), session_);
    if (!session_.ins.empty()) {
      drive::keep_near(session_.ins, place(*roles_.ins), session_.findings);
      drive::keep_ascending(session_.ins, "ins", place(*roles_.ins), session_.findings);
      settle_axes(kind, attitudes);
    }
    tell_slow(drive::median_period_s(session_.ins));
    formats::SamplesBetweenFixes between = formats::samples_between_fixes(std::move(session_.ins), attitudes);
    session_.ins = std::move(between.ins);
    session_.ins_fix_stamps_ns = std::move(between.fix_stamps_ns);
    if (!whole && roles_.ins_position) report_antenna(bag_, roles_, place(*roles_.ins_position), session_.findings);
  }

  void settle_axes(MessageKind kind, std::vector<formats::StampedAttitude>& attitudes) {
    std::optional<bool> enu;
    if (has_open_axes(kind)) enu = settle_driver_axes(kind, place(*roles_.ins), attitudes, session_);
    if (kind == MessageKind::SbgQuat || kind == MessageKind::SbgEuler) sbg_enu_ = enu;
    if (!is_solution(kind) && is_sbg_nav(roles_.ins_position)) settle_sbg_errors(sbg_enu_, session_.ins);
  }

  void tell_unusable() {
    Message why = why_no_ins(roles_, s_, session_.findings);
    if (session_.topic_choice.contains("ins")) throw Error(ErrorCode::Format, place(*roles_.ins), std::move(why));
    // Nobody asked for it: what else the bag has is still worth knowing.
    session_.findings.push_back(
        drive::make_finding(drive::Severity::Problem, "ins-unusable", place(*roles_.ins), std::move(why)));
  }

  const BagFile& bag_;
  const ChosenTopics& chosen_;
  const TopicRoles& roles_;
  BagStreams& s_;
  drive::Session& session_;
  std::optional<bool> sbg_enu_;  ///< whether SBG's driver counts from east and up; nothing: not known
};

}  // namespace

void add_ins(const BagFile& bag, const ChosenTopics& chosen, BagStreams& s, drive::Session& session) {
  share_lidar_clock(bag, chosen.roles, s, session.findings);
  MotionOfBag motion(bag, chosen, s, session);
  motion.keep_best_fixes();
  motion.add_motion();
  motion.add_others();
}

}  // namespace remount::bags
