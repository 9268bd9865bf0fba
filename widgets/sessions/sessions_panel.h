// Open sessions with what was found in them.
#pragma once

#include <QWidget>
#include <optional>

#include "algorithms/motion/pair.h"

class QAbstractItemModel;
class QMenu;
class QPushButton;
class QTreeView;

namespace remount::widgets {

class SessionListModel;

class SessionsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SessionsPanel(SessionListModel& model, QWidget* parent = nullptr);
  void set_open_menu(QMenu& menu);  ///< of what can be opened

 signals:
  void remove_requested(motion::SessionIndex session);
  void topics_requested(motion::SessionIndex session);  ///< of a bag

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void after_reset();
  void fit_height();
  void update_buttons();
  std::optional<motion::SessionIndex> session_with_topics()
      const;  ///< the current one; nothing where its format has none
  SessionListModel& model_;
  QTreeView* tree_;
  QPushButton *open_, *remove_, *topics_;
};

}  // namespace remount::widgets
