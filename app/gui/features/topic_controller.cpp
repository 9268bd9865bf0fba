#include "app/gui/features/topic_controller.h"

#include "widgets/sessions/topics_dialog.h"

namespace remount::gui {

TopicController::TopicController(Workbench& workbench, QWidget& window)
    : QObject(&window), workbench_(workbench), window_(window) {
  connect(&workbench_.sessions(), &SessionList::topics_asked, this,
          [this](const std::vector<drive::TopicOffer>& offers) { ask(offers, {}); });
  connect(&workbench_.session_edits(), &SessionEdits::topics_listed, this, &TopicController::ask_again);
}

void TopicController::ask(std::vector<drive::TopicOffer> offers, std::vector<ChosenOffer> answered) {
  if (offers.empty()) {
    if (!answered.empty()) workbench_.sessions().open_chosen(answered);
    return;
  }
  const drive::TopicOffer offer = offers.front();
  offers.erase(offers.begin());
  auto* dialog =
      new widgets::TopicsDialog(QString::fromStdString(offer.path.filename().string()), offer.topics, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::finished, this, [this, dialog, offer, offers, answered](int answer) {
    std::vector<ChosenOffer> all = answered;
    if (answer == QDialog::Accepted)
      all.push_back({offer, dialog->choice()});
    else
      workbench_.notices().say(drive::Severity::Note, QString::fromStdString(offer.path.string()),
                               tr("was not opened"));
    ask(offers, all);
  });
  dialog->open();
}

void TopicController::ask_again(motion::SessionIndex session, const std::vector<drive::OfferedTopic>& topics) {
  const std::shared_ptr<const drive::Session> asked = workbench_.sessions().all().at(session);
  auto* dialog = new widgets::TopicsDialog(QString::fromStdString(asked->name), topics, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, session] {
    if (!workbench_.vehicle().show_chosen(session, dialog->choice()))
      workbench_.session_edits().choose_topics(session, dialog->choice());
  });
  dialog->open();
}

}  // namespace remount::gui
