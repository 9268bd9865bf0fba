// The window on small and on dark screens, and where it begins.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QTreeView>
#include <optional>

#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/screen_room.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/project/options_dialog.h"
#include "widgets/project/recovery_dialog.h"
#include "widgets/sessions/missing_sessions_dialog.h"
#include "widgets/sessions/sessions_below_dialog.h"
#include "widgets/sessions/sessions_panel.h"
#include "widgets/shell/help_window.h"
#include "widgets/shell/message_banner.h"
#include "widgets/shell/progress_strip.h"
#include "widgets/shell/welcome_panel.h"
#include "widgets/text/readable.h"

namespace remount::widgets {
namespace {

class small_screen : public testing::WindowFixture {
 protected:
  void expect_fits(const char* when) {
    QTest::qWait(50);
    // 1600 by 1000 pixels at a scale of two, without the window's frame.
    const QSize room(790, 460);
    const QSize least = window_.minimumSizeHint();
    EXPECT_LE(least.width(), room.width()) << when;
    EXPECT_LE(least.height(), room.height()) << when;
    window_.resize(room);
    QTest::qWait(50);
    EXPECT_LE(window_.width(), room.width()) << when;
    EXPECT_LE(window_.height(), room.height()) << when;
    const auto& strip = child<ProgressStrip>();
    EXPECT_LE(strip.mapTo(&window_, QPoint(0, strip.height())).y(), room.height()) << when << ": the status is seen";
  }
};

TEST_F(small_screen, holds_the_whole_window_with_and_without_work_and_under_a_message) {
  show();
  expect_fits("empty");
  child<MessageBanner>().show_message(drive::Severity::Problem, "/data/x",
                                      QString("It looks for a file.\n").repeated(40));
  expect_fits("under a long message");
  calibrate_drive();
  expect_fits("with a result");
  child<MessageBanner>().show_message(drive::Severity::Problem, "/data/" + QString("x").repeated(300), "is no session");
  workbench_.notices().say(drive::Severity::Note, "/data/" + QString("x").repeated(300), "saved");
  expect_fits("with long paths");
  photograph(window_, "40-small");
}

/// Findings below the sessions would make the list as long as it may be.
gui::Engine engine_without_findings(std::shared_ptr<const std::atomic<int>> hold_at) {
  gui::Engine engine = testing::sample_engine(10, std::move(hold_at));
  engine.open = [open = engine.open](const std::filesystem::path& path, const drive::TopicChoice& choice,
                                     Progress& progress) {
    drive::Session session = open(path, choice, progress);
    session.findings.clear();
    return session;
  };
  return engine;
}

class session_list : public testing::WindowFixture {
 protected:
  session_list() : WindowFixture(&engine_without_findings) {}
};

TEST_F(session_list, shows_four_sessions_without_scrolling) {
  window_.resize(1280, 900);
  show();
  window_.open_paths({"/data/drive1", "/data/drive2", "/data/drive3", "/data/drive4"});
  ASSERT_TRUE(settle());
  QTest::qWait(100);
  auto& tree = *child<SessionsPanel>().findChild<QTreeView*>();
  const QRect last = tree.visualRect(tree.model()->index(3, 0));
  ASSERT_TRUE(last.isValid());
  EXPECT_TRUE(tree.viewport()->rect().contains(last)) << last.bottom() << " of " << tree.viewport()->height();
  photograph(window_, "41-four-sessions");
}

TEST_F(small_screen, begins_with_what_was_opened_lately) {
  show();
  auto& welcome = child<WelcomePanel>();
  welcome.show_recent({"/data/drive1", "/data/job.remount"}, {"drive1 – /data", "job.remount – /data"});
  QSignalSpy asked(&welcome, &WelcomePanel::recent_requested);
  QPushButton* project = nullptr;
  for (auto* button : welcome.findChildren<QPushButton*>())
    if (button->toolTip() == "/data/job.remount") project = button;
  ASSERT_TRUE(project);
  EXPECT_TRUE(project->text().contains("job.remount"));
  photograph(window_, "42-recent");
  project->click();
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked.at(0).at(0).toString(), "/data/job.remount");
  ASSERT_TRUE(settle()) << "there is no such project";
  window_.open_paths({"/data/drive3"});
  ASSERT_TRUE(settle());
  workbench_.session_edits().remove(motion::SessionIndex{0});
  bool offered = false;
  for (const auto* button : welcome.findChildren<QPushButton*>()) offered |= button->toolTip() == "/data/drive3";
  EXPECT_TRUE(offered) << "the list follows";
}

TEST_F(small_screen, nothing_opens_larger_than_it) {
  const QSize room = window_.screen()->availableSize();
  const QSize fitting = within_screen(window_, {5000, 5000});
  EXPECT_LT(fitting.width(), room.width());
  EXPECT_LT(fitting.height(), room.height());
  EXPECT_EQ(within_screen(window_, {300, 200}), QSize(300, 200));
}

TEST_F(small_screen, dialogs_can_be_as_small_as_it_is) {
  const QStringList many(40, "/data/a/folder/whose/name/is/long/2026-11-22-drive");
  const std::vector<RecoveryEntry> work(8, RecoveryEntry{"calibration", "four sessions", {"now", "before"}});
  SessionsBelowDialog sessions("/data/day", many, &window_);
  MissingSessionsDialog missing("/data/job.remount", many, &window_);
  RecoveryDialog recovery(work, &window_);
  OptionsDialog options(workbench_.setup().settings(), &window_);
  for (QDialog* dialog : std::initializer_list<QDialog*>{&sessions, &missing, &recovery, &options}) {
    const QSize least = dialog->minimumSizeHint();
    EXPECT_LE(least.width(), 790) << dialog->metaObject()->className();
    EXPECT_LE(least.height(), 460) << dialog->metaObject()->className();
  }
}

TEST(readable, mixtures_are_as_faint_as_they_may_be) {
  EXPECT_NEAR(contrast(Qt::black, Qt::white), 21.0, 1e-9);
  EXPECT_NEAR(contrast(QColor(119, 119, 119), Qt::white), 4.48, 0.01);
  const QColor faint = faint_but_readable(Qt::white, QColor(27, 30, 32), 4.5);
  EXPECT_GE(contrast(faint, QColor(27, 30, 32)), 4.5);
  EXPECT_LT(contrast(faint, QColor(27, 30, 32)), 8.0);
}

TEST_F(small_screen, placeholders_and_empty_boxes_can_be_seen_on_a_dark_palette) {
  QPalette dark(QColor(49, 54, 59), QColor(42, 46, 50));
  dark.setColor(QPalette::Base, QColor(27, 30, 32));
  dark.setColor(QPalette::Text, QColor(252, 252, 252));
  dark.setColor(QPalette::PlaceholderText, QColor(60, 64, 68));
  std::optional<testing::PaletteFor> turned(dark);
  show();
  calibrate_drive();
  trigger("Ctrl+Shift+B");
  HelpWindow pages(":/help/en");
  for (const QLineEdit* line : {child<PairsPanel>().findChild<QLineEdit*>(), pages.findChild<QLineEdit*>()}) {
    const QPalette now = line->palette();
    EXPECT_GE(contrast(now.color(QPalette::PlaceholderText), now.color(QPalette::Base)), 4.5);
    EXPECT_EQ(now.color(QPalette::Base), dark.color(QPalette::Base)) << "the rest follows the application";
  }
  QCheckBox box;
  keep_box_visible(box);
  const QImage picture = box.grab().toImage();
  double strongest = 1.0;
  for (int x = 0; x < picture.width(); ++x)
    strongest =
        std::max(strongest, contrast(picture.pixelColor(x, picture.height() / 2), dark.color(QPalette::Window)));
  EXPECT_GE(strongest, 3.0) << "the edge of an empty box";
  photograph(window_, "43-dark-quality");
  turned.reset();
  const QPalette now = child<PairsPanel>().findChild<QLineEdit*>()->palette();
  EXPECT_GE(contrast(now.color(QPalette::PlaceholderText), now.color(QPalette::Base)), 4.5);
}

}  // namespace
}  // namespace remount::widgets
