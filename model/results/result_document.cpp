// What stands in "remount-result/2" and its former version, with every check that keeps a damaged file from becoming an
// extrinsic.
#include <array>
#include <cmath>
#include <limits>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/error.h"
#include "messages/drives.h"
#include "messages/results.h"
#include "model/formats/documents/finding_document.h"
#include "model/formats/documents/method_document.h"
#include "model/formats/documents/notations.h"
#include "model/results/beam_document.h"
#include "model/results/result_file.h"
#include "model/results/sigma_document.h"
#include "model/results/topic_document.h"
#include "model/results/version_name.h"
#include "model/settings/settings_file.h"

namespace remount::results {

using calibration::Parameter;
using formats::DocumentNode;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Beyond this the list of pairs is cut, so that every file we write is one that we read.
constexpr std::size_t kMaxListedPairs = 20000;

// ---- What is told in a way of its own: each written and read side by side

constexpr formats::Through kSourceName{
    [](const calibration::MountingSource& source) { return DocumentNode::string(to_string(source)); },
    [](const formats::DocumentView& view) { return calibration::mounting_source_from_string(view.string()); }};

constexpr formats::Through kTopics{topic_choice_document,
                                   [](const formats::DocumentView& view) { return topic_choice_from_document(view); }};

std::vector<std::string_view> ins_axes_names() {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < drive::kInsAxesCount; ++i) names.push_back(to_string(static_cast<drive::InsAxes>(i)));
  return names;
}

/// Of a result whose `known` says already what is observed. Read, they are the diagonal of the covariance, for a file
/// that has none of it.
struct SigmaNotation {
  DocumentNode write(const calibration::CalibrationResult& result) const {
    Sigmas sigmas;
    for (const Parameter parameter : calibration::kParameters) sigmas[parameter] = result.estimate(parameter).sigma;
    return kSigmas.write(sigmas);
  }
  void read(const formats::DocumentView& view, calibration::CalibrationResult& result) const {
    Sigmas sigmas;
    kSigmas.read(view, sigmas);
    for (const Parameter parameter : calibration::kParameters) {
      const bool observed = result.known[parameter].observed;
      if (sigmas[parameter] && !observed) view.fail(say::result_sigma_of_unobserved(std::string(to_string(parameter))));
      const double sigma = sigmas[parameter].value_or(kNan);
      if (observed) result.covariance(calibration::row_of(parameter), calibration::row_of(parameter)) = sigma * sigma;
    }
  }
};

struct BootstrapSigmaNotation {
  DocumentNode write(const calibration::CalibrationResult& result) const {
    Sigmas sigmas;
    for (const Parameter parameter : calibration::kParameters)
      sigmas[parameter] = result.estimate(parameter).bootstrap_sigma;
    return kSigmas.write(sigmas);
  }
  void read(const formats::DocumentView& view, calibration::CalibrationResult& result) const {
    Sigmas sigmas;
    kSigmas.read(view, sigmas);
    for (const Parameter parameter : calibration::kParameters)
      result.known[parameter].bootstrap_sigma = sigmas[parameter];
  }
};

/// Null where it is not a number.
struct PartNotation {
  DocumentNode write(const calibration::PerParameter<double>& part) const {
    Sigmas sigmas;
    for (const Parameter parameter : calibration::kParameters)
      if (std::isfinite(part[parameter])) sigmas[parameter] = part[parameter];
    return kSigmas.write(sigmas);
  }
  void read(const formats::DocumentView& view, calibration::PerParameter<double>& part) const {
    Sigmas sigmas;
    kSigmas.read(view, sigmas);
    for (const Parameter parameter : calibration::kParameters) part[parameter] = sigmas[parameter].value_or(kNan);
  }
};

/// Row by row; null where it is not a number.
struct SixRows {
  DocumentNode write(const Matrix6d& matrix) const {
    DocumentNode rows = DocumentNode::sequence();
    for (int row = 0; row < 6; ++row) {
      const Vector6d entries = matrix.row(row);
      rows.add(DocumentNode::numbers({entries.begin(), entries.end()}));
    }
    return rows;
  }
  void read(const formats::DocumentView& view, Matrix6d& matrix) const {
    const std::vector<formats::DocumentView> rows = view.items();
    if (rows.size() != 6) view.fail(say::result_expected_rows());
    for (std::size_t row = 0; row < 6; ++row) {
      const std::vector<formats::DocumentView> entries = rows[row].items();
      if (entries.size() != 6) rows[row].fail(say::result_expected_entries());
      for (std::size_t column = 0; column < 6; ++column)
        matrix(static_cast<int>(row), static_cast<int>(column)) = entries[column].number_or_nan();
    }
  }
};

