// Layout and actions; what they do is the workbench's business.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <functional>

#include "app/gui/workbench/workbench.h"
#include "widgets/shell/step_bar.h"
#include "widgets/text/option_access.h"

class QComboBox;
class QDockWidget;
class QPushButton;
class QMenu;
class QStackedWidget;
class QTableView;
class QTabWidget;

namespace remount {

class CandidatesPanel;
class CandidateTableModel;
class DrivePanel;
class ErrorChartPanel;
class HelpWindow;
class LogPanel;
class MessageBanner;
class NominalPanel;
class OptionsDialog;
class PairsPanel;
class PairTableModel;
class PairView;
class MapController;
class MapView;
class SceneController;
class ProgressStrip;
class ProjectKeeper;
class QualityController;
class QualityView;
class ComparisonView;
class MethodController;
class MethodView;
class PathView;
class RangePanel;
class ReportMaker;
class ResultPanel;
class SessionListModel;
class SessionsPanel;
class TurnQueue;
class WelcomePanel;

class Autosave;
struct KeptResults;

/// What stays when another window takes the place of one.
struct WindowHandover {
  QByteArray geometry, state;
  QString log;
  std::unique_ptr<Autosave> autosave;     ///< null where work is not kept
  std::unique_ptr<KeptResults> compared;  ///< of the methods

  WindowHandover(QByteArray geometry, QByteArray state, QString log, std::unique_ptr<Autosave> autosave,
                 std::unique_ptr<KeptResults> compared);
  WindowHandover(WindowHandover&&) noexcept;
  ~WindowHandover();
};

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(Workbench& workbench, QWidget* parent = nullptr);
  ~MainWindow() override;

  void open_paths(const QStringList& paths);  ///< sessions and projects
  void open_sample();
  /// Keeps unsaved work in a folder of the user's and offers what a crashed window left there.
  void keep_work_in(const QString& data_folder);
  WindowHandover hand_over();
  void take_over(WindowHandover handover);
  /// Where the bundled sample session lies; empty where it is not installed.
  static QString sample_path();
  void show_everything();                             ///< what else would follow in the next turns of the event loop
  QString help_page_of(const QWidget* widget) const;  ///< its name in resources/help, by the panel that holds it

 signals:
  void language_requested(const QString& code);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  static constexpr int kWelcomePage = 0, kPairPage = 1;  // of centre_
  // main_window.cpp: layout
  void make_centre();
  void make_docks();
  QDockWidget* make_dock(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area);
  QWidget* make_setup();
  void size_docks();
  void set_angle_unit(AngleUnit unit);  ///< of range and options
  // main_window_actions.cpp: menus
  void make_file_menu();
  void make_edit_menu();
  void make_calibrate_menu();
  void make_view_menu();
  void add_language_menu(QMenu& menu);
  void make_help_menu();
  void reset_layout();  ///< main_window.cpp
  QAction* add_action(QMenu& menu, const QString& text, const QKeySequence& key, const std::function<void()>& act);
  void open_project();
  bool save_project(bool ask, std::function<void()> saved = {});  ///< false where the user changed their mind
  void begin_project();  ///< in place of what is there; asks about unsaved work first
  /// Opens a project in place of what is there; asks about unsaved work first.
  void replace_by(const QString& project);
  /// False where the user has to answer more, or changed their mind; `saved` is called where they chose to save.
  bool may_close(std::function<void()> saved);
  void show_project();
  void ask_what_to_open();  ///< a menu below what was clicked
  void ask_for_folder();
  void ask_for_sessions_below(const QString& folder, const QStringList& paths);
  void ask_for_file();
  void ask_for_nominal();
  void show_options();
  void ask_for_default_options();
  void show_export();
  void ask_for_report();
  bool may_replace(QStringList files);  ///< asks where one of them exists
  void show_obstacles();
  void show_quality();
  void show_methods();
  void ask_for_results();  ///< to be compared
  void copy_result();
  void use_result_as_nominal();
  void go_to_step(Step step);
  void show_about();
  void show_help();
  // main_window_review.cpp: decisions about pairs, and their keys
  void make_review_menu();
  QAction* add_review(QMenu& menu, const char* id, const QString& text, const char* key,
                      const std::function<void()>& act);
  /// An action whose key the user may change, under the name by which it is remembered.
  QAction* add_bound(QMenu& menu, const QString& id, const QString& text, const QKeySequence& key,
                     const std::function<void()>& act);
  void restore_keys();
  void make_reason_menu(QMenu& review);
  std::vector<int> pairs_to_decide() const;
  void decide(PairState state, const Message& reason = {});
  void ask_reason();
  void reject_above(const std::vector<int>& pairs, const QString& reason);
  void go(int step, bool undecided);
  void show_keys();
  std::vector<struct KeyBinding> key_bindings() const;
  void apply_keys(const std::vector<KeyBinding>& bindings);
  // main_window_wiring.cpp: workbench <-> widgets
  void connect_intents();
  void connect_state();
  void make_controllers();
  void connect_selection();
  void show_sessions();
  void show_output();
  void show_errors();
  void show_candidates();
  void show_state();
  void show_clouds(int pair, const CloudsPtr& clouds);
  void show_message(Severity severity, const QString& where, const QString& what);
  void progress_text(const QString& text);  ///< unless a calibration reports there
  QString scan_name(int keyframe) const;
  QString pair_caption(int pair) const;
  void set_palettes();

