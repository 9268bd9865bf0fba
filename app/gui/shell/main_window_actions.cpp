#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>

#include "app/gui/basics/undo_keys.h"
#include "app/gui/document/project_keeper.h"
#include "app/gui/document/result_files.h"
#include "app/gui/features/method_controller.h"
#include "app/gui/features/obstacle_controller.h"
#include "app/gui/jobs/error_words.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/workbench/wording.h"
#include "model/drive/session_frames.h"
#include "remount_version.h"
#include "widgets/forms/option_changes.h"
#include "widgets/map/map_view.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/project/options_dialog.h"
#include "widgets/quality/obstacle_dialog.h"
#include "widgets/quality/quality_view.h"
#include "widgets/result/result_panel.h"
#include "widgets/text/model_text.h"

namespace remount {
namespace {

bool is_project(const QString& path) { return path.endsWith(QLatin1String(".remount")); }

}  // namespace

QAction* MainWindow::add_action(QMenu& menu, const QString& text, const QKeySequence& key,
                                const std::function<void()>& act) {
  QAction* action = menu.addAction(text);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, [act] { act(); });
  return action;
}

void MainWindow::make_file_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&File"));
  add_action(menu, tr("&New project"), QKeySequence::New, [this] { begin_project(); });
  open_menu_ = menu.addMenu(tr("&Open"));
  add_action(*open_menu_, tr("&Folder of a drive…"), QKeySequence::Open, [this] { ask_for_folder(); });
  add_action(*open_menu_, tr("&Log or bag file…"), tr("Ctrl+Shift+O"), [this] { ask_for_file(); });
  open_menu_->addSeparator();
  add_action(*open_menu_, tr("&Project…"), tr("Ctrl+P"), [this] { open_project(); });
  QMenu* recent = menu.addMenu(tr("Open &recent"));
  recent->setToolTipsVisible(true);
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { keeper_->fill_recent_menu(*recent); });
  connect(keeper_, &ProjectKeeper::open_requested, this, &MainWindow::open_paths);
  menu.addSeparator();
  add_action(menu, tr("&Save project"), QKeySequence::Save, [this] { save_project(false); });
  add_action(menu, tr("Save project &as…"), QKeySequence::SaveAs, [this] { save_project(true); });
  menu.addSeparator();
  export_ = add_action(menu, tr("&Export result…"), tr("Ctrl+E"), [this] { show_export(); });
  make_report_ = add_action(menu, tr("Make &report…"), tr("Ctrl+R"), [this] { ask_for_report(); });
  menu.addSeparator();
  add_action(menu, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::make_edit_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
  QAction* undo = workbench_.history().stack().createUndoAction(this, tr("&Undo"));
  undo->setShortcuts(QKeySequence::Undo);
  QAction* redo = workbench_.history().stack().createRedoAction(this, tr("&Redo"));
  redo->setShortcuts(QKeySequence::Redo);
  undo_actions_ = {undo, redo};
  menu.addActions(undo_actions_);
  new UndoKeys(this);
  menu.addSeparator();
  copy_ = add_action(menu, tr("&Copy result"), tr("Ctrl+Shift+C"), [this] { copy_result(); });
  add_action(menu, tr("&Options…"), tr("Ctrl+,"), [this] { show_options(); });
}

void MainWindow::make_calibrate_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Calibrate"));
  calibrate_ = add_action(menu, tr("&Calibrate"), tr("F5"), [this] { workbench_.calibrations().calibrate(); });
  cancel_ = add_action(menu, tr("C&ancel"), tr("Esc"), [this] { workbench_.cancel(); });
  menu.addSeparator();
  use_as_nominal_ =
      add_action(menu, tr("Use the result as &nominal mounting"), {}, [this] { use_result_as_nominal(); });
  obstacles_ = add_action(menu, tr("Check &obstacles…"), tr("Ctrl+B"), [this] { show_obstacles(); });
  add_action(menu, tr("Check &quality"), tr("Ctrl+Shift+B"), [this] { show_quality(); });
  add_action(menu, tr("Figures of the &method, results compared"), tr("Ctrl+Shift+D"), [this] { show_methods(); });
}

