// What keeps work from being lost around a window: autosave, recovery, moved sessions, what was opened lately.
#pragma once

#include <QObject>

#include "app/gui/basics/recent_paths.h"
#include "app/gui/document/autosave.h"

class QMenu;
class QWidget;

namespace remount::widgets {
struct RecoveryEntry;
class MissingSessionsDialog;
}  // namespace remount::widgets

namespace remount::gui {

class ProjectKeeper : public QObject {
  Q_OBJECT
 public:
  ProjectKeeper(Workbench& workbench, QWidget& window);

  /// Begins to keep unsaved work in a folder of the user's, and offers what a crashed window left there.
  void keep_in(const QString& data_folder);
  Autosave* autosave() const { return autosave_.get(); }  ///< null before keep_in
  /// From a window to the one that takes its place.
  std::unique_ptr<Autosave> take_autosave();
  void put_autosave(std::unique_ptr<Autosave> autosave);
  void fill_recent_menu(QMenu& menu);
  const RecentPaths& recent() const { return recent_; }
  void finish();  ///< the window closes for good

 signals:
  void open_requested(const QStringList& paths);
  void recent_changed();

 private:
  void add_recent(const QString& path);
  void offer(const std::vector<RecoveryOffer>& offers);
  void ask_how_to_open(const ProjectToOpen& request, const project::LockHolder& holder, bool on_another_computer);
  void ask_for_sessions(const ProjectToOpen& request, const QStringList& missing);
  void locate(widgets::MissingSessionsDialog& dialog, const QStringList& missing, int row);

  Workbench& workbench_;
  QWidget& window_;
  RecentPaths recent_;
  std::unique_ptr<Autosave> autosave_;
};

/// What an offer is called, what is in it and how old its generations are.
widgets::RecoveryEntry describe(const RecoveryOffer& offer, const QDateTime& now);

}  // namespace remount::gui
