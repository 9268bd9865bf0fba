#include "model/methods/calibrate.h"

#include "algorithms/calibration/out_of_range.h"
#include "algorithms/core/error.h"
#include "messages/methods.h"
#include "messages/places.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/watched_scans.h"
#include "model/sweeps/settled_sweeps.h"

namespace remount {
namespace {

// Without an attitude there are no angles that could lie anywhere.
SearchRange range_of(const CalibrationResult& result, SearchRange range) {
  if (result.mounting.sensor != BodyFrame::Antenna && result.mounting.reference != BodyFrame::Antenna) return range;
  range.yaw_min_rad = range.pitch_min_rad = range.roll_min_rad = -kPi;
  range.yaw_max_rad = range.pitch_max_rad = range.roll_max_rad = kPi;
  return range;
}

RigidTransform unobserved_in_range(const CalibrationResult& result, const SearchRange& range) {
  const RigidTransform& x = result.mounting.reference_from_sensor;
  PerParameter<double> values = parameters_of(x);
  bool moved = false;
  const auto take = [&](Parameter parameter, double minimum, double maximum) {
    double& value = values[parameter];
    if (result.known[parameter].observed || (value >= minimum && value <= maximum)) return;
    value = value < minimum ? minimum : maximum;
    moved = true;
  };
  take(Parameter::X, range.x_min_m, range.x_max_m);
  take(Parameter::Y, range.y_min_m, range.y_max_m);
  take(Parameter::Z, range.z_min_m, range.z_max_m);
  take(Parameter::Yaw, range.yaw_min_rad, range.yaw_max_rad);
  take(Parameter::Pitch, range.pitch_min_rad, range.pitch_max_rad);
  take(Parameter::Roll, range.roll_min_rad, range.roll_max_rad);
  return moved ? rigid_of(values) : x;
}

}  // namespace

bool is_measured(const MeasuredOptions& measured) {
  return measured.ins_height_sigma_m > 0.0 || !Measured(measured, std::nullopt).parameters().empty();
}

void refuse_measured(const MeasuredOptions& measured, std::string_view method, const Message& frame) {
  if (!is_measured(measured)) return;
  throw Error(ErrorCode::Contract, "measured", say::measured_in_other_frame(std::string(method), frame));
}

// A value is given by its sigma: 0 is where one begins to fill the form in.
void report_values_without_sigma(const MeasuredOptions& measured, bool takes_ins_height,
                                 std::vector<Finding>& findings) {
  using Why = Message (*)(Message, Message);
  const auto report = [&findings](const Message& name, double value, double sigma, const Message& shown, Why why) {
    if (value != 0.0 && !(sigma > 0.0))
      findings.push_back({Severity::Warning, "measured-unused", say::place_measured(), why(name, shown)});
  };
  const auto length = [&](const Message& name, double length_m, double sigma_m, Why why) {
    report(name, length_m, sigma_m, say::measured_length(Length{length_m}), why);
  };
  const auto angle = [&](const Message& name, double angle_deg, double sigma_deg) {
    report(name, angle_deg, sigma_deg, say::measured_angle(Angle{degrees_to_radians(angle_deg)}),
           say::measured_without_sigma);
  };
  length(parameter_word(Parameter::X), measured.x_m, measured.x_sigma_m, say::measured_without_sigma);
  length(parameter_word(Parameter::Y), measured.y_m, measured.y_sigma_m, say::measured_without_sigma);
  length(parameter_word(Parameter::Z), measured.z_m, measured.z_sigma_m, say::measured_without_sigma);
  angle(parameter_word(Parameter::Yaw), measured.yaw_deg, measured.yaw_sigma_deg);
  angle(parameter_word(Parameter::Pitch), measured.pitch_deg, measured.pitch_sigma_deg);
  angle(parameter_word(Parameter::Roll), measured.roll_deg, measured.roll_sigma_deg);
  length(say::measured_ins_height(), measured.ins_height_m, measured.ins_height_sigma_m,
         takes_ins_height ? say::measured_without_sigma : say::measured_height_not_taken);
}

void check_nominal(const PipelineInput& input) {
  if (!input.nominal_ins_from_lidar) return;
  for (const Message& problem : {frame_problem(input.nominal_frames, *input.settings.run.method, input.sessions),
                                 nominal_problem(input.nominal_ins_from_lidar, input.settings.range)})
    if (!problem.empty()) throw Error(ErrorCode::Contract, "nominal mounting", problem);
}

void keep_in_range(const SearchRange& whole, bool nominal_known, CalibrationResult& result) {
  if (!is_usable(result)) return;
  const SearchRange range = range_of(result, whole);
  if (!nominal_known) result.mounting.reference_from_sensor = unobserved_in_range(result, range);
  const auto outside = outside_range(result.mounting.reference_from_sensor, range);
  if (!outside.empty()) refuse_out_of_range(outside, result);
}

namespace {

// What a session declares is of the LiDAR in the INS frame.
void tell_unused_nominal(const PipelineInput& input, std::vector<Finding>& findings) {
  const Message unused = unused_declaration(*input.settings.run.method, input.sessions);
  if (unused.empty() || input.nominal_ins_from_lidar) return;
  for (const auto& session : input.sessions)
    if (session->nominal_ins_from_lidar) findings.push_back({Severity::Note, "nominal-unused", session->name, unused});
}

// Their errors are the same in every pair: neither residuals nor the number of pairs tell of them.
void tell_of_registration(RegistrationAlgorithm algorithm, std::vector<Finding>& findings) {
  if (algorithm != RegistrationAlgorithm::PclIcp && algorithm != RegistrationAlgorithm::PclNdt) return;
  const bool icp = algorithm == RegistrationAlgorithm::PclIcp;
  findings.push_back({Severity::Warning, "registration-sigma", say::place_registration(),
                      say::method_registration_for_comparison(icp ? "pcl-icp" : "pcl-ndt")});
}

}  // namespace

void complete_output(const PipelineInput& input, PipelineOutput& output) {
  const CalibrationMethod& method = *input.settings.run.method;
  keep_in_range(input.settings.range, input.nominal_ins_from_lidar.has_value(), output.result);
  tell_unused_nominal(input, output.findings);
  tell_of_registration(input.settings.registration.algorithm, output.findings);
  if (method.id != kPairwise && output.keyframes.empty()) output.map_check = MapCheck::NoScans;
  // Others take no values: with a sigma they are refused or named by the method.
  if (output.result.mounting.is_of({BodyFrame::Ins, BodyFrame::Lidar}))
    report_values_without_sigma(input.settings.measured, method.from_pairs, output.findings);
}

PipelineOutput calibrate(const PipelineInput& input, Progress& progress) {
  require_valid(input.settings);
  const CalibrationMethod& method = *input.settings.run.method;
  check_nominal(input);
  const WatchedScans watched(input.sessions);
  PipelineInput seen = input;
  seen.sessions = watched.sessions();
  const SettledSweeps settled = settle_sweeps(seen, progress);
  PipelineOutput output = method.run(settled.input, progress);
  add_sweep_doubts(settled, method.run, output, progress);
  // The other methods go through all scans and say themselves what they left out.
  if (method.id == kPairwise) watched.report(output.findings);
  complete_output(input, output);
  if (!progress.cancelled()) refuse_vanished(input.sessions);
  return output;
}

}  // namespace remount
