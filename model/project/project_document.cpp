// What stands in "remount-project/2", and in the former version, whose sentences are plain texts.
#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "messages/projects.h"
#include "model/formats/documents/finding_document.h"
#include "model/formats/documents/notations.h"
#include "model/formats/documents/pair_document.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/atomic_save.h"
#include "model/project/project.h"
#include "model/results/beam_document.h"
#include "model/settings/settings_file.h"
#include "remount_version.h"

namespace remount::project {
namespace {

constexpr std::string_view kFormat = "remount-project/2", kFormerFormat = "remount-project/1";
constexpr formats::DocumentLimits kLimits{256U << 20U, 8000000, 32};

// ---- What is told in a way of its own: each written and read side by side

std::filesystem::path folder_of(const std::filesystem::path& project) {
  return std::filesystem::absolute(project).lexically_normal().parent_path();
}

/// Relative to the project's folder where that does not lead up to the root: a project and its data move together.
struct PathBeside {
  const std::filesystem::path& folder;

  formats::DocumentNode write(const std::filesystem::path& session) const {
    const std::filesystem::path absolute = std::filesystem::absolute(session).lexically_normal();
    const std::filesystem::path relative = absolute.lexically_relative(folder);
    return formats::DocumentNode::string((relative.empty() ? absolute : relative).generic_string());
  }
  void read(const formats::DocumentView& view, std::filesystem::path& session) const {
    const std::filesystem::path written = view.string();
    if (written.empty()) view.fail(say::project_session_empty());
    session = (folder / written).lexically_normal();
  }
};

/// A list of "ROLE=TOPIC".
struct TopicList {
  formats::DocumentNode write(const drive::TopicChoice& topics) const {
    formats::DocumentNode list = formats::DocumentNode::sequence();
    for (const auto& [role, topic] : topics) list.add(formats::DocumentNode::string(role + "=" + topic));
    return list;
  }
  void read(const formats::DocumentView& view, drive::TopicChoice& topics) const {
    for (const formats::DocumentView& item : view.items()) try {
        drive::add_topic_choice(topics, item.string());
      } catch (const Error& error) {
        item.fail(error.what_happened());
      }
  }
};

/// A session with its topics; a project has two lists of them.
struct StoredSession {
  std::filesystem::path path;
  drive::TopicChoice topics;
};

struct StoredSessions {
  const std::filesystem::path& folder;

  auto list() const {
    return formats::ListOf{formats::MapOf{[this](auto& session, auto& fields) {
      fields("path", session.path, PathBeside{folder});
      fields.where(!session.topics.empty(), "topics", session.topics, TopicList());
    }}};
  }
  formats::DocumentNode write(const Project& project) const {
    std::vector<StoredSession> sessions;
    for (std::size_t i = 0; i < project.sessions.size(); ++i)
      sessions.push_back({project.sessions[i], project.topics_of(i)});
    return list().write(sessions);
  }
  void read(const formats::DocumentView& view, Project& project) const {
    std::vector<StoredSession> sessions;
    list().read(view, sessions);
    for (StoredSession& session : sessions) {
      project.sessions.push_back(std::move(session.path));
      project.topics.push_back(std::move(session.topics));
    }
  }
};

/// The result as files of results hold it, without its pairs, which a project holds in full.
struct StoredResult {
  formats::DocumentNode write(const Project& project) const {
    pipeline::PipelineInput input;
    input.settings = project.basis.settings;
    input.nominal_ins_from_lidar = project.basis.nominal_ins_from_lidar;
    results::ResultFile file = make_result_file(input, *project.output, project.inputs);
    file.pairs.clear();
    return results::result_document(file);
  }
  void read(const formats::DocumentView& view, Project& project) const {
    results::ResultFile file = results::result_from_document(view);
    pipeline::PipelineOutput& output = *project.output;
    output.method = std::move(file.method);
    output.quantities = std::move(file.quantities);
    output.plots = std::move(file.plots);
    output.result = std::move(file.result);
    output.sharpness = std::move(file.sharpness);
    project.inputs = std::move(file.inputs);
    project.basis.settings = file.settings;
    project.basis.nominal_ins_from_lidar = file.nominal_ins_from_lidar;
  }
};

constexpr formats::Through kSettings{
    [](const settings::Settings& settings) { return settings::settings_document(settings); },
    [](const formats::DocumentView& view) { return settings::settings_from_document(view); }};

auto keyframes_of(std::size_t session_count) {
  return formats::ListOf{
      formats::Through{formats::keyframe_document, [session_count](const formats::DocumentView& view) {
                         return formats::keyframe_from_document(view, session_count);
                       }}};
}

auto pairs_of(std::size_t keyframe_count) {
  return formats::ListOf{formats::Through{formats::pair_document, [keyframe_count](const formats::DocumentView& view) {
                                            return formats::pair_from_document(view, keyframe_count);
                                          }}};
}

}  // namespace

}  // namespace remount::project

