// Records member by member, for tests that every one of them is kept: a member that is added to a record does not
// compile here until it is named, and is then asked for by each test that uses this.
#pragma once

#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/project/project.h"
#include "model/results/vehicle_file.h"
#include "model/settings/settings_file.h"

namespace remount::testing {

/// Members of a record with their names in one text, "session, stamp_ns".
template <class... Members>
struct NamedMembers {
  std::string_view names;
  std::tuple<const Members&...> values;
};
template <class... Members>
NamedMembers<Members...> named(std::string_view names, const Members&... values) {
  return {names, {values...}};
}

#define REMOUNT_MEMBERS(Record, ...)          \
  inline auto members(const Record& record) { \
    const auto& [__VA_ARGS__] = record;       \
    return named(#__VA_ARGS__, __VA_ARGS__);  \
  }

REMOUNT_MEMBERS(motion::Keyframe, session, scan, stamp_ns, travelled_m)
REMOUNT_MEMBERS(motion::RegistrationQuality, attempted, converged, iterations, rmse_m, overlap, information,
                beam_response, failure, undetermined)
REMOUNT_MEMBERS(cloud::BeamMean, error, sigma, told)
REMOUNT_MEMBERS(cloud::BeamEstimate, nodes, errors, sigmas, elevation, range)
REMOUNT_MEMBERS(cloud::BeamErrors, nodes, values)
REMOUNT_MEMBERS(motion::ScrewTest, rotation_difference_rad, translation_difference_m, score, passed)
REMOUNT_MEMBERS(motion::Pair, keyframe_a, keyframe_b, gap_s, baseline_m, rotation_rad, shared_objects, moving_objects,
                ins_b_from_ins_a, lidar_b_from_lidar_a, registration, screw, residual_rotation_rad,
                residual_translation_m, weight, state, decided_by, reason)
REMOUNT_MEMBERS(pipeline::PairVerdict, session, stamp_a_ns, stamp_b_ns, state, reason)
REMOUNT_MEMBERS(results::PairRecord, session, stamp_a_ns, stamp_b_ns, state, decided_by, reason, rotation_rad,
                baseline_m, rmse_m, overlap, screw_score, residual_rotation_rad, residual_translation_m, weight,
                shared_objects)
REMOUNT_MEMBERS(drive::Finding, severity, code, where, explanation)
REMOUNT_MEMBERS(calibration::NamedQuantity, id, name, value, sigma, unit, observed)
REMOUNT_MEMBERS(calibration::Curve, name, x, y, sigma, dots, z)
REMOUNT_MEMBERS(calibration::Plot, title, x_label, y_label, equal_axes, curves)
REMOUNT_MEMBERS(quality::MapSharpness, mean_map_entropy, plane_thickness_m, points)
REMOUNT_MEMBERS(quality::NamedSharpness, source, sharpness)
REMOUNT_MEMBERS(results::InputFile, session, file, bytes, sha256)
REMOUNT_MEMBERS(results::UsedTopics, session, topics, asked)
REMOUNT_MEMBERS(calibration::Candidate, source, ins_from_lidar, frobenius_sum, in_range, out_of_range, certified_gap)
REMOUNT_MEMBERS(calibration::ObservabilityDirection, direction, sigma, observed, words)
REMOUNT_MEMBERS(calibration::SigmaPart, source, sigma)
REMOUNT_MEMBERS(calibration::Knowledge, observed, measured, bootstrap_sigma, why_not_observed)
REMOUNT_MEMBERS(calibration::TimeOffset, offset_s, sigma_s, applied, in_sigma)
REMOUNT_MEMBERS(calibration::Mounting, reference, sensor, reference_from_sensor)
REMOUNT_MEMBERS(calibration::NoiseModel, ins_position_sigma_m, ins_attitude_sigma_rad, registration_scale,
                registration_floor_m, registration_floor_rad, ins_position_drift, ins_attitude_drift)
REMOUNT_MEMBERS(calibration::CalibrationResult, status, message, advice, mounting, known, covariance, directions,
                sigma_parts, beams, noise, session_disagreement, pairs_proposed, pairs_accepted, pairs_rejected,
                frobenius_sum, rotation_rms_rad, translation_rms_m, time_offset, session_time_offset_s,
                session_time_offset_sigma_s, session_position_lag_s, session_position_lag_sigma_s, position_lag_applied,
                candidates)
REMOUNT_MEMBERS(results::ResultFile, method, result, quantities, plots, ins_axes, nominal_ins_from_lidar, pairs,
                sharpness, findings, version, settings, inputs, topics)
REMOUNT_MEMBERS(results::LidarResult, name, joined, file)
REMOUNT_MEMBERS(results::RelativeRecord, lidar_a, lidar_b, lidar_a_from_lidar_b, sigma, height_m, height_sigma_m)
REMOUNT_MEMBERS(results::AgreementRecord, lidar_a, lidar_b, difference, sigma, most_sigmas)
REMOUNT_MEMBERS(results::VehicleFile, lidars, relatives, agreements, groups, findings, version)
REMOUNT_MEMBERS(motion::Sweep, from_s, until_s)
REMOUNT_MEMBERS(drive::SweepModel, period_s, stamp_azimuth_rad, clockwise, certain, direction_known, by_order, by_times)
REMOUNT_MEMBERS(calibration::ObservedGround, up_in_lidar, lidar_height_m, height_sigma_m, up_sigma_rad)
REMOUNT_MEMBERS(pipeline::PairEvidence, keyframes, pairs, up_in_lidar, session_uses_sweep, session_sweeps,
                session_swept, session_frames, sweep_doubts, clock_told, farthest_clock_s, ground)
REMOUNT_MEMBERS(pipeline::CalibrationOutcome, method, result, clock_is_unknown, clock_bias, quantities, plots,
                sharpness, map_check)
REMOUNT_MEMBERS(pipeline::RunRecord, findings, initial_ins_from_lidar, compensation_ins_from_lidar, beam_nodes,
                mended_beams, known_beams, nominal_known, initial_known)
REMOUNT_MEMBERS(project::CalibrationBasis, session_count, settings, nominal_ins_from_lidar)
REMOUNT_MEMBERS(project::PairNote, session, lidar, stamp_a_ns, stamp_b_ns, seen, flagged, comment)
REMOUNT_MEMBERS(project::Project, sessions, topics, settings, nominal_ins_from_lidar, verdicts, notes, output,
                solution_pending, confirmed, exported, basis, inputs, other_lidars, together)
REMOUNT_MEMBERS(project::OtherLidar, name, ticked, job)
#undef REMOUNT_MEMBERS

inline auto members(const pipeline::PipelineOutput& output) {
  return named("evidence, outcome, record", static_cast<const pipeline::PairEvidence&>(output),
               static_cast<const pipeline::CalibrationOutcome&>(output),
               static_cast<const pipeline::RunRecord&>(output));
}

/// Not a number is like itself. Angles are told in degrees, which costs a last digit.
inline bool is_same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= 1e-14 * std::abs(a);
}
template <class Numbers>
bool all_same(const Eigen::DenseBase<Numbers>& a, const Eigen::DenseBase<Numbers>& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
  for (Eigen::Index row = 0; row < a.rows(); ++row)
    for (Eigen::Index column = 0; column < a.cols(); ++column)
      if (!is_same(a(row, column), b(row, column))) return false;
  return true;
}
inline bool is_same(const Vector6d& a, const Vector6d& b) { return all_same(a, b); }
inline bool is_same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return all_same(a, b); }
inline bool is_same(const Matrix6d& a, const Matrix6d& b) { return all_same(a, b); }
/// A file ends with the last column that is not zero.
inline bool is_same(const motion::BeamResponse& a, const motion::BeamResponse& b) {
  const auto told = [](const motion::BeamResponse& response) {
    Eigen::Index columns = response.cols();
    while (columns > 0 && response.col(columns - 1).isZero(0.0f)) --columns;
    return response.leftCols(columns).eval();
  };
  return all_same(told(a), told(b));
}
inline bool is_same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return all_same(a, b); }
inline bool is_same(const RigidTransform& a, const RigidTransform& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < 1e-14;
}
inline bool is_same(const settings::Settings& a, const settings::Settings& b) {
  return settings::settings_text(a) == settings::settings_text(b);
}
inline bool is_same(const drive::TopicChoice& a, const drive::TopicChoice& b) { return a == b; }
template <class T>
bool is_same(const T& a, const T& b) {
  return a == b;
}

