#include "app/gui/shell/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/basics/remembering.h"
#include "app/gui/basics/turn_queue.h"
#include "app/gui/document/project_keeper.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/features/topic_controller.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/shrinking_area.h"
#include "widgets/map/map_view.h"
#include "widgets/map/path_view.h"
#include "widgets/methods/method_view.h"
#include "widgets/pairs/error_chart_panel.h"
#include "widgets/pairs/pair_table_model.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/project/options_dialog.h"
#include "widgets/quality/quality_view.h"
#include "widgets/result/candidate_table_model.h"
#include "widgets/result/candidates_panel.h"
#include "widgets/result/comparison_view.h"
#include "widgets/result/nominal_panel.h"
#include "widgets/result/range_panel.h"
#include "widgets/result/result_panel.h"
#include "widgets/sessions/drive_panel.h"
#include "widgets/sessions/session_list_model.h"
#include "widgets/sessions/sessions_panel.h"
#include "widgets/shell/log_panel.h"
#include "widgets/shell/message_banner.h"
#include "widgets/shell/progress_strip.h"
#include "widgets/shell/welcome_panel.h"

namespace remount {
namespace {
constexpr int kLayoutVersion = 3;
}  // namespace

MainWindow::MainWindow(Workbench& workbench, QWidget* parent)
    : QMainWindow(parent),
      workbench_(workbench),
      session_model_(new SessionListModel(this)),
      pair_model_(new PairTableModel(this)),
      candidate_model_(new CandidateTableModel(this)),
      turns_(new TurnQueue(this)) {
  setWindowTitle(tr("Remount"));
  setAcceptDrops(true);
  resize(within_screen(*this, {1280, 900}));  // or a small screen cuts the status strip off
  make_centre();
  make_docks();
  progress_ = new ProgressStrip(this);
  statusBar()->addWidget(progress_, 1);
  keeper_ = new ProjectKeeper(workbench_, *this);
  report_ = new ReportMaker(workbench_, this);
  new TopicController(workbench_, *this);
  make_file_menu();
  make_edit_menu();
  make_calibrate_menu();
  make_review_menu();
  make_view_menu();
  make_help_menu();
  restore_keys();
  connect_intents();
  connect_state();
  set_palettes();
  standard_layout_ = saveState(kLayoutVersion);
  if (remembers()) {
    const QSettings settings;
    if (settings.value("angles/radians").toBool()) set_angle_unit(AngleUnit::Radians);
    restoreGeometry(settings.value("window/geometry").toByteArray());
    restoreState(settings.value("window/state").toByteArray(), kLayoutVersion);
    resize(within_screen(*this, size()));  // the screen may be another
  }
  show_sessions();
  show_output();
  show_state();
}

MainWindow::~MainWindow() = default;

void MainWindow::make_centre() {
  steps_ = new StepBar(this);
  auto* bar = addToolBar(tr("Steps"));
  bar->setObjectName("steps");
  bar->setMovable(false);
  bar->addWidget(steps_);
  bar->toggleViewAction()->setEnabled(false);
  banner_ = new MessageBanner(this);
  welcome_ = new WelcomePanel(this);
  welcome_->set_sample_available(!sample_path().isEmpty());
  pair_view_ = new PairView(this);
  map_view_ = new MapView(this);
  centre_ = new QStackedWidget(this);
  auto* welcome_page = new QScrollArea(this);
  welcome_page->setWidget(welcome_);
  welcome_page->setWidgetResizable(true);
  welcome_page->setFrameShape(QFrame::NoFrame);
  centre_->addWidget(welcome_page);
  views_ = new QTabWidget(this);
  views_->setDocumentMode(true);
  views_->addTab(pair_view_, tr("Pair"));
  views_->addTab(map_view_, tr("Map"));
  // With all docks around it, 800 by 500 pixels are enough for the window.
  centre_->addWidget(new ShrinkingArea(views_, QSize(320, 150)));
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(banner_);
  column->addWidget(centre_, 1);
  setCentralWidget(page);
}

QDockWidget* MainWindow::make_dock(const QString& title, const QString& name, QWidget* content,
                                   Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  // What scrolls by itself is not put into another that does: one bar would hide the other.
  const bool scrolls = qobject_cast<QScrollArea*>(content) != nullptr;
  dock->setWidget(scrolls ? content : new ShrinkingArea(content));
  addDockWidget(area, dock);
  // A panel behind another keeps the focus otherwise: F1 and keys would be for what is not seen.
  connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool seen) {
    if (!seen) return;  // the window may be going
    const QList<QDockWidget*> others = tabifiedDockWidgets(dock);
    const bool behind = std::any_of(others.begin(), others.end(), [](const QDockWidget* other) {
      return other->isAncestorOf(QApplication::focusWidget());
    });
    if (behind) dock->widget()->setFocus();
  });
  return dock;
}

