#include "app/gui/basics/sample.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace remount::gui {

QString sample_path() {
  const QDir beside(QCoreApplication::applicationDirPath());
  for (const QString& path : {beside.filePath("../share/remount/sample"), QStringLiteral(REMOUNT_SOURCE_SAMPLE)})
    if (QFileInfo(path).isDir()) return QDir(path).canonicalPath();
  return {};
}

}  // namespace remount::gui