/// Goes through two records at once and notes at which members they are the same somewhere and nowhere. Members of
/// what stands in lists and for each parameter have one name for all of these.
class MemberComparison {
 public:
  template <class T>
  void compare(const std::string& name, const T& a, const T& b) {
    if constexpr (requires { members(a); })
      compare_members(name, members(a), members(b));
    else
      note(name, is_same(a, b));
  }

  template <class T>
  void compare(const std::string& name, const std::vector<T>& a, const std::vector<T>& b) {
    if (a.size() != b.size()) note(name, false);
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) compare<T>(name, a[i], b[i]);
    if (a.empty() && b.empty()) note(name, true);
  }

  template <class T>
  void compare(const std::string& name, const std::optional<T>& a, const std::optional<T>& b) {
    if (a && b)
      compare(name, *a, *b);
    else
      note(name, a.has_value() == b.has_value());
  }

  template <class T>
  void compare(const std::string& name, const calibration::PerParameter<T>& a, const calibration::PerParameter<T>& b) {
    for (const calibration::Parameter parameter : calibration::kParameters) compare(name, a[parameter], b[parameter]);
  }

  /// A record that is to have nothing as it is from the first: lists and what may be missing by what they hold.
  template <class T>
  void compare_with_fresh(const std::string& name, const T& value) {
    compare_with(name, value, T());
  }

  const std::set<std::string>& differ_somewhere() const { return differ_; }
  std::set<std::string> same_everywhere() const {
    std::set<std::string> names;
    for (const std::string& name : same_)
      if (differ_.count(name) == 0) names.insert(name);
    return names;
  }

 private:
  template <class T>
  void compare_with(const std::string& name, const T& value, const T& fresh) {
    if constexpr (requires { members(value); })
      compare_members(name, members(value), members(fresh), true);
    else
      note(name, is_same(value, fresh));
  }
  template <class T>
  void compare_with(const std::string& name, const std::vector<T>& values, const std::vector<T>&) {
    if (values.empty()) note(name, true);
    for (const T& value : values) compare_with<T>(name, value, T());
  }
  template <class T>
  void compare_with(const std::string& name, const std::optional<T>& value, const std::optional<T>&) {
    if (value)
      compare_with(name, *value, T());
    else
      note(name, true);
  }
  template <class T>
  void compare_with(const std::string& name, const calibration::PerParameter<T>& values,
                    const calibration::PerParameter<T>& fresh) {
    for (const calibration::Parameter parameter : calibration::kParameters)
      compare_with(name, values[parameter], fresh[parameter]);
  }

  template <class... Members>
  void compare_members(const std::string& name, const NamedMembers<Members...>& a, const NamedMembers<Members...>& b,
                       bool fresh = false) {
    std::size_t begin = 0;
    const auto next_name = [&] {
      const std::size_t end = std::min(a.names.find(", ", begin), a.names.size());
      const std::string member(a.names.substr(begin, end - begin));
      begin = end + 2;
      return (name.empty() ? "" : name + ".") + member;
    };
    const auto one = [&](const auto& of_a, const auto& of_b) {
      if (fresh)
        compare_with(next_name(), of_a, of_b);
      else
        compare(next_name(), of_a, of_b);
    };
    [&]<std::size_t... index>(std::index_sequence<index...>) {
      (one(std::get<index>(a.values), std::get<index>(b.values)), ...);
    }
    (std::index_sequence_for<Members...>());
  }

  void note(const std::string& name, bool same) { (same ? same_ : differ_).insert(name); }

  std::set<std::string> same_, differ_;
};

/// Names of the members that are not the same.
template <class Record>
std::set<std::string> members_that_differ(const Record& a, const Record& b) {
  MemberComparison comparison;
  comparison.compare("", a, b);
  return comparison.differ_somewhere();
}

/// Names of the members that are as those of a fresh record, in each record of a list.
template <class Record>
std::set<std::string> members_not_set(const Record& record) {
  MemberComparison comparison;
  comparison.compare_with_fresh("", record);
  return comparison.same_everywhere();
}

}  // namespace remount::testing
