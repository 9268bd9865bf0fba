// Another language in the midst of work.
#include "app/gui/window_host.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "app/gui/basics/language.h"
#include "app/gui/document/report_maker.h"
#include "tests/support/draws.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/shell/log_panel.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

class window_host : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto settle = [&] {
      return QTest::qWaitFor([&] { return !workbench_.activity().opening() && !workbench_.activity().calibrating(); },
                             kPatience_ms);
    };
    host_.window().open_paths({"/data/drive1"});
    ASSERT_TRUE(settle());
    workbench_.calibrations().calibrate();
    ASSERT_TRUE(settle());
    ASSERT_TRUE(workbench_.outcome().output());
  }
  void TearDown() override { gui::speak("en", false); }
  gui::ReportMaker& report() { return *host_.window().findChild<gui::ReportMaker*>(); }
  QString log() { return host_.window().findChild<LogPanel*>()->toPlainText(); }

  QTemporaryDir folder_;
  const QString html_ = folder_.filePath("drive.html"), pdf_ = folder_.filePath("drive.pdf");
  gui::Workbench workbench_{testing::sample_engine()};
  gui::WindowHost host_{workbench_};
  QSignalSpy changed_{&host_, &gui::WindowHost::window_changed};
};

TEST_F(window_host, a_report_is_finished_before_the_language_changes) {
  report().make(html_);
  ASSERT_TRUE(report().busy());
  host_.change_language("zh_CN");
  EXPECT_EQ(gui::spoken_language(), "en");
  EXPECT_EQ(changed_.count(), 0);
  EXPECT_TRUE(log().contains("as soon as the report is written")) << log().toStdString();
  ASSERT_TRUE(QTest::qWaitFor([&] { return changed_.count() > 0; }, kPatience_ms));
  EXPECT_EQ(gui::spoken_language(), "zh_CN");
  EXPECT_TRUE(log().contains("report saved")) << log().toStdString();
  EXPECT_TRUE(QFile::exists(pdf_));
  QFile page(html_);
  ASSERT_TRUE(page.open(QIODevice::ReadOnly));
  EXPECT_TRUE(page.readAll().contains("Residuals of the pairs")) << "in the language in which it was begun";
  EXPECT_FALSE(report().busy());
}

TEST_F(window_host, a_report_that_fails_lets_the_language_change_too) {
  ONLY_IN_LONG_TESTS();
  report().make("/nowhere/at/all/drive.html");
  host_.change_language("zh_CN");
  EXPECT_TRUE(QTest::qWaitFor([&] { return changed_.count() > 0; }, kPatience_ms));
  EXPECT_EQ(gui::spoken_language(), "zh_CN");
}

TEST_F(window_host, the_last_wish_counts) {
  QSignalSpy finished(&report(), &gui::ReportMaker::finished);
  report().make(html_);
  host_.change_language("zh_CN");
  host_.change_language("en");
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() > 0; }, kPatience_ms));
  QTest::qWait(50);
  EXPECT_EQ(changed_.count(), 0);
  EXPECT_EQ(gui::spoken_language(), "en");
}

}  // namespace
}  // namespace remount::widgets
