// remount [SESSION…]: the window.
#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QStandardPaths>
#include <QTimer>
#include <iostream>
#include <string_view>

#include "app/gui/basics/language.h"
#include "app/gui/features/project_feature.h"
#include "app/gui/window_host.h"
#include "remount_version.h"
#include "widgets/basics/gl_support.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/toolkits.h"

namespace {

/// Qt ends the program with a core dump where it finds no display; a sentence is kinder.
bool display_is_missing(int argc, char** argv) {
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
  for (int i = 1; i < argc; ++i)
    if (std::string_view(argv[i]) == "-platform") return false;
  return qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
         qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
#else
  return argc < 0 || !argv;
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (display_is_missing(argc, argv)) {
    std::cerr << "remount: there is no display to open the window on. Set DISPLAY, or use remount-cli.\n";
    return 1;
  }
  remount::widgets::prepare_gl();
  remount::widgets::prepare_theme();
  QApplication application(argc, argv);
  QApplication::setApplicationName("Remount");
  QApplication::setOrganizationName("Remount");
  QApplication::setApplicationVersion(remount::kVersion);
  // By these the desktop knows whose window it is.
  QApplication::setDesktopFileName("remount");
  QApplication::setWindowIcon(QIcon::fromTheme("remount"));
  remount::gui::speak(remount::gui::preferred_language(), false);
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QApplication::translate("main", "Finds where a LiDAR sits on a vehicle, relative to its GNSS/INS."));
  parser.addHelpOption();
  const QCommandLineOption version = parser.addVersionOption();
  const QCommandLineOption sample("sample", QApplication::translate("main", "Open the bundled sample session."));
  parser.addOption(sample);
  parser.addPositionalArgument(
      "session", QApplication::translate("main", "Sessions (folders or files) or a project to open."), "[SESSION…]");
  if (parser.parse(QApplication::arguments()) && parser.isSet(version)) {
    std::cout << "Remount " << remount::kVersion << "\n" << remount::widgets::toolkit_versions().toStdString() << "\n";
    return 0;
  }
  parser.process(application);

  remount::gui::Workbench workbench(remount::gui::model_engine());
  remount::gui::WindowHost host(workbench);
  host.window().show();
  host.window().feature<remount::gui::ProjectFeature>()->keep_work_in(
      QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
  const QStringList paths = parser.positionalArguments();
  QTimer::singleShot(0, &host, [&] {
    if (parser.isSet(sample)) host.window().feature<remount::gui::ProjectFeature>()->open_sample();
    if (!paths.isEmpty()) host.window().open_paths(paths);
  });
  return QApplication::exec();
}
