// Asks which topics of a bag are meant: before it is opened, where that is not clear, and afterwards.
#pragma once

#include <QObject>

#include "app/gui/workbench/workbench.h"

class QWidget;

namespace remount::gui {

class TopicController : public QObject {
  Q_OBJECT
 public:
  TopicController(Workbench& workbench, QWidget& window);

 private:
  /// Of a session that is open.
  void ask_again(motion::SessionIndex session, const std::vector<drive::OfferedTopic>& topics);
  /// One after the other; those that were answered are opened together.
  void ask(std::vector<drive::TopicOffer> offers, std::vector<ChosenOffer> answered);

  Workbench& workbench_;
  QWidget& window_;
};

}  // namespace remount::gui
