#include "model/results/result_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <set>
#include <tuple>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "algorithms/core/parallel.h"
#include "messages/stages.h"
#include "model/drive/topic_offer.h"
#include "model/formats/documents/finding_document.h"
#include "model/formats/documents/message_document.h"
#include "model/formats/documents/method_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/sha256.h"
#include "model/settings/settings_file.h"
#include "remount_version.h"

namespace remount {
namespace {

/// Beyond this the list of pairs is cut, so that every file we write is one that we read.
constexpr std::size_t kMaxListedPairs = 20000;

DocumentNode error_document(const CalibrationResult& result) {
  DocumentNode node = DocumentNode::map();
  node.add("frobenius_sum", DocumentNode::number(result.frobenius_sum));
  node.add("rotation_rms_deg", DocumentNode::number(radians_to_degrees(result.rotation_rms_rad)));
  node.add("translation_rms_m", DocumentNode::number(result.translation_rms_m));
  node.add("session_disagreement", DocumentNode::number(result.session_disagreement));
  return node;
}

/// translation_m in the order x, y, z; rotation_deg in the order roll, pitch, yaw; null where not observed.
template <class SigmaOf>
DocumentNode sigma_document(SigmaOf&& sigma_of) {
  DocumentNode node = DocumentNode::map();
  DocumentNode& order = node.add("order", DocumentNode::sequence());
  for (const char* name : {"x", "y", "z", "roll", "pitch", "yaw"}) order.add(DocumentNode::string(name));
  const auto written = [&](Parameter parameter) {
    const double sigma = sigma_of(parameter).value_or(std::numeric_limits<double>::quiet_NaN());
    return is_angle(parameter) ? radians_to_degrees(sigma) : sigma;
  };
  node.add("translation_m",
           DocumentNode::numbers({written(Parameter::X), written(Parameter::Y), written(Parameter::Z)}));
  node.add("rotation_deg",
           DocumentNode::numbers({written(Parameter::Roll), written(Parameter::Pitch), written(Parameter::Yaw)}));
  return node;
}

DocumentNode covariance_document(const CalibrationResult& result) {
  DocumentNode node = DocumentNode::map();
  DocumentNode& order = node.add("order", DocumentNode::sequence());
  for (const Parameter parameter : kParameters) order.add(DocumentNode::string(to_string(parameter)));
  node.add("units", DocumentNode::string("m and rad"));
  DocumentNode& matrix = node.add("matrix", DocumentNode::sequence());
  for (int row = 0; row < 6; ++row) {
    std::vector<double> numbers;
    for (int column = 0; column < 6; ++column) numbers.push_back(result.covariance(row, column));
    matrix.add(DocumentNode::numbers(numbers));
  }
  return node;
}

DocumentNode candidates_document(const std::vector<Candidate>& candidates) {
  DocumentNode list = DocumentNode::sequence();
  for (const Candidate& candidate : candidates) {
    DocumentNode& node = list.add(DocumentNode::map());
    node.on_one_line = true;
    node.add("source", DocumentNode::string(to_string(candidate.source)));
    node.add("frobenius_sum", DocumentNode::number(candidate.frobenius_sum));
    node.add("in_range", DocumentNode::boolean(candidate.in_range));
    if (!candidate.in_range) node.add("out_of_range", message_document(candidate.out_of_range));
    if (std::isfinite(candidate.certified_gap))
      node.add("certified_gap", DocumentNode::number(candidate.certified_gap));
    const Eigen::Vector3d t = candidate.ins_from_lidar.translation();
    const Eigen::Quaterniond q = canonical_quaternion(candidate.ins_from_lidar.linear());
    node.add("translation_m", DocumentNode::numbers({t.x(), t.y(), t.z()}));
    node.add("quaternion_xyzw", DocumentNode::numbers({q.x(), q.y(), q.z(), q.w()}));
  }
  return list;
}

DocumentNode directions_document(const std::vector<ObservabilityDirection>& directions) {
  DocumentNode list = DocumentNode::sequence();
  for (const ObservabilityDirection& direction : directions) {
    DocumentNode& node = list.add(DocumentNode::map());
    node.on_one_line = true;
    const auto& v = direction.direction;
    node.add("direction", DocumentNode::numbers({v.begin(), v.end()}));
    node.add("sigma", DocumentNode::number(direction.sigma));
    node.add("observed", DocumentNode::boolean(direction.observed));
    node.add("words", message_document(direction.words));
  }
  return list;
}

DocumentNode sharpness_document(const std::vector<NamedSharpness>& sharpness) {
  DocumentNode list = DocumentNode::sequence();
  for (const NamedSharpness& one : sharpness) {
    DocumentNode& node = list.add(DocumentNode::map());
    node.on_one_line = true;
    node.add("source", DocumentNode::string(to_string(one.source)));
    node.add("mean_map_entropy", DocumentNode::number(one.sharpness.mean_map_entropy));
    node.add("plane_thickness_m", DocumentNode::number(one.sharpness.plane_thickness_m));
    node.add("points", DocumentNode::integer(static_cast<std::int64_t>(one.sharpness.points)));
  }
  return list;
}

DocumentNode pairs_document(const std::vector<PairRecord>& pairs) {
  DocumentNode list = DocumentNode::sequence();
  for (std::size_t i = 0; i < std::min(pairs.size(), kMaxListedPairs); ++i) {
    const PairRecord& pair = pairs[i];
    DocumentNode& node = list.add(DocumentNode::map());
    node.on_one_line = true;
    node.add("session", DocumentNode::integer(pair.session));
    node.add("stamp_a_ns", DocumentNode::integer(pair.stamp_a_ns));
    node.add("stamp_b_ns", DocumentNode::integer(pair.stamp_b_ns));
    node.add("state", DocumentNode::string(to_string(pair.state)));
    node.add("decided_by", DocumentNode::string(to_string(pair.decided_by)));
    node.add("reason", message_document(pair.reason));
    node.add("rotation_deg", DocumentNode::number(radians_to_degrees(pair.rotation_rad)));
    node.add("baseline_m", DocumentNode::number(pair.baseline_m));
    node.add("rmse_m", DocumentNode::number(pair.rmse_m));
    node.add("overlap", DocumentNode::number(pair.overlap));
    node.add("screw_score", DocumentNode::number(pair.screw_score));
    node.add("residual_rotation_deg", DocumentNode::number(radians_to_degrees(pair.residual_rotation_rad)));
    node.add("residual_translation_m", DocumentNode::number(pair.residual_translation_m));
    node.add("weight", DocumentNode::number(pair.weight));
    node.add("shared_objects", DocumentNode::integer(pair.shared_objects));
  }
  return list;
}

DocumentNode topics_document(const std::vector<UsedTopics>& used) {
  DocumentNode list = DocumentNode::sequence();
  for (const UsedTopics& one : used) {
    DocumentNode& node = list.add(DocumentNode::map());
    node.add("session", DocumentNode::string(one.session));
    const auto add = [&node](const char* key, const TopicChoice& choice) {
      DocumentNode& topics = node.add(key, DocumentNode::map());
      topics.on_one_line = true;
      for (const auto& [role, topic] : choice) topics.add(role, DocumentNode::string(topic));
    };
    add("topics", one.topics);
    if (!one.asked.empty()) add("asked", one.asked);
  }
  return list;
}

DocumentNode provenance_document(const ResultFile& file) {
  DocumentNode node = DocumentNode::map();
  node.add("version", DocumentNode::string(file.version.empty() ? kVersion : file.version));
  node.add("settings", settings_document(file.settings));
  DocumentNode& inputs = node.add("inputs", DocumentNode::sequence());
  for (const InputFile& input : file.inputs) {
    DocumentNode& entry = inputs.add(DocumentNode::map());
    entry.on_one_line = true;
    entry.add("session", DocumentNode::string(input.session));
    entry.add("file", DocumentNode::string(input.file));
    entry.add("bytes", DocumentNode::integer(static_cast<std::int64_t>(input.bytes)));
    entry.add("sha256", input.sha256.empty() ? DocumentNode::null() : DocumentNode::string(input.sha256));
  }
  if (!file.topics.empty()) node.add("topics", topics_document(file.topics));
  return node;
}

}  // namespace

std::string_view to_string(PairState state) {
  constexpr std::array<std::string_view, 3> kNames{"proposed", "accepted", "rejected"};
  return kNames.at(index_of(state));
}

std::string_view to_string(DecidedBy decided_by) {
  constexpr std::array<std::string_view, 3> kNames{"nobody", "program", "user"};
  return kNames.at(index_of(decided_by));
}

std::vector<PairRecord> pair_records(const std::vector<Keyframe>& keyframes, const std::vector<Pair>& pairs) {
  std::vector<PairRecord> records;
  for (const Pair& pair : pairs) {
    const Keyframe& a = keyframes.at(pair.keyframe_a);
    const Keyframe& b = keyframes.at(pair.keyframe_b);
    records.push_back({a.session, a.stamp_ns, b.stamp_ns, pair.state, pair.decided_by, pair.reason, pair.rotation_rad,
                       pair.baseline_m, pair.registration.rmse_m, pair.registration.overlap, pair.screw.score,
                       pair.residual_rotation_rad, pair.residual_translation_m, pair.weight, pair.shared_objects});
  }
  return records;
}

namespace {

InputFile unhashed_input(const std::filesystem::path& path) {
  InputFile input;
  input.file = path.filename().string();
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  input.bytes = ignored ? 0 : size;
  return input;
}

void name_by_session(const Session& session, const std::filesystem::path& file, InputFile& input) {
  input.session = session.name;
  const std::filesystem::path relative = file.lexically_relative(session.path);
  if (!relative.empty() && relative != "." && *relative.begin() != "..") input.file = relative.generic_string();
}

}  // namespace

InputFile hash_input(const std::filesystem::path& path) {
  InputFile input = unhashed_input(path);
  try {
    input.sha256 = sha256_of_file(path);
  } catch (const Error&) {
    input.sha256.clear();
  }
  return input;
}

std::vector<InputFile> hash_inputs(const std::vector<std::shared_ptr<const Session>>& sessions, int threads,
                                   Progress& progress) {
  std::vector<std::pair<const Session*, std::filesystem::path>> files;
  for (const auto& session : sessions)
    for (const std::filesystem::path& file : session->files) files.emplace_back(session.get(), file);
  std::vector<InputFile> inputs(files.size());
  std::atomic<std::size_t> done{0};
  parallel_for(files.size(), threads, [&](std::size_t i) {
    if (progress.cancelled()) return;
    const auto& [session, file] = files[i];
    inputs[i] = hash_input(file);
    name_by_session(*session, file, inputs[i]);
    progress.report(say::stage_hashing_inputs, ++done, files.size());
  });
  return inputs;
}

std::vector<UsedTopics> used_topics(const std::vector<std::shared_ptr<const Session>>& sessions) {
  std::vector<UsedTopics> used;
  for (const auto& session : sessions)
    if (!session->topics.empty())
      used.push_back({session->name, choice_in_use(session->topics), session->topic_choice});
  return used;
}

std::vector<InputFile> list_inputs(const std::vector<std::shared_ptr<const Session>>& sessions) {
  std::vector<InputFile> inputs;
  for (const auto& session : sessions)
    for (const std::filesystem::path& file : session->files) {
      inputs.push_back(unhashed_input(file));
      name_by_session(*session, file, inputs.back());
    }
  return inputs;
}

std::string changed_file(const std::vector<InputFile>& then, const std::vector<InputFile>& now) {
  // Two sessions of one name may have files of one name.
  std::multiset<std::tuple<std::string, std::string, std::uint64_t, std::string>> left;
  for (const InputFile& file : now) left.emplace(file.session, file.file, file.bytes, file.sha256);
  for (const InputFile& file : then) {
    const auto found = left.find({file.session, file.file, file.bytes, file.sha256});
    if (found == left.end()) return file.session + "/" + file.file;
    left.erase(found);
  }
  return {};
}

bool is_from_pairs(const ResultFile& file) { return file.method == kPairwise || !file.pairs.empty(); }

DocumentNode result_document(const ResultFile& file) {
  const CalibrationResult& result = file.result;
  DocumentNode root = DocumentNode::map();
  root.add("format", DocumentNode::string(kResultFormat));
  root.add("method", DocumentNode::string(file.method));
  root.add("status", DocumentNode::string(to_string(result.status)));
  root.add("message", message_document(result.message));
  root.add("advice", messages_document(result.advice));
  root.add("ins_from_lidar", transform_document(result.mounting.reference_from_sensor));
  root.add("reference_frame", DocumentNode::string(to_string(result.mounting.reference)));
  root.add("calibrated", DocumentNode::string(to_string(result.mounting.sensor)));
  root.add("ins_axes", file.ins_axes ? DocumentNode::string(to_string(*file.ins_axes)) : DocumentNode::null());
  DocumentNode& observed = root.add("observed", DocumentNode::map());
  observed.on_one_line = true;
  for (const Parameter parameter : kParameters)
    observed.add(std::string(to_string(parameter)), DocumentNode::boolean(result.known[parameter].observed));
  DocumentNode& measured = root.add("measured", DocumentNode::map());
  measured.on_one_line = true;
  for (const Parameter parameter : kParameters)
    measured.add(std::string(to_string(parameter)), DocumentNode::boolean(result.known[parameter].measured));
  root.add("sigma", sigma_document([&](Parameter parameter) { return result.estimate(parameter).sigma; }));
  root.add("bootstrap_sigma",
           sigma_document([&](Parameter parameter) { return result.estimate(parameter).bootstrap_sigma; }));
  root.add("covariance", covariance_document(result));
  DocumentNode& pairs = root.add("pairs", DocumentNode::map());
  pairs.on_one_line = true;
  pairs.add("proposed", DocumentNode::integer(result.pairs_proposed));
  pairs.add("accepted", DocumentNode::integer(result.pairs_accepted));
  pairs.add("rejected", DocumentNode::integer(result.pairs_rejected));
  root.add("error", error_document(result));
  root.add("time_offset_s", DocumentNode::number(result.time_offset.offset_s));
  root.add("time_offset_sigma_s", DocumentNode::number(result.time_offset.sigma_s));
  root.add("time_offset_applied", DocumentNode::boolean(result.time_offset.applied));
  root.add("time_offset_in_sigma", DocumentNode::boolean(result.time_offset.in_sigma));
  root.add("session_time_offset_s", DocumentNode::numbers(result.session_time_offset_s));
  root.add("session_time_offset_sigma_s", DocumentNode::numbers(result.session_time_offset_sigma_s));
  root.add("session_position_lag_s", DocumentNode::numbers(result.session_position_lag_s));
  root.add("session_position_lag_sigma_s", DocumentNode::numbers(result.session_position_lag_sigma_s));
  root.add("position_lag_applied", DocumentNode::boolean(result.position_lag_applied));
  if (!file.quantities.empty()) root.add("quantities", quantities_document(file.quantities));
  if (!file.plots.empty()) root.add("plots", plots_document(file.plots));
  root.add("directions", directions_document(result.directions));
  root.add("nominal_ins_from_lidar",
           file.nominal_ins_from_lidar ? transform_document(*file.nominal_ins_from_lidar) : DocumentNode::null());
  root.add("map_sharpness", sharpness_document(file.sharpness));
  root.add("candidates", candidates_document(result.candidates));
  root.add("findings", findings_document(file.findings));
  root.add("provenance", provenance_document(file));
  root.add("pair_list", pairs_document(file.pairs));
  return root;
}

void save_result(const ResultFile& file, const std::filesystem::path& path) {
  const DocumentNode document = result_document(file);
  save_atomically(path, path.extension() == ".json" ? to_json(document) : to_yaml(document));
}

}  // namespace remount
