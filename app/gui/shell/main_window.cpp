#include "app/gui/shell/main_window.h"

#include <QActionGroup>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QPointer>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/gui/basics/language.h"
#include "app/gui/basics/undo_keys.h"
#include "app/gui/workbench/steps.h"
#include "widgets/basics/remembering.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/shrinking_area.h"

namespace remount::gui {
MainWindow::MainWindow(Workbench& workbench, const std::vector<MakeFeature>& features, QWidget* parent)
    : QMainWindow(parent),
      workbench_(workbench),
      menus_(new Menus(*menuBar())),
      keys_(new KeyBindings(*this)),
      docks_(new Docks(*this)),
      full_screen_(new FullScreen(*this)),
      workspaces_(new Workspaces(*this, *docks_)),
      turns_(new TurnQueue(this)) {
  setWindowTitle(tr("Remount"));
  setAcceptDrops(true);
  resize(widgets::within_screen(*this, {1280, 900}));  // or a small screen cuts the status strip off
  make_centre();
  make_own_menus();
  for (const MakeFeature& make : features) features_.push_back(make(*this));
  make_view_menu();
  docks_->arrange();
  keys_->restore();
  connect(&workbench_.outcome(), &Outcome::changed, this, &MainWindow::show_output);
  connect(&workbench_, &Workbench::state_changed, this, &MainWindow::show_state);
  for (const auto& feature : features_) feature->show_palette(palette());
  restore_layout();
  show_output();
}

MainWindow::~MainWindow() = default;

void MainWindow::make_centre() {
  steps_ = new widgets::StepBar(this);
  auto* bar = addToolBar(tr("Steps"));
  bar->setObjectName("steps");
  bar->setMovable(false);
  bar->addWidget(steps_);
  bar->toggleViewAction()->setEnabled(false);
  connect(steps_, &widgets::StepBar::step_clicked, this, &MainWindow::go_to_step);
  on_step(widgets::Step::Load, [this] { menus_->open_menu().popup(steps_->mapToGlobal(QPoint(0, steps_->height()))); });
  centre_ = new QStackedWidget(this);
  welcome_page_ = new QScrollArea(this);
  welcome_page_->setWidgetResizable(true);
  welcome_page_->setFrameShape(QFrame::NoFrame);
  centre_->addWidget(welcome_page_);
  views_ = new QTabWidget(this);
  views_->setDocumentMode(true);
  // With all docks around it, 800 by 500 pixels are enough for the window.
  centre_->addWidget(new widgets::ShrinkingArea(views_, QSize(320, 150)));
  auto* page = new QWidget(this);
  column_ = new QVBoxLayout(page);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(2);
  column_->addWidget(centre_, 1);
  setCentralWidget(page);
}

void MainWindow::make_own_menus() {
  menus_->add(MenuPlace::FileQuit, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
  QAction* undo = workbench_.history().stack().createUndoAction(this, tr("&Undo"));
  undo->setShortcuts(QKeySequence::Undo);
  QAction* redo = workbench_.history().stack().createRedoAction(this, tr("&Redo"));
  redo->setShortcuts(QKeySequence::Redo);
  undo_actions_ = {undo, redo};
  for (QAction* action : undo_actions_) menus_->add(MenuPlace::EditUndo, action);
  new UndoKeys(this);
  menus_->add(MenuPlace::ReviewKeys, tr("&Keys…"), {}, [this] { keys_->ask(); });
}

void MainWindow::make_view_menu() {
  struct NamedView {
    QString id, text;
    scene::StandardView view;
  };
  const std::array<NamedView, 5> views{{{"view-fit", tr("&Fit"), scene::StandardView::Fit},
                                        {"view-top", tr("&Top"), scene::StandardView::Top},
                                        {"view-front", tr("F&ront"), scene::StandardView::Front},
                                        {"view-left", tr("&Left"), scene::StandardView::Left},
                                        {"view-isometric", tr("&Isometric"), scene::StandardView::Isometric}}};
  QList<QAction*> actions;
  for (const NamedView& named : views)
    actions << keys_->bind(named.id,
                           menus_->add(MenuPlace::ViewDirections, named.text,
                                       QKeySequence(QStringLiteral("Ctrl+%1").arg(actions.size() + 1)), [this, named] {
                                         if (auto* shown = qobject_cast<widgets::SceneView*>(views_->currentWidget()))
                                           shown->look(named.view);
                                       }));
  for (const ViewSpec& spec : shown_views_) {
    if (auto* view = qobject_cast<widgets::SceneView*>(spec.view)) view->set_view_actions(actions);
    keys_->bind(spec.action_id, menus_->add(MenuPlace::ViewTabs, spec.action_text, spec.key,
                                            [this, view = spec.view] { show_view(*view); }));
  }
  for (QDockWidget* dock : docks_->all()) menus_->add(MenuPlace::ViewDocks, dock->toggleViewAction());
  QAction* full = menus_->add(MenuPlace::ViewLayout, tr("F&ull screen"), QKeySequence(Qt::Key_F11), [] {});
  full->setCheckable(true);
  connect(full, &QAction::toggled, this, &MainWindow::set_full_screen);
  menus_->add(MenuPlace::ViewLayout, tr("&Everything"), tr("Ctrl+Shift+E"),
              [this] { workspaces_->go_to(Workspace::All); });
  menus_->add(MenuPlace::ViewLayout, tr("Re&view of pairs"), tr("Ctrl+Shift+R"),
              [this] { workspaces_->go_to(Workspace::Review); });
  menus_->add(MenuPlace::ViewLayout, tr("&Reset layout"), {}, [this] { workspaces_->reset(); });
  add_language_menu();
}

void MainWindow::add_language_menu() {
  // Found also by those who cannot read the language that is set.
  QMenu* list = menus_->add_menu(MenuPlace::ViewLanguage, QStringLiteral("&Language / 语言"));
  auto* group = new QActionGroup(list);
  for (const SpokenLanguage& language : languages()) {
    QAction* action = list->addAction(language.name);
    action->setCheckable(true);
    action->setChecked(language.code == spoken_language());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, code = language.code] { emit language_requested(code); });
  }
}

