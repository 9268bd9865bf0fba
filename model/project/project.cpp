#include "model/project/project.h"

#include "messages/projects.h"
#include "model/checks/data_check.h"
#include "model/drive/session_frames.h"
#include "model/results/deciding_notes.h"
#include "model/settings/settings_file.h"
#include "remount_version.h"

namespace remount::project {
namespace {

/// Points of a curve that a file keeps: more than a page or a window shows.
constexpr std::size_t kMostPlotted = 2000;

void add_setting_changes(const settings::Settings& then, const settings::Settings& now, std::vector<Message>& changes) {
  const formats::DocumentNode before = settings::settings_document(then), after = settings::settings_document(now);
  for (std::size_t s = 0; s < before.items.size(); ++s)
    for (std::size_t i = 0; i < before.items[s].items.size(); ++i) {
      const std::string &section = before.keys[s], &name = before.items[s].keys[i];
      const std::string &old_value = before.items[s].items[i].text, &new_value = after.items[s].items[i].text;
      if (old_value != new_value && affects_result(section, name))
        changes.push_back(say::change_of_setting(section + "." + name, old_value, new_value));
    }
}

}  // namespace

CalibrationBasis basis_of(const pipeline::PipelineInput& input) {
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

std::filesystem::path relocate(const std::filesystem::path& missing, const std::filesystem::path& from,
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

results::ResultFile make_result_file(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output,
                                     std::vector<results::InputFile> inputs) {
  results::ResultFile file;
  file.method = output.method;
  file.result = output.result;
  file.quantities = output.quantities;
  file.plots = output.plots;
  calibration::thin(file.plots, kMostPlotted);
  file.ins_axes = drive::common_axes(input.sessions);
  file.nominal_ins_from_lidar = input.nominal_ins_from_lidar;
  file.pairs = results::pair_records(output.keyframes, output.pairs);
  file.sharpness = output.sharpness;
  // Of the notes, what data are suspected of and what the result rests on: the rest of how the program went about its
  // work is for its log.
  for (const drive::Finding& finding : output.findings)
    if (finding.severity != drive::Severity::Note || checks::finding_kind(finding.code) ||
        results::is_deciding(finding))
      file.findings.push_back(finding);
  file.version = kVersion;
  file.settings = input.settings;
  file.inputs = std::move(inputs);
  file.topics = results::used_topics(input.sessions);
  return file;
}

}  // namespace remount::project