QWidget* MainWindow::make_setup() {
  sessions_ = new SessionsPanel(*session_model_);
  nominal_ = new NominalPanel;
  range_ = new RangePanel;
  auto* column_widget = new QWidget;
  auto* column = new QVBoxLayout(column_widget);
  column->setContentsMargins(6, 4, 6, 4);
  const auto add = [&](const QString& title, QWidget* content, int stretch) {
    auto* group = new QGroupBox(title);
    auto* layout = new QVBoxLayout(group);
    layout->setContentsMargins(6, 4, 6, 6);
    layout->addWidget(content);
    column->addWidget(group, stretch);
  };
  add(tr("Sessions"), sessions_, 1);
  add(tr("Nominal mounting (LiDAR in the INS frame)"), nominal_, 0);
  method_chooser_ = new QComboBox;
  method_chooser_->setAccessibleName(tr("Method"));
  auto* method_label = new QLabel(tr("&Method"));
  method_label->setBuddy(method_chooser_);
  auto* method_row = new QHBoxLayout;
  method_row->addWidget(method_label);
  method_row->addWidget(method_chooser_, 1);
  column->addLayout(method_row);
  run_ = new QPushButton(tr("Calibrate (F5)"));
  run_->setMinimumHeight(34);
  QFont bold = run_->font();
  bold.setBold(true);
  run_->setFont(bold);
  column->addWidget(run_);
  add(tr("Search range"), range_, 0);
  return column_widget;
}

void MainWindow::make_docks() {
  pairs_ = new PairsPanel(*pair_model_);
  errors_ = new ErrorChartPanel;
  result_ = new ResultPanel;
  result_->setMinimumWidth(200);
  log_ = new LogPanel;
  candidates_ = new CandidatesPanel(*candidate_model_);
  quality_ = new QualityView;
  method_ = new MethodView;
  paths_ = new PathView;
  comparison_ = new ComparisonView;
  methods_ = new QTabWidget;
  methods_->setDocumentMode(true);
  methods_->addTab(method_, tr("Figures and plots"));
  methods_->addTab(paths_, tr("In three dimensions"));
  methods_->addTab(comparison_, tr("Results compared"));

  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  setup_dock_ = make_dock(tr("Set-up"), "setup", make_setup(), Qt::LeftDockWidgetArea);
  drive_ = new DrivePanel;
  drive_dock_ = make_dock(tr("Drive"), "drive", drive_, Qt::LeftDockWidgetArea);
  tabifyDockWidget(setup_dock_, drive_dock_);
  setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::North);
  setup_dock_->raise();
  result_dock_ = make_dock(tr("Result"), "result", result_, Qt::RightDockWidgetArea);
  pairs_dock_ = make_dock(tr("Pairs"), "pairs", pairs_, Qt::BottomDockWidgetArea);
  error_dock_ = make_dock(tr("Error chart"), "errors", errors_, Qt::BottomDockWidgetArea);
  splitDockWidget(pairs_dock_, error_dock_, Qt::Horizontal);
  // One after the other: all beside each other would widen the window.
  candidates_dock_ = make_dock(tr("Candidates"), "candidates", candidates_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(pairs_dock_, candidates_dock_);
  quality_dock_ = make_dock(tr("Quality"), "quality", quality_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(candidates_dock_, quality_dock_);
  methods_dock_ = make_dock(tr("Method"), "methods", methods_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(quality_dock_, methods_dock_);
  log_dock_ = make_dock(tr("Log"), "log", log_, Qt::BottomDockWidgetArea);
  tabifyDockWidget(methods_dock_, log_dock_);
  setTabPosition(Qt::BottomDockWidgetArea, QTabWidget::North);
  pairs_dock_->raise();
  size_docks();
}

void MainWindow::size_docks() {
  resizeDocks({pairs_dock_, error_dock_}, {860, 420}, Qt::Horizontal);
  resizeDocks({pairs_dock_}, {300}, Qt::Vertical);
  resizeDocks({setup_dock_, result_dock_}, {320, 325}, Qt::Horizontal);
}

void MainWindow::set_angle_unit(AngleUnit unit) {
  angle_unit_ = unit;
  range_->set_angle_unit(unit);
  if (options_) options_->set_angle_unit(unit, workbench_.setup().settings());
  if (remembers()) QSettings().setValue("angles/radians", unit == AngleUnit::Radians);
}

void MainWindow::reset_layout() {
  restoreState(standard_layout_, kLayoutVersion);
  for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->show();
  setup_dock_->raise();
  pairs_dock_->raise();
  size_docks();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  open_paths(paths);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_close([window = QPointer(this)] {
        if (window) window->close();
      })) {
    event->ignore();
    return;
  }
  if (remembers()) {
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    settings.setValue("window/state", saveState(kLayoutVersion));
  }
  workbench_.jobs().cancel_all();
  keeper_->finish();
  QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && centre_) set_palettes();
  QMainWindow::changeEvent(event);
}

}  // namespace remount
