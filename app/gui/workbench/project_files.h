// Projects as they are read and written: what workers do of it.
#pragma once

#include <QStringList>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "app/gui/jobs/engine.h"
#include "app/gui/jobs/job_runner.h"
#include "app/gui/workbench/calibrated.h"
#include "app/gui/workbench/lock_keeper.h"
#include "app/gui/workbench/vehicle_state.h"
#include "model/project/holder_lock.h"
#include "model/project/project.h"

namespace remount::gui {

/// What the user works on at a moment, as it is saved: a value that a worker may write to a file.
struct ProjectSnapshot {
  project::Project project;  ///< without its output
  OutputPtr output;          ///< null before the first calibration
  std::vector<SavedLidar> other_lidars;
  CommonSolutionPtr common;  ///< null where LiDARs were not calibrated together
  int revision = 0;          ///< of the document
};
/// Writes it; throws Error(Io). Nothing of it is copied on the thread that took the snapshot.
void write_snapshot(ProjectSnapshot snapshot, const QString& path);

/// A project that is to be opened, and how.
struct ProjectToOpen {
  enum class Access {
    Own,       ///< to be saved again: nobody else may have it open
    ReadOnly,  ///< saving asks for another name
    Copy,      ///< as work that has no file yet
    TakeOver,  ///< as Own, from a holder that is gone
  };
  QString path;
  bool recovered = false;  ///< an autosave: what is opened belongs to `belongs_to` and is not saved yet
  QString belongs_to;      ///< of an autosave: the project's own path; empty where it never had one
  std::map<std::string, std::filesystem::path> moved;  ///< sessions that lie elsewhere now, by the path in the file
  bool without_missing = false;                        ///< sessions that are nowhere are left out
  Access access = Access::Own;
};

/// Where the work is saved that a project is opened for; empty for none.
QString own_path_of(const ProjectToOpen& request);

/// Everything that a worker found out about a project's file.
struct OpenedProject {
  project::Project project;  ///< its sessions as they were found, its output apart
  std::vector<SessionPtr> sessions;
  std::vector<JobFailure> failures;
  QStringList missing;
  OutputPtr output;
  std::vector<SavedLidar> other_lidars;  ///< their recordings as they were found
  project::HolderLock::Attempt lock;
};

/// What a project holds of a calibration. @param input what is set now, with the sessions as they are opened
CalibratedResult calibrated_in(const project::Project& project, OutputPtr output, pipeline::PipelineInput input);

/// The lock that goes with what is asked for. `present`: of the project that is open.
project::HolderLock::Attempt lock_to_open(const ProjectToOpen& request, const LockKeeper::LockPtr& present,
                                          LockKeeper& locks);

/// For saving; null where the file system knows no locks. Throws Error where another window has the project.
LockKeeper::LockPtr lock_to_save(const QString& path, const LockKeeper::LockPtr& present, LockKeeper& locks);

/// Reads the project and opens its sessions; throws Error where the file itself cannot be read.
void read_project(const ProjectToOpen& request, OpenedProject& opened, const Engine& engine, Progress& progress);

}  // namespace remount::gui