  Workbench& workbench_;
  SessionListModel* session_model_;
  PairTableModel* pair_model_;
  CandidateTableModel* candidate_model_;
  StepBar* steps_ = nullptr;
  MessageBanner* banner_ = nullptr;
  QStackedWidget* centre_ = nullptr;
  WelcomePanel* welcome_ = nullptr;
  PairView* pair_view_ = nullptr;
  MapView* map_view_ = nullptr;
  QTabWidget* views_ = nullptr;  // pair and map
  SceneController* scenes_ = nullptr;
  MapController* maps_ = nullptr;
  QualityView* quality_ = nullptr;
  QComboBox* method_chooser_ = nullptr;
  MethodView* method_ = nullptr;
  PathView* paths_ = nullptr;
  ComparisonView* comparison_ = nullptr;
  QTabWidget* methods_ = nullptr;  // of the method, in space, and results compared
  MethodController* method_control_ = nullptr;
  QualityController* checks_ = nullptr;
  SessionsPanel* sessions_ = nullptr;
  NominalPanel* nominal_ = nullptr;
  RangePanel* range_ = nullptr;
  PairsPanel* pairs_ = nullptr;
  ErrorChartPanel* errors_ = nullptr;
  DrivePanel* drive_ = nullptr;
  CandidatesPanel* candidates_ = nullptr;
  ResultPanel* result_ = nullptr;
  LogPanel* log_ = nullptr;
  ProgressStrip* progress_ = nullptr;
  ProjectKeeper* keeper_ = nullptr;
  ReportMaker* report_ = nullptr;
  OptionsDialog* options_ = nullptr;
  HelpWindow* help_ = nullptr;
  QDockWidget *pairs_dock_ = nullptr, *error_dock_ = nullptr, *drive_dock_ = nullptr, *candidates_dock_ = nullptr,
              *log_dock_ = nullptr, *setup_dock_ = nullptr, *result_dock_ = nullptr, *quality_dock_ = nullptr,
              *methods_dock_ = nullptr;
  QPushButton* run_ = nullptr;
  QAction *calibrate_ = nullptr, *cancel_ = nullptr, *export_ = nullptr, *make_report_ = nullptr, *obstacles_ = nullptr;
  QAction *copy_ = nullptr, *use_as_nominal_ = nullptr;
  QList<QAction*> undo_actions_;  // undo, redo
  QMenu* open_menu_ = nullptr;    // folder, files, project: behind every button that opens
  struct BoundAction {
    QString id;  // by which its key is remembered
    QAction* action;
    QKeySequence standard;
  };
  std::vector<BoundAction> bound_actions_;
  std::vector<QAction*> review_actions_;  // that need a calibration
  TurnQueue* turns_;                      // what follows when the output has changed
  QByteArray standard_layout_;
  AngleUnit angle_unit_ = AngleUnit::Degrees;
  CloudsPtr shown_clouds_;  // of the selected pair
  bool was_busy_ = false;
  QElapsedTimer solving_since_;  // of solutions after edits; not valid while there is none
  QString idle_;                 // what the status strip said last while nothing ran
  QString note_at_end_;          // what it says when the present work is done
};

}  // namespace remount