// ---- Records, a line a key

namespace remount::pipeline {

void describe(formats::RecordOf<PairVerdict> auto& verdict, auto& fields) {
  fields.on_one_line();
  fields("session", verdict.session);
  fields("stamp_a_ns", verdict.stamp_a_ns);
  fields("stamp_b_ns", verdict.stamp_b_ns);
  fields("state", verdict.state, formats::OneOf{{results::kPairStates.begin(), results::kPairStates.end()}});
  fields("reason", verdict.reason);
}

}  // namespace remount::pipeline

namespace remount::project {

void describe(formats::RecordOf<PairNote> auto& note, auto& fields) {
  fields.on_one_line();
  fields("session", note.session);
  fields("lidar", note.lidar);
  fields("stamp_a_ns", note.stamp_a_ns);
  fields("stamp_b_ns", note.stamp_b_ns);
  fields("seen", note.seen);
  fields("flagged", note.flagged);
  fields("comment", note.comment);
}

}  // namespace remount::project

namespace remount::calibration {

void describe(formats::RecordOf<ObservedGround> auto& ground, auto& fields) {
  fields("up_in_lidar", ground.up_in_lidar);
  fields.require(std::abs(ground.up_in_lidar.norm() - 1.0) < 1e-6, "up_in_lidar", say::project_expected_unit_vector);
  fields("lidar_height_m", ground.lidar_height_m, formats::Finite());
  fields("height_sigma_m", ground.height_sigma_m, formats::Finite());
  fields("up_sigma_rad", ground.up_sigma_rad, formats::Finite());
}

}  // namespace remount::calibration

namespace remount::motion {

void describe(formats::RecordOf<Sweep> auto& sweep, auto& fields) {
  fields("from_s", sweep.from_s, formats::Finite());
  fields("until_s", sweep.until_s, formats::Finite());
  fields.require(sweep.until_s >= sweep.from_s, "until_s", say::project_expected_until_after_from);
}

}  // namespace remount::motion

namespace remount::drive {

void describe(formats::RecordOf<SweepModel> auto& sweep, auto& fields) {
  fields("period_s", sweep.period_s, formats::Finite());
  fields.require(sweep.period_s > 0.0, "period_s", say::project_expected_above_zero);
  fields("stamp_azimuth_rad", sweep.stamp_azimuth_rad, formats::Finite());
  fields("clockwise", sweep.clockwise);
  fields("by_order", sweep.by_order);
}

}  // namespace remount::drive

