#include "model/methods/fusion_odometry/fusion_odometry_method.h"

#include <algorithm>
#include <memory>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/error.h"
#include "messages/methods.h"
#include "messages/places.h"
#include "messages/quantities.h"
#include "model/drive/session_frames.h"
#include "model/method_registry/method_needs.h"
#include "model/methods/fusion_odometry/fusion_run.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/solve_stage.h"

namespace remount::methods {
namespace {

void add_quantities(const FusionRun& run, const std::string& session,
                    std::vector<calibration::NamedQuantity>& quantities) {
  const odometry::FusionOdometryResult& odometry = run.odometry;
  if (odometry.scans.empty()) return;
  double driven_m = 0.0;
  for (std::size_t i = 1; i < odometry.scans.size(); ++i)
    driven_m += (odometry.scans[i].odometry_from_vehicle.translation() -
                 odometry.scans[i - 1].odometry_from_vehicle.translation())
                    .norm();
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  quantities.push_back({"distance driven" + (session.empty() ? "" : ", " + session),
                        session.empty() ? say::quantity_distance_driven() : say::quantity_distance_driven_in(session),
                        driven_m, unknown, "m", true});
}

// Whether there are wheels that were not asked, for want of a mounting.
bool has_idle_wheels(const drive::Session& session, FusionUse use) {
  return use == FusionUse::ScansAlone && !session.wheels.empty();
}

void tell_breaks(const drive::Session& session, FusionUse use, const FusionRun& run,
                 std::vector<drive::Finding>& findings) {
  if (run.breaks_ns.empty()) return;
  const auto breaks = has_idle_wheels(session, use) ? say::odometry_breaks_beside_idle_wheels : say::odometry_breaks;
  findings.push_back({drive::Severity::Warning, "odometry-breaks", session.name,
                      breaks(run.breaks_ns.size(), run.odometry.scans.size())});
}

calibration::CalibrationResult without_ins() {
  calibration::CalibrationResult result;
  result.conclude(calibration::Status::NoUsableData, say::odometry_without_ins());
  result.advice = {say::odometry_write_poses()};
  return result;
}

/// Every session driven through once, and what the calibration makes of it.
struct FusionPass {
  pipeline::PipelineInput by_odometry;  ///< sessions with their odometry's poses instead of scans
  std::vector<calibration::Plot> plots;
  std::vector<calibration::NamedQuantity> quantities;
  std::vector<drive::Finding> findings;
  std::size_t scans = 0, breaks = 0;  ///< of the sessions that take part
  bool cancelled = false;
  bool idle_wheels = false;  ///< wheels were recorded, and not used for want of a mounting
};

void add_session(const std::shared_ptr<const drive::Session>& session, FusionRun run, FusionPass& pass) {
  if (!method_registry::has_ins(*session)) {
    pass.findings.push_back(
        {drive::Severity::Warning, "odometry-without-ins", session->name, say::odometry_session_without_ins()});
    return;
  }
  pass.scans += run.odometry.scans.size();
  pass.breaks += run.breaks_ns.size();
  auto with_poses = std::make_shared<drive::Session>(*session);
  with_poses->odometry_from_lidar = std::move(run.odometry_from_lidar);
  with_poses->odometry_breaks_ns = std::move(run.breaks_ns);
  pass.by_odometry.odometry_untold.push_back(std::move(run.untold));
  with_poses->scans = nullptr;
  pass.by_odometry.sessions.push_back(std::move(with_poses));
}

FusionPass drive_through(const pipeline::PipelineInput& input,
                         const std::optional<RigidTransform>& mounting_ins_from_lidar, Progress& progress) {
  FusionPass pass;
  pass.by_odometry = input;
  pass.by_odometry.sessions.clear();
  const FusionUse use = mounting_ins_from_lidar ? FusionUse::Calibration : FusionUse::ScansAlone;
  for (const auto& session : input.sessions) {
    FusionRun run =
        run_fusion_odometry(*session, mounting_ins_from_lidar, input.settings, input.threads, progress, use);
    pass.cancelled = pass.cancelled || run.odometry.cancelled;
    add_quantities(run, input.sessions.size() > 1 ? session->name : "", pass.quantities);
    const std::vector<calibration::Plot> of_session = fusion_plots(*session, run);
    pass.plots.insert(pass.plots.end(), of_session.begin(), of_session.end());
    pass.findings.insert(pass.findings.end(), run.findings.begin(), run.findings.end());
    tell_breaks(*session, use, run, pass.findings);
    pass.idle_wheels = pass.idle_wheels || has_idle_wheels(*session, use);
    add_session(session, std::move(run), pass);
  }
  return pass;
}

bool can_help(const drive::Session& session) {
  return !session.wheels.empty() || !session.imu.empty() || !session.barometer.empty();
}

// What the pipeline says of pairs is of no use where there was no odometry to make them of.
void blame_scans(const FusionPass& pass, bool with_sensors, calibration::CalibrationResult& result) {
  if (result.status != calibration::Status::TooFewPairs || 2 * pass.breaks < pass.scans) return;
  result.conclude(calibration::Status::TooFewPairs, say::odometry_hardly_any_pair(pass.breaks, pass.scans));
  result.advice = {with_sensors       ? say::odometry_sensors_do_not_cover()
                   : pass.idle_wheels ? say::odometry_give_nominal()
                                      : say::odometry_record_sensors()};
}

pipeline::PipelineOutput calibrate_from(const FusionPass& pass, bool with_sensors, Progress& progress) {
  pipeline::PipelineOutput output;
  if (pass.cancelled) {
    output.result.conclude(calibration::Status::Cancelled, say::method_cancelled());
  } else if (pass.by_odometry.sessions.empty()) {
    output.result = without_ins();
  } else {
    output = pipeline::run_pipeline(pass.by_odometry, progress);
    blame_scans(pass, with_sensors, output.result);
  }
  return output;
}

/// By how much the mounting that an odometry took for granted differs from what came of it, under `perturb`; of what
/// is observed.
Vector6d taken_for_granted(const RigidTransform& mounting_ins_from_lidar,
                           const calibration::CalibrationResult& result) {
  const RigidTransform& found = result.mounting.ins_from_lidar();
  return difference(found, calibration::with_kept(found, mounting_ins_from_lidar, result.observed()));
}

// Whether another odometry with the mounting that was found would be another one.
bool worth_another(const Vector6d& change) {
  return change.head<3>().norm() > 0.02 || change.tail<3>().norm() > degrees_to_radians(0.05);
}

// What the mounting still moves by when it is put in feeds back into it: the next round would move it by less again,
// and all that are left out by no more than this one did.
void add_feedback(const Vector6d& change, const calibration::SolveOptions& options,
                  calibration::CalibrationResult& result) {
  calibration::add_doubt(change, say::odometry_still_changes(), options, result);
  pipeline::judge_again(say::odometry_never_settles(), result);
}

bool knows_rotation(const calibration::CalibrationResult& result) {
  return calibration::is_usable(result) && (~result.observed() & calibration::kAttitudeParameters).empty();
}

// The odometry with a mounting, the mounting from the odometry, and again with that, until it stays.
pipeline::PipelineOutput iterate_mounting(const pipeline::PipelineInput& input, RigidTransform mounting_ins_from_lidar,
                                          FusionPass& pass, Progress& progress) {
  constexpr int kMostRounds = 4;
  for (int round = 1;; ++round) {
    pass = drive_through(input, mounting_ins_from_lidar, progress);
    pipeline::PipelineOutput output = calibrate_from(pass, true, progress);
    if (!calibration::is_usable(output.result) || progress.cancelled()) return output;
    const Vector6d change = taken_for_granted(mounting_ins_from_lidar, output.result);
    const bool settled = !worth_another(change);
    if (settled || round == kMostRounds) {
      add_feedback(change, input.settings.solve, output.result);
      if (!settled)
        output.findings.push_back(
            {drive::Severity::Warning, "odometry-unsettled", say::place_odometry(), say::odometry_unsettled()});
      return output;
    }
    mounting_ins_from_lidar = output.result.mounting.ins_from_lidar();
  }
}

}  // namespace

pipeline::PipelineOutput run_fusion_method(const pipeline::PipelineInput& given, Progress& progress) {
  const pipeline::PipelineInput input = pipeline::with_possible_motion(given);
  if (input.sessions.empty()) throw Error(ErrorCode::Contract, "", say::method_no_session());
  settings::require_valid(input.settings);
  // Without an INS the odometry is shown all the same.
  for (const auto& session : input.sessions)
    if (!method_registry::has_scans(*session)) method_registry::require_served(kFusionOdometryMethod, {session});
  const bool helped =
      std::any_of(input.sessions.begin(), input.sessions.end(), [](const auto& session) { return can_help(*session); });
  FusionPass pass;
  pipeline::PipelineOutput output;
  std::optional<RigidTransform> start = input.nominal_ins_from_lidar;
  // The other sensors reach the LiDAR through its mounting; without a nominal that is known from where scans suffice.
  if (!start || !helped) {
    pass = drive_through(input, std::nullopt, progress);
    output = calibrate_from(pass, false, progress);
    start.reset();
    if (helped && knows_rotation(output.result) && !progress.cancelled())
      start = output.result.mounting.ins_from_lidar();
  }
  if (start) output = iterate_mounting(input, *start, pass, progress);
  output.method = kFusionOdometryMethod.id;
  output.plots = std::move(pass.plots);
  output.quantities = std::move(pass.quantities);
  output.findings.insert(output.findings.end(), pass.findings.begin(), pass.findings.end());
  return output;
}

}  // namespace remount::methods
