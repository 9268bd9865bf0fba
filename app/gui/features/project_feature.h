// Projects and what is opened: their files, their dialogs, and that no work is lost around a window.
#pragma once

#include "app/gui/shell/feature.h"

namespace remount::widgets {
class WelcomePanel;
}  // namespace remount::widgets

namespace remount::gui {

class ProjectKeeper;

class ProjectFeature : public Feature {
  Q_OBJECT
 public:
  explicit ProjectFeature(MainWindow& window);
  void open_paths(const QStringList& paths);  ///< sessions and projects
  void open_sample();
  /// Keeps unsaved work in a folder of the user's and offers what a crashed window left there.
  void keep_work_in(const QString& data_folder);
  bool may_close(const std::function<void()>& again) override;
  void finish() override;
  std::unique_ptr<Kept> hand_over() override;
  void take_over(Kept* kept) override;

 private:
  void make_menu();
  void make_welcome();
  void open_project();
  bool save_project(bool ask, std::function<void()> saved = {});  ///< false where the user changed their mind
  void begin_project();  ///< in place of what is there; asks about unsaved work first
  /// Opens a project in place of what is there; asks about unsaved work first.
  void replace_by(const QString& project);
  void show_project();
  void ask_for_folder();
  void ask_for_file();
  void ask_for_sessions_below(const QString& folder, const QStringList& paths);

  ProjectKeeper* keeper_;
};

}  // namespace remount::gui
