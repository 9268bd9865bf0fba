#include "tests/screenshots/tour.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <cstdio>

#include "app/gui/basics/language.h"
#include "app/gui/document/report_maker.h"
#include "app/gui/features/help_feature.h"
#include "app/gui/features/project_feature.h"
#include "app/gui/features/vehicle_export_dialog.h"
#include "app/gui/window_host.h"
#include "widgets/map/map_view.h"
#include "widgets/map/path_view.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/project/options_dialog.h"
#include "widgets/quality/obstacle_dialog.h"
#include "widgets/quality/quality_view.h"
#include "widgets/result/export_dialog.h"
#include "widgets/sessions/topics_dialog.h"
#include "widgets/shell/help_window.h"
#include "widgets/shell/keys_dialog.h"
#include "widgets/vehicle/lidars_panel.h"

namespace remount::testing {
namespace {

constexpr int kPatience_ms = 600000, kDrawn_ms = 700, kMostQuestions = 8;

QPalette dark_palette() {
  QPalette palette(QColor(53, 53, 53), QColor(42, 42, 42));
  palette.setColor(QPalette::Base, QColor(30, 30, 30));
  palette.setColor(QPalette::AlternateBase, QColor(42, 42, 42));
  palette.setColor(QPalette::Highlight, QColor(61, 142, 201));
  return palette;
}

class Tour {
 public:
  explicit Tour(const TourRequest& request) : request_(request) {}

  bool take() {
    window().resize(request_.size);
    window().show();
    if (!QTest::qWaitForWindowExposed(&window(), kPatience_ms)) return false;
    save(window(), "start");
    open_sessions();
    if (workbench_.sessions().all().empty()) return give_up("no session was opened");
    save(window(), "opened");
    raise("drive");
    save(window(), "drive");
    raise("setup");
    workbench_.calibrations().calibrate();
    QTest::qWait(1500);
    save(window(), "calibrating");
    if (!settled() || !workbench_.outcome().output()) return give_up("no calibration came to an end");
    QTest::qWait(3000);
    save(window(), "result");
    docks();
    views();
    decisions();
    dialogs();
    errors();
    if (workbench_.vehicle().lidars().size() > 1) vehicle();
    return exported() && other_method() && saved_;
  }

 private:
  gui::MainWindow& window() { return host_.window(); }

