// The project that is worked on.
#pragma once

#include <QTimer>
#include <deque>

#include "app/gui/workbench/part.h"
#include "app/gui/workbench/project_files.h"

namespace remount::gui {

class Workbench;

/// Holds the path of the project, who may write to it and whether it is saved. Opens, saves and begins projects: all
/// other parts change at once, and what belonged to the project before is dropped.
class ProjectDocument : public WorkbenchPart {
  Q_OBJECT
 public:
  ProjectDocument(const Desk& desk, Workbench& workbench, std::unique_ptr<LockKeeper> locks);

  /// Reads a project and its sessions in the background and replaces what is there. Where sessions are not where the
  /// file says, nothing is replaced and sessions_missing asks for them; where another window has the project open,
  /// held asks how to go on.
  void open(const QString& path) { open(ProjectToOpen{path, {}, {}, {}, {}, {}}); }
  void open(const ProjectToOpen& request);
  /// Saves what is there now, after the saves that were asked for before. `saved` is called once the file is whole, but
  /// not where another project took this one's place meanwhile; a failure becomes a message.
  void save(const QString& path, std::function<void()> saved = {});
  void begin();                                  ///< a new one, without anything in it
  const QString& path() const { return path_; }  ///< empty where it has not been saved
  /// Another window has the project: it is not saved under its path until that one has closed it.
  bool read_only() const { return read_only_; }
  void show_life();  ///< to other computers, by the lock of the project; now and then by itself
  bool has_unsaved_decisions() const;
  /// Edits, decisions or results that no project file has. Sessions that were merely opened are none.
  bool has_unsaved_work() const;
  bool unsaved() const { return revision_ != saved_revision_; }
  int revision() const { return revision_; }  ///< goes up with every edit
  void mark_edited();
  ProjectSnapshot snapshot() const;
  /// Replaces everything; the project's sessions are given opened, its paths are not used.
  void restore(std::vector<SessionPtr> sessions, const project::Project& project, OutputPtr output,
               std::vector<SavedLidar> other_lidars = {});
  void announce() { emit changed(); }

 signals:
  void changed();   ///< its path, or whether it is saved
  void replaced();  ///< what was there belongs to another; what takes its place is told by the other parts
  void saved(const QString& path);
  void opened(const gui::ProjectToOpen& request, bool whole);  ///< whole: with all of its sessions
  /// Ask for them and open again, with `moved` or `without_missing` filled in.
  void sessions_missing(const gui::ProjectToOpen& request, const QStringList& paths);
  /// Another window has it open. Ask, and open again with another `access`.
  void held(const gui::ProjectToOpen& request, const project::LockHolder& holder, bool on_another_computer);
  /// Another window took the project over: it is read-only here from now on.
  void lost(const QString& path, const project::LockHolder& holder);

 private:
  using LockPtr = LockKeeper::LockPtr;
  struct Save {
    QString path;
    ProjectSnapshot snapshot;
    std::function<void()> saved;
    int project = 0;
  };
  bool may_open(const QString& why_not);  ///< says why not
  /// `of_last`: of the save before in the line, which holds its project; it is not in the way of the next to that path.
  void start_save(const LockPtr& of_last);
  void take_saved(const Save& save, const LockPtr& lock);
  void end_save(const LockPtr& lock);
  void hold(LockPtr lock, bool read_only);  ///< of the project that is there now
  void set_path(const QString& path, int saved_revision);
  void take(const ProjectToOpen& request, OpenedProject& opened);
  void take_path(const ProjectToOpen& request, const OpenedProject& opened);
  void stop_all();
  void put_outcome(const project::Project& project, OutputPtr output);
  void announce_replaced();

  Workbench& workbench_;
  std::unique_ptr<LockKeeper> locks_;
  LockPtr lock_;  // of path_; null where there is none
  QString path_;
  bool read_only_ = false;
  bool recovered_ = false;  // from an autosave, and not saved since
  int revision_ = 0, saved_revision_ = 0;
  int project_ = 0;         // goes up where another project takes this one's place
  std::deque<Save> saves_;  // the first is being written: two at once could leave the older in the file
  QTimer beats_;
};

}  // namespace remount::gui
