// Pictures of the window at work on the bundled sample, for README: made by packaging/screenshots, never by hand.
#include <QAction>
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QSignalSpy>
#include <QTest>

#include "app/gui/basics/language.h"
#include "app/gui/features/project_feature.h"
#include "app/gui/window_host.h"
#include "tests/screenshots/imports.h"
#include "tests/screenshots/tour.h"
#include "widgets/basics/gl_support.h"
#include "widgets/basics/theme.h"
#include "widgets/result/export_dialog.h"

namespace remount::testing {
namespace {

constexpr int kPatience_ms = 300000;

class Photographer {
 public:
  explicit Photographer(const QString& folder) : folder_(folder) {}

  bool take_all() {
    gui::speak("en", false);
    gui::MainWindow& window = host_.window();
    window.resize(1440, 900);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window, kPatience_ms)) return false;
    save(window, "1-start");
    QSignalSpy loaded(&workbench_.pair_scenes(), &gui::PairScenes::ready);
    window.feature<gui::ProjectFeature>()->open_sample();
    if (!settled() || workbench_.sessions().all().empty()) return false;
    workbench_.calibrations().calibrate();
    if (!settled() || !workbench_.outcome().output()) return false;
    if (!QTest::qWaitFor([&] { return loaded.count() > 0; }, kPatience_ms)) return false;
    save(window, "2-result");
    for (QAction* action : window.findChildren<QAction*>())
      if (action->shortcut() == QKeySequence("Ctrl+E")) action->trigger();
    auto* dialog = window.findChild<widgets::ExportDialog*>();
    if (!dialog) return false;
    dialog->choose("autoware");
    save(*dialog, "3-export");
    dialog->close();
    const auto before = loaded.count();
    host_.change_language("zh_CN");
    host_.window().resize(1440, 900);
    if (!QTest::qWaitFor([&] { return loaded.count() > before; }, kPatience_ms)) return false;
    save(host_.window(), "4-chinese");
    return saved_;
  }

 private:
  bool settled() {
    return QTest::qWaitFor(
        [&] {
          return !workbench_.activity().opening() && !workbench_.activity().calibrating() &&
                 !workbench_.activity().solving();
        },
        kPatience_ms);
  }
  void save(QWidget& widget, const QString& name) {
    QTest::qWait(1500);  // what is drawn late is drawn by then
    saved_ = widget.grab().save(QDir(folder_).filePath(name + ".png")) && saved_;
  }

  QString folder_;
  bool saved_ = true;
  gui::Workbench workbench_{gui::model_engine()};
  gui::WindowHost host_{workbench_};
};

}  // namespace
}  // namespace remount::testing

int main(int argc, char** argv) {
  remount::widgets::prepare_gl();
  remount::widgets::prepare_theme();
  QApplication application(argc, argv);
  QCommandLineParser parser;
  parser.addPositionalArgument("folder", "where the pictures go");
  parser.addPositionalArgument("sessions", "of the tour; the bundled sample where there are none", "[SESSION…]");
  const QCommandLineOption tour("tour", "every page and dialog, instead of README's pictures"), dark("dark", "dark"),
      language("language", "of the tour", "code", "en"), width("width", "of the window", "pixels", "1440"),
      height("height", "of the window", "pixels", "900");
  const QCommandLineOption imports("import", "the page that imports tables, of sessions that no reader knows");
  parser.addOptions({tour, imports, dark, language, width, height});
  parser.addHelpOption();
  parser.process(application);
  QStringList sessions = parser.positionalArguments();
  if (sessions.isEmpty()) parser.showHelp(1);
  const QString folder = sessions.takeFirst();
  if (!parser.isSet(tour) && !parser.isSet(imports)) return remount::testing::Photographer(folder).take_all() ? 0 : 2;
  remount::testing::TourRequest request{folder, sessions, parser.value(language), {}, parser.isSet(dark)};
  request.size = {parser.value(width).toInt(), parser.value(height).toInt()};
  const bool taken =
      parser.isSet(imports) ? remount::testing::take_imports(request) : remount::testing::take_tour(request);
  return taken ? 0 : 2;
}
