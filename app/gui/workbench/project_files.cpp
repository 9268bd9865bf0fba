#include "app/gui/workbench/project_files.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/core/places_of_rest.h"
#include "app/gui/workbench/wording.h"
#include "messages/window.h"
#include "widgets/text/model_text.h"

namespace remount::gui {
namespace {

struct ProjectFiles {
  Q_DECLARE_TR_FUNCTIONS(remount::gui::project_files)
};

using LockPtr = LockKeeper::LockPtr;

/// What is held already is not taken again: a lock does not know that it is asked by its own holder.
project::HolderLock::Attempt take_lock(const QString& project, const LockPtr& present, bool by_force,
                                       LockKeeper& locks) {
  const std::filesystem::path path = project::lock_path_of(project.toStdString());
  project::HolderLock::Attempt attempt;
  if (!present || present->path() != path) {
    locks.await(path);
    attempt = project::HolderLock::take(path, by_force);
    attempt.lock = locks.keep(std::move(attempt.lock));
    return attempt;
  }
  attempt.holder = present->beat();
  if (!attempt.holder) attempt.lock = present;
  return attempt;
}

/// They name sessions by number: of those that are left.
template <class OfSession>
void leave_those_of_missing(const std::vector<std::optional<motion::SessionIndex>>& places,
                            std::vector<OfSession>& all) {
  std::erase_if(all, [&](const OfSession& one) { return one.session >= places.size() || !places[one.session]; });
  for (OfSession& one : all) one.session = *places[one.session];
}

void leave_verdicts_of_missing(const std::vector<SessionPtr>& sessions, project::Project& project) {
  const auto places = places_of_rest<motion::SessionIndex>(
      sessions.size(), [&](motion::SessionIndex i) { return sessions[i] != nullptr; });
  leave_those_of_missing(places, project.verdicts);
  leave_those_of_missing(places, project.notes);
}

/// They are of the same recordings, wherever these were found: none of them where one is missing.
void take_other_lidars(const std::vector<std::filesystem::path>& saved_at,
                       const std::vector<std::filesystem::path>& found, OpenedProject& opened) {
  std::vector<project::OtherLidar> others = std::exchange(opened.project.other_lidars, {});
  if (opened.sessions.size() != saved_at.size()) {
    opened.project.together.reset();
    return;
  }
  for (project::OtherLidar& lidar : others) {
    for (std::filesystem::path& path : lidar.job.sessions)
      if (const auto place = std::ranges::find(saved_at, path); place != saved_at.end())
        path = found[static_cast<std::size_t>(place - saved_at.begin())];
    SavedLidar saved;
    if (lidar.job.output) saved.output = std::make_shared<const pipeline::PipelineOutput>(std::move(*lidar.job.output));
    lidar.job.output.reset();
    saved.lidar = std::move(lidar);
    opened.other_lidars.push_back(std::move(saved));
  }
}

void open_sessions(const ProjectToOpen& request, OpenedProject& opened, const Engine& engine, Progress& progress) {
  std::vector<std::filesystem::path>& paths = opened.project.sessions;
  const std::vector<std::filesystem::path> saved_at = paths;
  std::vector<std::filesystem::path> found = paths;
  for (auto& path : found)
    if (const auto moved = request.moved.find(path.string()); moved != request.moved.end()) path = moved->second;
  std::vector<SessionPtr> sessions(paths.size());
  std::vector<std::optional<Error>> errors(paths.size());
  parallel_for(paths.size(), 0, [&](std::size_t i) {
    if (progress.cancelled()) return;
    try {
      sessions[i] =
          std::make_shared<const drive::Session>(engine.open(found[i], opened.project.topics_of(i), progress));
    } catch (const Error& error) {
      errors[i] = error;
    }
  });
  std::error_code none;
  for (std::size_t i = 0; i < paths.size() && !progress.cancelled(); ++i) {
    if (sessions[i]) {
      opened.sessions.push_back(sessions[i]);
      paths[i] = found[i];
    } else if (errors[i]) {
      const Error& error = *errors[i];
      if (!std::filesystem::exists(found[i], none) && !request.without_missing)
        opened.missing << QString::fromStdString(paths[i].string());
      else
        opened.failures.push_back(
            {QString::fromStdString(error.where().empty() ? found[i].string() : error.where()),
             ProjectFiles::tr(
                 "%1\nThe project is opened without this session and without its pairs. Its file is left as it "
                 "is: saving asks for another name.")
                 .arg(widgets::model_text(error.what_happened()))});
    }
  }
  leave_verdicts_of_missing(sessions, opened.project);
  take_other_lidars(saved_at, found, opened);
}

}  // namespace

void write_snapshot(ProjectSnapshot snapshot, const QString& path) {
  if (snapshot.output) snapshot.project.output = *snapshot.output;
  for (SavedLidar& saved : snapshot.other_lidars) {
    if (saved.output) saved.lidar.job.output = *saved.output;
    snapshot.project.other_lidars.push_back(std::move(saved.lidar));
  }
  if (snapshot.common) {
    snapshot.project.together = snapshot.common->file;
    for (results::LidarResult& lidar : snapshot.project.together->lidars) lidar.file.pairs.clear();
  }
  project::save_project(snapshot.project, path.toStdString());
}

CalibratedResult calibrated_in(const project::Project& project, OutputPtr output, pipeline::PipelineInput input) {
  CalibratedResult result;
  result.output = std::move(output);
  result.solved = project.solution_pending ? nullptr : result.output;
  result.input = std::move(input);
  if (result.output) {
    result.input.settings = project.basis.settings;
    result.input.nominal_ins_from_lidar = project.basis.nominal_ins_from_lidar;
    result.input.sessions.resize(std::min(result.input.sessions.size(), project.basis.session_count));
  }
  result.files = project.inputs;
  const bool whole = result.output && result.output == result.solved;
  result.exported = whole && project.exported ? Exported::Written : Exported::No;
  result.confirmed = whole && project.confirmed;
  return result;
}

QString own_path_of(const ProjectToOpen& request) { return request.recovered ? request.belongs_to : request.path; }

project::HolderLock::Attempt lock_to_open(const ProjectToOpen& request, const LockPtr& present, LockKeeper& locks) {
  using Access = ProjectToOpen::Access;
  const QString path = own_path_of(request);
  if (path.isEmpty() || request.access == Access::ReadOnly || request.access == Access::Copy) return {};
  return take_lock(path, present, request.access == Access::TakeOver, locks);
}

LockPtr lock_to_save(const QString& path, const LockPtr& present, LockKeeper& locks) {
  project::HolderLock::Attempt attempt = take_lock(path, present, false, locks);
  if (attempt.holder)
    throw Error(ErrorCode::Contract, path.toStdString(),
                say::window_project_elsewhere(holder_text(*attempt.holder).toStdString()));
  return attempt.lock;
}

void read_project(const ProjectToOpen& request, OpenedProject& opened, const Engine& engine, Progress& progress) {
  opened.project = project::load_project(request.path.toStdString());
  open_sessions(request, opened, engine, progress);
  if (progress.cancelled()) return;
  if (opened.project.output && opened.failures.empty())
    opened.output = std::make_shared<const pipeline::PipelineOutput>(std::move(*opened.project.output));
  opened.project.output.reset();
}

}  // namespace remount::gui
