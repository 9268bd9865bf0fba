// Asks where the sessions of a project lie now.
#pragma once

#include <QDialog>
#include <QStringList>

class QPushButton;
class QTreeWidget;

namespace remount::widgets {

class MissingSessionsDialog : public QDialog {
  Q_OBJECT
 public:
  MissingSessionsDialog(const QString& project, const QStringList& missing, QWidget* parent = nullptr);
  void show_found(int row, const QString& path);
  QStringList found() const { return found_; }  ///< as many as are missing; empty where not found yet

 signals:
  void locate_requested(int row);
  void open_requested(bool without_missing);  ///< the dialog closes

 private:
  void update_buttons();
  QTreeWidget* list_;
  QPushButton *locate_ = nullptr, *open_ = nullptr, *without_ = nullptr;
  QStringList found_;
};

}  // namespace remount::widgets
