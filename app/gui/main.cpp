// remount [SESSION…]: the window.
#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

#include "app/gui/main_window.h"
#include "remount_version.h"
#include "widgets/gl_support.h"

int main(int argc, char** argv) {
  remount::prepare_gl();
  QApplication application(argc, argv);
  QApplication::setApplicationName("Remount");
  QApplication::setOrganizationName("Remount");
  QApplication::setApplicationVersion(remount::kVersion);
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QApplication::translate("main", "Finds where a LiDAR sits on a vehicle, relative to its GNSS/INS."));
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption sample("sample", QApplication::translate("main", "Open the bundled sample session."));
  parser.addOption(sample);
  parser.addPositionalArgument(
      "session", QApplication::translate("main", "Sessions (folders or files) or a project to open."), "[SESSION…]");
  parser.process(application);

  remount::Workbench workbench(remount::model_engine());
  remount::MainWindow window(workbench);
  window.show();
  const QStringList paths = parser.positionalArguments();
  QTimer::singleShot(0, &window, [&] {
    if (parser.isSet(sample)) window.open_sample();
    if (!paths.isEmpty()) window.open_paths(paths);
  });
  return QApplication::exec();
}
