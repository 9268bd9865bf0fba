// Dialogs for files, which begin where files of their kind were chosen last.
#pragma once

#include <QFileDialog>

namespace remount::widgets {

enum class FileKind { Recordings, Projects, Mountings, Results, Reports, Exports, Pictures };

/// Nothing where the user cancels, as of the dialogs of Qt. The folder of what is chosen is remembered for its kind.
QString ask_for_folder(QWidget* parent, const QString& title, FileKind kind);
QString ask_for_file(QWidget* parent, const QString& title, FileKind kind, const QString& filter = {});
QStringList ask_for_files(QWidget* parent, const QString& title, FileKind kind, const QString& filter = {});

/// @param suggested a name, in the folder that is remembered, or a whole path
QString ask_where_to_save(QWidget* parent, const QString& title, FileKind kind, const QString& suggested,
                          const QString& filter = {}, QFileDialog::Options options = {});

/// Where such a dialog begins; empty where nothing was chosen yet.
QString usual_folder(FileKind kind);
void remember_folder_of(const QString& path, FileKind kind);

}  // namespace remount::widgets
