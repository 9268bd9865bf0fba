// Open sessions with what was found in them.
#pragma once

#include <QWidget>

class QAbstractItemModel;
class QPushButton;
class QTreeView;

namespace remount {

class SessionListModel;

class SessionsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SessionsPanel(SessionListModel& model, QWidget* parent = nullptr);

 signals:
  void open_requested();
  void remove_requested(int session);

 private:
  void after_reset();
  SessionListModel& model_;
  QTreeView* tree_;
  QPushButton* remove_;
};

}  // namespace remount
