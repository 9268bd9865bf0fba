// Reading of "remount-result/2" and of its former version, with every check that keeps a damaged file from becoming an
// extrinsic.
#include <cmath>
#include <limits>

#include "algorithms/calibration/observability.h"
#include "algorithms/core/error.h"
#include "messages/drives.h"
#include "messages/results.h"
#include "model/formats/documents/finding_document.h"
#include "model/formats/documents/message_document.h"
#include "model/formats/documents/method_document.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/results/result_file.h"
#include "model/results/topic_document.h"
#include "model/settings/settings_file.h"
#include "remount_version.h"

namespace remount {
namespace {

constexpr int kMaxCount = std::numeric_limits<int>::max();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double number_or(const DocumentView& view, double otherwise) { return view.is_null() ? otherwise : view.number(); }

int count_of(const DocumentView& view) { return static_cast<int>(view.integer(0, kMaxCount)); }

BodyFrame frame_in(const DocumentView& view) {
  const std::optional<BodyFrame> frame = frame_from_string(view.string());
  if (!frame) view.fail(say::frame_unknown(view.string()));
  return *frame;
}

/// The six sigmas, nothing for null.
PerParameter<std::optional<double>> sigma_of(const DocumentView& view) {
  const auto translation = view.at("translation_m").items(), rotation = view.at("rotation_deg").items();
  if (translation.size() != 3) view.at("translation_m").fail(say::result_expected_translation());
  if (rotation.size() != 3) view.at("rotation_deg").fail(say::result_expected_rotation());
  PerParameter<std::optional<double>> sigma;
  const auto read = [&](Parameter parameter, const DocumentView& number) {
    if (number.is_null()) return;
    const double value = number.number();
    if (value < 0.0) view.fail(say::result_negative_sigma());
    sigma[parameter] = is_angle(parameter) ? degrees_to_radians(value) : value;
  };
  constexpr Parameter kLengths[] = {Parameter::X, Parameter::Y, Parameter::Z},
                      kAngles[] = {Parameter::Roll, Parameter::Pitch, Parameter::Yaw};
  for (std::size_t i = 0; i < 3; ++i) {
    read(kLengths[i], translation[i]);
    read(kAngles[i], rotation[i]);
  }
  return sigma;
}

Matrix6d covariance_of(const DocumentView& view) {
  const std::vector<DocumentView> rows = view.at("matrix").items();
  if (rows.size() != 6) view.at("matrix").fail(say::result_expected_rows());
  Matrix6d covariance;
  for (std::size_t row = 0; row < 6; ++row) {
    const std::vector<DocumentView> entries = rows[row].items();
    if (entries.size() != 6) rows[row].fail(say::result_expected_entries());
    for (std::size_t column = 0; column < 6; ++column)
      covariance(static_cast<int>(row), static_cast<int>(column)) = number_or(entries[column], kNan);
  }
  return covariance;
}

void read_uncertainty(const DocumentView& root, CalibrationResult& result) {
  const PerParameter<std::optional<double>> sigma = sigma_of(root.at("sigma"));
  for (const Parameter parameter : kParameters) {
    Knowledge& known = result.known[parameter];
    known.observed = root.at("observed").at(to_string(parameter)).boolean();
    if (sigma[parameter] && !known.observed)
      root.at("sigma").fail(say::result_sigma_of_unobserved(std::string(to_string(parameter))));
    const double sigma_or_nan = sigma[parameter].value_or(kNan);
    if (known.observed) result.covariance(row_of(parameter), row_of(parameter)) = sigma_or_nan * sigma_or_nan;
  }
  if (root.has("covariance")) result.covariance = covariance_of(root.at("covariance"));
  if (root.has("bootstrap_sigma")) {
    const PerParameter<std::optional<double>> bootstrap = sigma_of(root.at("bootstrap_sigma"));
    for (const Parameter parameter : kParameters) result.known[parameter].bootstrap_sigma = bootstrap[parameter];
  }
  if (!root.has("directions")) return;
  for (const DocumentView& item : root.at("directions").items()) {
    ObservabilityDirection direction;
    direction.direction = Eigen::Map<const Vector6d>(item.at("direction").numbers(6).data());
    direction.sigma = number_or(item.at("sigma"), std::numeric_limits<double>::infinity());
    direction.observed = item.at("observed").boolean();
    direction.words = message_from_document(item.at("words"));
    result.directions.push_back(direction);
  }
  for (const Parameter parameter : kParameters)
    if (Knowledge& known = result.known[parameter]; !known.observed)
      known.why_not_observed = said_of_direction(parameter, result);
}

void read_candidates(const DocumentView& root, CalibrationResult& result) {
  for (const DocumentView& item : root.at("candidates").items()) {
    Candidate candidate;
    candidate.source = mounting_source_from_string(item.at("source").string());
    candidate.frobenius_sum = number_or(item.at("frobenius_sum"), kNan);
    candidate.in_range = item.at("in_range").boolean();
    if (item.has("out_of_range")) candidate.out_of_range = message_from_document(item.at("out_of_range"));
    if (item.has("certified_gap")) candidate.certified_gap = number_or(item.at("certified_gap"), kNan);
    candidate.ins_from_lidar = transform_from_document(item);
    result.candidates.push_back(candidate);
  }
}

PairRecord pair_of(const DocumentView& item) {
  const std::int64_t longest = std::numeric_limits<std::int64_t>::max();
  PairRecord pair;
  pair.session = index_at<SessionIndex>(count_of(item.at("session")));
  pair.stamp_a_ns = item.at("stamp_a_ns").integer(-longest, longest);
  pair.stamp_b_ns = item.at("stamp_b_ns").integer(-longest, longest);
  pair.state = static_cast<PairState>(item.at("state").choice({"proposed", "accepted", "rejected"}));
  pair.decided_by = static_cast<DecidedBy>(item.at("decided_by").choice({"nobody", "program", "user"}));
  pair.reason = message_from_document(item.at("reason"));
  pair.rotation_rad = degrees_to_radians(number_or(item.at("rotation_deg"), kNan));
  pair.baseline_m = number_or(item.at("baseline_m"), kNan);
  pair.rmse_m = number_or(item.at("rmse_m"), kNan);
  pair.overlap = number_or(item.at("overlap"), kNan);
  pair.screw_score = number_or(item.at("screw_score"), kNan);
  pair.residual_rotation_rad = degrees_to_radians(number_or(item.at("residual_rotation_deg"), kNan));
  pair.residual_translation_m = number_or(item.at("residual_translation_m"), kNan);
  pair.weight = number_or(item.at("weight"), kNan);
  pair.shared_objects = count_of(item.at("shared_objects"));
  return pair;
}

void read_provenance(const DocumentView& view, ResultFile& file) {
  file.version = view.at("version").string();
  try {
    file.settings = settings_from_document(view.at("settings"));
  } catch (const Error&) {
    // Another version may have other settings; its X is no worse for that.
    if (file.version == kVersion) throw;
  }
  for (const DocumentView& item : view.at("inputs").items()) {
    InputFile input;
    input.session = item.at("session").string();
    input.file = item.at("file").string();
    input.bytes = static_cast<std::uint64_t>(item.at("bytes").integer(0, std::numeric_limits<std::int64_t>::max()));
    if (!item.at("sha256").is_null()) input.sha256 = item.at("sha256").string();
    file.inputs.push_back(input);
  }
  if (view.has("topics"))
    for (const DocumentView& item : view.at("topics").items())
      file.topics.push_back({item.at("session").string(), topic_choice_from_document(item.at("topics")),
                             item.has("asked") ? topic_choice_from_document(item.at("asked")) : TopicChoice{}});
}

}  // namespace

ResultFile result_from_document(const DocumentView& root) {
  const std::string format = root.at("format").string();
  if (format != kResultFormat && format != kFormerResultFormat)
    root.at("format").fail(say::result_of_other_format(std::string(kResultFormat), format));
  ResultFile file;
  CalibrationResult& result = file.result;
  const auto status = status_from_string(root.at("status").string());
  if (!status) root.at("status").fail(say::result_unknown_status(root.at("status").string()));
  result.status = *status;
  if (root.has("method")) file.method = root.at("method").string();
  if (root.has("reference_frame")) result.mounting.reference = frame_in(root.at("reference_frame"));
  if (root.has("calibrated")) result.mounting.sensor = frame_in(root.at("calibrated"));
  if (root.has("quantities")) file.quantities = quantities_from_document(root.at("quantities"));
  if (root.has("plots")) file.plots = plots_from_document(root.at("plots"));
  if (root.has("message")) result.message = message_from_document(root.at("message"));
  if (root.has("advice")) result.advice = messages_from_document(root.at("advice"));
  result.mounting.reference_from_sensor = transform_from_document(root.at("ins_from_lidar"));
  if (root.has("ins_axes") && !root.at("ins_axes").is_null()) {
    constexpr InsAxes kAxes[kInsAxesCount] = {InsAxes::ForwardLeftUp, InsAxes::RightForwardUp, InsAxes::BackwardRightUp,
                                              InsAxes::LeftBackwardUp};
    file.ins_axes =
        kAxes[root.at("ins_axes")
                  .choice({to_string(kAxes[0]), to_string(kAxes[1]), to_string(kAxes[2]), to_string(kAxes[3])})];
  }
  read_uncertainty(root, result);
  result.pairs_proposed = count_of(root.at("pairs").at("proposed"));
  result.pairs_accepted = count_of(root.at("pairs").at("accepted"));
  result.pairs_rejected = count_of(root.at("pairs").at("rejected"));
  result.frobenius_sum = number_or(root.at("error").at("frobenius_sum"), kNan);
  result.rotation_rms_rad = degrees_to_radians(number_or(root.at("error").at("rotation_rms_deg"), kNan));
  result.translation_rms_m = number_or(root.at("error").at("translation_rms_m"), kNan);
  if (root.at("error").has("session_disagreement"))
    result.session_disagreement = number_or(root.at("error").at("session_disagreement"), kNan);
  if (root.has("measured"))
    for (const Parameter parameter : kParameters)
      result.known[parameter].measured = root.at("measured").at(to_string(parameter)).boolean();
  result.time_offset.offset_s = number_or(root.at("time_offset_s"), kNan);
  if (root.has("time_offset_sigma_s")) result.time_offset.sigma_s = number_or(root.at("time_offset_sigma_s"), kNan);
  if (root.has("time_offset_applied")) result.time_offset.applied = root.at("time_offset_applied").boolean();
  if (root.has("time_offset_in_sigma")) result.time_offset.in_sigma = root.at("time_offset_in_sigma").boolean();
  const auto read_numbers = [&root](const char* key, std::vector<double>& numbers) {
    if (!root.has(key)) return;
    for (const DocumentView& item : root.at(key).items()) numbers.push_back(number_or(item, kNan));
  };
  read_numbers("session_time_offset_s", result.session_time_offset_s);
  read_numbers("session_time_offset_sigma_s", result.session_time_offset_sigma_s);
  read_numbers("session_position_lag_s", result.session_position_lag_s);
  read_numbers("session_position_lag_sigma_s", result.session_position_lag_sigma_s);
  if (root.has("position_lag_applied")) result.position_lag_applied = root.at("position_lag_applied").boolean();
  if (result.session_position_lag_sigma_s.size() != result.session_position_lag_s.size())
    result.session_position_lag_sigma_s.assign(result.session_position_lag_s.size(), kNan);
  read_candidates(root, result);
  if (root.has("nominal_ins_from_lidar") && !root.at("nominal_ins_from_lidar").is_null())
    file.nominal_ins_from_lidar = transform_from_document(root.at("nominal_ins_from_lidar"));
  if (root.has("map_sharpness"))
    for (const DocumentView& item : root.at("map_sharpness").items())
      file.sharpness.push_back(
          {mounting_source_from_string(item.at("source").string()),
           {number_or(item.at("mean_map_entropy"), kNan), number_or(item.at("plane_thickness_m"), kNan),
            static_cast<std::size_t>(count_of(item.at("points")))}});
  file.findings = root.has("findings") ? findings_from_document(root.at("findings")) : std::vector<Finding>();
  read_provenance(root.at("provenance"), file);
  if (root.has("pair_list"))
    for (const DocumentView& item : root.at("pair_list").items()) file.pairs.push_back(pair_of(item));
  return file;
}

ResultFile load_result(const std::filesystem::path& path) {
  const DocumentLimits limits{64U << 20U, 2000000, 32};
  const DocumentNode document = read_document(path, limits);
  return result_from_document(DocumentView(document, path.string()));
}

}  // namespace remount
