#include "model/project/project.h"

#include <limits>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "algorithms/messages/render.h"
#include "messages/projects.h"
#include "model/checks/data_check.h"
#include "model/drive/session_frames.h"
#include "model/formats/documents/finding_document.h"
#include "model/formats/documents/message_document.h"
#include "model/formats/documents/pair_document.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/files/atomic_save.h"
#include "model/results/deciding_notes.h"
#include "model/settings/settings_file.h"
#include "remount_version.h"

namespace remount {
namespace {

constexpr std::string_view kFormat = "remount-project/2", kFormerFormat = "remount-project/1";
constexpr DocumentLimits kLimits{256U << 20U, 8000000, 32};
/// Points of a curve that a file keeps: more than a page or a window shows.
constexpr std::size_t kMostPlotted = 2000;
/// In the order of MapCheck.
const std::vector<std::string_view> kMapChecks{"not_reached", "made",       "switched_off",
                                               "no_scans",    "no_overlap", "moved"};
constexpr std::int64_t kLongest = std::numeric_limits<std::int64_t>::max();

/// Relative to the project's folder where that does not lead up to the root: a project and its data move together.
std::string written_path(const std::filesystem::path& session, const std::filesystem::path& folder) {
  const std::filesystem::path absolute = std::filesystem::absolute(session).lexically_normal();
  const std::filesystem::path relative = absolute.lexically_relative(folder);
  return relative.empty() ? absolute.generic_string() : relative.generic_string();
}

std::filesystem::path folder_of(const std::filesystem::path& project) {
  return std::filesystem::absolute(project).lexically_normal().parent_path();
}

DocumentNode verdicts_document(const std::vector<PairVerdict>& verdicts) {
  DocumentNode list = DocumentNode::sequence();
  for (const PairVerdict& verdict : verdicts) {
    DocumentNode& node = list.add(DocumentNode::map());
    node.on_one_line = true;
    node.add("session", DocumentNode::integer(verdict.session));
    node.add("stamp_a_ns", DocumentNode::integer(verdict.stamp_a_ns));
    node.add("stamp_b_ns", DocumentNode::integer(verdict.stamp_b_ns));
    node.add("state", DocumentNode::string(to_string(verdict.state)));
    node.add("reason", message_document(verdict.reason));
  }
  return list;
}

std::vector<PairVerdict> verdicts_from(const DocumentView& view) {
  std::vector<PairVerdict> verdicts;
  for (const DocumentView& item : view.items()) {
    PairVerdict verdict;
    verdict.session = index_at<SessionIndex>(item.at("session").integer(0, std::numeric_limits<int>::max()));
    verdict.stamp_a_ns = item.at("stamp_a_ns").integer(-kLongest, kLongest);
    verdict.stamp_b_ns = item.at("stamp_b_ns").integer(-kLongest, kLongest);
    verdict.state = static_cast<PairState>(item.at("state").choice({"proposed", "accepted", "rejected"}));
    verdict.reason = message_from_document(item.at("reason"));
    verdicts.push_back(verdict);
  }
  return verdicts;
}

DocumentNode ground_document(const ObservedGround& ground) {
  DocumentNode node = DocumentNode::map();
  node.add("up_in_lidar",
           DocumentNode::numbers({ground.up_in_lidar.x(), ground.up_in_lidar.y(), ground.up_in_lidar.z()}));
  node.add("lidar_height_m", DocumentNode::number(ground.lidar_height_m));
  node.add("height_sigma_m", DocumentNode::number(ground.height_sigma_m));
  node.add("up_sigma_rad", DocumentNode::number(ground.up_sigma_rad));
  return node;
}

ObservedGround ground_from_document(const DocumentView& view) {
  ObservedGround ground;
  ground.up_in_lidar = Eigen::Map<const Eigen::Vector3d>(view.at("up_in_lidar").numbers(3).data()).eval();
  if (!(std::abs(ground.up_in_lidar.norm() - 1.0) < 1e-6))
    view.at("up_in_lidar").fail(say::project_expected_unit_vector());
  ground.lidar_height_m = view.at("lidar_height_m").number();
  ground.height_sigma_m = view.at("height_sigma_m").number();
  ground.up_sigma_rad = view.at("up_sigma_rad").number();
  return ground;
}

DocumentNode sweep_document(const SweepModel& sweep) {
  DocumentNode node = DocumentNode::map();
  node.add("period_s", DocumentNode::number(sweep.period_s));
  node.add("stamp_azimuth_rad", DocumentNode::number(sweep.stamp_azimuth_rad));
  node.add("clockwise", DocumentNode::boolean(sweep.clockwise));
  node.add("by_order", DocumentNode::boolean(sweep.by_order));
  return node;
}

SweepModel sweep_from_document(const DocumentView& view) {
  SweepModel sweep;
  sweep.period_s = view.at("period_s").number();
  if (!(sweep.period_s > 0.0)) view.at("period_s").fail(say::project_expected_above_zero());
  sweep.stamp_azimuth_rad = view.at("stamp_azimuth_rad").number();
  sweep.clockwise = view.at("clockwise").boolean();
  sweep.by_order = view.at("by_order").boolean();
  return sweep;
}

DocumentNode calibration_document(const Project& project) {
  const PipelineOutput& output = *project.output;
  PipelineInput input;
  input.settings = project.basis.settings;
  input.nominal_ins_from_lidar = project.basis.nominal_ins_from_lidar;
  ResultFile file = make_result_file(input, output, project.inputs);
  file.pairs.clear();  // they follow in full
  DocumentNode node = DocumentNode::map();
  node.add("session_count", DocumentNode::integer(static_cast<std::int64_t>(project.basis.session_count)));
  if (project.solution_pending) node.add("solution_pending", DocumentNode::boolean(true));
  if (project.confirmed) node.add("confirmed", DocumentNode::boolean(true));
  if (project.exported) node.add("exported", DocumentNode::boolean(true));
  node.add("map_check", DocumentNode::string(kMapChecks[index_of(output.map_check)]));
  node.add("result", result_document(file));
  node.add("initial_ins_from_lidar", transform_document(output.initial_ins_from_lidar));
  node.add("compensation_ins_from_lidar", transform_document(output.compensation_ins_from_lidar));
  node.add("initial_known", DocumentNode::boolean(output.initial_known));
  node.add("nominal_known", DocumentNode::boolean(output.nominal_known));
  if (output.up_in_lidar)
    node.add("up_in_lidar", DocumentNode::numbers({output.up_in_lidar->begin(), output.up_in_lidar->end()}));
  if (output.clock_bias)
    node.add("clock_bias", DocumentNode::numbers({output.clock_bias->begin(), output.clock_bias->end()}));
  if (output.ground) node.add("ground", ground_document(*output.ground));
  DocumentNode& sweeps = node.add("session_uses_sweep", DocumentNode::sequence());
  for (const bool uses : output.session_uses_sweep) sweeps.add(DocumentNode::boolean(uses));
  DocumentNode& found = node.add("session_sweeps", DocumentNode::sequence());
  for (const SweepModel& sweep : output.session_sweeps) found.add(sweep_document(sweep));
  if (!output.clock_told) node.add("clock_told", DocumentNode::boolean(false));
  if (output.clock_is_unknown) node.add("clock_is_unknown", DocumentNode::boolean(true));
  if (output.farthest_clock_s > 0.0) node.add("farthest_clock_s", DocumentNode::number(output.farthest_clock_s));
  DocumentNode& doubts = node.add("sweep_doubts", DocumentNode::sequence());
  for (const Vector6d& doubt : output.sweep_doubts) doubts.add(DocumentNode::numbers({doubt.begin(), doubt.end()}));
  node.add("findings", findings_document(output.findings));
  DocumentNode& keyframes = node.add("keyframes", DocumentNode::sequence());
  for (const Keyframe& keyframe : output.keyframes) keyframes.add(keyframe_document(keyframe));
  DocumentNode& pairs = node.add("pairs", DocumentNode::sequence());
  for (const Pair& pair : output.pairs) pairs.add(pair_document(pair));
  return node;
}

void read_calibration(const DocumentView& view, Project& project) {
  const std::size_t session_count = project.sessions.size();
  PipelineOutput& output = project.output.emplace();
  ResultFile file = result_from_document(view.at("result"));
  output.method = std::move(file.method);
  output.quantities = std::move(file.quantities);
  output.plots = std::move(file.plots);
  output.result = std::move(file.result);
  output.sharpness = std::move(file.sharpness);
  output.map_check = output.sharpness.empty() ? MapCheck::NotReached : MapCheck::Made;
  if (view.has("map_check")) output.map_check = static_cast<MapCheck>(view.at("map_check").choice(kMapChecks));
  project.inputs = std::move(file.inputs);
  project.basis.settings = file.settings;
  project.basis.nominal_ins_from_lidar = file.nominal_ins_from_lidar;
  project.basis.session_count = session_count;
  if (view.has("session_count"))
    project.basis.session_count =
        static_cast<std::size_t>(view.at("session_count").integer(0, static_cast<std::int64_t>(session_count)));
  project.solution_pending = view.has("solution_pending") && view.at("solution_pending").boolean();
  project.confirmed = view.has("confirmed") && view.at("confirmed").boolean();
  project.exported = view.has("exported") && view.at("exported").boolean();
  output.initial_ins_from_lidar = transform_from_document(view.at("initial_ins_from_lidar"));
  output.compensation_ins_from_lidar = transform_from_document(view.at("compensation_ins_from_lidar"));
  output.initial_known = view.at("initial_known").boolean();
  output.nominal_known = view.at("nominal_known").boolean();
  if (view.has("up_in_lidar"))
    output.up_in_lidar = Eigen::Map<const Eigen::Vector3d>(view.at("up_in_lidar").numbers(3).data());
  if (view.has("clock_bias")) output.clock_bias = Eigen::Map<const Vector6d>(view.at("clock_bias").numbers(6).data());
  if (view.has("ground")) output.ground = ground_from_document(view.at("ground"));
  if (view.has("session_uses_sweep"))
    for (const DocumentView& item : view.at("session_uses_sweep").items())
      output.session_uses_sweep.push_back(item.boolean());
  if (view.has("session_sweeps"))
    for (const DocumentView& item : view.at("session_sweeps").items())
      output.session_sweeps.push_back(sweep_from_document(item));
  output.clock_told = !view.has("clock_told") || view.at("clock_told").boolean();
  output.clock_is_unknown = view.has("clock_is_unknown") && view.at("clock_is_unknown").boolean();
  if (view.has("farthest_clock_s")) output.farthest_clock_s = view.at("farthest_clock_s").number();
  if (view.has("sweep_doubts"))
    for (const DocumentView& item : view.at("sweep_doubts").items())
      output.sweep_doubts.emplace_back(Eigen::Map<const Vector6d>(item.numbers(6).data()));
  output.findings = findings_from_document(view.at("findings"));
  for (const DocumentView& item : view.at("keyframes").items())
    output.keyframes.push_back(keyframe_from_document(item, project.basis.session_count));
  for (const DocumentView& item : view.at("pairs").items())
    output.pairs.push_back(pair_from_document(item, output.keyframes.size()));
}

void add_setting_changes(const Settings& then, const Settings& now, std::vector<Message>& changes) {
  const DocumentNode before = settings_document(then), after = settings_document(now);
  for (std::size_t s = 0; s < before.items.size(); ++s)
    for (std::size_t i = 0; i < before.items[s].items.size(); ++i) {
      const std::string &section = before.keys[s], &name = before.items[s].keys[i];
      const std::string &old_value = before.items[s].items[i].text, &new_value = after.items[s].items[i].text;
      if (old_value != new_value && affects_result(section, name))
        changes.push_back(say::change_of_setting(section + "." + name, old_value, new_value));
    }
}

TopicChoice topics_from(const DocumentView& session) {
  TopicChoice topics;
  if (!session.has("topics")) return topics;
  for (const DocumentView& item : session.at("topics").items()) try {
      add_topic_choice(topics, item.string());
    } catch (const Error& error) {
      item.fail(error.what_happened());
    }
  return topics;
}

}  // namespace

CalibrationBasis basis_of(const PipelineInput& input) {
  return {input.sessions.size(), input.settings, input.nominal_ins_from_lidar};
}

std::vector<Message> changes_since(const CalibrationBasis& calibration, const CalibrationBasis& now) {
  std::vector<Message> changes;
  if (calibration.session_count != now.session_count)
    changes.push_back(say::change_of_sessions(calibration.session_count, now.session_count));
  const auto &then = calibration.nominal_ins_from_lidar, &present = now.nominal_ins_from_lidar;
  if (then.has_value() != present.has_value())
    changes.push_back(present ? say::change_nominal_given() : say::change_nominal_gone());
  else if (then && difference(*then, *present).norm() > 1e-9)
    changes.push_back(say::change_another_nominal());
  add_setting_changes(calibration.settings, now.settings, changes);
  return changes;
}

bool affects_result(std::string_view section, std::string_view name) { return section != "run" || name != "cache_mb"; }

std::vector<Message> Project::changes_since_calibration() const {
  if (!output) return {};
  std::vector<Message> changes = changes_since(basis, {sessions.size(), settings, nominal_ins_from_lidar});
  if (solution_pending) changes.push_back(say::change_of_decisions());
  return changes;
}

void save_project(const Project& project, const std::filesystem::path& path) {
  const std::filesystem::path folder = folder_of(path);
  DocumentNode root = DocumentNode::map();
  root.add("format", DocumentNode::string(kFormat));
  root.add("version", DocumentNode::string(kVersion));
  DocumentNode& sessions = root.add("sessions", DocumentNode::sequence());
  for (std::size_t i = 0; i < project.sessions.size(); ++i) {
    DocumentNode& session = sessions.add(DocumentNode::map());
    session.add("path", DocumentNode::string(written_path(project.sessions[i], folder)));
    const TopicChoice topics = project.topics_of(i);
    if (topics.empty()) continue;
    DocumentNode& chosen = session.add("topics", DocumentNode::sequence());
    for (const auto& [role, topic] : topics) chosen.add(DocumentNode::string(role + "=" + topic));
  }
  root.add("settings", settings_document(project.settings));
  root.add("nominal_ins_from_lidar",
           project.nominal_ins_from_lidar ? transform_document(*project.nominal_ins_from_lidar) : DocumentNode::null());
  root.add("verdicts", verdicts_document(project.verdicts));
  root.add("calibration", project.output ? calibration_document(project) : DocumentNode::null());
  save_atomically(path, to_yaml(root));
}

Project load_project(const std::filesystem::path& path) {
  const DocumentNode document = read_document(path, kLimits);
  const DocumentView root(document, path.string());
  const std::string format = root.at("format").string();
  if (format != kFormat && format != kFormerFormat)
    root.at("format").fail((format.starts_with("remount-project/")
                                ? say::file_of_later_version
                                : say::file_of_other_format)(format.substr(0, 60), std::string(kFormat)));
  root.allow_only({"format", "version", "sessions", "settings", "nominal_ins_from_lidar", "verdicts", "calibration"});
  Project project;
  const std::filesystem::path folder = folder_of(path);
  for (const DocumentView& item : root.at("sessions").items()) {
    const std::filesystem::path session = item.at("path").string();
    if (session.empty()) item.at("path").fail(say::project_session_empty());
    project.sessions.push_back((folder / session).lexically_normal());
    project.topics.push_back(topics_from(item));
  }
  project.settings = settings_from_document(root.at("settings"));
  if (!root.at("nominal_ins_from_lidar").is_null())
    project.nominal_ins_from_lidar = transform_from_document(root.at("nominal_ins_from_lidar"));
  project.verdicts = verdicts_from(root.at("verdicts"));
  if (!root.at("calibration").is_null()) read_calibration(root.at("calibration"), project);
  return project;
}

std::filesystem::path relocated(const std::filesystem::path& missing, const std::filesystem::path& from,
                                const std::filesystem::path& to) {
  std::filesystem::path old_root = from.lexically_normal(), new_root = to.lexically_normal();
  while (old_root.has_filename() && old_root.filename() == new_root.filename()) {
    old_root = old_root.parent_path();
    new_root = new_root.parent_path();
  }
  const std::filesystem::path rest = missing.lexically_normal().lexically_relative(old_root);
  if (rest.empty() || *rest.begin() == "..") return {};
  const std::filesystem::path there = new_root / rest;
  std::error_code none;
  return std::filesystem::exists(there, none) ? there : std::filesystem::path();
}

ResultFile make_result_file(const PipelineInput& input, const PipelineOutput& output, std::vector<InputFile> inputs) {
  ResultFile file;
  file.method = output.method;
  file.result = output.result;
  file.quantities = output.quantities;
  file.plots = output.plots;
  thin(file.plots, kMostPlotted);
  file.ins_axes = common_axes(input.sessions);
  file.nominal_ins_from_lidar = input.nominal_ins_from_lidar;
  file.pairs = pair_records(output.keyframes, output.pairs);
  file.sharpness = output.sharpness;
  // Of the notes, what data are suspected of and what the result rests on: the rest of how the program went about its
  // work is for its log.
  for (const Finding& finding : output.findings)
    if (finding.severity != Severity::Note || finding_kind(finding.code) || is_deciding(finding))
      file.findings.push_back(finding);
  file.version = kVersion;
  file.settings = input.settings;
  file.inputs = std::move(inputs);
  file.topics = used_topics(input.sessions);
  return file;
}

}  // namespace remount
