#include "model/methods/calibrate.h"

#include "algorithms/calibration/out_of_range.h"
#include "algorithms/core/error.h"
#include "messages/methods.h"
#include "messages/places.h"
#include "model/pipeline/beam_report.h"
#include "model/pipeline/input_checks.h"
#include "model/pipeline/mended_scans.h"
#include "model/pipeline/watched_scans.h"
#include "model/results/beam_file.h"
#include "model/sweeps/settled_sweeps.h"

namespace remount::methods {
namespace {

// Without an attitude there are no angles that could lie anywhere.
calibration::SearchRange range_of(const calibration::CalibrationResult& result, calibration::SearchRange range) {
  if (result.mounting.sensor != calibration::BodyFrame::Antenna &&
      result.mounting.reference != calibration::BodyFrame::Antenna)
    return range;
  range.yaw_min_rad = range.pitch_min_rad = range.roll_min_rad = -kPi;
  range.yaw_max_rad = range.pitch_max_rad = range.roll_max_rad = kPi;
  return range;
}

RigidTransform unobserved_in_range(const calibration::CalibrationResult& result,
                                   const calibration::SearchRange& range) {
  const RigidTransform& x = result.mounting.reference_from_sensor;
  calibration::PerParameter<double> values = calibration::parameters_of(x);
  bool moved = false;
  const auto take = [&](calibration::Parameter parameter, double minimum, double maximum) {
    double& value = values[parameter];
    if (result.known[parameter].observed || (value >= minimum && value <= maximum)) return;
    value = value < minimum ? minimum : maximum;
    moved = true;
  };
  take(calibration::Parameter::X, range.x_min_m, range.x_max_m);
  take(calibration::Parameter::Y, range.y_min_m, range.y_max_m);
  take(calibration::Parameter::Z, range.z_min_m, range.z_max_m);
  take(calibration::Parameter::Yaw, range.yaw_min_rad, range.yaw_max_rad);
  take(calibration::Parameter::Pitch, range.pitch_min_rad, range.pitch_max_rad);
  take(calibration::Parameter::Roll, range.roll_min_rad, range.roll_max_rad);
  return moved ? calibration::rigid_of(values) : x;
}

}  // namespace

bool is_measured(const calibration::MeasuredOptions& measured) {
  return measured.ins_height_sigma_m > 0.0 || !calibration::Measured(measured, std::nullopt).parameters().empty();
}

void refuse_measured(const calibration::MeasuredOptions& measured, std::string_view method, const Message& frame) {
  if (!is_measured(measured)) return;
  throw Error(ErrorCode::Contract, "measured", say::measured_in_other_frame(std::string(method), frame));
}

// A value is given by its sigma: 0 is where one begins to fill the form in.
void report_values_without_sigma(const calibration::MeasuredOptions& measured, bool takes_ins_height,
                                 std::vector<drive::Finding>& findings) {
  using Why = Message (*)(Message, Message);
  const auto report = [&findings](const Message& name, double value, double sigma, const Message& shown, Why why) {
    if (value != 0.0 && !(sigma > 0.0))
      findings.push_back({drive::Severity::Warning, "measured-unused", say::place_measured(), why(name, shown)});
  };
  const auto length = [&](const Message& name, double length_m, double sigma_m, Why why) {
    report(name, length_m, sigma_m, say::measured_length(Length{length_m}), why);
  };
  const auto angle = [&](const Message& name, double angle_deg, double sigma_deg) {
    report(name, angle_deg, sigma_deg, say::measured_angle(Angle{degrees_to_radians(angle_deg)}),
           say::measured_without_sigma);
  };
  length(calibration::parameter_word(calibration::Parameter::X), measured.x_m, measured.x_sigma_m,
         say::measured_without_sigma);
  length(calibration::parameter_word(calibration::Parameter::Y), measured.y_m, measured.y_sigma_m,
         say::measured_without_sigma);
  length(calibration::parameter_word(calibration::Parameter::Z), measured.z_m, measured.z_sigma_m,
         say::measured_without_sigma);
  angle(calibration::parameter_word(calibration::Parameter::Yaw), measured.yaw_deg, measured.yaw_sigma_deg);
  angle(calibration::parameter_word(calibration::Parameter::Pitch), measured.pitch_deg, measured.pitch_sigma_deg);
  angle(calibration::parameter_word(calibration::Parameter::Roll), measured.roll_deg, measured.roll_sigma_deg);
  length(say::measured_ins_height(), measured.ins_height_m, measured.ins_height_sigma_m,
         takes_ins_height ? say::measured_without_sigma : say::measured_height_not_taken);
}

void check_nominal(const pipeline::PipelineInput& input) {
  if (!input.nominal_ins_from_lidar) return;
  for (const Message& problem :
       {results::frame_problem(input.nominal_frames, *input.settings.run.method, input.sessions),
        settings::nominal_problem(input.nominal_ins_from_lidar, input.settings.range)})
    if (!problem.empty()) throw Error(ErrorCode::Contract, "nominal mounting", problem);
}

void keep_in_range(const calibration::SearchRange& whole, bool nominal_known, calibration::CalibrationResult& result) {
  if (!calibration::is_usable(result)) return;
  const calibration::SearchRange range = range_of(result, whole);
  if (!nominal_known) result.mounting.reference_from_sensor = unobserved_in_range(result, range);
  const auto outside = calibration::outside_range(result.mounting.reference_from_sensor, range);
  if (!outside.empty()) calibration::refuse_out_of_range(outside, result);
}

namespace {

// What a session declares is of the LiDAR in the INS frame.
void tell_unused_nominal(const pipeline::PipelineInput& input, std::vector<drive::Finding>& findings) {
  const Message unused = results::unused_declaration(*input.settings.run.method, input.sessions);
  if (unused.empty() || input.nominal_ins_from_lidar) return;
  for (const auto& session : input.sessions)
    if (session->nominal_ins_from_lidar)
      findings.push_back({drive::Severity::Note, "nominal-unused", session->name, unused});
}

// Their errors are the same in every pair: neither residuals nor the number of pairs tell of them.
void tell_of_registration(registration::RegistrationAlgorithm algorithm, std::vector<drive::Finding>& findings) {
  if (algorithm != registration::RegistrationAlgorithm::PclIcp &&
      algorithm != registration::RegistrationAlgorithm::PclNdt)
    return;
  const bool icp = algorithm == registration::RegistrationAlgorithm::PclIcp;
  findings.push_back({drive::Severity::Warning, "registration-sigma", say::place_registration(),
                      say::method_registration_for_comparison(icp ? "pcl-icp" : "pcl-ndt")});
}

}  // namespace

void complete_output(const pipeline::PipelineInput& input, pipeline::PipelineOutput& output) {
  const method_registry::CalibrationMethod& method = *input.settings.run.method;
  keep_in_range(input.settings.range, input.nominal_ins_from_lidar.has_value(), output.result);
  tell_unused_nominal(input, output.findings);
  tell_of_registration(input.settings.registration.algorithm, output.findings);
  if (method.id != calibration::kPairwise && output.keyframes.empty()) output.map_check = pipeline::MapCheck::NoScans;
  // Others take no values: with a sigma they are refused or named by the method.
  if (output.result.mounting.is_of({calibration::BodyFrame::Ins, calibration::BodyFrame::Lidar}))
    report_values_without_sigma(input.settings.measured, method.from_pairs, output.findings);
}

pipeline::PipelineOutput calibrate(const pipeline::PipelineInput& input, Progress& progress) {
  settings::require_valid(input.settings);
  const method_registry::CalibrationMethod& method = *input.settings.run.method;
  check_nominal(input);
  const pipeline::WatchedScans watched(input.sessions);
  pipeline::PipelineInput seen = input;
  seen.known_beams = results::known_beams(input.settings.beams, input.sessions);
  for (std::size_t s = 0; s < seen.sessions.size(); ++s)
    seen.sessions[s] = pipeline::mended_session(watched.sessions()[s], seen.known_beams);
  const sweeps::SettledSweeps settled = sweeps::settle_sweeps(seen, progress);
  pipeline::PipelineOutput output = method.run(settled.input, progress);
  sweeps::add_sweep_doubts(settled, method.run, output, progress);
  // The other methods go through all scans and say themselves what they left out.
  if (method.id == calibration::kPairwise) watched.report(output.findings);
  complete_output(input, output);
  pipeline::add_known_beams(seen.known_beams, output);
  if (!progress.cancelled()) pipeline::refuse_vanished(input.sessions);
  return output;
}

}  // namespace remount::methods
