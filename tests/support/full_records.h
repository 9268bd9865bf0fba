// A result and a project of which every member is another than from the first.
#pragma once

#include <filesystem>
#include <string>

#include "messages/parameters.h"
#include "messages/places.h"
#include "messages/plots.h"
#include "messages/quantities.h"
#include "model/project/project.h"
#include "model/results/vehicle_file.h"

namespace remount::testing {

inline cloud::BeamNodes full_nodes() { return cloud::BeamNodes::over(-1.0, 1.0, -0.2, 0.2); }

inline calibration::CalibrationResult full_calibration_result() {
  calibration::CalibrationResult result;
  result.status = calibration::Status::Degenerate;
  result.message = Message::verbatim("Solved; z is not observed.");
  result.advice = {Message::verbatim("Drive a ramp."), Message::verbatim("Turn more.")};
  result.mounting = {calibration::BodyFrame::Vehicle, calibration::BodyFrame::Antenna,
                     rigid_from_six({0.9, -0.25, 0.75, 0.3, -0.02, 0.015})};
  result.set_observed(~calibration::ParameterSet{calibration::Parameter::Z},
                      Message::verbatim("height z: flat driving"));
  result.set_measured({calibration::Parameter::X, calibration::Parameter::Yaw});
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k)
      result.covariance(i, k) = i == 2 || k == 2 ? std::nan("") : i == k ? 1e-4 * (i + 1) : 1e-7 * (i + k);
  for (const calibration::Parameter parameter : calibration::kParameters)
    if (parameter != calibration::Parameter::Z)
      result.known[parameter].bootstrap_sigma = 0.01 + 0.003 * calibration::row_of(parameter);
  result.directions = {
      {Vector6d::Unit(2), std::numeric_limits<double>::infinity(), false, Message::verbatim("height z: flat driving")},
      {Vector6d::Unit(0), 0.25, true, Message::verbatim("x")}};
  calibration::SigmaPart part{say::sigma_part_registration(), {}};
  for (const calibration::Parameter parameter : calibration::kParameters)
    part.sigma[parameter] = parameter == calibration::Parameter::Z ? std::nan("") : 0.001 * (1 + row_of(parameter));
  result.sigma_parts = {part, {Message::verbatim("clocks"), part.sigma}};
  result.beams.nodes = full_nodes();
  result.beams.errors.setLinSpaced(full_nodes().errors(), -0.01, 0.02);
  result.beams.sigmas.setConstant(full_nodes().errors(), 0.001);
  result.beams.elevation = {0.003, 0.0001, true}, result.beams.range = {0.004, 0.001, true};
  result.noise = {0.02, 6e-4, 4.0, 2e-3, 2e-4, 0.1, 0.2};
  result.session_disagreement = 1.5;
  result.pairs_proposed = 10, result.pairs_accepted = 7, result.pairs_rejected = 3;
  result.frobenius_sum = 0.123, result.rotation_rms_rad = 1e-4, result.translation_rms_m = 0.0123;
  result.time_offset = {0.0123, 0.001, true, true};
  result.session_time_offset_s = {0.01, std::nan("")}, result.session_time_offset_sigma_s = {0.001, 0.002};
  result.session_position_lag_s = {0.03, 0.04}, result.session_position_lag_sigma_s = {0.003, std::nan("")};
  result.position_lag_applied = true;
  result.candidates = {
      {calibration::MountingSource::ParkMartin, result.mounting.reference_from_sensor, 0.123, true, {}, 0.01},
      {calibration::MountingSource::pairs(motion::PairIndex(3), motion::PairIndex(4)),
       rigid_from_six({9, 0, 0, 3.0, 0, 0}), 5.0, false, Message::verbatim("x = 9 m is above 5 m"), std::nan("")}};
  return result;
}

inline std::vector<calibration::NamedQuantity> full_quantities() {
  return {{"odometry scale 2", say::quantity_odometry_scale_of(2), 1.01, 0.1, "m", false},
          {"slew centre x", say::quantity_slew_centre_x(), std::nan(""), std::nan(""), "", true}};
}

inline std::vector<calibration::Plot> full_plots() {
  calibration::Curve way{
      say::plot_curve_aligned(), {0.5, 1.5, std::nan("")}, {2.0, -3.25, 0.0}, {0.1, 0.2, 0.3}, true, {0.5, 1, 2}};
  calibration::Curve bare{say::plot_curve_gnss_fixes(), {1.0}, {2.0}, {}, false, {}};
  return {{say::plot_trajectory_before_and_after(), say::plot_axis_east(), say::plot_axis_north(), true, {way, bare}}};
}