  void open_sessions() {
    if (request_.sessions.isEmpty())
      window().feature<gui::ProjectFeature>()->open_sample();
    else
      window().open_paths(request_.sessions);
    answer_for_topics();
    settled();
  }
  /// A recording whose topics are not clear asks for them: what it suggests is taken.
  void answer_for_topics() {
    const auto dialog = [&] { return window().findChild<widgets::TopicsDialog*>(); };
    for (int asked = 0; asked < kMostQuestions; ++asked) {
      (void)QTest::qWaitFor([&] { return dialog() || !workbench_.activity().opening(); }, kPatience_ms);
      QTest::qWait(kDrawn_ms);
      widgets::TopicsDialog* asks = dialog();
      if (!asks) return;
      save(*asks, "topics");
      asks->accept();
      QTest::qWait(kDrawn_ms);
    }
  }
  static bool give_up(const char* why) {
    std::fprintf(stderr, "%s\n", why);
    return false;
  }
  void raise(const QString& name) {
    if (auto* dock = window().findChild<QDockWidget*>(name)) dock->raise();
  }
  void docks() {
    for (const char* name : {"residuals", "candidates", "log", "drive"}) {
      raise(name);
      save(window(), name);
    }
    raise("quality");
    auto& quality = *window().findChild<widgets::QualityView*>();
    for (int page = 0; page < quality.count(); ++page) {
      quality.setCurrentIndex(page);
      QTest::qWait(2500);
      save(window(), QStringLiteral("quality-%1").arg(page + 1));
    }
    raise("pairs");
    raise("setup");
  }
  void views() {
    auto& pair = *window().findChild<widgets::PairView*>();
    pair.set_side_by_side(true);
    save(window(), "side-by-side");
    pair.set_side_by_side(false);
    pair.set_coloring(scene::PairColoring::Distance);
    QTest::qWait(1500);
    save(window(), "by-distance");
    pair.set_coloring(scene::PairColoring::Orange);
    trigger("Ctrl+M");
    auto& map = *window().findChild<widgets::MapView*>("map");
    (void)QTest::qWaitFor([&] { return map.shows_scene() && map.rests(); }, kPatience_ms / 10);
    save(window(), "map");
    trigger("Ctrl+Shift+P");
  }
  void decisions() {
    workbench_.decisions().decide({motion::PairIndex{0}}, motion::PairState::Rejected);
    save(window(), "decided");
    settled();
    save(window(), "solved-again");
    workbench_.history().stack().undo();
    settled();
  }
  void vehicle() {
    raise("lidars");
    save(window(), "lidars");
    workbench_.vehicle().calibrate();
    settled();
    QTest::qWait(2000);
    auto& panel = *window().findChild<widgets::LidarsPanel*>();
    for (int page = 0; page < panel.pages()->count(); ++page) {
      panel.pages()->setCurrentIndex(page);
      save(window(), QStringLiteral("lidars-%1").arg(page + 1));
    }
    panel.cross_table()->selectRow(0);
    QTest::qWait(3000);
    save(window(), "pair-across");
    if (auto* reference = panel.findChild<QComboBox*>("reference")) reference->setCurrentIndex(1);
    auto& map = *window().findChild<widgets::MapView*>("vehicle-map");
    window().show_view(map);
    (void)QTest::qWaitFor([&] { return map.shows_scene() && map.rests(); }, kPatience_ms / 10);
    save(window(), "lidars-map");
    workbench_.vehicle().show(motion::LidarIndex{1});
    settled();
    QTest::qWait(1500);
    raise("pairs");
    save(window(), "lidar-shown");
    raise("lidars");
    gui::export_vehicle_from(workbench_, workbench_.vehicle().common()->file, window());
    if (auto* dialog = window().findChild<widgets::ExportDialog*>()) {
      save(*dialog, "export-lidars");
      dialog->reject();
      QTest::qWait(kDrawn_ms);  // until it is gone, and nobody takes it for another
    }
  }
  template <class Dialog>
  void dialog(const QString& key, const QString& name) {
    trigger(key);
    QWidget* shown = window().template findChild<Dialog*>();
    if (!shown) {
      std::fprintf(stderr, "no dialog %s\n", qPrintable(name));
      saved_ = false;
      return;
    }
    save(*shown, name);
    shown->close();
  }
  void dialogs() {
    dialog<widgets::OptionsDialog>("Ctrl+,", "options");
    dialog<widgets::ObstacleDialog>("Ctrl+B", "obstacles");
    dialog<widgets::HelpWindow>("F1", "help");
    for (QAction* action : window().findChildren<QAction*>())
      if (action->text() == gui::HelpFeature::tr("&Keys")) action->trigger();
    if (auto* keys = window().findChild<widgets::KeysDialog*>()) {
      save(*keys, "keys");
      keys->close();
    }
  }
  void errors() {
    window().open_paths({request_.folder + QStringLiteral("/nowhere")});
    settled();
    save(window(), "error-missing");
    QFile empty(request_.folder + QStringLiteral("/empty.txt"));
    if (empty.open(QIODevice::WriteOnly)) empty.close();
    window().open_paths({empty.fileName()});
    settled();
    save(window(), "error-empty");
    empty.remove();
  }
  bool exported() {
    trigger("Ctrl+E");
    auto* dialog = window().findChild<widgets::ExportDialog*>();
    if (!dialog) return false;
    save(*dialog, "export");
    const QString path = request_.folder + QStringLiteral("/exported.txt");
    emit dialog->save_requested(dialog->current_id(), path, dialog->current_text());
    dialog->close();
    save(window(), "exported");
    auto& maker = *window().findChild<gui::ReportMaker*>();
    QSignalSpy finished(&maker, &gui::ReportMaker::finished);
    maker.make(request_.folder + QStringLiteral("/report.html"));
    return QTest::qWaitFor([&] { return finished.count() > 0; }, kPatience_ms) && QFile::exists(path);
  }

  bool other_method() {
    workbench_.setup().edit_option("run", "method", static_cast<int>(method_registry::MethodChoice("trajectory")));
    workbench_.calibrations().calibrate();
    if (!settled()) return false;
    trigger("Ctrl+Shift+D");
    window().resizeDocks({window().findChild<QDockWidget*>("methods")}, {2 * request_.size.height() / 5}, Qt::Vertical);
    auto& pages = *qobject_cast<QTabWidget*>(window().findChild<widgets::PathView*>()->parentWidget()->parentWidget());
    for (int page = 0; page < pages.count(); ++page) {
      pages.setCurrentIndex(page);
      save(window(), QStringLiteral("method-%1").arg(page + 1));
    }
    return true;
  }

  void trigger(const QString& key) {
    for (QAction* action : window().findChildren<QAction*>())
      if (action->shortcut() == QKeySequence(key)) return action->trigger();
    std::fprintf(stderr, "no action has the key %s\n", qPrintable(key));
  }
  bool settled() {
    return QTest::qWaitFor(
        [&] {
          return !workbench_.activity().opening() && !workbench_.activity().calibrating() &&
                 !workbench_.activity().solving();
        },
        kPatience_ms);
  }
  void save(QWidget& widget, const QString& name) {
    QTest::qWait(kDrawn_ms);
    const QString file = QStringLiteral("%1-%2.png").arg(++number_, 2, 10, QLatin1Char('0')).arg(name);
    saved_ = widget.grab().save(QDir(request_.folder).filePath(file)) && saved_;
  }

  TourRequest request_;
  int number_ = 0;
  bool saved_ = true;
  gui::Workbench workbench_{gui::model_engine()};
  gui::WindowHost host_{workbench_};
};

}  // namespace

bool take_tour(const TourRequest& request) {
  QDir().mkpath(request.folder);
  gui::speak(request.language, false);
  if (request.dark) QApplication::setPalette(dark_palette());
  return Tour(request).take();
}

}  // namespace remount::testing
