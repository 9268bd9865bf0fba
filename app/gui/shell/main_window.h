// The window: docks, menus, views and their order; what it can do is plugged in.
#pragma once

#include <QMainWindow>
#include <map>
#include <memory>
#include <vector>

#include "app/gui/shell/docks.h"
#include "app/gui/shell/feature.h"
#include "app/gui/shell/full_screen.h"
#include "app/gui/shell/key_bindings.h"
#include "app/gui/shell/menus.h"
#include "app/gui/shell/workspaces.h"
#include "app/gui/workbench/workbench.h"
#include "widgets/basics/scene_view.h"
#include "widgets/shell/step_bar.h"

class QScrollArea;
class QStackedWidget;
class QTabWidget;
class QVBoxLayout;

namespace remount::gui {

/// What stays when another window takes the place of one.
struct WindowHandover {
  QByteArray geometry;
  WorkspaceStates workspaces;
  std::vector<std::unique_ptr<Feature::Kept>> of_features;  ///< in their order
};

/// A view in the middle of the window.
struct ViewSpec {
  QWidget* view = nullptr;
  QString title;
  QString help_page;
  QString action_id, action_text;  ///< of the action that shows it
  QKeySequence key;
};

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// Features come in the order in which their docks, views and actions are to stand.
  MainWindow(Workbench& workbench, const std::vector<MakeFeature>& features, QWidget* parent = nullptr);
  ~MainWindow() override;

  Workbench& workbench() const { return workbench_; }
  /// Null where the window was made without it.
  template <class Plugged>
  Plugged* feature() const {
    for (const auto& one : features_)
      if (auto* plugged = dynamic_cast<Plugged*>(one.get())) return plugged;
    return nullptr;
  }

  // For features.
  Menus& menus() const { return *menus_; }
  KeyBindings& keys() const { return *keys_; }
  QDockWidget* add_dock(const DockSpec& spec);
  void add_view(const ViewSpec& spec);
  void show_view(QWidget& view);
  void show_first_view();
  void offer_view(QWidget& view, bool offered);  ///< its tab: there is something that it can show
  void add_banner(QWidget* banner);              ///< above the views
  void set_welcome(QWidget* welcome);            ///< in their place while no session is open
  /// What the step bar leads to; several features may answer.
  void on_step(widgets::Step step, const std::function<void()>& go);
  void go_to_step(widgets::Step step);
  const QList<QAction*>& undo_actions() const { return undo_actions_; }
  /// In the status strip, unless a calibration reports there.
  void tell(const QString& text) { emit told(text); }

  void open_paths(const QStringList& paths) { emit paths_requested(paths); }  ///< sessions and projects
  WindowHandover hand_over();
  void take_over(WindowHandover handover);
  void show_everything();                             ///< what else would follow in the next turns of the event loop
  QString help_page_of(const QWidget* widget) const;  ///< its name in resources/help, by the panel that holds it

 signals:
  void language_requested(const QString& code);
  void paths_requested(const QStringList& paths);
  void told(const QString& text);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void make_centre();
  void make_own_menus();
  void make_view_menu();
  void add_language_menu();
  void restore_layout();
  void set_full_screen(bool on);
  void show_output();
  void show_state();

  Workbench& workbench_;
  Menus* menus_;
  KeyBindings* keys_;
  Docks* docks_;
  FullScreen* full_screen_;
  Workspaces* workspaces_;
  TurnQueue* turns_;  // what follows when the output has changed
  widgets::StepBar* steps_ = nullptr;
  QVBoxLayout* column_ = nullptr;
  QStackedWidget* centre_ = nullptr;
  QScrollArea* welcome_page_ = nullptr;
  QTabWidget* views_ = nullptr;
  std::vector<ViewSpec> shown_views_;
  QList<QAction*> undo_actions_;  // undo, redo
  std::multimap<widgets::Step, std::function<void()>> step_answers_;
  std::map<const QWidget*, QString> help_pages_;
  std::vector<std::unique_ptr<Feature>> features_;
};

}  // namespace remount::gui