inline std::vector<drive::Finding> full_findings() {
  return {{drive::Severity::Warning, "scan-unreadable", std::string("drive"), Message::verbatim("scan 7 was skipped")},
          {drive::Severity::Problem, "ins-gap", say::place_lidar_and_gnss(), Message::verbatim("a gap")}};
}

inline results::ResultFile full_result_file() {
  results::ResultFile file;
  file.method = "trajectory";
  file.result = full_calibration_result();
  file.quantities = full_quantities();
  file.plots = full_plots();
  file.ins_axes = drive::InsAxes::BackwardRightUp;
  file.nominal_ins_from_lidar = rigid_from_six({1, 0, 1, 0, 0, 0});
  file.pairs = {
      {motion::SessionIndex(1), 1317636475123456789LL, 1317636476123456789LL, motion::PairState::Rejected,
       motion::DecidedBy::User, Message::verbatim("by \"hand\": no"), 0.1, 2.0, 0.03, 0.7, 1.2, 0.001, 0.02, 0.5, 9},
      {motion::SessionIndex(2),
       -5,
       7,
       motion::PairState::Accepted,
       motion::DecidedBy::Program,
       {},
       std::nan(""),
       2.0,
       std::nan(""),
       0.7,
       1.2,
       std::nan(""),
       0.02,
       0.5,
       0}};
  file.sharpness = {{calibration::MountingSource::Result, {-2.5, 0.02, 1234}},
                    {calibration::MountingSource::Nominal, {-2.25, std::nan(""), 5}}};
  file.findings = full_findings();
  file.version = "0.0.1-before";
  file.settings.solve.max_listed_candidates = 55;
  file.inputs = {{"drive", "ins.csv", 123, std::string(64, 'a')}, {"drive", "gone.csv", 0, ""}};
  file.topics = {{"drive", {{"lidar", "/front/points"}, {"gnss", "none"}}, {{"gnss", "none"}}}, {"other", {}, {}}};
  return file;
}

inline results::VehicleFile full_vehicle_file() {
  results::VehicleFile vehicle;
  vehicle.lidars = {{"front", true, full_result_file()}, {"rear", true, full_result_file()}};
  vehicle.lidars[1].file.result.mounting.reference_from_sensor = rigid_from_six({-1, 0.5, 1, 3, 0.1, 0});
  results::RelativeRecord relative;
  relative.lidar_a = "front", relative.lidar_b = "rear";
  relative.lidar_a_from_lidar_b = rigid_from_six({-2, 0.5, 0.25, 3, 0, 0.125});
  relative.sigma[calibration::Parameter::X] = 0.002, relative.sigma[calibration::Parameter::Z] = 0.003;
  relative.sigma[calibration::Parameter::Yaw] = 0.001;
  relative.height_m = 0.125, relative.height_sigma_m = 0.002;
  vehicle.relatives = {relative};
  vehicle.agreements = {{"front", "rear", Vector6d::Constant(0.01), Vector6d::Constant(0.005), 1.5}};
  vehicle.groups = {{"front", "rear"}};
  vehicle.findings = full_findings();
  vehicle.version = "0.0.1-before";
  return vehicle;
}

inline motion::Pair full_pair(motion::KeyframeIndex first) {
  motion::Pair pair;
  pair.keyframe_a = first, pair.keyframe_b = motion::KeyframeIndex(first + 1);
  pair.gap_s = 0.5, pair.baseline_m = 3.0, pair.rotation_rad = 0.2;
  pair.shared_objects = 4, pair.moving_objects = 2;
  pair.ins_b_from_ins_a = rigid_from_six({1, 2, 3, 0.1, 0.2, 0.3});
  pair.lidar_b_from_lidar_a = rigid_from_six({3, 2, 1, -0.1, 0.2, 0.3});
  pair.registration.attempted = pair.registration.converged = true;
  pair.registration.iterations = 12;
  pair.registration.rmse_m = 0.02, pair.registration.overlap = 0.75;
  pair.registration.information = Matrix6d::Identity() * 7;
  pair.registration.information(0, 5) = pair.registration.information(5, 0) = 0.25;
  pair.registration.beam_response.setZero(6, full_nodes().errors());
  pair.registration.beam_response.col(3).setLinSpaced(0.5f, 0.25f);
  pair.registration.beam_response.col(full_nodes().range_scale()).setConstant(-1.5f);
  pair.registration.failure = Message::verbatim("too few points");
  pair.registration.undetermined = Message::verbatim("along the tunnel");
  pair.screw = {0.001, 0.02, 1.5, false};
  pair.residual_rotation_rad = 0.003, pair.residual_translation_m = 0.04, pair.weight = 0.6;
  pair.state = motion::PairState::Rejected, pair.decided_by = motion::DecidedBy::User;
  pair.reason = Message::verbatim("moving objects here");
  return pair;
}

