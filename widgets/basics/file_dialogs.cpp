#include "widgets/basics/file_dialogs.h"

#include <QDir>
#include <QFileInfo>
#include <QMap>
#include <QSettings>

#include "widgets/basics/remembering.h"

namespace remount::widgets {
namespace {

QString key_of(FileKind kind) { return QStringLiteral("folders/%1").arg(static_cast<int>(kind)); }

/// Of this run, also where nothing is remembered beyond it.
QMap<FileKind, QString>& folders() {
  static QMap<FileKind, QString> all;
  return all;
}

}  // namespace

QString usual_folder(FileKind kind) {
  QString folder = folders().value(kind);
  if (folder.isEmpty() && remembers()) folder = QSettings().value(key_of(kind)).toString();
  return QFileInfo(folder).isDir() ? folder : QString();  // it may be gone since
}

void remember_folder_of(const QString& path, FileKind kind) {
  if (path.isEmpty()) return;
  const QString folder = QFileInfo(path).absolutePath();
  folders()[kind] = folder;
  if (remembers()) QSettings().setValue(key_of(kind), folder);
}

QString ask_for_folder(QWidget* parent, const QString& title, FileKind kind) {
  const QString path = QFileDialog::getExistingDirectory(parent, title, usual_folder(kind));
  remember_folder_of(path, kind);
  return path;
}

QString ask_for_file(QWidget* parent, const QString& title, FileKind kind, const QString& filter) {
  const QString path = QFileDialog::getOpenFileName(parent, title, usual_folder(kind), filter);
  remember_folder_of(path, kind);
  return path;
}

QStringList ask_for_files(QWidget* parent, const QString& title, FileKind kind, const QString& filter) {
  const QStringList paths = QFileDialog::getOpenFileNames(parent, title, usual_folder(kind), filter);
  remember_folder_of(paths.value(0), kind);
  return paths;
}

QString ask_where_to_save(QWidget* parent, const QString& title, FileKind kind, const QString& suggested,
                          const QString& filter, QFileDialog::Options options) {
  const QString folder = usual_folder(kind);
  const bool in_folder = QFileInfo(suggested).isRelative() && !folder.isEmpty();
  const QString path = QFileDialog::getSaveFileName(
      parent, title, in_folder ? QDir(folder).filePath(suggested) : suggested, filter, nullptr, options);
  remember_folder_of(path, kind);
  return path;
}

}  // namespace remount::widgets
