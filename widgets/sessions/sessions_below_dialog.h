// Asks which of the sessions in a folder are to be opened together.
#pragma once

#include <QDialog>
#include <QStringList>

class QListWidget;
class QPushButton;

namespace remount::widgets {

class SessionsBelowDialog : public QDialog {
  Q_OBJECT
 public:
  SessionsBelowDialog(const QString& folder, const QStringList& paths, QWidget* parent = nullptr);
  QStringList chosen() const;  ///< paths

 private:
  void update_button();
  QListWidget* list_;
  QPushButton* open_ = nullptr;
  QStringList paths_;
};

}  // namespace remount::widgets
