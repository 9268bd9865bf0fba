// The calibration of a slewing machine from three recordings: ground, swept arm, full turn. docs/maths/slew.md
#include "model/methods/slew/slew_method.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "algorithms/calibration/slew/slew.h"
#include "algorithms/calibration/slew/slew_turn.h"
#include "algorithms/cloud/deskew.h"
#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "algorithms/motion/motion_track.h"
#include "messages/methods.h"
#include "messages/places.h"
#include "messages/stages.h"
#include "model/methods/calibrate.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/scan_times.h"
#include "model/results/deciding_notes.h"

namespace remount::methods {
namespace {

enum Role { kGround, kArm, kTurn, kRoles };
constexpr const char* kRoleNames[] = {"ground", "arm", "turn"};  // in settings, and in names of sessions
constexpr Message (*kRoleWords[])() = {say::slew_ground, say::slew_arm, say::slew_turn};
using Recordings = std::array<const drive::Session*, kRoles>;

// Whole words, as in "full turn", "turn_2" and "FullTurn": an "alarm" is no arm.
bool is_named(const drive::Session& session, const char* word) {
  std::string read;
  bool was_small = false;
  // Drives of one source may all be called the same; their folders are not.
  for (const char each : session.name + " " + session.path.filename().string() + " ") {
    const auto c = static_cast<unsigned char>(each);
    const bool letter = std::isalpha(c) != 0;
    if (!letter || (std::isupper(c) && was_small)) {
      if (read == word) return true;
      read.clear();
    }
    if (letter) read += static_cast<char>(std::tolower(c));
    was_small = std::islower(c) != 0;
  }
  return false;
}

// By the settings, else by name ("ground", "arm", "turn" in it), else by order: ground, arm, turn; or arm, turn.
Recordings recordings_of(const pipeline::PipelineInput& input) {
  const calibration::SlewOptions& options = input.settings.slew;
  const int chosen[] = {options.ground_session, options.arm_session, options.turn_session};
  const auto count = static_cast<int>(input.sessions.size());
  Recordings recordings{};
  std::vector<const drive::Session*> rest;
  for (const auto& session : input.sessions) rest.push_back(session.get());
  const auto take = [&](int role, const drive::Session* session) {
    recordings[index_at(role)] = session;
    rest.erase(std::remove(rest.begin(), rest.end(), session), rest.end());
  };
  for (int role = 0; role < kRoles; ++role) {
    if (chosen[role] == 0) continue;
    if (chosen[role] > count)
      throw Error(ErrorCode::Contract, std::string("slew.") + kRoleNames[role] + "_session",
                  say::slew_no_such_session(chosen[role], count));
    take(role, input.sessions[index_at(chosen[role] - 1)].get());
  }
  for (int role = 0; role < kRoles; ++role) {
    if (recordings[index_at(role)]) continue;
    std::vector<const drive::Session*> named;
    for (const drive::Session* session : rest)
      if (is_named(*session, kRoleNames[role])) named.push_back(session);
    if (named.size() == 1) take(role, named.front());
  }
  for (int role = kRoles - 1; role >= 0 && !rest.empty(); --role)
    if (!recordings[index_at(role)]) take(role, rest.back());
  return recordings;
}

std::vector<cloud::PointCloud> load_some(const drive::Session& session, std::size_t most,
                                         std::vector<drive::Finding>& findings, const Progress& progress) {
  std::vector<cloud::PointCloud> clouds;
  if (!session.scans) return clouds;
  const std::size_t count = session.scans->size(), step = std::max<std::size_t>(1, (count + most - 1) / most);
  for (std::size_t i = 0; i < count && !progress.cancelled(); i += step) {
    try {
      clouds.push_back(session.scans->load(i));
    } catch (const Error& error) {
      findings.push_back({drive::Severity::Warning, "scan-unreadable", session.name, error.message()});
    }
  }
  return clouds;
}

std::vector<Eigen::Vector3d> ground_points(const drive::Session& session, const settings::Settings& settings,
                                           std::vector<drive::Finding>& findings, Progress& progress) {
  constexpr std::size_t kMostScans = 10, kMostPoints = 60'000;
  progress.report(say::stage_reading_the_ground, 0, 0);
  std::vector<Eigen::Vector3d> points;
  for (const cloud::PointCloud& cloud : load_some(session, kMostScans, findings, progress))
    for (const Eigen::Vector3f& point : cloud.points)
      if (point.norm() >= settings.registration.min_range_m && point.norm() <= settings.slew.ground_radius_m)
        points.push_back(point.cast<double>());
  if (points.size() <= kMostPoints) return points;
  std::vector<Eigen::Vector3d> thinned;
  for (std::size_t i = 0; i < kMostPoints; ++i) thinned.push_back(points[i * points.size() / kMostPoints]);
  return thinned;
}

std::vector<Eigen::Vector3d> arm_points(const drive::Session& session, const settings::Settings& settings,
                                        std::vector<drive::Finding>& findings, Progress& progress) {
  constexpr std::size_t kMostScans = 60;
  progress.report(say::stage_reading_the_arm, 0, 0);
  return calibration::moving_points(load_some(session, kMostScans, findings, progress), settings.slew.arm_reach_m);
}

bool is_distorted(const drive::Session& session, const settings::Settings& settings) {
  if (settings.run.deskew == settings::DeskewMode::Off) return false;
  return session.scan_timing == drive::ScanTiming::PerPoint ||
         (session.scan_timing == drive::ScanTiming::SweepAzimuth &&
          (session.sweep.certain || settings.run.deskew == settings::DeskewMode::On));
}

cloud::PointCloud compensated(const drive::Session& session, const cloud::PointCloud& cloud,
                              const motion::MotionTrack& first_from_lidar, std::int64_t stamp_ns,
                              settings::DeskewMode mode) {
  const auto passage = first_from_lidar.around(stamp_ns);
  const std::vector<float> times = pipeline::scan_times(session, cloud, mode);
  if (!passage || times.empty()) return cloud;
  const RigidTransform stamp_from_first = passage->pose().inverse();
  // At the ends of the turn the trajectory covers half a scan: the other half moves as that one does.
  return cloud::deskew(cloud, times, [&](double time_s) -> RigidTransform {
    if (const auto pose = passage->at(time_s)) return stamp_from_first * *pose;
    if (const auto mirrored = passage->at(-time_s)) return (stamp_from_first * *mirrored).inverse();
    return RigidTransform::Identity();
  });
}

// Poses relative to the first scan: at first as if scans were taken at once, then with the motion in them taken out.
void take_turn(const drive::Session& session, const settings::Settings& settings, std::vector<drive::Finding>& findings,
               Progress& progress, calibration::SlewData& data) {
  if (!session.scans) {
    for (const motion::StampedPose& pose : session.odometry_from_lidar)
      data.first_from_lidar.push_back(session.odometry_from_lidar.front().pose.inverse() * pose.pose);
    return;
  }
  constexpr std::size_t kMostScans = 100;
  const std::size_t count = session.scans->size(),
                    step = std::max<std::size_t>(1, (count + kMostScans - 1) / kMostScans);
  std::vector<std::int64_t> stamps_ns;
  for (std::size_t i = 0; i < count; i += step) stamps_ns.push_back(session.scans->stamp_ns(i));
  const calibration::LoadScan raw = [&](std::size_t i) { return session.scans->load(i * step); };
  calibration::TurnTrajectory turn = calibration::turn_trajectory(stamps_ns, raw, settings.registration, {}, progress);
  const int passes = is_distorted(session, settings) ? 2 : 0;
  for (int pass = 0; pass < passes && !progress.cancelled(); ++pass) {
    const motion::MotionTrack track(turn.first_from_lidar);
    const calibration::LoadScan undistorted = [&](std::size_t i) {
      return compensated(session, raw(i), track, stamps_ns[i], settings.run.deskew);
    };
    turn = calibration::turn_trajectory(stamps_ns, undistorted, settings.registration, turn.first_from_lidar, progress);
  }
  if (turn.failed > 0)
    findings.push_back({drive::Severity::Warning, "turn-scans", session.name,
                        say::slew_scans_not_aligned(turn.failed, stamps_ns.size(), turn.first_failure)});
  data.turn_scans = stamps_ns.size();
  data.turn_scans_failed = turn.failed;
  for (const motion::StampedPose& pose : turn.first_from_lidar) data.first_from_lidar.push_back(pose.pose);
}

// A ground that the method used, or left, although it leans.
void report_ground(const calibration::SlewResult& result, const calibration::SlewOptions& options,
                   std::vector<drive::Finding>& findings) {
  if (!result.ground.found) return;
  if (options.first_plane == calibration::FirstPlane::Turn) {
    if (result.ground_to_turn_rad > degrees_to_radians(options.max_plane_angle_deg))
      findings.push_back(
          {drive::Severity::Warning, "ground-tilted", say::place_ground(), say::slew_ground_not_square()});
    return;
  }
  if (!calibration::is_usable(result.calibration) || result.ground_lean_variance_rad2.isZero(0.0)) return;
  findings.push_back(
      {drive::Severity::Warning, "ground-tilted", say::place_ground(),
       say::slew_ground_leans(Angle{result.ground_to_turn_rad}, Angle{result.ground_to_turn_sigma_rad})});
}

// With its folder where others have the same name.
std::string known_name(const drive::Session& session, const std::vector<std::shared_ptr<const drive::Session>>& all) {
  const auto namesakes =
      std::count_if(all.begin(), all.end(), [&](const auto& other) { return other->name == session.name; });
  return namesakes > 1 ? session.name + " (" + session.path.filename().string() + ")" : session.name;
}

}  // namespace

pipeline::PipelineOutput run_slew(const pipeline::PipelineInput& given, Progress& progress) {
  const pipeline::PipelineInput input = pipeline::with_possible_motion(given);
  if (input.sessions.empty()) throw Error(ErrorCode::Contract, "", say::method_no_session());
  settings::require_valid(input.settings);
  refuse_measured(input.settings.measured, kSlewMethod.id, say::method_frame_machine());
  const Recordings recordings = recordings_of(input);
  if (!recordings[kTurn] || (!recordings[kTurn]->scans && recordings[kTurn]->odometry_from_lidar.empty()))
    throw Error(ErrorCode::Unsupported, recordings[kTurn] ? recordings[kTurn]->name : std::string(kSlewMethod.id),
                say::slew_no_turn());
  pipeline::PipelineOutput output;
  output.method = kSlewMethod.id;
  output.nominal_known = output.initial_known = input.nominal_ins_from_lidar.has_value();
  for (const auto& session : input.sessions)
    output.findings.insert(output.findings.end(), session->findings.begin(), session->findings.end());
  for (int role = 0; role < kRoles; ++role)
    if (const drive::Session* session = recordings[index_at(role)])
      output.findings.push_back({drive::Severity::Note, results::kRecording, known_name(*session, input.sessions),
                                 say::slew_recording(kRoleWords[role]())});

  calibration::SlewData data;
  if (input.nominal_ins_from_lidar)
    data.up_in_lidar = input.nominal_ins_from_lidar->linear().transpose() * Eigen::Vector3d::UnitZ();
  if (recordings[kGround])
    data.ground_points = ground_points(*recordings[kGround], input.settings, output.findings, progress);
  if (recordings[kArm]) data.arm_points = arm_points(*recordings[kArm], input.settings, output.findings, progress);
  take_turn(*recordings[kTurn], input.settings, output.findings, progress, data);
  const calibration::SlewResult result =
      calibration::solve_slew(data, input.nominal_ins_from_lidar, input.settings.slew, input.settings.solve, progress);
  output.result = result.calibration;
  output.quantities = result.quantities;
  output.plots = result.plots;
  calibration::thin(output.plots, 1000);
  output.initial_ins_from_lidar =
      input.nominal_ins_from_lidar ? *input.nominal_ins_from_lidar : result.calibration.mounting.reference_from_sensor;
  output.compensation_ins_from_lidar = result.calibration.mounting.reference_from_sensor;
  output.session_uses_sweep.assign(input.sessions.size(), false);
  report_ground(result, input.settings.slew, output.findings);
  return output;
}

}  // namespace remount::methods
