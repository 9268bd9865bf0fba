// The whole job in the window: open, calibrate, select, reject, undo, export.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <algorithm>

#include "algorithms/messages/render.h"
#include "app/gui/document/result_files.h"
#include "model/formats/documents/parse_document.h"
#include "tests/widgets/support/restored.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/gl_support.h"
#include "widgets/basics/theme.h"
#include "widgets/pairs/error_bar_chart.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/project/options_dialog.h"
#include "widgets/quality/obstacle_dialog.h"
#include "widgets/result/export_dialog.h"
#include "widgets/result/result_panel.h"
#include "widgets/shell/message_banner.h"

namespace remount::widgets {

using motion::PairIndex;

namespace {

settings::Settings load_result_settings(const QString& yaml) {
  const formats::DocumentNode document = formats::parse_yaml(yaml.toStdString(), "result.yaml");
  return results::result_from_document(formats::DocumentView(document, "result.yaml")).settings;
}

using testing::kPatience_ms;
using window_flow = testing::WindowFixture;

TEST_F(window_flow, rejecting_moves_the_result_and_undo_takes_it_back) {
  show();
  photograph(window_, "1-empty");
  calibrate_drive();
  const double before_m = x_m();
  const motion::PairState state_before = pair(5).state;
  workbench_.selection().select(PairIndex{5});
  trigger("R");
  EXPECT_EQ(pair(5).state, motion::PairState::Rejected);
  EXPECT_EQ(pair(5).decided_by, motion::DecidedBy::User);
  ASSERT_TRUE(settle());
  EXPECT_NEAR(x_m() - before_m, 0.001, 1e-9);
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(pair(5).state, state_before);
  EXPECT_EQ(pair(5).decided_by, motion::DecidedBy::Program);
  EXPECT_NEAR(x_m(), before_m, 1e-12);
}

TEST_F(window_flow, table_chart_and_keys_share_one_selection) {
  show();
  calibrate_drive();
  auto& pairs = child<PairsPanel>();
  emit child<ErrorBarChart>().pair_clicked(PairIndex{17});
  EXPECT_EQ(workbench_.selection().pair(), PairIndex{17});
  EXPECT_EQ(pairs.marked_pairs(), std::vector<PairIndex>{PairIndex{17}});
  pairs.table()->selectRow(9);
  EXPECT_EQ(workbench_.selection().pair(), PairIndex{9});
  trigger("N");
  EXPECT_EQ(workbench_.selection().pair(), PairIndex{10});
  trigger("P");
  EXPECT_EQ(workbench_.selection().pair(), PairIndex{9});
  trigger("A");
  ASSERT_TRUE(settle());
  pairs.table()->selectRow(8);
  trigger("U");
  EXPECT_EQ(workbench_.selection().pair(), PairIndex{10}) << "pair 9 has been decided by the user";
}

TEST_F(window_flow, letters_decide_pairs_but_not_while_text_is_typed) {
  if (!missing_gl_reason().isEmpty()) GTEST_SKIP() << "shortcuts need a window that can be active";
  show();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_, kPatience_ms));
  calibrate_drive();
  auto& pairs = child<PairsPanel>();
  pairs.table()->selectRow(6);
  QTest::keyClick(pairs.table(), Qt::Key_R);
  EXPECT_EQ(pair(6).decided_by, motion::DecidedBy::User);
  ASSERT_TRUE(settle());
  auto* filter = pairs.findChild<QLineEdit*>();
  filter->setFocus();
  pairs.table()->selectRow(8);
  QTest::keyClicks(filter, "ra");
  EXPECT_EQ(filter->text(), "ra");
  EXPECT_NE(pair(8).decided_by, motion::DecidedBy::User);
  filter->clear();
  auto& view = child<PairView>();
  const scene::PairAlignment before = view.alignment();
  pairs.table()->setFocus();
  QTest::keyClick(pairs.table(), Qt::Key_Space);
  EXPECT_NE(view.alignment(), before) << "Space flips in the table";
  auto* top = view.findChild<QToolButton*>("measure");
  ASSERT_TRUE(QTest::qWaitFor([&] { return top->isEnabled(); }, kPatience_ms)) << "once there is something to view";
  top->setFocus();
  const scene::PairAlignment flipped = view.alignment();
  QSignalSpy pressed(top, &QToolButton::clicked);
  QTest::keyClick(top, Qt::Key_Space);
  EXPECT_EQ(pressed.count(), 1) << "Space still presses a button";
  EXPECT_EQ(view.alignment(), flipped);
}