namespace remount::project {

namespace {

/// The numbers alone; they are at the output's nodes.
struct MendedBeams {
  formats::DocumentNode write(const pipeline::PipelineOutput& output) const {
    return formats::DocumentNode::numbers({output.mended_beams.values.begin(), output.mended_beams.values.end()});
  }
  void read(const formats::DocumentView& view, pipeline::PipelineOutput& output) const {
    // Of a former version.
    if (output.beam_nodes.empty()) output.beam_nodes = cloud::BeamNodes::all_around();
    const std::vector<double> numbers = view.numbers(static_cast<std::size_t>(output.beam_nodes.errors()));
    output.mended_beams = cloud::BeamErrors(output.beam_nodes);
    std::ranges::copy(numbers, output.mended_beams.values.begin());
  }
};

/// Of a project that has an output.
constexpr formats::MapOf kCalibration{[](auto& project, auto& fields) {
  auto& output = *project.output;
  const formats::OneOf map_checks{{"not_reached", "made", "switched_off", "no_scans", "no_overlap", "moved"}};
  fields.later("session_count", project.basis.session_count,
               formats::Whole{0, static_cast<std::int64_t>(project.sessions.size())});
  fields.where(project.solution_pending, "solution_pending", project.solution_pending);
  fields.where(project.confirmed, "confirmed", project.confirmed);
  fields.where(project.exported, "exported", project.exported);
  fields.later("map_check", output.map_check, map_checks);
  fields("result", project, StoredResult());
  fields("initial_ins_from_lidar", output.initial_ins_from_lidar);
  fields("compensation_ins_from_lidar", output.compensation_ins_from_lidar);
  fields.where(!output.beam_nodes.empty(), "beam_nodes", output.beam_nodes, results::BeamNodesNotation());
  fields.where(!output.known_beams.empty(), "known_beams", output.known_beams, results::BeamNotation());
  fields.where(!output.mended_beams.none(), "mended_beams", output, MendedBeams());
  fields("initial_known", output.initial_known);
  fields("nominal_known", output.nominal_known);
  fields.optional("up_in_lidar", output.up_in_lidar);
  fields.optional("clock_bias", output.clock_bias);
  fields.optional("ground", output.ground);
  fields.later("session_uses_sweep", output.session_uses_sweep);
  fields.later("session_sweeps", output.session_sweeps);
  fields.later("session_swept", output.session_swept);
  fields.later("session_frames", output.session_frames);
  fields.where(!output.clock_told, "clock_told", output.clock_told);
  fields.where(output.clock_is_unknown, "clock_is_unknown", output.clock_is_unknown);
  fields.where(output.farthest_clock_s > 0.0, "farthest_clock_s", output.farthest_clock_s, formats::Finite());
  fields.later("sweep_doubts", output.sweep_doubts);
  fields("findings", output.findings, formats::Through{formats::findings_document, formats::findings_from_document});
  fields("keyframes", output.keyframes, keyframes_of(project.basis.session_count));
  fields("pairs", output.pairs, pairs_of(output.keyframes.size()));
}};

/// null where there is none. What files of former versions lack follows from the rest.
struct CalibrationOrNull {
  formats::DocumentNode write(const Project& project) const {
    return project.output ? kCalibration.write(project) : formats::DocumentNode::null();
  }
  void read(const formats::DocumentView& view, Project& project) const {
    if (view.is_null()) return;
    pipeline::PipelineOutput& output = project.output.emplace();
    project.basis.session_count = project.sessions.size();
    kCalibration.read(view, project);
    const bool told = std::ranges::any_of(
        output.pairs, [](const motion::Pair& pair) { return pair.registration.beam_response.cols() > 0; });
    if (told && output.beam_nodes.empty()) output.beam_nodes = cloud::BeamNodes::all_around();
    if (!view.has("map_check") && !output.sharpness.empty()) output.map_check = pipeline::MapCheck::Made;
  }
};

/// What a project holds of one LiDAR. @param folder of the project
void describe_job(auto& project, auto& fields, const std::filesystem::path& folder) {
  fields("sessions", project, StoredSessions{folder});
  fields("settings", project.settings, kSettings);
  fields("nominal_ins_from_lidar", project.nominal_ins_from_lidar);
  fields("verdicts", project.verdicts);
  fields("calibration", project, CalibrationOrNull());
}

auto other_lidars_in(const std::filesystem::path& folder) {
  return formats::ListOf{formats::MapOf{[&folder](auto& lidar, auto& fields) {
    fields("name", lidar.name);
    fields("ticked", lidar.ticked);
    describe_job(lidar.job, fields, folder);
  }}};
}

constexpr formats::Through kTogether{results::vehicle_document, results::vehicle_from_document};

/// Of a project that lies in this folder.
auto project_fields(const std::filesystem::path& folder) {
  return formats::MapOf{[&folder](auto& project, auto& fields) {
    fields.only_written("format", formats::DocumentNode::string(kFormat));
    fields.only_written("version", formats::DocumentNode::string(kVersion));
    describe_job(project, fields, folder);
    fields.where(!project.notes.empty(), "notes", project.notes);
    fields.where(!project.other_lidars.empty(), "other_lidars", project.other_lidars, other_lidars_in(folder));
    fields.optional("together", project.together, kTogether);
  }};
}

void require_format(const formats::DocumentView& root) {
  const std::string format = root.at("format").string();
  if (format == kFormat || format == kFormerFormat) return;
  const auto problem = format.starts_with("remount-project/") ? say::file_of_later_version : say::file_of_other_format;
  root.at("format").fail(problem(format.substr(0, 60), std::string(kFormat)));
}

}  // namespace

void save_project(const Project& project, const std::filesystem::path& path) {
  const std::filesystem::path folder = folder_of(path);
  formats::save_atomically(path, formats::to_yaml(project_fields(folder).write(project)));
}

Project load_project(const std::filesystem::path& path) {
  const formats::DocumentNode document = formats::read_document(path, kLimits);
  const formats::DocumentView root(document, path.string());
  const std::filesystem::path folder = folder_of(path);
  const auto fields = project_fields(folder);
  require_format(root);
  Project project;
  fields.allow_no_others(root, project);
  fields.read(root, project);
  return project;
}

}  // namespace remount::project
