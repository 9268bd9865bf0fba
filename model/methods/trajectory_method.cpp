#include "model/methods/trajectory_method.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "model/attitude_check.h"
#include "model/method_needs.h"
#include "model/methods/builtin.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/solve_stage.h"

namespace remount {
namespace {

void check(const PipelineInput& input) {
  if (input.sessions.empty()) throw Error(ErrorCode::Contract, "", "there is no session to calibrate");
  require_valid(input.settings);
  check_companions(input.sessions);
}

std::string count_of(std::size_t count, std::size_t total, const std::string& what) {
  return std::to_string(count) + " of " + std::to_string(total) + " " + what;
}

void add_odometry_findings(const Session& session, const SessionOdometry& odometry, std::vector<Finding>& findings) {
  if (odometry.unreadable > 0)
    findings.push_back({Severity::Warning, "scan-unreadable", session.name,
                        count_of(odometry.unreadable, odometry.scans_used, "scans cannot be read and are left out. ") +
                            "First: " + sentence(odometry.first_unreadable)});
  if (odometry.unaligned > 0)
    findings.push_back(
        {Severity::Warning, "odometry-lost", session.name,
         count_of(odometry.unaligned, odometry.scans_used, "scans could not be aligned with the local map; ") +
             "their poses are predicted from the motion before. First: " + sentence(odometry.first_unaligned)});
  if (odometry.undetermined > 0)
    findings.push_back(
        {Severity::Note, "odometry-undetermined", session.name,
         count_of(odometry.undetermined, odometry.scans_used, "scans do not determine every direction of motion; ") +
             "what they leave open counts as hardly known."});
}

void add_coverage_finding(const Session& session, const SessionOdometry& odometry, const TrajectorySession& aligned,
                          std::vector<Finding>& findings) {
  if (!aligned.epochs.empty() || odometry.poses.empty()) return;
  findings.push_back({Severity::Problem, "trajectory-not-covered", session.name,
                      "No pose of the LiDAR lies within the data of the INS or between GNSS fixes. Give data of the "
                      "same time, on one clock."});
}

// Positions of an antenna have no axes in which a value could have been measured.
void add_measured_finding(const Settings& settings, const CalibrationResult& result, std::vector<Finding>& findings) {
  if (result.reference_frame != "antenna" || !is_measured(settings.measured)) return;
  findings.push_back(
      {Severity::Warning, "measured-without-ins", "measured",
       "The values measured by hand are of the LiDAR in the INS frame; there is no INS, and they are not "
       "used."});
}

void add_outcome_findings(const TrajectoryOutcome& outcome, std::vector<Finding>& findings) {
  if (outcome.outliers > 0)
    findings.push_back({20 * outcome.outliers > outcome.measurements ? Severity::Warning : Severity::Note,
                        "trajectory-outliers", "INS and GNSS",
                        count_of(outcome.outliers, outcome.measurements,
                                 "positions and attitudes contradict the motion of the LiDAR and have no weight.")});
  const CalibrationResult& result = outcome.answer.result;
  char text[320];
  if (outcome.answer.odometry_drift > 0.0) {
    std::snprintf(
        text, sizeof text,
        "The motion of the LiDAR leaves its way to one side, by %.2f %% of it: it rises, sinks or drifts where "
        "INS and GNSS do not. X is solved with that taken out.",
        100.0 * outcome.answer.odometry_drift);
    findings.push_back({Severity::Warning, "odometry-drifts", "LiDAR", text});
  }
  constexpr double kClockWell_s = 5e-3;
  if (result.reference_frame == "antenna" && result.time_offset.in_sigma &&
      !(result.time_offset.sigma_s < kClockWell_s)) {
    constexpr double kExpected_s = 0.2;
    std::snprintf(
        text, sizeof text,
        "Positions alone hardly show how far the clocks of LiDAR and GNSS are apart: %.0f ms (1 sigma) are in "
        "the sigmas.",
        1e3 * (std::isfinite(result.time_offset.sigma_s) ? result.time_offset.sigma_s : kExpected_s));
    findings.push_back({Severity::Note, "clock-open", "LiDAR and GNSS", text});
  }
  if (std::isfinite(outcome.converged_after_s))
    std::snprintf(text, sizeof text, "X had converged after %.0f s of data.", outcome.converged_after_s);
  else
    std::snprintf(text, sizeof text,
                  "X has not converged to the sigmas that trajectory.converged_translation_m and "
                  "trajectory.converged_rotation_deg ask for.");
  findings.push_back({Severity::Note, "trajectory-convergence", "trajectory", text});
}

}  // namespace

PipelineOutput trajectory_output(const PipelineInput& input, const TrajectoryFeed& feed,
                                 const TrajectoryOutcome& outcome) {
  PipelineOutput output;
  output.method = "trajectory";
  for (std::size_t s = 0; s < input.sessions.size(); ++s) {
    const Session& session = *input.sessions[s];
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
  output.compensation_ins_from_lidar = output.result.ins_from_lidar;
  const bool solved = output.result.status == Status::Ok || output.result.status == Status::Degenerate;
  if (!solved) return output;
  add_measured_finding(input.settings, output.result, output.findings);
  add_outcome_findings(outcome, output.findings);
  report_clock(input, output.result, output.findings);
  output.plots = trajectory_plots(feed, outcome);
  return output;
}

PipelineOutput run_trajectory_method(const PipelineInput& given, Progress& progress) {
  const PipelineInput input = with_possible_motion(given);
  check(input);
  TrajectoryFeed feed(input.settings, input.nominal_ins_from_lidar, input.threads);
  // As many answers on the way as a plot can show.
  constexpr double kPoints = 150.0;
  for (const auto& session : input.sessions) {
    feed.begin(*session);
    const double length_s =
        seconds(has_scans(*session)
                    ? session->scans->stamp_ns(session->scans->size() - 1) - session->scans->stamp_ns(0)
                    : session->odometry_from_lidar.back().stamp_ns - session->odometry_from_lidar.front().stamp_ns);
    feed.offer(*session, true, static_cast<double>(input.sessions.size()) * length_s / kPoints, {}, progress);
    if (progress.cancelled()) break;
  }
  if (!progress.cancelled()) progress.report("aligning trajectories", 0, 0);
  TrajectoryOutcome outcome;
  if (progress.cancelled()) {
    outcome.answer.result.status = Status::Cancelled;
    outcome.answer.result.message = "Cancelled.";
    PipelineOutput output;
    output.method = "trajectory";
    output.result = outcome.answer.result;
    return output;
  }
  outcome = feed.finish(input.sessions, progress);
  PipelineOutput output = trajectory_output(input, feed, outcome);
  blame_attitude(output.findings, output.result);
  return output;
}

}  // namespace remount
