#include "model/pipeline/input_checks.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "algorithms/calibration/method_details.h"
#include "algorithms/core/error.h"
#include "algorithms/geodesy/earth_radius.h"
#include "algorithms/messages/render.h"
#include "messages/general.h"
#include "messages/pipeline.h"
#include "model/conventions/clock_hint.h"
#include "model/conventions/impossible_motion.h"
#include "model/formats/files/system_call.h"
#include "model/method_registry/method_needs.h"
#include "model/results/deciding_notes.h"

namespace remount::pipeline {
namespace {

bool same_place(const drive::Session& a, const drive::Session& b) {
  if (a.path.empty() || b.path.empty()) return false;
  std::error_code failure;
  return std::filesystem::equivalent(a.path, b.path, failure);
}

/// The first and the last scan whose stamps both have, as indices into a and b.
std::vector<std::pair<std::size_t, std::size_t>> shared_stamps(const drive::ScanSource& a, const drive::ScanSource& b) {
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    if (a.stamp_ns(i) == b.stamp_ns(k)) {
      if (ends.size() == 2) ends.pop_back();
      ends.emplace_back(i, k);
    }
    a.stamp_ns(i) < b.stamp_ns(k) ? ++i : ++k;
  }
  return ends;
}

bool same_points(const drive::ScanSource& a, std::size_t scan_a, const drive::ScanSource& b, std::size_t scan_b) {
  try {
    const cloud::PointCloud first = a.load(scan_a), second = b.load(scan_b);
    return !first.points.empty() && first.points == second.points;
  } catch (const Error&) {
    return false;  // reported where the scans are used
  }
}

bool same_scans(const drive::ScanSource& a, const drive::ScanSource& b) {
  if (a.size() == 0 || b.size() == 0) return false;
  for (const auto& [i, k] : shared_stamps(a, b))
    if (same_points(a, i, b, k)) return true;
  // The same scans under other stamps are no new evidence either.
  return a.size() == b.size() && same_points(a, 0, b, 0);
}

bool equal(const motion::StampedPose& a, const motion::StampedPose& b) { return a.pose.matrix() == b.pose.matrix(); }
/// But for what is lost where a log is written in another format.
bool equal(const motion::InsSample& a, const motion::InsSample& b) {
  constexpr double kRounded_rad = 1e-9, kRounded_m = 1e-3, kRoundedAttitude_rad = 1e-6;
  return std::abs(a.latitude_rad - b.latitude_rad) < kRounded_rad &&
         std::abs(a.longitude_rad - b.longitude_rad) < kRounded_rad && std::abs(a.height_m - b.height_m) < kRounded_m &&
         a.enu_from_ins.angularDistance(b.enu_from_ins) < kRoundedAttitude_rad;
}

/// More than an INS at rest scatters: what stands still shares its place with every other recording of that place, and
/// says nothing of X either.
bool apart(double distance_m, double angle_rad) { return distance_m > 0.05 || angle_rad > degrees_to_radians(0.3); }
bool are_apart(const motion::StampedPose& a, const motion::StampedPose& b) {
  return apart((a.pose.translation() - b.pose.translation()).norm(), rotation_angle_between_rad(a.pose, b.pose));
}
bool are_apart(const motion::InsSample& a, const motion::InsSample& b) {
  const double north_m = geodesy::kEarthRadius_m * (a.latitude_rad - b.latitude_rad),
               east_m = geodesy::kEarthRadius_m * std::cos(a.latitude_rad) * (a.longitude_rad - b.longitude_rad);
  return apart(std::hypot(north_m, east_m, a.height_m - b.height_m), a.enu_from_ins.angularDistance(b.enu_from_ins));
}

/// Most poses of the stamps that both have are equal. Drives whose stamps count from their start share stamps, and the
/// pose in which they rest at first.
template <class Posed>
bool same_motion(const std::vector<Posed>& a, const std::vector<Posed>& b) {
  constexpr std::size_t kMany = 10;
  std::size_t shared = 0, same = 0, first_same = 0;
  bool has_moved = false;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    if (a[i].stamp_ns == b[k].stamp_ns) {
      ++shared;
      if (equal(a[i], b[k])) {
        if (same++ == 0) first_same = i;
        has_moved = has_moved || are_apart(a[i], a[first_same]);
      }
    }
    a[i].stamp_ns < b[k].stamp_ns ? ++i : ++k;
  }
  return has_moved && (shared < kMany ? same == shared : same >= kMany && 10 * same >= 9 * shared);
}

/// Scans of the same times beside the same INS, whatever they hold: one copy may have been rounded, thinned or cropped.
/// Parts of a drive that share its INS log have scans of other times.
bool same_times_of_one_drive(const drive::Session& a, const drive::Session& b) {
  const bool two_scans_share_stamps = shared_stamps(*a.scans, *b.scans).size() == 2;  // the first and the last that do
  return two_scans_share_stamps && (same_motion(a.ins, b.ins) || same_motion(a.world_from_ins, b.world_from_ins));
}

void check_same_axes(const drive::Session& first, const drive::Session& other) {
  if (!first.ins_axes || !other.ins_axes || *first.ins_axes == *other.ins_axes) return;
  if (first.ins_axes_by_travel != other.ins_axes_by_travel) return;  // a drive too short to tell is of the same INS
  throw Error(ErrorCode::Contract, drive::path_or_name(other),
              say::pipeline_other_axes(std::string(to_string(*other.ins_axes)), drive::path_or_name(first),
                                       std::string(to_string(*first.ins_axes))));
}