inline pipeline::PipelineOutput full_output() {
  pipeline::PipelineOutput output;
  output.keyframes = {{motion::SessionIndex(0), motion::ScanIndex(3), 100, 1.5},
                      {motion::SessionIndex(1), motion::ScanIndex(5), 200, 3.0},
                      {motion::SessionIndex(1), motion::ScanIndex(9), 300, 6.0}};
  output.pairs = {full_pair(motion::KeyframeIndex(0)), full_pair(motion::KeyframeIndex(1))};
  output.pairs[1].registration.rmse_m = std::nan("");
  output.pairs[1].registration.undetermined = {};
  output.up_in_lidar = Eigen::Vector3d(0.0, 0.6, 0.8);
  output.session_uses_sweep = {true, false};
  output.session_sweeps = {{0.05, 0.5, false, true, true, true, {}}};
  output.session_swept = {{-0.02, 0.03}};
  output.session_frames = {1, 5};
  output.sweep_doubts = {Vector6d::Constant(0.01), Vector6d::Constant(0.02)};
  output.clock_told = false;
  output.farthest_clock_s = 0.125;
  output.ground = calibration::ObservedGround{{0.6, 0.0, 0.8}, 1.75, 0.01, 0.002};
  output.method = "fusion-odometry";
  output.result = full_calibration_result();
  output.clock_is_unknown = true;
  output.clock_bias = Vector6d::Constant(0.25);
  output.quantities = full_quantities();
  output.plots = full_plots();
  output.sharpness = full_result_file().sharpness;
  output.map_check = pipeline::MapCheck::Moved;
  output.findings = full_findings();
  output.initial_ins_from_lidar = rigid_from_six({1, 0, 1, 0.1, 0, 0});
  output.compensation_ins_from_lidar = rigid_from_six({1, 0.5, 1, 0.1, 0, 0});
  output.beam_nodes = full_nodes();
  output.mended_beams = cloud::BeamErrors(full_nodes());
  output.mended_beams.values[4] = 0.002, output.mended_beams.values[full_nodes().range_scale()] = 1e-4;
  output.known_beams.nodes = full_nodes();
  output.known_beams.errors.setConstant(full_nodes().errors(), 0.002);
  output.known_beams.sigmas.setConstant(full_nodes().errors(), 0.0005);
  output.known_beams.elevation = {0.002, 0.0004, true}, output.known_beams.range = {0.002, 0.0003, true};
  output.nominal_known = output.initial_known = true;
  return output;
}

/// Of one LiDAR.
inline project::Project full_job(const std::filesystem::path& folder) {
  project::Project project;
  project.sessions = {folder / "drives" / "one", folder / "two", folder / "three"};
  project.topics = {{{"lidar", "/points"}, {"gnss", "none"}}, {}, {{"ins", "/ins"}}};
  project.settings.pairing.max_gap_s = 1.25;
  project.nominal_ins_from_lidar = rigid_from_six({1, 0, 1, 0.1, 0, 0});
  project.verdicts = {{motion::SessionIndex(1), 100, 200, motion::PairState::Rejected, Message::verbatim("a lorry")},
                      {motion::SessionIndex(0), -1, 2, motion::PairState::Accepted, {}}};
  project.output = full_output();
  project.solution_pending = project.confirmed = project.exported = true;
  project.basis.session_count = 2;
  project.basis.settings.pairing.max_gap_s = 2.5;
  project.basis.nominal_ins_from_lidar = rigid_from_six({2, 0, 1, 0.1, 0, 0});
  project.inputs = full_result_file().inputs;
  return project;
}

inline project::Project full_project(const std::filesystem::path& folder) {
  project::Project project = full_job(folder);
  project.notes = {{motion::SessionIndex(1), "/points", 100, 200, true, true, "the lorry's shadow"},
                   {motion::SessionIndex(0), "", -1, 2, true, false, ""}};
  project.other_lidars.push_back({"rear", false, full_job(folder)});
  project.together = full_vehicle_file();
  return project;
}

}  // namespace remount::testing
