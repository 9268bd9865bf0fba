#include <memory>

#include "algorithms/core/error.h"
#include "model/method_needs.h"
#include "model/methods/builtin.h"
#include "model/methods/fusion_run.h"
#include "model/session_frames.h"

namespace remount {
namespace {

void add_quantities(const FusionRun& run, const std::string& session, std::vector<NamedQuantity>& quantities) {
  const FusionOdometryResult& odometry = run.odometry;
  if (odometry.scans.empty()) return;
  double driven_m = 0.0;
  for (std::size_t i = 1; i < odometry.scans.size(); ++i)
    driven_m += (odometry.scans[i].odometry_from_vehicle.translation() -
                 odometry.scans[i - 1].odometry_from_vehicle.translation())
                    .norm();
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  quantities.push_back({"distance driven" + (session.empty() ? "" : ", " + session), driven_m, unknown, "m", true});
}

void tell_breaks(const std::string& session, const FusionRun& run, std::vector<Finding>& findings) {
  if (!run.breaks_ns.empty())
    findings.push_back({Severity::Warning, "odometry-breaks", session,
                        std::to_string(run.breaks_ns.size()) + " of " + std::to_string(run.odometry.scans.size()) +
                            " scans do not tell of every direction of the motion; no pair spans them. Drive where "
                            "there is more to see."});
}

CalibrationResult without_ins() {
  CalibrationResult result;
  result.status = Status::TooFewPairs;
  result.message = "The odometry is complete, but no session has an INS with attitude to calibrate against.";
  result.advice = {"Write the poses with \"remount-cli odometry\", or add a session with an INS."};
  return result;
}

}  // namespace

PipelineOutput run_fusion_method(const PipelineInput& input, Progress& progress) {
  if (input.sessions.empty()) throw Error(ErrorCode::Contract, "", "there is no session to calibrate");
  require_valid(input.settings);
  PipelineInput by_odometry = input;
  by_odometry.sessions.clear();
  std::vector<Plot> plots;
  std::vector<NamedQuantity> quantities;
  std::vector<Finding> findings;
  bool cancelled = false;
  // Without an INS the odometry is shown all the same.
  for (const auto& session : input.sessions)
    if (!has_scans(*session)) require_served(MethodChoice::FusionOdometry, {session});
  for (const auto& session : input.sessions) {
    // The poses must not rest on the mounting that they are to judge.
    FusionRun run =
        run_fusion_odometry(*session, std::nullopt, input.settings, input.threads, progress, FusionSensors::ScansAlone);
    cancelled = cancelled || run.odometry.cancelled;
    add_quantities(run, input.sessions.size() > 1 ? session->name : "", quantities);
    const std::vector<Plot> of_session = fusion_plots(*session, run);
    plots.insert(plots.end(), of_session.begin(), of_session.end());
    findings.insert(findings.end(), run.findings.begin(), run.findings.end());
    tell_breaks(session->name, run, findings);
    if (!has_ins(*session)) {
      findings.push_back({Severity::Warning, "odometry-without-ins", session->name,
                          "The session has no INS with attitude: its odometry takes no part in the calibration."});
      continue;
    }
    auto with_poses = std::make_shared<Session>(*session);
    with_poses->odometry_from_lidar = std::move(run.odometry_from_lidar);
    with_poses->odometry_breaks_ns = std::move(run.breaks_ns);
    with_poses->scans = nullptr;
    by_odometry.sessions.push_back(std::move(with_poses));
  }
  PipelineOutput output;
  if (cancelled) {
    output.result.status = Status::Cancelled;
    output.result.message = "Cancelled.";
  } else if (by_odometry.sessions.empty()) {
    output.result = without_ins();
  } else {
    output = run_pipeline(by_odometry, progress);
  }
  output.method = "fusion-odometry";
  output.plots = std::move(plots);
  output.quantities = std::move(quantities);
  output.findings.insert(output.findings.end(), findings.begin(), findings.end());
  return output;
}

}  // namespace remount