void MainWindow::make_view_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  struct NamedView {
    QString id, text;
    StandardView view;
  };
  const std::array<NamedView, 5> views{{{"view-fit", tr("&Fit"), StandardView::Fit},
                                        {"view-top", tr("&Top"), StandardView::Top},
                                        {"view-front", tr("F&ront"), StandardView::Front},
                                        {"view-left", tr("&Left"), StandardView::Left},
                                        {"view-isometric", tr("&Isometric"), StandardView::Isometric}}};
  QList<QAction*> view_actions;
  for (const NamedView& named : views)
    view_actions << add_bound(
        menu, named.id, named.text, QKeySequence(QStringLiteral("Ctrl+%1").arg(view_actions.size() + 1)),
        [this, view = named.view] { static_cast<SceneView*>(views_->currentWidget())->look(view); });
  pair_view_->set_view_actions(view_actions);
  map_view_->set_view_actions(view_actions);
  menu.addSeparator();
  add_bound(menu, "show-pair", tr("The &pair"), tr("Ctrl+Shift+P"), [this] { views_->setCurrentWidget(pair_view_); });
  add_bound(menu, "show-map", tr("The accumulated &map"), tr("Ctrl+M"),
            [this] { views_->setCurrentWidget(map_view_); });
  menu.addSeparator();
  for (QDockWidget* dock : {setup_dock_, drive_dock_, result_dock_, pairs_dock_, error_dock_, candidates_dock_,
                            quality_dock_, methods_dock_, log_dock_})
    menu.addAction(dock->toggleViewAction());
  menu.addSeparator();
  add_action(menu, tr("&Reset layout"), {}, [this] { reset_layout(); });
  menu.addSeparator();
  add_language_menu(menu);
}

void MainWindow::make_help_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Help"));
  add_action(menu, tr("Open &sample session"), {}, [this] { open_sample(); })->setEnabled(!sample_path().isEmpty());
  add_action(menu, tr("&Help on this panel"), QKeySequence::HelpContents, [this] { show_help(); });
  add_action(menu, tr("&Keys"), {}, [this] { show_keys(); });
  add_action(menu, tr("&About Remount"), {}, [this] { show_about(); });
}

QString MainWindow::sample_path() {
  const QDir beside(QCoreApplication::applicationDirPath());
  for (const QString& path : {beside.filePath("../share/remount/sample"), QStringLiteral(REMOUNT_SOURCE_SAMPLE)})
    if (QFileInfo(path).isDir()) return QDir(path).canonicalPath();
  return {};
}

void MainWindow::open_sample() {
  if (sample_path().isEmpty())
    show_message(Severity::Problem, {},
                 tr("The sample session is not installed. Install the package again, or open a recorded drive of yours "
                    "(Ctrl+O)."));
  else
    workbench_.sessions().open({sample_path()});
}

void MainWindow::open_paths(const QStringList& paths) {
  QStringList sessions;
  for (const QString& path : paths) {
    if (is_project(path))
      replace_by(path);
    else
      sessions << path;
  }
  if (!sessions.isEmpty()) workbench_.sessions().open(sessions);
}

void MainWindow::ask_what_to_open() { open_menu_->popup(steps_->mapToGlobal(QPoint(0, steps_->height()))); }

void MainWindow::ask_for_folder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open the folder of a recorded drive"));
  if (!path.isEmpty()) open_paths({path});
}

void MainWindow::ask_for_file() {
  const QStringList paths = QFileDialog::getOpenFileNames(this, tr("Open files of recorded drives"));
  if (!paths.isEmpty()) open_paths(paths);
}

void MainWindow::ask_for_nominal() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Nominal mounting from a result or an exported file"));
  if (path.isEmpty()) return;
  try {
    QStringList doubts;
    workbench_.setup().edit_nominal(nominal_from_file(path, workbench_, doubts));
    if (!doubts.isEmpty()) show_message(Severity::Warning, path, doubts.join('\n'));
  } catch (const Error& error) {
    const JobFailure failure = failure_of(error);
    show_message(Severity::Problem, failure.where, failure.what);
  }
}

void MainWindow::show_options() {
  if (!options_) {
    options_ = new OptionsDialog(workbench_.setup().settings(), this);
    connect(options_, &OptionsDialog::edited, &workbench_.setup(), &Setup::edit_option);
    connect(options_, &OptionsDialog::defaults_requested, this, &MainWindow::ask_for_default_options);
    connect(&workbench_.setup(), &Setup::settings_changed, options_,
            [this] { options_->show_settings(workbench_.setup().settings()); });
    options_->set_angle_unit(angle_unit_, workbench_.setup().settings());
    options_->addActions(undo_actions_);  // keys reach no other window by themselves
  }
  options_->show();
  options_->raise();
  options_->activateWindow();
}

void MainWindow::ask_for_default_options() {
  const QStringList changes = setting_changes(Settings{}, workbench_.setup().settings());
  auto* question = new QMessageBox(QMessageBox::Question, tr("Restore default options"),
                                   tr("Set every option back to its default, the search range as well?"),
                                   QMessageBox::Cancel, options_);
  question->setObjectName(QStringLiteral("default-options"));
  question->setAttribute(Qt::WA_DeleteOnClose);
  if (!changes.isEmpty())
    question->setInformativeText(tr("Defaults that are changed: %1.").arg(in_short(changes, QStringLiteral("; "))));
  const QPushButton* restore = question->addButton(tr("Restore defaults"), QMessageBox::DestructiveRole);
  question->setDefaultButton(QMessageBox::Cancel);
  connect(restore, &QPushButton::clicked, &workbench_.setup(), &Setup::reset_settings);
  question->open();
}