/// The key of the settings. Another version may have others, or none; its X is no worse for that.
struct SettingsOfVersion {
  const std::string& version;

  DocumentNode write(const settings::Settings& settings) const {
    DocumentNode keys = DocumentNode::map();
    keys.add("settings", settings::settings_document(settings));
    return keys;
  }
  void read(const formats::DocumentView& provenance, settings::Settings& settings) const {
    try {
      settings = settings::settings_from_document(provenance.at("settings"));
    } catch (const Error&) {
      if (version == kVersion) throw;
    }
  }
};

}  // namespace

// ---- Records, a line a key

void describe(formats::RecordOf<PairRecord> auto& pair, auto& fields) {
  fields.on_one_line();
  fields("session", pair.session);
  fields("stamp_a_ns", pair.stamp_a_ns);
  fields("stamp_b_ns", pair.stamp_b_ns);
  fields("state", pair.state, formats::OneOf{{kPairStates.begin(), kPairStates.end()}});
  fields("decided_by", pair.decided_by, formats::OneOf{{kDeciders.begin(), kDeciders.end()}});
  fields("reason", pair.reason);
  fields("rotation_deg", pair.rotation_rad, formats::Degrees());
  fields("baseline_m", pair.baseline_m);
  fields("rmse_m", pair.rmse_m);
  fields("overlap", pair.overlap);
  fields("screw_score", pair.screw_score);
  fields("residual_rotation_deg", pair.residual_rotation_rad, formats::Degrees());
  fields("residual_translation_m", pair.residual_translation_m);
  fields("weight", pair.weight);
  fields("shared_objects", pair.shared_objects);
}

}  // namespace remount::results

namespace remount::calibration {

void describe(formats::RecordOf<Candidate> auto& candidate, auto& fields) {
  fields.on_one_line();
  fields("source", candidate.source, results::kSourceName);
  fields("frobenius_sum", candidate.frobenius_sum);
  fields("in_range", candidate.in_range);
  fields.where(!candidate.in_range, "out_of_range", candidate.out_of_range);
  fields.where(std::isfinite(candidate.certified_gap), "certified_gap", candidate.certified_gap);
  fields.spread(candidate.ins_from_lidar, formats::kShortTransform);
}

void describe(formats::RecordOf<ObservabilityDirection> auto& direction, auto& fields) {
  fields.on_one_line();
  fields("direction", direction.direction);
  fields("sigma", direction.sigma, formats::Number{std::numeric_limits<double>::infinity()});
  fields("observed", direction.observed);
  fields("words", direction.words);
}

void describe(formats::RecordOf<SigmaPart> auto& part, auto& fields) {
  fields("source", part.source);
  fields("sigma", part.sigma, results::PartNotation());
}

}  // namespace remount::calibration

namespace remount::quality {

void describe(formats::RecordOf<NamedSharpness> auto& named, auto& fields) {
  fields.on_one_line();
  fields("source", named.source, results::kSourceName);
  fields("mean_map_entropy", named.sharpness.mean_map_entropy);
  fields("plane_thickness_m", named.sharpness.plane_thickness_m);
  fields("points", named.sharpness.points, formats::kCount);
}

}  // namespace remount::quality

