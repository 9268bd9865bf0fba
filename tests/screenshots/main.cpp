// Pictures of the window at work on the bundled sample, for README: made by packaging/screenshots, never by hand.
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QSignalSpy>
#include <QTest>
#include <cstdio>

#include "app/gui/language.h"
#include "app/gui/window_host.h"
#include "widgets/gl_support.h"
#include "widgets/panels/export_dialog.h"

namespace remount {
namespace {

constexpr int kPatience_ms = 300000;

class Photographer {
 public:
  explicit Photographer(const QString& folder) : folder_(folder) {}

  bool take_all() {
    speak("en", false);
    MainWindow& window = host_.window();
    window.resize(1440, 900);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window, kPatience_ms)) return false;
    save(window, "1-start");
    QSignalSpy loaded(&workbench_, &Workbench::clouds_loaded);
    window.open_sample();
    if (!settled() || workbench_.sessions().empty()) return false;
    workbench_.calibrate();
    if (!settled() || !workbench_.output()) return false;
    if (!QTest::qWaitFor([&] { return loaded.count() > 0; }, kPatience_ms)) return false;
    save(window, "2-result");
    for (QAction* action : window.findChildren<QAction*>())
      if (action->shortcut() == QKeySequence("Ctrl+E")) action->trigger();
    auto* dialog = window.findChild<ExportDialog*>();
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
    return QTest::qWaitFor([&] { return !workbench_.opening() && !workbench_.calibrating() && !workbench_.solving(); },
                           kPatience_ms);
  }
  void save(QWidget& widget, const QString& name) {
    QTest::qWait(1500);  // what is drawn late is drawn by then
    saved_ = widget.grab().save(QDir(folder_).filePath(name + ".png")) && saved_;
  }

  QString folder_;
  bool saved_ = true;
  Workbench workbench_{model_engine()};
  WindowHost host_{workbench_};
};

}  // namespace
}  // namespace remount

int main(int argc, char** argv) {
  remount::prepare_gl();
  QApplication application(argc, argv);
  if (argc != 2) {
    std::fputs("usage: remount_screenshots FOLDER\n", stderr);
    return 1;
  }
  return remount::Photographer(QString::fromLocal8Bit(argv[1])).take_all() ? 0 : 2;
}