/// With those of the settings of pairs that a pair must meet.
Message no_pair(std::size_t keyframes, const motion::PairingOptions& options) {
  const Duration gap{options.max_gap_s};
  const Length apart{options.max_distance_m}, moved{options.min_distance_m};
  const Angle turned{degrees_to_radians(options.min_rotation_deg)};
  if (options.limit == motion::PairLimit::Time) return say::pipeline_no_pair_in_time(keyframes, gap, moved, turned);
  if (options.limit == motion::PairLimit::Distance)
    return say::pipeline_no_pair_in_distance(keyframes, apart, moved, turned);
  return say::pipeline_no_pair_in_either(keyframes, gap, apart, moved, turned);
}

}  // namespace

bool same_recording(const drive::Session& a, const drive::Session& b) {
  if (same_place(a, b)) return true;
  if (a.scans && b.scans) return same_scans(*a.scans, *b.scans) || same_times_of_one_drive(a, b);
  return same_motion(a.odometry_from_lidar, b.odometry_from_lidar);
}

PipelineInput with_possible_motion(PipelineInput input) {
  input.sessions = conventions::possible_sessions(std::move(input.sessions));
  return input;
}

void check_sessions(const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  method_registry::require_served(method_registry::calibration_method(calibration::kPairwise), sessions);
  check_companions(sessions);
}

void check_companions(const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  for (std::size_t i = 0; i < sessions.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) check_same_axes(*sessions[k], *sessions[i]);
  for (std::size_t i = 0; i < sessions.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (same_recording(*sessions[k], *sessions[i]))
        throw Error(ErrorCode::Contract, drive::path_or_name(*sessions[i]),
                    say::pipeline_same_recording(drive::path_or_name(*sessions[k])));
}

Message why_not_covered(const DriveMotion& motion, motion::SessionIndex session) {
  const std::vector<std::int64_t> stamps = motion.lidar_stamps_ns(session);
  const auto& samples = motion.track(session).samples();
  const conventions::TimeSpan lidar{stamps.front(), stamps.back()},
      ins{samples.front().stamp_ns, samples.back().stamp_ns};
  if (lidar.last_ns < ins.first_ns || lidar.first_ns > ins.last_ns) return conventions::time_spans_apart(lidar, ins);
  return say::pipeline_in_gaps();
}

// The default spacing is nobody's wish; one that was set larger is not given up without a word.
void report_closer_keyframes(const drive::Session& session, const motion::KeyframeOptions& options,
                             std::size_t asked_for, std::size_t chosen, std::vector<drive::Finding>& findings) {
  const motion::KeyframeOptions usual;
  const bool by_time = options.mode == motion::KeyframeMode::Time;
  const bool set = by_time ? options.interval_s > usual.interval_s
                           : options.distance_m > usual.distance_m || options.rotation_deg > usual.rotation_deg;
  if (!set || chosen <= asked_for) return;
  const Message spacing = by_time ? say::pipeline_spacing_time(Duration{options.interval_s})
                                  : say::pipeline_spacing_distance(Length{options.distance_m},
                                                                   Angle{degrees_to_radians(options.rotation_deg)});
  findings.push_back({drive::Severity::Note, results::kCloserKeyframes, session.name,
                      say::pipeline_closer_keyframes(spacing, asked_for, chosen)});
}

calibration::CalibrationResult result_without_pairs(const DriveMotion& motion,
                                                    const std::vector<motion::Keyframe>& keyframes,
                                                    const settings::Settings& settings) {
  calibration::CalibrationResult result;
  if (keyframes.empty()) {
    std::vector<Message> causes;
    for (motion::SessionIndex s; s < motion.session_count(); ++s)
      causes.push_back(say::of_file(motion.session(s).name, why_not_covered(motion, s)));
    result.conclude(calibration::Status::NoUsableData, say::pipeline_no_scan_covered(causes));
    result.advice.push_back(say::pipeline_give_same_time());
    return result;
  }
  result.conclude(calibration::Status::TooFewPairs, no_pair(keyframes.size(), settings.pairing));
  double travelled_m = 0.0;  // the farthest of all sessions
  for (const motion::Keyframe& keyframe : keyframes) travelled_m = std::max(travelled_m, keyframe.travelled_m);
  if (keyframes.size() == 1)
    result.advice.push_back(settings.keyframes.mode == motion::KeyframeMode::Time
                                ? say::pipeline_one_keyframe_by_time()
                                : say::pipeline_one_keyframe_by_distance());
  else if (travelled_m < settings.pairing.min_distance_m)
    result.advice.push_back(say::pipeline_stands_still());
  else
    result.advice.push_back(say::pipeline_widen_pairing());
  return result;
}

calibration::CalibrationResult result_without_scans(std::size_t scans, const Message& first) {
  calibration::CalibrationResult result;
  result.conclude(calibration::Status::NoUsableData, say::pipeline_no_scan_readable(scans, first));
  result.advice.push_back(say::pipeline_copy_scans_again());
  return result;
}

void refuse_vanished(const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  for (const auto& session : sessions)
    if (!session->files.empty() && !formats::status_of(session->files.front()))
      throw Error(ErrorCode::Io, session->path.string(), say::pipeline_vanished());
}

Message all_scans_unreadable(const std::vector<KeyframeObjects>& objects,
                             const std::vector<motion::Keyframe>& keyframes, const std::vector<motion::Pair>& pairs,
                             const DriveMotion& motion, std::size_t& scans) {
  std::vector<bool> used(objects.size(), false);
  for (const motion::Pair& pair : pairs) used[pair.keyframe_a] = used[pair.keyframe_b] = true;
  Message first;
  scans = 0;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (!used[k] || !motion.session(keyframes[k].session).scans) continue;
    if (objects[k].failure.empty()) return {};
    if (scans++ == 0) first = objects[k].failure;
  }
  return first;
}

}  // namespace remount::pipeline