namespace remount::results {

void describe(formats::RecordOf<InputFile> auto& input, auto& fields) {
  fields.on_one_line();
  fields("session", input.session);
  fields("file", input.file);
  fields("bytes", input.bytes);
  fields("sha256", input.sha256, formats::TextOrNull());
}

void describe(formats::RecordOf<UsedTopics> auto& used, auto& fields) {
  fields("session", used.session);
  fields("topics", used.topics, kTopics);
  fields.where(!used.asked.empty(), "asked", used.asked, kTopics);
}

namespace {

// ---- Maps of a result that are no record of their own

constexpr formats::MapOf kObserved{[](auto& result, auto& fields) {
  fields.on_one_line();
  for (const Parameter parameter : calibration::kParameters)
    fields(to_string(parameter), result.known[parameter].observed);
}};

constexpr formats::MapOf kMeasured{[](auto& result, auto& fields) {
  fields.on_one_line();
  for (const Parameter parameter : calibration::kParameters)
    fields(to_string(parameter), result.known[parameter].measured);
}};

constexpr formats::MapOf kCovariance{[](auto& result, auto& fields) {
  fields.only_written("order", order_document(calibration::kParameters));
  fields.only_written("units", DocumentNode::string("m and rad"));
  fields("matrix", result.covariance, SixRows());
}};

constexpr formats::MapOf kPairCounts{[](auto& result, auto& fields) {
  fields.on_one_line();
  fields("proposed", result.pairs_proposed);
  fields("accepted", result.pairs_accepted);
  fields("rejected", result.pairs_rejected);
}};

constexpr formats::MapOf kErrors{[](auto& result, auto& fields) {
  fields("frobenius_sum", result.frobenius_sum);
  fields("rotation_rms_deg", result.rotation_rms_rad, formats::Degrees());
  fields("translation_rms_m", result.translation_rms_m);
  fields.later("session_disagreement", result.session_disagreement);
}};

constexpr formats::MapOf kProvenance{[](auto& file, auto& fields) {
  fields("version", file.version, kVersionName);
  fields.spread(file.settings, SettingsOfVersion{file.version});
  fields("inputs", file.inputs);
  fields.where(!file.topics.empty(), "topics", file.topics);
}};

}  // namespace

void describe(formats::RecordOf<ResultFile> auto& file, auto& fields) {
  auto& result = file.result;
  const formats::ByName frame{calibration::frame_from_string, say::frame_unknown};
  fields.only_written("format", DocumentNode::string(kResultFormat));
  fields.later("method", file.method);
  fields("status", result.status, formats::ByName{calibration::status_from_string, say::result_unknown_status});
  fields.later("message", result.message);
  fields.later("advice", result.advice);
  fields("ins_from_lidar", result.mounting.reference_from_sensor);
  fields.later("reference_frame", result.mounting.reference, frame);
  fields.later("calibrated", result.mounting.sensor, frame);
  fields.later("ins_axes", file.ins_axes, formats::OrNull{formats::OneOf{ins_axes_names()}});
  fields("observed", result, kObserved);
  fields.later("measured", result, kMeasured);
  fields("sigma", result, SigmaNotation());
  fields.later("bootstrap_sigma", result, BootstrapSigmaNotation());
  fields.later("covariance", result, kCovariance);
  fields("pairs", result, kPairCounts);
  fields("error", result, kErrors);
  fields("time_offset_s", result.time_offset.offset_s);
  fields.later("time_offset_sigma_s", result.time_offset.sigma_s);
  fields.later("time_offset_applied", result.time_offset.applied);
  fields.later("time_offset_in_sigma", result.time_offset.in_sigma);
  fields.later("session_time_offset_s", result.session_time_offset_s);
  fields.later("session_time_offset_sigma_s", result.session_time_offset_sigma_s);
  fields.later("session_position_lag_s", result.session_position_lag_s);
  fields.later("session_position_lag_sigma_s", result.session_position_lag_sigma_s);
  fields.later("position_lag_applied", result.position_lag_applied);
  fields.where(!file.quantities.empty(), "quantities", file.quantities,
               formats::Through{formats::quantities_document, formats::quantities_from_document});
  fields.where(!file.plots.empty(), "plots", file.plots,
               formats::Through{formats::plots_document, formats::plots_from_document});
  fields.where(!result.beams.empty(), "beams", result.beams, BeamNotation());
  fields.later("directions", result.directions);
  fields.where(!result.sigma_parts.empty(), "sigma_parts", result.sigma_parts);
  fields.later("nominal_ins_from_lidar", file.nominal_ins_from_lidar);
  fields.later("map_sharpness", file.sharpness);
  fields("candidates", result.candidates);
  fields.later("findings", file.findings,
               formats::Through{formats::findings_document, formats::findings_from_document});
  fields("provenance", file, kProvenance);
  fields.later("pair_list", file.pairs, formats::ListOf{formats::Notation<PairRecord>(), kMaxListedPairs});
}

namespace {

/// What files do not hold and what they do hold tells.
void complete(calibration::CalibrationResult& result) {
  if (result.session_position_lag_sigma_s.size() != result.session_position_lag_s.size())
    result.session_position_lag_sigma_s.assign(result.session_position_lag_s.size(), kNan);
  for (const Parameter parameter : calibration::kParameters)
    if (calibration::Knowledge& known = result.known[parameter]; !known.observed)
      known.why_not_observed = calibration::said_of_direction(parameter, result);
}

}  // namespace

DocumentNode result_document(const ResultFile& file) { return formats::document_of(file); }

ResultFile result_from_document(const formats::DocumentView& root) {
  const std::string format = root.at("format").string();
  if (format.starts_with("remount-vehicle/")) root.at("format").fail(say::result_of_several_lidars());
  if (format != kResultFormat && format != kFormerResultFormat)
    root.at("format").fail(say::result_of_other_format(std::string(kResultFormat), format));
  ResultFile file;
  formats::read_fields(root, file);
  complete(file.result);
  return file;
}

}  // namespace remount::results
