#include "app/gui/basics/sample.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace remount::gui {

QString sample_path() {
  // In the build tree as well (app/CMakeLists.txt).
  const QString path = QDir(QCoreApplication::applicationDirPath()).filePath("../share/remount/sample");
  return QFileInfo(path).isDir() ? QDir(path).canonicalPath() : QString();
}

}  // namespace remount::gui
