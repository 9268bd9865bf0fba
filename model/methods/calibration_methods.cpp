#include <algorithm>

#include "algorithms/calibration/out_of_range.h"
#include "algorithms/core/error.h"
#include "model/io/document.h"
#include "model/method_needs.h"
#include "model/methods/builtin.h"
#include "model/methods/settled_sweeps.h"
#include "model/pipeline/input_checks.h"

namespace remount {
namespace {

// Without an attitude there are no angles that could lie anywhere.
SearchRange range_of(const CalibrationResult& result, SearchRange range) {
  if (result.calibrated != "antenna" && result.reference_frame != "antenna") return range;
  range.yaw_min_rad = range.pitch_min_rad = range.roll_min_rad = -kPi;
  range.yaw_max_rad = range.pitch_max_rad = range.roll_max_rad = kPi;
  return range;
}

RigidTransform unobserved_in_range(const CalibrationResult& result, const SearchRange& range) {
  SixParameters six = six_from_rigid(result.ins_from_lidar);
  bool moved = false;
  const auto take = [&](std::size_t parameter, double& value, double minimum, double maximum) {
    if (result.observed[parameter] || (value >= minimum && value <= maximum)) return;
    value = value < minimum ? minimum : maximum;
    moved = true;
  };
  take(0, six.x_m, range.x_min_m, range.x_max_m);
  take(1, six.y_m, range.y_min_m, range.y_max_m);
  take(2, six.z_m, range.z_min_m, range.z_max_m);
  take(3, six.yaw_rad, range.yaw_min_rad, range.yaw_max_rad);
  take(4, six.pitch_rad, range.pitch_min_rad, range.pitch_max_rad);
  take(5, six.roll_rad, range.roll_min_rad, range.roll_max_rad);
  return moved ? rigid_from_six(six) : result.ins_from_lidar;
}

Message words(MethodChoice method) { return needs_of(method).words; }
}  // namespace

const std::vector<CalibrationMethod>& calibration_methods() {
  static const std::vector<CalibrationMethod> methods{
      {kPairwise, "Pairs of keyframes", words(MethodChoice::Pairwise), "", true, run_pipeline},
      {"trajectory", "Trajectory alignment", words(MethodChoice::Trajectory), "trajectory", false,
       run_trajectory_method},
      {"vehicle-frame", "Vehicle frame", words(MethodChoice::VehicleFrame), "vehicle_frame", false, run_vehicle_frame},
      {"fusion-odometry", "Multi-sensor odometry", words(MethodChoice::FusionOdometry), "fusion", true,
       run_fusion_method},
      {"slew", "Slewing machine", words(MethodChoice::Slew), "slew", false, run_slew},
  };
  return methods;
}

const CalibrationMethod& calibration_method(std::string_view id) {
  std::string known;
  for (const CalibrationMethod& method : calibration_methods()) {
    if (method.id == id) return method;
    known += (known.empty() ? "" : ", ") + std::string(method.id);
  }
  throw Error(ErrorCode::Contract, "method " + std::string(id), "is not one of: " + known);
}

bool is_from_pairs(std::string_view id) {
  return std::any_of(calibration_methods().begin(), calibration_methods().end(),
                     [&](const CalibrationMethod& method) { return method.id == id && method.from_pairs; });
}

bool is_measured(const MeasuredOptions& measured) {
  const std::array<bool, 6> parameters = Measured(measured, std::nullopt).parameters();
  return measured.ins_height_sigma_m > 0.0 ||
         std::any_of(parameters.begin(), parameters.end(), [](bool given) { return given; });
}

void refuse_measured(const MeasuredOptions& measured, std::string_view method, std::string_view frame) {
  if (!is_measured(measured)) return;
  throw Error(ErrorCode::Contract, "measured",
              "values measured by hand are of the LiDAR in the INS frame, and the method '" + std::string(method) +
                  "' finds it in that of the " + std::string(frame) + "; leave them out");
}

// A value is given by its sigma: 0 is where one begins to fill the form in.
void report_values_without_sigma(const MeasuredOptions& measured, bool takes_ins_height,
                                 std::vector<Finding>& findings) {
  const auto report = [&findings](const char* name, double value, double sigma, const char* unit, const char* why) {
    if (value != 0.0 && !(sigma > 0.0))
      findings.push_back({Severity::Warning, "measured-unused", "measured",
                          std::string(name) + " was given as measured, " + shortest(value) + " " + unit + why});
  };
  const char* const lacks_sigma = ", without a sigma and is not used: give its sigma, too.";
  report("x", measured.x_m, measured.x_sigma_m, "m", lacks_sigma);
  report("y", measured.y_m, measured.y_sigma_m, "m", lacks_sigma);
  report("z", measured.z_m, measured.z_sigma_m, "m", lacks_sigma);
  report("yaw", measured.yaw_deg, measured.yaw_sigma_deg, "deg", lacks_sigma);
  report("pitch", measured.pitch_deg, measured.pitch_sigma_deg, "deg", lacks_sigma);
  report("roll", measured.roll_deg, measured.roll_sigma_deg, "deg", lacks_sigma);
  report("INS height", measured.ins_height_m, measured.ins_height_sigma_m, "m",
         takes_ins_height ? lacks_sigma : ", and is not used: this method takes no height of the INS. Leave it out.");
}

void check_nominal(const PipelineInput& input) {
  if (!input.nominal_ins_from_lidar) return;
  for (const Message& problem : {frame_problem(input.nominal_frames, input.settings.run.method, input.sessions),
                                 nominal_problem(input.nominal_ins_from_lidar, input.settings.range)})
    if (!problem.empty()) throw Error(ErrorCode::Contract, "nominal mounting", problem);
}

void keep_in_range(const SearchRange& whole, bool nominal_known, CalibrationResult& result) {
  if (!is_usable(result)) return;
  const SearchRange range = range_of(result, whole);
  if (!nominal_known) result.ins_from_lidar = unobserved_in_range(result, range);
  const std::string outside = outside_range(result.ins_from_lidar, range);
  if (!outside.empty()) refuse_out_of_range(outside, result);
}

namespace {

// What a session declares is of the LiDAR in the INS frame.
void tell_unused_nominal(const PipelineInput& input, std::vector<Finding>& findings) {
  const Message unused = unused_declaration(input.settings.run.method, input.sessions);
  if (unused.empty() || input.nominal_ins_from_lidar) return;
  for (const auto& session : input.sessions)
    if (session->nominal_ins_from_lidar) findings.push_back({Severity::Note, "nominal-unused", session->name, unused});
}

// Their errors are the same in every pair: neither residuals nor the number of pairs tell of them.
void tell_of_registration(RegistrationAlgorithm algorithm, std::vector<Finding>& findings) {
  if (algorithm != RegistrationAlgorithm::PclIcp && algorithm != RegistrationAlgorithm::PclNdt) return;
  const bool icp = algorithm == RegistrationAlgorithm::PclIcp;
  findings.push_back({Severity::Warning, "registration-sigma", "registration",
                      std::string(icp ? "pcl-icp" : "pcl-ndt") +
                          " is for comparison: errors may be several times the sigma that is stated."});
}

const CalibrationMethod& chosen_method(const Settings& settings) {
  return calibration_method(kMethodIds.at(static_cast<std::size_t>(settings.run.method)));
}

}  // namespace

void complete_output(const PipelineInput& input, PipelineOutput& output) {
  const CalibrationMethod& method = chosen_method(input.settings);
  keep_in_range(input.settings.range, input.nominal_ins_from_lidar.has_value(), output.result);
  tell_unused_nominal(input, output.findings);
  tell_of_registration(input.settings.registration.algorithm, output.findings);
  if (method.id != kPairwise && output.keyframes.empty()) output.map_check = MapCheck::NoScans;
  // Others take no values: with a sigma they are refused or named by the method.
  if (output.result.reference_frame == "ins" && output.result.calibrated == "lidar")
    report_values_without_sigma(input.settings.measured, method.from_pairs, output.findings);
}

PipelineOutput calibrate(const PipelineInput& input, Progress& progress) {
  const CalibrationMethod& method = chosen_method(input.settings);
  require_valid(input.settings);
  check_nominal(input);
  const SettledSweeps settled = settle_sweeps(input, progress);
  PipelineOutput output = method.run(settled.input, progress);
  add_sweep_doubts(settled, method.run, output, progress);
  complete_output(input, output);
  if (!progress.cancelled()) refuse_vanished(input.sessions);
  return output;
}

}  // namespace remount
