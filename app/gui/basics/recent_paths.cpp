#include "app/gui/basics/recent_paths.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include "widgets/basics/remembering.h"

namespace remount::gui {
namespace {
const QString kPathsKey = QStringLiteral("recent/paths");
}  // namespace

RecentPaths::RecentPaths() {
  if (widgets::remembers()) paths_ = QSettings().value(kPathsKey).toStringList();
  while (paths_.size() > kMost) paths_.removeLast();
}

void RecentPaths::add(const QString& path) {
  const QString whole = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
  paths_.removeAll(whole);
  paths_.prepend(whole);
  while (paths_.size() > kMost) paths_.removeLast();
  keep();
}

void RecentPaths::clear() {
  paths_.clear();
  keep();
}

void RecentPaths::keep() const {
  if (widgets::remembers()) QSettings().setValue(kPathsKey, paths_);
}

QStringList RecentPaths::labels() const {
  QStringList labels;
  for (const QString& path : paths_) {
    const QFileInfo file(path);
    labels << QStringLiteral("%1  –  %2").arg(file.fileName(), QDir::toNativeSeparators(file.path()));
  }
  return labels;
}

}  // namespace remount::gui
