// What the window says follows the state of the work, and nothing of it is cut.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeView>

#include "app/gui/workbench/steps.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/quality/quality_view.h"
#include "widgets/result/export_dialog.h"
#include "widgets/result/result_panel.h"
#include "widgets/sessions/sessions_panel.h"
#include "widgets/shell/message_banner.h"
#include "widgets/shell/progress_strip.h"
#include "widgets/shell/welcome_panel.h"

namespace remount::widgets {
namespace {

using testing::kPatience_ms;

class window_state : public testing::WindowFixture {
 protected:
  explicit window_state(int stages = 10) : WindowFixture(stages) {}

  QString strip() { return texts_of(child<ProgressStrip>()); }
  /// Scans that are read for the view are announced there, too.
  bool strip_becomes(const QString& text) {
    return QTest::qWaitFor([&] { return strip() == text; }, kPatience_ms);
  }
  QString result() { return texts_of(child<ResultPanel>()); }
  StepInfo step(Step which) { return gui::describe_steps(workbench_)[static_cast<std::size_t>(which)]; }
};

TEST_F(window_state, a_result_that_is_out_of_date_is_nowhere_shown_as_solved_or_ready) {
  show();
  calibrate_drive();
  EXPECT_TRUE(result().contains("Solved") && !result().contains("Out of date")) << result().toStdString();
  EXPECT_TRUE(strip_becomes("Ready")) << strip().toStdString();
  workbench_.setup().edit_option("registration", "voxel_m", 0.5);
  EXPECT_TRUE(result().contains("Out of date")) << result().toStdString();
  EXPECT_TRUE(strip().contains("out of date")) << strip().toStdString();
  for (const Step which : {Step::Pairs, Step::Align, Step::Solve, Step::Check, Step::Export})
    EXPECT_EQ(step(which).state, StepState::Attention) << static_cast<int>(which);
  workbench_.selection().select(motion::PairIndex{7});
  // The scans of the pair are read, and the strip says so.
  EXPECT_TRUE(QTest::qWaitFor([&] { return strip().contains("out of date"); }, kPatience_ms)) << strip().toStdString();
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(result().contains("Out of date")) << result().toStdString();
  EXPECT_TRUE(strip_becomes("Ready")) << strip().toStdString();
  EXPECT_NE(step(Step::Export).state, StepState::Attention);
}

TEST_F(window_state, a_result_is_checked_when_the_user_says_so_and_what_speaks_against_it_is_said) {
  show();
  auto& confirm = *child<QualityView>().findChild<QCheckBox*>();
  EXPECT_FALSE(confirm.isEnabled()) << "there is nothing to confirm";
  calibrate_drive();
  trigger("Ctrl+Shift+B");
  ASSERT_TRUE(QTest::qWaitFor([&] { return child<QualityView>().seen() && confirm.isEnabled(); }, kPatience_ms));
  EXPECT_EQ(step(Step::Check).state, StepState::Next) << "a page that was open has convinced nobody yet";
  QTest::keyClick(&confirm, Qt::Key_Space);
  EXPECT_EQ(step(Step::Check).state, StepState::Done);
  EXPECT_EQ(step(Step::Check).detail, "confirmed by you");
  workbench_.decisions().decide({motion::PairIndex{5}}, motion::PairState::Rejected);
  EXPECT_TRUE(QTest::qWaitFor([&] { return step(Step::Check).state == StepState::Next; }, kPatience_ms))
      << "another result is to be confirmed again";
  ASSERT_TRUE(settle());
  EXPECT_FALSE(confirm.isChecked());
  pipeline::PipelineOutput output = *workbench_.outcome().output();
  output.result.session_disagreement = 1.05 * calibration::kSessionsContradict;
  project::Project project;
  project.basis.session_count = 1;
  workbench_.document().restore(workbench_.sessions().all(), project,
                                std::make_shared<const pipeline::PipelineOutput>(output));
  workbench_.outcome().confirm(true);
  EXPECT_EQ(step(Step::Check).detail, "sessions contradict");
  EXPECT_TRUE(confirm.isChecked());
  workbench_.session_edits().remove(motion::SessionIndex{0});
  EXPECT_FALSE(confirm.isChecked()) << "there is no result any more";
}

class slow_window_state : public window_state {
 protected:
  slow_window_state() : window_state(400) {}
};

TEST_F(slow_window_state, what_is_next_is_not_said_while_it_is_under_way) {
  show();
  EXPECT_TRUE(result().contains("Open the sessions")) << result().toStdString();
  window_.open_paths({"/data/drive1"});
  EXPECT_FALSE(result().contains("Open the sessions")) << result().toStdString();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(result().contains("F5")) << result().toStdString();
  workbench_.calibrations().calibrate();
  EXPECT_TRUE(result().contains("running") && !result().contains("F5")) << result().toStdString();
  ASSERT_TRUE(settle());
  workbench_.calibrations().calibrate();
  EXPECT_TRUE(result().contains("Result before")) << result().toStdString();
  EXPECT_FALSE(strip().contains("Ready")) << strip().toStdString();
  workbench_.cancel();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(result().contains("Result before")) << result().toStdString();
}

TEST_F(window_state, a_pair_without_a_usable_alignment_cannot_be_accepted_and_the_reason_is_said) {
  show();
  calibrate_drive();
  pipeline::PipelineOutput output = *workbench_.outcome().output();
  for (const std::size_t failed : {5U, 6U}) {
    output.pairs[failed].state = motion::PairState::Rejected;
    output.pairs[failed].registration.converged = true;
    output.pairs[failed].registration.failure = Message::verbatim("only 12% of the points overlap");
  }
  project::Project project;
  project.basis.session_count = 1;
  workbench_.document().restore(workbench_.sessions().all(), project,
                                std::make_shared<const pipeline::PipelineOutput>(output));
  workbench_.decisions().decide({motion::PairIndex{5}, motion::PairIndex{6}, motion::PairIndex{8}},
                                motion::PairState::Accepted);
  ASSERT_TRUE(settle());
  EXPECT_EQ(pair(5).state, motion::PairState::Rejected);
  EXPECT_EQ(pair(6).state, motion::PairState::Rejected);
  EXPECT_EQ(pair(8).decided_by, motion::DecidedBy::User) << "the others are decided all the same";
  const QString banner = texts_of(child<MessageBanner>());
  EXPECT_TRUE(banner.contains("pair 5") && banner.contains("pair 6") && banner.contains("12%")) << banner.toStdString();
}

TEST_F(window_state, notes_on_a_session_are_shown_whole) {
  show();
  window_.open_paths({"/data/drive1", "/data/drive-with-a-name-that-is-much-longer-than-the-list-is-wide"});
  ASSERT_TRUE(settle());
  QTest::qWait(50);
  auto& tree = *child<SessionsPanel>().findChild<QTreeView*>();
  int rows = 0;
  for (QModelIndex index = tree.model()->index(0, 0); index.isValid(); index = tree.indexBelow(index)) {
    const QRect drawn = tree.visualRect(index);
    const QRect needed = tree.fontMetrics().boundingRect(QRect(0, 0, drawn.width() - 6, 10000), Qt::TextWordWrap,
                                                         index.data().toString());
    EXPECT_GE(drawn.height(), needed.height()) << index.data().toString().toStdString();
    rows += needed.height() > 2 * tree.fontMetrics().lineSpacing();
  }
  EXPECT_GE(rows, 1) << "one of them must need more than two lines, or nothing was tried";
}

TEST_F(window_state, a_long_message_can_be_read_to_its_end) {
  show();
  auto& banner = child<MessageBanner>();
  for (const int lines : {1, 3, 40}) {
    banner.show_message(drive::Severity::Problem, "/data/x",
                        QString("It looks for: session.yaml, or another file.\n").repeated(lines));
    QTest::qWait(50);
    const QLabel* text = banner.findChild<QLabel*>();
    EXPECT_GE(text->height(), text->heightForWidth(text->width())) << lines << " lines";
    EXPECT_LT(banner.height(), 220) << lines << " lines: it is no more than a part of the window";
    EXPECT_TRUE(lines > 1 || banner.height() < 80) << banner.height();
  }
}

TEST_F(window_state, the_welcome_is_whole_under_a_long_message) {
  window_.resize(1280, 800);
  show();
  child<MessageBanner>().show_message(drive::Severity::Problem, "/data/x",
                                      QString("It looks for a file.\n").repeated(40));
  QTest::qWait(50);
  const QLabel* text = child<WelcomePanel>().findChild<QLabel*>();
  EXPECT_GE(text->height(), text->heightForWidth(text->width()));
  EXPECT_LE(window_.height(), 800);
}

TEST_F(window_state, names_of_formats_are_shown_on_one_line_each) {
  show();
  calibrate_drive();
  trigger("Ctrl+E");
  auto& list = *child<ExportDialog>().findChild<QListWidget*>();
  QTest::qWait(50);
  EXPECT_TRUE(texts_of(child<ExportDialog>()).contains("Not observed: z")) << "a file cannot leave it out";
  EXPECT_LE(list.sizeHintForColumn(0), list.viewport()->width());
  for (int row = 0; row < list.count(); ++row) {
    EXPECT_LT(list.visualItemRect(list.item(row)).height(), 2 * list.fontMetrics().lineSpacing());
    EXPECT_FALSE(list.item(row)->toolTip().isEmpty());
  }
  child<ExportDialog>().close();
}

TEST(export_dialog, a_reason_against_a_format_is_shown_and_cannot_be_saved_for_it) {
  ExportDialog dialog({{"good", "good", "there", "a"}, {"bad", "bad", "there", "b"}}, [](const QString& id) {
    return id == "good" ? ExportText{"X", {}} : ExportText{{}, "turned"};
  });
  const auto enabled = [&] {
    int count = 0;
    for (const QPushButton* button : dialog.findChildren<QPushButton*>()) count += button->isEnabled();
    return count;
  };
  EXPECT_EQ(dialog.current_text(), "X");
  EXPECT_EQ(enabled(), 3);
  dialog.choose("bad");
  EXPECT_TRUE(dialog.current_text().isEmpty());
  EXPECT_EQ(dialog.findChild<QPlainTextEdit*>()->toPlainText(), "turned");
  EXPECT_EQ(enabled(), 1) << "only Close";
  dialog.choose("good");
  EXPECT_EQ(enabled(), 3);
}

TEST_F(window_state, fits_into_1280_by_800_with_its_steps_whole) {
  window_.resize(1280, 800);
  show();
  calibrate_drive();
  workbench_.setup().edit_option("registration", "voxel_m", 0.5);  // its words are the longest
  QTest::qWait(50);
  EXPECT_LE(window_.width(), 1280);
  EXPECT_LE(window_.height(), 800);
  for (const QToolButton* button : child<StepBar>().findChildren<QToolButton*>())
    EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
}

TEST_F(window_state, the_layout_can_be_put_back) {
  show();
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) dock->close();
  window_.findChild<QDockWidget*>("errors")->setFloating(true);
  for (QAction* action : window_.findChildren<QAction*>())
    if (action->text().remove('&') == "Reset layout") action->trigger();
  QTest::qWait(50);
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
    EXPECT_FALSE(dock->isHidden()) << dock->objectName().toStdString();
    EXPECT_FALSE(dock->isFloating()) << dock->objectName().toStdString();
  }
  EXPECT_FALSE(window_.findChild<QDockWidget*>("pairs")->visibleRegion().isEmpty()) << "in front of its tabs";
}

}  // namespace
}  // namespace remount::widgets
