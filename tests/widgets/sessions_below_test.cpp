// A folder of sessions: the window asks which of them are meant.
#include <QListWidget>
#include <QPushButton>

#include "model/formats/sessions/several_sessions.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/sessions/sessions_below_dialog.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;
using testing::WindowFixture;

/// "/data/day" holds three sessions, "/data/week" two; other paths are drives.
gui::Engine day_engine(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = testing::sample_engine(10, std::move(hold_at));
  engine.open = [drive = engine.open](const std::filesystem::path& path, const drive::TopicChoice& choice,
                                      Progress& progress) {
    if (path == "/data/day")
      throw formats::SeveralSessions(path, Message::verbatim("is no session itself"),
                                     {"/data/day/drive1", "/data/day/drive2", "/data/day/drive3"});
    if (path == "/data/week")
      throw formats::SeveralSessions(path, Message::verbatim("is no session itself"),
                                     {"/data/week/drive4", "/data/week/drive5"});
    return drive(path, choice, progress);
  };
  return engine;
}

class sessions_below : public WindowFixture {
 protected:
  sessions_below() : WindowFixture(&day_engine) {}
  void SetUp() override {
    show();
    window_.open_paths({"/data/day"});
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_.findChild<SessionsBelowDialog*>() != nullptr; }, kPatience_ms));
    dialog_ = window_.findChild<SessionsBelowDialog*>();
  }
  QListWidget& list() { return *dialog_->findChild<QListWidget*>(); }
  QPushButton& open_button() {
    for (QPushButton* button : dialog_->findChildren<QPushButton*>())
      if (button->isDefault()) return *button;
    throw std::logic_error("no button is the default");
  }
  SessionsBelowDialog* dialog_ = nullptr;
};

TEST_F(sessions_below, enter_opens_all_of_them) {
  ASSERT_EQ(list().count(), 3);
  photograph(*dialog_, "sessions-below");
  QTest::keyClick(dialog_, Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.sessions().all().size() == 3; }, kPatience_ms))
      << workbench_.sessions().all().size();
}

TEST_F(sessions_below, only_those_that_are_ticked_are_opened) {
  list().item(1)->setCheckState(Qt::Unchecked);
  open_button().click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.sessions().all().size() == 2; }, kPatience_ms));
  EXPECT_EQ(workbench_.sessions().all().at(0)->name, "drive1");
  EXPECT_EQ(workbench_.sessions().all().at(1)->name, "drive3");
}

TEST_F(sessions_below, answers_to_two_questions_are_both_taken) {
  window_.open_paths({"/data/week"});
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_.findChildren<SessionsBelowDialog*>().size() == 2; }, kPatience_ms));
  for (SessionsBelowDialog* dialog : window_.findChildren<SessionsBelowDialog*>()) dialog->accept();
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.sessions().all().size() == 5; }, kPatience_ms))
      << workbench_.sessions().all().size();
}

TEST_F(sessions_below, none_is_no_answer_and_escape_opens_nothing) {
  for (int i = 0; i < 3; ++i) list().item(i)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(open_button().isEnabled());
  QTest::keyClick(dialog_, Qt::Key_Escape);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.sessions().all().empty());
}

}  // namespace
}  // namespace remount::widgets
