#include <memory>

#include "algorithms/core/error.h"
#include "model/methods/builtin.h"
#include "model/methods/fusion_run.h"
#include "model/session_frames.h"

namespace remount {
namespace {

bool has_ins(const Session& session) { return !session.ins.empty() || !session.world_from_ins.empty(); }

void add_quantities(const FusionRun& run, const std::string& session, std::vector<NamedQuantity>& quantities) {
  const FusionOdometryResult& odometry = run.odometry;
  if (odometry.scans.empty()) return;
  double driven_m = 0.0;
  bool reckoned = false;
  for (std::size_t i = 1; i < odometry.scans.size(); ++i) {
    driven_m += (odometry.scans[i].odometry_from_vehicle.translation() -
                 odometry.scans[i - 1].odometry_from_vehicle.translation())
                    .norm();
    reckoned = reckoned || odometry.scans[i].dead_reckoned;
  }
  const std::string of = session.empty() ? "" : ", " + session;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  quantities.push_back({"distance driven" + of, driven_m, unknown, "m", true});
  if (!reckoned) return;
  constexpr std::array<const char*, 3> kAxes{"roll", "pitch", "yaw"};
  for (int axis = 0; axis < 3; ++axis)
    quantities.push_back({std::string("gyroscope bias per s, ") + kAxes[static_cast<std::size_t>(axis)] + of,
                          odometry.drift.gyro_bias_radps[axis], odometry.drift_sigma[axis], "rad", true});
  quantities.push_back({"wheel speed scale" + of, odometry.drift.wheel_scale, odometry.drift_sigma[3], "", true});
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
  for (const auto& session : input.sessions) {
    FusionRun run =
        run_fusion_odometry(*session, input.nominal_ins_from_lidar, input.settings, input.threads, progress);
    cancelled = cancelled || run.odometry.cancelled;
    add_quantities(run, input.sessions.size() > 1 ? session->name : "", quantities);
    const std::vector<Plot> of_session = fusion_plots(*session, run);
    plots.insert(plots.end(), of_session.begin(), of_session.end());
    findings.insert(findings.end(), run.findings.begin(), run.findings.end());
    if (!has_ins(*session)) continue;
    auto with_poses = std::make_shared<Session>(*session);
    with_poses->odometry_from_lidar = std::move(run.odometry_from_lidar);
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
