#include "model/methods/trajectory/trajectory_method.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "messages/methods.h"
#include "messages/places.h"
#include "messages/stages.h"
#include "model/conventions/attitude_check.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/calibrate.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/solve_stage.h"

namespace remount::methods {
namespace {

void check(const pipeline::PipelineInput& input) {
  if (input.sessions.empty()) throw Error(ErrorCode::Contract, "", say::method_no_session());
  settings::require_valid(input.settings);
  pipeline::check_companions(input.sessions);
}

void add_odometry_findings(const drive::Session& session, const SessionOdometry& odometry,
                           std::vector<drive::Finding>& findings) {
  if (odometry.unreadable > 0)
    findings.push_back(
        {drive::Severity::Warning, "scan-unreadable", session.name,
         say::trajectory_scans_unreadable(odometry.unreadable, odometry.scans_used, odometry.first_unreadable)});
  if (odometry.unaligned > 0)
    findings.push_back({drive::Severity::Warning, "odometry-lost", session.name,
                        say::trajectory_scans_lost(odometry.unaligned, odometry.scans_used, odometry.first_unaligned)});
  if (odometry.undetermined > 0)
    findings.push_back({drive::Severity::Note, "odometry-undetermined", session.name,
                        say::trajectory_scans_undetermined(odometry.undetermined, odometry.scans_used)});
}

void add_coverage_finding(const drive::Session& session, const SessionOdometry& odometry,
                          const calibration::TrajectorySession& aligned, std::vector<drive::Finding>& findings) {
  if (!aligned.epochs.empty() || odometry.poses.empty()) return;
  findings.push_back({drive::Severity::Problem, "trajectory-not-covered", session.name, say::trajectory_not_covered()});
}

// Where no session has data of one time, or scans that can be read, no longer drive helps.
void blame_data(const calibration::TrajectoryProblem& problem, const std::vector<drive::Finding>& findings,
                calibration::CalibrationResult& result) {
  const bool some = std::any_of(problem.sessions.begin(), problem.sessions.end(),
                                [](const calibration::TrajectorySession& session) { return !session.epochs.empty(); });
  if (result.status != calibration::Status::TooLittleData || some) return;
  for (const char* code : {"trajectory-not-covered", "scan-unreadable"}) {
    const auto found =
        std::find_if(findings.begin(), findings.end(), [&](const drive::Finding& one) { return one.code == code; });
    if (found != findings.end()) return result.conclude(calibration::Status::NoUsableData, found->explanation);
  }
}

// Positions of an antenna have no axes in which a value could have been measured.
void add_measured_finding(const settings::Settings& settings, const calibration::CalibrationResult& result,
                          std::vector<drive::Finding>& findings) {
  if (result.mounting.reference != calibration::BodyFrame::Antenna || !is_measured(settings.measured)) return;
  findings.push_back(
      {drive::Severity::Warning, "measured-without-ins", say::place_measured(), say::measured_without_ins()});
}

void add_fixes_finding(const pipeline::PipelineInput& input, const calibration::TrajectoryOutcome& outcome,
                       std::vector<drive::Finding>& findings) {
  if (!outcome.fixes_left_out) return;
  for (const auto& session : input.sessions)
    if (!session->gnss.empty() && !session->ins.empty() && session->world_from_ins.empty())
      findings.push_back({drive::Severity::Note, "trajectory-fixes", session->name, say::trajectory_fixes_left_out()});
}

void add_outcome_findings(const calibration::TrajectoryOutcome& outcome, std::vector<drive::Finding>& findings) {
  if (outcome.outliers > 0)
    findings.push_back({20 * outcome.outliers > outcome.measurements ? drive::Severity::Warning : drive::Severity::Note,
                        "trajectory-outliers", say::place_ins_and_gnss(),
                        say::trajectory_outliers(outcome.outliers, outcome.measurements)});
  const calibration::CalibrationResult& result = outcome.answer.result;
  if (outcome.answer.odometry_drift > 0.0)
    findings.push_back({drive::Severity::Warning, "odometry-drifts", say::place_lidar(),
                        say::trajectory_odometry_drifts(Share{outcome.answer.odometry_drift})});
  constexpr double kClockWell_s = 5e-3, kExpected_s = 0.2;
  const double clock_s = std::isfinite(result.time_offset.sigma_s) ? result.time_offset.sigma_s : kExpected_s;
  if (result.mounting.reference == calibration::BodyFrame::Antenna && result.time_offset.in_sigma &&
      !(clock_s < kClockWell_s))
    findings.push_back({drive::Severity::Note, "clock-open", say::place_lidar_and_gnss(),
                        say::trajectory_clock_open(Duration{clock_s})});
  findings.push_back({drive::Severity::Note, "trajectory-convergence", say::place_trajectory(),
                      std::isfinite(outcome.converged_after_s)
                          ? say::trajectory_converged(Duration{outcome.converged_after_s})
                          : say::trajectory_not_converged()});
}

}  // namespace

pipeline::PipelineOutput trajectory_output(const pipeline::PipelineInput& input, const TrajectoryFeed& feed,
                                           const calibration::TrajectoryOutcome& outcome) {
  pipeline::PipelineOutput output;
  output.method = kTrajectoryMethod.id;
  for (std::size_t s = 0; s < input.sessions.size(); ++s) {
    const drive::Session& session = *input.sessions[s];
    output.findings.insert(output.findings.end(), session.findings.begin(), session.findings.end());
    add_odometry_findings(session, feed.odometry()[s], output.findings);
    if (s < feed.problem().sessions.size())
      add_coverage_finding(session, feed.odometry()[s], feed.problem().sessions[s], output.findings);
  }
  output.result = outcome.answer.result;
  output.quantities = outcome.answer.quantities;
  output.nominal_known = input.nominal_ins_from_lidar.has_value();
  output.initial_known = output.nominal_known;
  output.initial_ins_from_lidar = input.nominal_ins_from_lidar.value_or(RigidTransform::Identity());
  output.compensation_ins_from_lidar = output.result.mounting.reference_from_sensor;
  blame_data(feed.problem(), output.findings, output.result);
  if (!calibration::is_solved(output.result.status)) return output;
  add_measured_finding(input.settings, output.result, output.findings);
  add_outcome_findings(outcome, output.findings);
  add_fixes_finding(input, outcome, output.findings);
  pipeline::report_clock(input, output.result, output.findings);
  output.plots = trajectory_plots(feed, outcome);
  return output;
}

pipeline::PipelineOutput run_trajectory_method(const pipeline::PipelineInput& given, Progress& progress) {
  const pipeline::PipelineInput input = pipeline::with_possible_motion(given);
  check(input);
  TrajectoryFeed feed(input.settings, input.nominal_ins_from_lidar, input.threads);
  // As many answers on the way as a plot can show.
  constexpr double kPoints = 150.0;
  for (const auto& session : input.sessions) {
    feed.begin(*session);
    const double length_s =
        seconds(method_registry::has_scans(*session)
                    ? session->scans->stamp_ns(session->scans->size() - 1) - session->scans->stamp_ns(0)
                    : session->odometry_from_lidar.back().stamp_ns - session->odometry_from_lidar.front().stamp_ns);
    feed.offer(*session, true, static_cast<double>(input.sessions.size()) * length_s / kPoints, {}, progress);
    if (progress.cancelled()) break;
  }
  if (!progress.cancelled()) progress.report(say::stage_aligning_trajectories, 0, 0);
  calibration::TrajectoryOutcome outcome;
  if (progress.cancelled()) {
    pipeline::PipelineOutput output;
    output.method = kTrajectoryMethod.id;
    output.result.conclude(calibration::Status::Cancelled, say::method_cancelled());
    return output;
  }
  outcome = feed.finish(input.sessions, progress);
  pipeline::PipelineOutput output = trajectory_output(input, feed, outcome);
  conventions::blame_attitude(output.findings, output.result);
  return output;
}

}  // namespace remount::methods
