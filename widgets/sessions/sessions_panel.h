// Open sessions with what was found in them.
#pragma once

#include <QWidget>

class QAbstractItemModel;
class QMenu;
class QPushButton;
class QTreeView;

namespace remount {

class SessionListModel;

class SessionsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SessionsPanel(SessionListModel& model, QWidget* parent = nullptr);
  void set_open_menu(QMenu& menu);  ///< of what can be opened

 signals:
  void remove_requested(int session);
  void topics_requested(int session);  ///< of a bag

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void after_reset();
  void fit_height();
  void update_buttons();
  int session_with_topics() const;  ///< the current one; -1 where its format has none
  SessionListModel& model_;
  QTreeView* tree_;
  QPushButton *open_, *remove_, *topics_;
};

}  // namespace remount
