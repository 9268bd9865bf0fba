// Work that was not saved, in files that outlive a crash: where they lie, and what a crashed window left behind.
#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/project/holder_lock.h"

namespace remount::gui {

/// What an autosave holds, in figures, so that an offer needs not read the whole of it.
struct AutosaveSummary {
  QString project_path;  ///< empty where it was never saved
  QStringList sessions;
  int pairs = 0, decisions = 0;
  QString status;  ///< of the result; empty without one
};

struct AutosaveGeneration {
  QString path;
  QDateTime saved;  ///< for people: which is newer is known by its number, whatever the clock of the wall did
};

/// A window that ended without closing, and what it left.
struct RecoveryOffer {
  QString folder;  ///< of the window's notes
  AutosaveSummary summary;
  std::vector<AutosaveGeneration> generations;  ///< newest first
};

/// The autosaves of one window. A folder of notes in the user's data folder says where they lie; a lock in it, which
/// ends with the process, tells a crash from a window that is still open. Throws Error(Io).
class RecoveryNotes {
 public:
  static constexpr int kGenerations = 5;
  static constexpr int kGenerationAge_s = 60;  ///< a newer one is overwritten, an older one is kept beside it

  using Clock = std::function<std::chrono::steady_clock::time_point()>;  ///< one that nobody can set
  explicit RecoveryNotes(const QString& data_folder, Clock clock = std::chrono::steady_clock::now);
  ~RecoveryNotes();  ///< leaves everything as it is: only clear() says that all is well

  /// Where the next autosave goes, with earlier generations moved out of the way: beside the project if it has a path,
  /// no other window's autosaves lie there, and its name leaves room for theirs.
  QString next_path(const QString& project_path);
  /// In the notes' own folder: where the project's folder cannot be written.
  QString next_path_in_notes();
  /// After the file at `path` is whole and noted; autosaves at other places are removed.
  void adopt(const QString& path);
  void clear();  ///< all is saved or given up: removes the autosaves, also one that a cancelled write left
  bool empty() const { return used_.isEmpty(); }  ///< since the last clear()
  const QString& folder() const { return folder_; }
  /// Its beat() is to be called now and then, by a worker.
  std::shared_ptr<const project::HolderLock> lock() const { return lock_; }

 private:
  QString rotated(const QString& base);
  QString folder_, base_;
  QStringList used_;  // every base that was handed out
  Clock clock_;
  std::optional<std::chrono::steady_clock::time_point> generation_began_;
  std::shared_ptr<const project::HolderLock> lock_;
};

/// Notes, in the folder of a window's notes, where its autosaves lie and what is in them. Waits for the disk: for a
/// worker. Throws Error(Io).
void write_note(const QString& folder, const QString& autosave_path, const AutosaveSummary& summary);

/// Those of windows that are gone; newest first. Folders that hold nothing to restore are removed. A note that cannot
/// be read is offered nevertheless, with what lies in its folder.
std::vector<RecoveryOffer> find_recoveries(const QString& data_folder);
/// Removes notes and autosaves.
void discard(const RecoveryOffer& offer);

/// "3 minutes ago", "yesterday 17:20", for a list.
QString age_text(const QDateTime& then, const QDateTime& now);

}  // namespace remount::gui