TEST_F(window_flow, several_marked_pairs_are_one_edit) {
  show();
  calibrate_drive();
  workbench_.decisions().decide({PairIndex{1}, PairIndex{2}, PairIndex{4}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  EXPECT_EQ(edits_since_calibration(), 1);
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  for (int index : {1, 2, 4}) EXPECT_NE(pair(index).decided_by, motion::DecidedBy::User) << "pair " << index;
}

TEST_F(window_flow, decisions_outlive_a_new_calibration) {
  show();
  calibrate_drive();
  workbench_.decisions().decide({PairIndex{5}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_EQ(pair(5).state, motion::PairState::Rejected);
  EXPECT_EQ(pair(5).decided_by, motion::DecidedBy::User);
}

TEST_F(window_flow, unreadable_input_is_explained_and_nothing_is_lost) {
  show();
  calibrate_drive();
  window_.open_paths({"/data/holiday-photos"});
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.sessions().all().size(), 1U);
  EXPECT_TRUE(workbench_.outcome().output());
  auto& banner = child<MessageBanner>();
  EXPECT_TRUE(banner.isVisible());
  const QString text = banner.findChild<QLabel*>()->text();
  EXPECT_TRUE(text.contains("/data/holiday-photos") && text.contains("a folder with session.yaml"))
      << text.toStdString();
  photograph(window_, "5-unreadable");
}

TEST_F(window_flow, a_change_of_the_search_range_solves_again_and_can_be_undone) {
  show();
  calibrate_drive();
  const gui::OutputPtr before = workbench_.outcome().output();
  workbench_.setup().edit_option("range", "x_max_m", 0.95);
  workbench_.setup().edit_option("range", "x_max_m", 0.98);
  EXPECT_EQ(edits_since_calibration(), 1) << "turning one knob is one edit";
  ASSERT_TRUE(settle());
  EXPECT_NE(workbench_.outcome().output(), before);
  EXPECT_FALSE(workbench_.calibrations().out_of_date());
  workbench_.history().stack().undo();
  EXPECT_EQ(workbench_.setup().settings().range.x_max_m, calibration::SearchRange{}.x_max_m);
  workbench_.setup().edit_option("registration", "voxel_m", 0.5);
  EXPECT_TRUE(workbench_.calibrations().out_of_date()) << "alignments have to be made anew";
}

TEST_F(window_flow, a_result_made_with_other_settings_is_shown_as_such_also_after_reopening) {
  QTemporaryDir folder;
  const QString path = folder.filePath("job.remount");
  show();
  calibrate_drive();
  const auto note = [&] {
    for (const QLabel* label : child<ResultPanel>().findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains("other settings")) return label->text();
    return QString();
  };
  EXPECT_EQ(note(), "");
  workbench_.setup().edit_option("registration", "voxel_m", 0.5);
  EXPECT_FALSE(workbench_.activity().solving()) << "a new solution from the same alignments would change nothing";
  EXPECT_TRUE(note().contains("Voxel (Alignment)") && note().contains("now 0.5")) << note().toStdString();
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(workbench_.calibrations().out_of_date()) << "the edit was taken back";
  workbench_.setup().edit_nominal(rigid_from_six({1, 0, 1, 0, 0, 0}));
  workbench_.setup().edit_option("registration", "voxel_m", 0.5);
  ASSERT_TRUE(settle());
  workbench_.document().save(path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.document().path() == path; }, kPatience_ms));

  workbench_.document().open(path);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.calibrations().out_of_date());
  EXPECT_TRUE(note().contains("nominal mounting") && note().contains("now 0.5")) << note().toStdString();
  const QString banner = child<MessageBanner>().findChild<QLabel*>()->text();
  EXPECT_TRUE(child<MessageBanner>().isVisible() && banner.contains("other settings")) << banner.toStdString();
  EXPECT_EQ(load_result_settings(gui::export_text(workbench_, "yaml")).registration.voxel_m,
            registration::RegistrationOptions{}.voxel_m)
      << "an exported result says with what it was made, not what is set now";
  photograph(window_, "11-made-with-other-settings");
}

TEST_F(window_flow, a_nominal_outside_the_search_range_is_not_calibrated_with) {
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  workbench_.setup().edit_nominal(rigid_from_six({6, 0, 1, 0, 0, 0}));
  workbench_.calibrations().calibrate();
  EXPECT_FALSE(workbench_.activity().calibrating());
  const QString banner = child<MessageBanner>().findChild<QLabel*>()->text();
  EXPECT_TRUE(banner.contains("x 6.00 m (at most 5.00 m)")) << banner.toStdString();
}

TEST_F(window_flow, every_format_can_be_previewed_with_its_direction) {
  show();
  calibrate_drive();
  ASSERT_FALSE(gui::export_formats().empty());
  for (const ExportFormat& format : gui::export_formats()) {
    EXPECT_FALSE(format.direction.isEmpty()) << format.id.toStdString();
    if (format.id == "beams")
      EXPECT_THROW(gui::export_text(workbench_, format.id), Error) << "the LiDAR of this drive has no errors";
    else
      EXPECT_FALSE(gui::export_text(workbench_, format.id).isEmpty()) << format.id.toStdString();
  }
  trigger("Ctrl+E");
  auto& dialog = child<ExportDialog>();
  EXPECT_FALSE(dialog.current_text().isEmpty());
  photograph(dialog, "6-export");
  dialog.close();
}

TEST_F(window_flow, closing_while_calibrating_ends_in_time) {
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  workbench_.calibrations().calibrate();
  window_.close();
  ASSERT_TRUE(settle());
}