QDockWidget* MainWindow::add_dock(const DockSpec& spec) {
  QDockWidget* dock = docks_->add(spec);
  help_pages_[dock] = spec.help_page;
  return dock;
}

void MainWindow::add_view(const ViewSpec& spec) {
  views_->addTab(spec.view, spec.title);
  help_pages_[spec.view] = spec.help_page;
  shown_views_.push_back(spec);
}

void MainWindow::show_view(QWidget& view) { views_->setCurrentWidget(&view); }

void MainWindow::show_first_view() { views_->setCurrentIndex(0); }

void MainWindow::offer_view(QWidget& view, bool offered) { views_->setTabVisible(views_->indexOf(&view), offered); }

void MainWindow::add_banner(QWidget* banner) { column_->insertWidget(column_->indexOf(centre_), banner); }

void MainWindow::set_welcome(QWidget* welcome) { welcome_page_->setWidget(welcome); }

void MainWindow::on_step(widgets::Step step, const std::function<void()>& go) { step_answers_.emplace(step, go); }

void MainWindow::go_to_step(widgets::Step step) {
  workspaces_->go_to(step == widgets::Step::Review ? Workspace::Review : Workspace::All);
  const auto [first, last] = step_answers_.equal_range(step);
  for (auto answer = first; answer != last; ++answer) answer->second();
}

QString MainWindow::help_page_of(const QWidget* widget) const {
  for (; widget; widget = widget->parentWidget())
    if (const auto page = help_pages_.find(widget); page != help_pages_.end()) return page->second;
  return workbench_.sessions().empty() ? QStringLiteral("start") : QStringLiteral("projects");
}

void MainWindow::restore_layout() {
  if (widgets::remembers()) restoreGeometry(QSettings().value("window/geometry").toByteArray());
  workspaces_->restore();
  if (!widgets::remembers()) return;
  resize(widgets::within_screen(*this, size()));  // the screen may be another
}

/// Keys stay as they are: pairs are looked through and decided about without a table beside them.
void MainWindow::set_full_screen(bool on) {
  full_screen_->set(on);
  if (QWidget* view = views_->currentWidget()) view->setFocus();
}

void MainWindow::show_output() {
  for (const auto& feature : features_) feature->show_output();
  show_state();
  std::vector<TurnQueue::Piece> later;
  for (const auto& feature : features_)
    for (TurnQueue::Piece& piece : feature->show_output_later()) later.push_back(std::move(piece));
  turns_->start(std::move(later));
  if (!workbench_.outcome().output()) turns_->finish();  // its pairs and sessions may be gone
}

void MainWindow::show_everything() { turns_->finish(); }

void MainWindow::show_state() {
  for (const auto& feature : features_) feature->show_state();
  steps_->show_steps(describe_steps(workbench_));
  const bool nothing_yet = workbench_.sessions().empty() && !workbench_.activity().opening();
  if (nothing_yet && welcome_page_->widget())
    centre_->setCurrentWidget(welcome_page_);
  else
    centre_->setCurrentIndex(centre_->count() - 1);
}

WindowHandover MainWindow::hand_over() {
  full_screen_->set(false);  // or what it hides would stay hidden in the next window
  WindowHandover handover{saveGeometry(), workspaces_->hand_over(), {}};
  for (const auto& feature : features_) handover.of_features.push_back(feature->hand_over());
  return handover;
}

void MainWindow::take_over(WindowHandover handover) {
  restoreGeometry(handover.geometry);
  workspaces_->take_over(handover.workspaces);
  handover.of_features.resize(features_.size());
  for (std::size_t i = 0; i < features_.size(); ++i) features_[i]->take_over(handover.of_features[i].get());
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
  const auto again = [window = QPointer(this)] {
    if (window) window->close();
  };
  for (const auto& feature : features_)
    if (!feature->may_close(again)) return event->ignore();
  if (widgets::remembers()) {
    full_screen_->set(false);
    QSettings().setValue("window/geometry", saveGeometry());
    workspaces_->remember();
  }
  workbench_.jobs().cancel_all();
  for (const auto& feature : features_) feature->finish();
  QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange)
    for (const auto& feature : features_) feature->show_palette(palette());
  QMainWindow::changeEvent(event);
}

}  // namespace remount::gui
