// F1 opens the page of the panel that has the focus; both languages have the same pages.
#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QTableView>
#include <QTextBrowser>

#include "app/gui/basics/language.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/map/map_view.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/result/result_panel.h"
#include "widgets/shell/help_window.h"

namespace remount::widgets {
namespace {

using help = testing::WindowFixture;

TEST(help_pages, are_the_same_in_every_language) {
  gui::speak("en", false);
  const QStringList english = QDir(":/help/en").entryList(QDir::Files);
  EXPECT_GT(english.size(), 8);
  for (const gui::SpokenLanguage& language : gui::languages()) {
    const QDir folder(":/help/" + language.code);
    EXPECT_EQ(folder.entryList(QDir::Files), english) << language.code.toStdString();
    HelpWindow window(folder.path());
    for (const QString& page : window.listed_pages()) {
      window.show_page(page);
      EXPECT_EQ(window.current_page(), page);
      const QString text = window.findChild<QTextBrowser*>()->toPlainText(), title = text.section('\n', 0, 0);
      EXPECT_FALSE(title.isEmpty());
      EXPECT_GT(text.size() - title.size(), 40) << page.toStdString() << " says no more than its title";
    }
  }
}

TEST(help_pages, are_found_by_their_text) {
  gui::speak("en", false);
  HelpWindow window(":/help/en");
  const qsizetype all = window.listed_pages().size();
  window.findChild<QLineEdit*>()->setText("quaternions");
  EXPECT_EQ(window.listed_pages(), QStringList{"axes"});
  window.findChild<QLineEdit*>()->clear();
  EXPECT_EQ(window.listed_pages().size(), all);
}

TEST_F(help, f1_opens_the_page_of_the_panel) {
  gui::speak("en", false);
  show();
  trigger("F1");
  auto& opened = child<HelpWindow>();
  EXPECT_EQ(opened.current_page(), "start") << "an empty window begins at the beginning";
  opened.close();
  calibrate_drive();
  window_.activateWindow();
  child<PairsPanel>().table()->setFocus();
  if (!QTest::qWaitFor([&] { return QApplication::focusWidget() == child<PairsPanel>().table(); }, 2000))
    GTEST_SKIP() << "the window cannot have the focus here";
  trigger("F1");
  EXPECT_EQ(opened.current_page(), "pairs");
  opened.close();
  window_.activateWindow();
  child<PairsPanel>().table()->clearFocus();
  if (QWidget* other = QApplication::focusWidget()) other->clearFocus();
  auto& result = child<ResultPanel>();
  QCursor::setPos(result.mapToGlobal(result.rect().center()));
  ASSERT_TRUE(QTest::qWaitFor([&] { return result.isAncestorOf(QApplication::widgetAt(QCursor::pos())); }, 2000));
  trigger("F1");
  EXPECT_EQ(opened.current_page(), "result") << "no panel has the keyboard: the one under the pointer";
  auto& map = child<MapView>("map");
  EXPECT_EQ(window_.help_page_of(&map), "map");
  for (const auto* dock : window_.findChildren<QDockWidget*>())
    EXPECT_TRUE(opened.listed_pages().contains(window_.help_page_of(dock)) && window_.help_page_of(dock) != "projects")
        << dock->objectName().toStdString() << " has no page of its own";
  opened.show_page("axes");
  photograph(opened, "17-help");
}

}  // namespace
}  // namespace remount::widgets