TEST_F(window_flow, cancel_keeps_what_was_there) {
  *hold_at_ = 0;  // until it is cancelled, however long that takes
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  QSignalSpy progress(&workbench_.activity(), &gui::Activity::progressed);
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return progress.count() > 3; }, kPatience_ms));
  photograph(window_, "2-calibrating");
  workbench_.cancel();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(workbench_.outcome().output());
  EXPECT_EQ(workbench_.sessions().all().size(), 1U);
}

class cancelled_calibration : public testing::WindowFixture {
 protected:
  void calibrate_and_cancel() {
    constexpr int kStage = 3;  // of 10: 15 of 50 pairs are aligned
    *hold_at_ = kStage;
    QSignalSpy progress(&workbench_.activity(), &gui::Activity::progressed);
    const auto reached = [&] {
      return std::any_of(progress.begin(), progress.end(),
                         [](const QList<QVariant>& report) { return report[1].toInt() == kStage; });
    };
    workbench_.calibrations().calibrate();
    ASSERT_TRUE(QTest::qWaitFor(reached, kPatience_ms));
    workbench_.cancel();
    ASSERT_TRUE(settle());
    *hold_at_ = -1;
  }
};

TEST_F(cancelled_calibration, keeps_the_pairs_that_were_aligned_but_no_part_instead_of_a_whole) {
  show();
  window_.open_paths({"/data/drive1"});
  ASSERT_TRUE(settle());
  calibrate_and_cancel();
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_FALSE(workbench_.solutions().incomplete()) << "what was aligned is solved";
  EXPECT_EQ(english(pair(2).reason), "");
  EXPECT_EQ(pair(2).state, motion::PairState::Proposed) << "the solver decides";
  EXPECT_EQ(pair(49).state, motion::PairState::Rejected);
  EXPECT_EQ(english(pair(49).reason), "not aligned: the calibration was cancelled");
  const QString banner = child<MessageBanner>().findChild<QLabel*>()->text();
  EXPECT_TRUE(child<MessageBanner>().isVisible() && banner.contains("15 of 50 pairs")) << banner.toStdString();
  photograph(window_, "26-cancelled");
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  const gui::OutputPtr whole = workbench_.outcome().output();
  calibrate_and_cancel();
  EXPECT_EQ(workbench_.outcome().output(), whole);
}

TEST_F(window_flow, the_pair_is_shown_in_three_dimensions) {
  if (!missing_gl_reason().isEmpty())
    GTEST_SKIP() << "needs a display with OpenGL: " << missing_gl_reason().toStdString();
  show();
  QSignalSpy loaded(&workbench_.pair_scenes(), &gui::PairScenes::ready);
  calibrate_drive();
  ASSERT_TRUE(QTest::qWaitFor([&] { return loaded.count() > 0; }, kPatience_ms));
  auto& view = child<PairView>();
  ASSERT_TRUE(view.has_gl());
  view.look(scene::StandardView::Top);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view.shows_scene(); }, kPatience_ms));
  const auto grab = [&] {
    QTest::qWait(300);  // until all points are drawn
    return view.canvas()->grab().toImage();
  };
  const QImage aligned = grab();
  view.flip();
  const QImage before = grab();
  EXPECT_NE(aligned, before) << "the mounting assumed before is 20 cm and 2 degrees off: this must be seen";
  view.flip();
  EXPECT_EQ(aligned, grab());
  view.look(scene::StandardView::Fit);
  photograph(window_, "3-pair");
  trigger("Ctrl+,");
  photograph(child<OptionsDialog>(), "9-options");
  trigger("Ctrl+B");
  photograph(child<ObstacleDialog>(), "10-obstacles");
  workbench_.decisions().decide({PairIndex{3}, PairIndex{4}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  view.look(scene::StandardView::Top);
  view.show_alignment(scene::PairAlignment::Before);
  photograph(window_, "4-before-top");
  const auto loads = loaded.count();
  workbench_.selection().select(PairIndex{10});
  ASSERT_TRUE(QTest::qWaitFor([&] { return loaded.count() > loads; }, kPatience_ms));
  photograph(window_, "12-rejected-pair");
  std::vector<PairIndex> nearly_all;
  for (PairIndex index{2}; index < workbench_.outcome().output()->pairs.size(); ++index) nearly_all.push_back(index);
  workbench_.decisions().decide(nearly_all, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.outcome().output()->result.status, calibration::Status::TooFewPairs);
  photograph(window_, "13-not-solved");
}

TEST_F(window_flow, dark_palettes_are_followed) {
  if (!missing_gl_reason().isEmpty())
    GTEST_SKIP() << "needs a display with OpenGL: " << missing_gl_reason().toStdString();
  const testing::PaletteFor dark(testing::dark_palette());
  show();
  QSignalSpy loaded(&workbench_.pair_scenes(), &gui::PairScenes::ready);
  calibrate_drive();
  ASSERT_TRUE(QTest::qWaitFor([&] { return loaded.count() > 0; }, kPatience_ms));
  EXPECT_TRUE(is_dark(window_.palette()));
  photograph(window_, "7-dark");
}

}  // namespace
}  // namespace remount::widgets
