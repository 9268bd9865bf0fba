// One place from which folders, files and projects are opened.
#include <gtest/gtest.h>

#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>

#include "tests/widgets/support/window_fixture.h"
#include "widgets/sessions/sessions_panel.h"
#include "widgets/shell/step_bar.h"
#include "widgets/shell/welcome_panel.h"

namespace remount::widgets {
namespace {

class open_menu : public testing::WindowFixture {
 protected:
  static QPushButton* opens(const QWidget& panel) {
    for (auto* button : panel.findChildren<QPushButton*>())
      if (button->text() == "Open") return button;
    return nullptr;
  }
  QMenu* in_file_menu() {
    for (QAction* action : window_.menuBar()->actions().first()->menu()->actions())
      if (action->text() == "&Open") return action->menu();
    return nullptr;
  }
};

TEST_F(open_menu, stands_behind_every_button_that_opens) {
  show();
  QMenu* menu = in_file_menu();
  ASSERT_TRUE(menu);
  for (const QWidget* panel :
       {static_cast<QWidget*>(&child<SessionsPanel>()), static_cast<QWidget*>(&child<WelcomePanel>())}) {
    const QPushButton* button = opens(*panel);
    ASSERT_TRUE(button) << panel->metaObject()->className();
    EXPECT_EQ(button->menu(), menu);
  }
  QStringList entries, keys;
  for (const QAction* action : menu->actions()) {
    if (action->isSeparator()) continue;
    entries << QString(action->text()).remove('&');
    keys << action->shortcut().toString();
  }
  EXPECT_EQ(entries.join(", "), "Folder of a drive…, Log or bag file…, Import a table…, Project…");
  EXPECT_EQ(keys.join(", "), "Ctrl+O, Ctrl+Shift+O, Ctrl+I, Ctrl+P");
  EXPECT_FALSE(menu->isVisible());
  child<StepBar>().findChildren<QToolButton*>().first()->click();
  EXPECT_TRUE(menu->isVisible()) << "the first step asks the same";
  menu->close();
}

}  // namespace
}  // namespace remount::widgets