void MainWindow::show_export() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output || !is_usable(output->result)) {
    show_message(Severity::Warning, {},
                 tr("There is no result to export yet. Open a session (Ctrl+O) and calibrate (F5)."));
    return;
  }
  auto* dialog = new ExportDialog(
      export_formats(),
      [this](const QString& id) -> ExportText {
        try {
          return {export_text(workbench_, id), {}};
        } catch (const Error& error) {
          return {{}, tr("Cannot be written in this format: %1").arg(failure_of(error).what)};
        }
      },
      this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  const auto follow = [this, dialog] {
    const OutputPtr now = workbench_.outcome().output();
    if (!now || !is_usable(now->result)) return dialog->reject();
    dialog->show_warning(export_warning(workbench_));
    dialog->set_final(!workbench_.activity().solving());
    dialog->show_current();  // what is saved is what is the result then
  };
  follow();
  connect(&workbench_.outcome(), &Outcome::changed, dialog, follow);
  connect(&workbench_, &Workbench::state_changed, dialog, follow);
  connect(dialog, &ExportDialog::copied, &workbench_, [this] { workbench_.outcome().mark_exported(Exported::Copied); });
  connect(dialog, &ExportDialog::save_requested, this,
          [this, dialog](const QString&, const QString& path, const QString& text) {
            try {
              save_text(path, text);
              workbench_.outcome().mark_exported(Exported::Written);
              show_message(Severity::Note, path, tr("saved"));
              dialog->show_outcome(tr("Saved: %1").arg(path), false);
            } catch (const Error& error) {
              const JobFailure failure = failure_of(error);
              show_message(Severity::Problem, failure.where, failure.what);
              dialog->show_outcome(in_words(failure), true);
            }
          });
  dialog->open();
}

void MainWindow::show_obstacles() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output || !shown_clouds_ || workbench_.selection().pair() < 0) return;
  const Pair& pair = output->pairs.at(static_cast<std::size_t>(workbench_.selection().pair()));
  const RigidTransform vehicle_from_ins = forward_left_up_from(common_axes(workbench_.outcome().input().sessions));
  auto* dialog =
      new ObstacleDialog(tr("scan b of pair %1, %2").arg(workbench_.selection().pair()).arg(scan_name(pair.keyframe_b)),
                         output->nominal_known, distance_caution(workbench_), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  new ObstacleController(workbench_.jobs(), *dialog, shown_clouds_, vehicle_from_ins * output->initial_ins_from_lidar,
                         vehicle_from_ins * output->result.ins_from_lidar);
  dialog->show();
}

void MainWindow::use_result_as_nominal() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output || !is_usable(output->result)) return;
  if (const Message problem = not_in_ins_frame(frames_of(output->result)); !problem.empty())
    workbench_.notices().say(Severity::Problem, tr("Nominal mounting"), model_text(problem));
  else
    workbench_.setup().edit_nominal(output->result.ins_from_lidar);
}

void MainWindow::show_methods() {
  methods_dock_->show();
  methods_dock_->raise();
  methods_->setFocus();
}

void MainWindow::ask_for_results() {
  const QStringList paths = QFileDialog::getOpenFileNames(this, tr("Results to compare"), {},
                                                          tr("Results (*.yaml *.yml *.json);;All files (*)"));
  if (!paths.isEmpty()) method_control_->add_files(paths);
}

void MainWindow::show_quality() {
  quality_dock_->show();
  quality_dock_->raise();
  quality_->setFocus();
}

void MainWindow::copy_result() {
  const OutputPtr output = workbench_.outcome().output();
  if (!output) return;
  QString text = result_as_text(output->result);
  // With the numbers that an export has, for those who go on to paste them.
  if (is_usable(output->result)) {
    text += QStringLiteral("\n\n") + export_text(workbench_, QStringLiteral("matrix"));
    workbench_.outcome().mark_exported(Exported::Copied);
  }
  QGuiApplication::clipboard()->setText(text);
}

void MainWindow::go_to_step(Step step) {
  switch (step) {
    case Step::Load:
      ask_what_to_open();
      break;
    case Step::Pairs:
    case Step::Align:
      if (!workbench_.outcome().output() || workbench_.calibrations().out_of_date())
        workbench_.calibrations().calibrate();
      [[fallthrough]];
    case Step::Review:
      pairs_dock_->show();
      pairs_dock_->raise();
      pairs_->table()->setFocus();
      break;
    case Step::Solve:
      result_dock_->show();
      candidates_dock_->raise();
      break;
    case Step::Check:
      show_quality();
      break;
    case Step::Export:
      show_export();
      break;
  }
}

void MainWindow::show_about() {
  QMessageBox::about(this, tr("About Remount"),
                     tr("<b>Remount %1</b><p>Finds where a LiDAR sits on a vehicle, relative to its GNSS/INS, "
                        "from recorded drives.</p>")
                         .arg(QString::fromUtf8(kVersion)));
}

}  // namespace remount
