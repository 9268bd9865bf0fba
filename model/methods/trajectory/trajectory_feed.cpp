#include "model/methods/trajectory/trajectory_feed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "messages/calibration.h"
#include "messages/methods.h"
#include "messages/parameters.h"
#include "messages/stages.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/trajectory/trajectory_method.h"
#include "model/pipeline/first_ground.h"
#include "model/pipeline/offset_search.h"
#include "model/pipeline/position_lag.h"
#include "model/pipeline/scan_times.h"
#include "model/pipeline/solve_stage.h"

namespace remount::methods {
namespace {

constexpr std::int64_t kAll = std::numeric_limits<std::int64_t>::max();

// Adds what is new of somebody's poses. They state no errors: those of the options.
void add_given_poses(const std::vector<motion::StampedPose>& odometry_from_lidar, std::size_t count,
                     const calibration::TrajectoryOptions& options, std::vector<odometry::OdometryPose>& poses) {
  const double translation = options.odometry_translation_sigma_m;
  const double rotation = degrees_to_radians(options.odometry_rotation_sigma_deg);
  for (std::size_t i = poses.size(); i < count; ++i) {
    odometry::OdometryPose pose;
    pose.stamp_ns = odometry_from_lidar[i].stamp_ns;
    pose.odometry_from_lidar = odometry_from_lidar[i].pose;
    // A step has the errors of two poses.
    pose.covariance.diagonal() << Eigen::Vector3d::Constant(0.5 * translation * translation),
        Eigen::Vector3d::Constant(0.5 * rotation * rotation);
    poses.push_back(pose);
  }
}

// Whether poses that were taken on the way are those of the whole.
bool begins_with(const std::vector<motion::StampedPose>& whole, const std::vector<odometry::OdometryPose>& taken) {
  return taken.size() <= whole.size() && std::equal(taken.begin(), taken.end(), whole.begin(),
                                                    [](const odometry::OdometryPose& a, const motion::StampedPose& b) {
                                                      return a.stamp_ns == b.stamp_ns &&
                                                             a.odometry_from_lidar.matrix() == b.pose.matrix();
                                                    });
}

// As those of X, which is the lever arm.
void set_lever_arm_sigmas(calibration::TrajectoryAnswer& answer) {
  for (calibration::NamedQuantity& quantity : answer.quantities)
    for (std::size_t i = 0; i < 3; ++i) {
      if (quantity.id != calibration::lever_arm_id(static_cast<int>(i))) continue;
      const calibration::Estimate estimate = answer.result.estimate(calibration::kParameters[i]);
      quantity.observed = estimate.observed;
      quantity.sigma = estimate.sigma.value_or(std::numeric_limits<double>::quiet_NaN());
    }
}

}  // namespace

std::int64_t trajectory_reach_ns(const drive::Session& session, const std::vector<odometry::OdometryPose>& poses) {
  // Poses of the INS are smoothed over what follows.
  constexpr std::int64_t kSmoothed_ns = 300'000'000, kPatience_ns = 5'000'000'000;
  if (poses.empty()) return 0;
  const std::int64_t lidar = poses.back().stamp_ns;
  std::int64_t until = lidar;
  const auto held_by = [&](std::int64_t last_ns) { until = std::min(until, std::max(last_ns, lidar - kPatience_ns)); };
  if (session.ins.size() > 1) held_by((session.ins.end() - 2)->stamp_ns - kSmoothed_ns);
  if (session.world_from_ins.size() > 1) held_by((session.world_from_ins.end() - 2)->stamp_ns - kSmoothed_ns);
  // Fixes have no place among poses in somebody's world: they are not used there.
  if (session.gnss.size() > 1 && session.world_from_ins.empty()) held_by((session.gnss.end() - 2)->stamp_ns);
  return until;
}

TrajectoryFeed::TrajectoryFeed(const settings::Settings& settings, std::optional<RigidTransform> nominal_ins_from_lidar,
                               int threads)
    : settings_(settings),
      nominal_(nominal_ins_from_lidar),
      threads_(threads),
      aligner_(settings.trajectory, settings.solve, nominal_ins_from_lidar,
               settings.solve.apply_time_offset == calibration::ClockOffsetUse::Yes) {
  if (settings.measured.ins_height_sigma_m > 0.0)
    throw Error(ErrorCode::Contract, "measured.ins_height_m", say::measured_height_needs_ground());
  aligner_.set_measured(calibration::Measured(settings.measured, std::nullopt));
}

void TrajectoryFeed::begin(const drive::Session& session) {
  // Not owned: the session outlives this call.
  method_registry::require_served(kTrajectoryMethod,
                                  {std::shared_ptr<const drive::Session>(std::shared_ptr<void>(), &session)});
  odometry_.emplace_back();
  from_scans_ = method_registry::has_scans(session);
  begin_odometry();
  calibration::TrajectorySession empty = trajectory_session(session, {}, settings_, {});
  aligner_.add_session(std::move(empty));
  if (nominal_ || aligner_.problem().up_in_lidar) return;
  aligner_.set_up_in_lidar(pipeline::up_of_first_scans(session));
}

void TrajectoryFeed::begin_odometry() {
  odometry_.back() = {};
  used_scans_ns_.clear();
  running_ = std::make_unique<odometry::LidarOdometry>(settings_.lidar_odometry, settings_.registration);
}

// A scan that came out of order was not seen on the way.
bool TrajectoryFeed::used_are_first_of(const drive::ScanSource& scans) const {
  if (used_scans_ns_.size() > scans.size()) return false;
  for (std::size_t i = 0; i < used_scans_ns_.size(); ++i)
    if (scans.stamp_ns(i) != used_scans_ns_[i]) return false;
  return true;
}

void TrajectoryFeed::keep_poses(const drive::Session& session, const std::vector<odometry::OdometryPose>& poses) {
  SessionOdometry& odometry = odometry_.back();
  for (const odometry::OdometryPose& pose : poses) {
    if (!pose.aligned && odometry.unaligned++ == 0)
      odometry.first_unaligned = say::of_file(pipeline::scan_name_at(*session.scans, pose.stamp_ns), pose.problem);
    odometry.undetermined += pose.undetermined.empty() ? 0 : 1;
    odometry.poses.push_back(pose);
  }
}

void TrajectoryFeed::run_odometry(const drive::Session& session, std::size_t scans, const std::function<void()>& after,
                                  Progress& progress) {
  SessionOdometry& odometry = odometry_.back();
  const std::size_t at_once = 4 * static_cast<std::size_t>(worker_count(threads_));
  while (odometry.scans_used < scans && !progress.cancelled()) {
    const std::size_t first = odometry.scans_used, count = std::min(at_once, scans - first);
    std::vector<cloud::PointCloud> clouds(count);
    std::vector<Message> failures(count);
    parallel_for(count, threads_, [&](std::size_t i) {
      try {
        clouds[i] = session.scans->load(first + i);
      } catch (const Error& error) {
        failures[i] = error.message();
      }
    });
    for (std::size_t i = 0; i < count && !progress.cancelled(); ++i) {
      progress.report(say::stage_lidar_odometry, first + i, session.scans->size());
      ++odometry.scans_used;
      used_scans_ns_.push_back(session.scans->stamp_ns(first + i));
      if (!failures[i].empty()) {
        if (odometry.unreadable++ == 0) odometry.first_unreadable = failures[i];
        continue;
      }
      keep_poses(session, running_->push(clouds[i], pipeline::scan_times(session, clouds[i], settings_.run.deskew),
                                         session.scans->stamp_ns(first + i), progress));
    }
    after();
  }
}

void TrajectoryFeed::push_epochs(const drive::Session& session, std::int64_t until_ns, double least_update_s,
                                 const Tell& tell, Progress& progress) {
  if (odometry_.back().poses.empty()) return;  // or not again, where the odometry began anew
  const std::size_t index = odometry_.size() - 1;
  const std::vector<calibration::TrajectoryEpoch>& had = aligner_.problem().sessions[index].epochs;
  EpochRange range;
  range.until_ns = until_ns;
  // Of a long drive only what is new.
  if (!had.empty())
    range.since_ns =
        odometry_.back().poses.front().stamp_ns + static_cast<std::int64_t>(std::llround(had.back().time_s * 1e9));
  calibration::TrajectorySession now = trajectory_session(session, odometry_.back(), settings_, {}, range);
  auto observed = static_cast<double>(std::count_if(
      had.begin(), had.end(), [](const calibration::TrajectoryEpoch& epoch) { return epoch.ins.has_value(); }));
  for (calibration::TrajectoryEpoch& epoch : now.epochs) {
    if (progress.cancelled()) return;
    if (!had.empty() && epoch.time_s <= had.back().time_s + 1e-4) continue;
    if (epoch.ins) {
      // A tilt that is assumed is said once, however many poses follow: weights 1 / (k (k + 1)) add up to less than 1.
      observed += 1.0;
      const double root = std::sqrt(observed * (observed + 1.0));
      epoch.ins->assumed_tilt_sigma_rad = root * now.assumed_tilt_sigma_rad;
      epoch.ins->unmeasured_height_sigma_m = root * now.unmeasured_height_sigma_m;
    }
    aligner_.push(index, epoch);
    if (!aligner_.due(std::max(least_update_s, settings_.trajectory.update_s))) continue;
    const calibration::TrajectorySnapshot snapshot = aligner_.update(progress);
    if (tell && !progress.cancelled()) tell(snapshot);
  }
}

void TrajectoryFeed::offer(const drive::Session& session, bool complete, double least_update_s, const Tell& tell,
                           Progress& progress) {
  if (from_scans_ && !session.scans)
    throw Error(ErrorCode::Unsupported, drive::path_or_name(session), say::trajectory_scans_gone());
  SessionOdometry& odometry = odometry_.back();
  const auto push = [&] {
    push_epochs(session,
                complete && (!from_scans_ || odometry.scans_used == session.scans->size())
                    ? kAll
                    : trajectory_reach_ns(session, odometry.poses),
                least_update_s, tell, progress);
  };
  const std::size_t held_back = complete ? 0 : 1;
  if (from_scans_) {
    if (complete && !used_are_first_of(*session.scans)) begin_odometry();
    const std::size_t ready = session.scans->size() - std::min(held_back, session.scans->size());
    run_odometry(session, ready, complete && !tell ? std::function<void()>([] {}) : push, progress);
    if (complete && !progress.cancelled()) keep_poses(session, running_->finish(progress));
  } else {
    const std::size_t given = session.odometry_from_lidar.size();
    if (complete && !begins_with(session.odometry_from_lidar, odometry.poses)) odometry.poses.clear();
    add_given_poses(session.odometry_from_lidar, given - std::min(held_back, given), settings_.trajectory,
                    odometry.poses);
  }
  push();
}

calibration::TrajectoryOutcome TrajectoryFeed::solve_at(const Sessions& sessions,
                                                        const std::vector<SessionTimes>& times, const Sought& sought,
                                                        Progress& progress) {
  problem_ = {};
  problem_.nominal_ins_from_lidar = nominal_;
  problem_.measured = calibration::Measured(settings_.measured, std::nullopt);
  problem_.estimate_clock = sought.clock;
  problem_.position_lag_sigma_s = sought.position_lag_sigma_s;
  problem_.estimate_odometry_drift = sought.odometry_drift;
  problem_.up_in_lidar = up_in_lidar_;
  for (std::size_t s = 0; s < sessions.size(); ++s)
    problem_.sessions.push_back(trajectory_session(*sessions[s], odometry_[s], settings_, times[s]));
  return calibration::solve_alignment(problem_, settings_.trajectory, settings_.solve, progress);
}

// Of a lag that nobody expects.
constexpr double kAnyLag_s = 0.2;

// Offsets are linear about those before: once more from INS poses at the times that were found.
calibration::TrajectoryOutcome TrajectoryFeed::solve_with_times(const Sessions& sessions, const Sought& sought,
                                                                Progress& progress) {
  constexpr int kMostRounds = 4;
  constexpr double kSettled_s = 5e-4;
  calibration::TrajectoryOutcome outcome;
  std::vector<SessionTimes> times(sessions.size(), {.with_fixes = sought.with_fixes});
  for (int round = 0; round < kMostRounds; ++round) {
    outcome = solve_at(sessions, times, sought, progress);
    calibration::CalibrationResult& result = outcome.answer.result;
    double change_s = 0.0, sum_s = 0.0;
    std::vector<double>&clocks_s = result.session_time_offset_s, &lags_s = result.session_position_lag_s;
    const bool with_clocks = clocks_s.size() == times.size(), with_lags = lags_s.size() == times.size();
    if (!with_clocks && !with_lags) break;
    for (std::size_t s = 0; s < times.size(); ++s) {
      // What a drive does not show stays where it is expected: a search for it would end anywhere.
      const double weight = with_clocks ? outcome.answer.clock_weights[s] : 0.0;
      const double clock_s = with_clocks ? clocks_s[s] : 0.0;
      const double lag_s = with_lags && calibration::position_lag_stands_out(times[s].position_lag_s + lags_s[s],
                                                                             result.session_position_lag_sigma_s[s])
                               ? lags_s[s]
                               : 0.0;
      if (with_clocks) clocks_s[s] += times[s].clock_s;
      if (with_lags) lags_s[s] += times[s].position_lag_s;
      sum_s += weight * (times[s].clock_s + clock_s);
      if (weight > 0.0) times[s].clock_s += clock_s;
      times[s].position_lag_s += lag_s;
      change_s = std::max({change_s, weight > 0.0 ? std::abs(clock_s) : 0.0, std::abs(lag_s)});
    }
    if (result.time_offset.applied) {
      result.time_offset.offset_s = sum_s;
      for (const double weight : outcome.answer.clock_weights)
        result.session_time_offset_sigma_s.push_back(result.time_offset.sigma_s / std::sqrt(weight));
    }
    if (change_s < kSettled_s) break;
  }
  outcome.fixes_left_out = !sought.with_fixes;
  return outcome;
}

// What is found of times and is left in X: how far it moves X joins the sigmas.
void TrajectoryFeed::doubt_times_of(const calibration::CalibrationResult& found,
                                    calibration::CalibrationResult& result) const {
  if (!calibration::is_usable(found) || !calibration::is_usable(result)) return;
  const bool lag_is_in = !result.position_lag_applied;
  const std::vector<double> lags_s = result.session_position_lag_s, sigmas_s = result.session_position_lag_sigma_s;
  pipeline::keep_clock(found, result);
  result.time_offset.applied = result.time_offset.in_sigma = result.position_lag_applied = false;
  if (!lag_is_in) {
    result.session_position_lag_s = lags_s;
    result.session_position_lag_sigma_s = sigmas_s;
    result.position_lag_applied = true;
  }
  calibration::add_doubt(calibration::mounting_difference(result.mounting, found.mounting),
                         pipeline::clock_differs(found) ? say::unknown_clocks_differ() : say::unknown_positions_lag(),
                         settings_.solve, result);
  pipeline::judge_again(say::nothing_known_clocks(), result);
}

calibration::TrajectoryOutcome TrajectoryFeed::solve_as_set(const Sessions& sessions, Progress& progress) {
  const calibration::ClockOffsetUse use = settings_.solve.apply_time_offset;
  const bool told = std::ranges::all_of(
      sessions, [&](const auto& session) { return pipeline::tells_clock(*session, settings_.run.deskew); });
  const bool asked = told && use != calibration::ClockOffsetUse::No;
  const auto state_times = [&](calibration::TrajectoryOutcome outcome, bool with_clocks) {
    calibration::CalibrationResult& result = outcome.answer.result;
    // As an unknown it is in the sigmas; that it was taken out is said of what stands out.
    result.time_offset.applied =
        result.time_offset.applied && (use == calibration::ClockOffsetUse::Yes || pipeline::clock_differs(result));
    result.time_offset.in_sigma = with_clocks && !result.time_offset.applied;
    result.position_lag_applied = calibration::position_lag_differs(result);
    if (!told) pipeline::drop_offsets(result);  // scans that are bent by their motion look like one
    return outcome;
  };
  const std::vector<SessionTimes> as_logged(sessions.size());
  double expected_lag_s = 0.0;  // where messages of different times were put together
  for (const auto& session : sessions) expected_lag_s = std::max(expected_lag_s, session->ins_position_lag_sigma_s);
  // What nobody expects is looked for beside the clocks, which alone would be a mean of the two. Where it stands out, X
  // is the one that was found with it.
  calibration::TrajectoryOutcome odd = solve_with_times(sessions, {true, kAnyLag_s, true, false}, progress);
  if (progress.cancelled()) return odd;
  const bool lags = calibration::position_lag_differs(odd.answer.result), drifts = odd.answer.odometry_drift > 0.0;
  if (use == calibration::ClockOffsetUse::No) {
    calibration::TrajectoryOutcome outcome =
        state_times(solve_at(sessions, as_logged, {false, expected_lag_s, drifts}, progress), false);
    if (!lags && !(told && pipeline::clock_differs(odd.answer.result))) return outcome;
    if (!drifts)
      odd = solve_with_times(sessions, {told || lags, lags ? kAnyLag_s : expected_lag_s, false, !lags}, progress);
    doubt_times_of(odd.answer.result, outcome.answer.result);
    if (!told) pipeline::drop_offsets(outcome.answer.result);
    return outcome;
  }
  if (lags && drifts) return state_times(std::move(odd), true);
  if (lags || (drifts && asked))
    return state_times(solve_with_times(sessions, {true, lags ? kAnyLag_s : expected_lag_s, drifts, !lags}, progress),
                       true);
  if (asked) {
    calibration::TrajectoryOutcome outcome = solve_with_times(sessions, {true, expected_lag_s, false}, progress);
    const calibration::CalibrationResult& result = outcome.answer.result;
    if (use == calibration::ClockOffsetUse::Yes || progress.cancelled() ||
        (calibration::is_usable(result) && (pipeline::clock_differs(result) || pipeline::clock_is_determined(result))))
      return state_times(std::move(outcome), true);
  }
  return state_times(solve_at(sessions, as_logged, {false, expected_lag_s, drifts}, progress), false);
}

// Where there is no attitude that would show turns, the offset of the clocks is told by the way alone, and that hardly:
// it is an unknown of X wherever it ends up. Where it is to stay in, sigma is that of a solution with it, which says
// how far it may move X, beside how far it does.
calibration::TrajectoryOutcome TrajectoryFeed::solve_positions_alone(const Sessions& sessions, Progress& progress) {
  const calibration::ClockOffsetUse use = settings_.solve.apply_time_offset;
  calibration::TrajectoryOutcome with_clock = solve_with_times(sessions, {.clock = true}, progress);
  calibration::CalibrationResult& found = with_clock.answer.result;
  const bool differs = pipeline::clock_differs(found);
  if (use != calibration::ClockOffsetUse::No) {
    found.time_offset.applied = found.time_offset.applied && (use == calibration::ClockOffsetUse::Yes || differs);
    found.time_offset.in_sigma = !found.time_offset.applied;
    return with_clock;
  }
  calibration::TrajectoryOutcome outcome = solve_at(sessions, std::vector<SessionTimes>(sessions.size()), {}, progress);
  calibration::CalibrationResult& result = outcome.answer.result;
  if (!calibration::is_usable(found) || !calibration::is_usable(result)) return outcome;
  const calibration::CalibrationResult held = std::exchange(result, found);
  result.mounting = held.mounting;
  result.translation_rms_m = held.translation_rms_m;
  result.rotation_rms_rad = held.rotation_rms_rad;
  result.time_offset.applied = false;
  result.time_offset.in_sigma = !differs;
  calibration::add_doubt(calibration::mounting_difference(held.mounting, found.mounting), say::unknown_clocks_differ(),
                         settings_.solve, result);
  if (result.observed() != found.observed()) pipeline::judge_again(say::nothing_known_clocks(), result);
  set_lever_arm_sigmas(outcome.answer);
  return outcome;
}

calibration::TrajectoryOutcome TrajectoryFeed::finish(const Sessions& sessions, Progress& progress) {
  for (auto session = sessions.begin(); !nominal_ && !up_in_lidar_ && session != sessions.end(); ++session)
    up_in_lidar_ = pipeline::up_of_first_scans(**session);
  const bool positions_alone = std::ranges::all_of(
      sessions, [](const auto& session) { return session->ins.empty() && session->world_from_ins.empty(); });
  calibration::TrajectoryOutcome outcome =
      positions_alone ? solve_positions_alone(sessions, progress) : solve_as_set(sessions, progress);
  outcome.converged_after_s = calibration::converged_after_s(history());
  return outcome;
}

}  // namespace remount::methods
