// Pairs looked through one after the other: what is kept of it, and what each way of seeing shows.
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>

#include "app/gui/basics/held_action.h"
#include "model/project/project.h"
#include "tests/widgets/support/window_fixture.h"
#include "widgets/basics/distance_legend.h"
#include "widgets/basics/scale_bar.h"
#include "widgets/pairs/contact_sheet.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/pairs/pairs_panel.h"
#include "widgets/pairs/section_panel.h"
#include "widgets/shell/step_bar.h"

namespace remount::widgets {
namespace {

using motion::PairIndex;

class looking_through : public testing::WindowFixture {
 protected:
  void SetUp() override {
    show();
    calibrate_drive();
    ASSERT_TRUE(shown());
  }
  bool shown() {
    return QTest::qWaitFor([&] { return !workbench_.pair_scenes().awaited(); }, testing::kPatience_ms);
  }
  bool has_gl() { return child<PairView>().has_gl(); }
  QAction& action(const QString& key) {
    for (QAction* action : window_.findChildren<QAction*>())
      if (action->shortcut() == QKeySequence(key)) return *action;
    throw std::runtime_error("no action " + key.toStdString());
  }
};

TEST_F(looking_through, goes_on_after_a_decision_where_that_is_wanted_and_in_the_order_that_was) {
  child<PairsPanel>().table()->sortByColumn(PairTableModel::State, Qt::AscendingOrder);
  const std::vector<PairIndex> order = child<PairsPanel>().filter()->pairs();
  workbench_.selection().select(order.at(3));
  trigger("R");
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.selection().pair(), order.at(3)) << "not asked for";
  EXPECT_EQ(child<PairsPanel>().filter()->pairs(), order) << "the row stays";
  trigger("N");
  EXPECT_EQ(workbench_.selection().pair(), order.at(4));
  for (QAction* one : window_.findChildren<QAction*>())
    if (one->text().contains("after a decision")) one->setChecked(true);
  trigger("R");
  EXPECT_EQ(workbench_.selection().pair(), order.at(5));
  ASSERT_TRUE(settle());
  EXPECT_EQ(pair(order.at(4)).state, motion::PairState::Rejected);
  EXPECT_NE(pair(order.at(5)).decided_by, motion::DecidedBy::User);
}

TEST_F(looking_through, is_remembered_with_flags_and_comments_in_the_project) {
  ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.review_notes().seen() == 1; }, testing::kPatience_ms));
  for (const std::size_t pair : {4U, 8U}) {
    workbench_.selection().select(PairIndex(pair));
    ASSERT_TRUE(shown());
  }
  EXPECT_EQ(workbench_.review_notes().seen(), 3);
  EXPECT_TRUE(texts_of(child<PairsPanel>()).contains("3 looked at")) << texts_of(child<PairsPanel>()).toStdString();
  const int revision = workbench_.document().snapshot().revision;
  trigger("F");
  workbench_.review_notes().comment({PairIndex{4}}, "a lorry's shadow");
  EXPECT_GT(workbench_.document().snapshot().revision, revision) << "flags and comments are edits";
  const QTemporaryDir folder;
  const auto path = folder.filePath("job.remount").toStdString();
  project::save_project(workbench_.document().snapshot().project, path);
  const std::vector<project::PairNote> notes = project::load_project(path).notes;
  ASSERT_EQ(notes.size(), 3U);
  workbench_.review_notes().put_saved({});
  EXPECT_EQ(workbench_.review_notes().seen(), 0);
  workbench_.review_notes().put_saved(notes);
  const PairMarksPtr marks = workbench_.review_notes().marks();
  EXPECT_TRUE(marks->at(8).flagged && marks->at(8).seen);
  EXPECT_EQ(marks->at(4).comment, "a lorry's shadow");
  EXPECT_FALSE(marks->at(5).seen);
  trigger("F");
  EXPECT_FALSE(workbench_.review_notes().marks()->at(8).flagged) << "once more takes it back";
}

TEST_F(looking_through, plays_until_the_last_pair) {
  workbench_.selection().select(PairIndex{46});
  action("L").setChecked(true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !action("L").isChecked(); }, testing::kPatience_ms));
  EXPECT_EQ(workbench_.selection().pair(), PairIndex{49});
}

TEST_F(looking_through, a_held_key_waits_for_each_picture_and_stops_when_it_is_let_go) {
  QSignalSpy changed(&workbench_.selection(), &gui::Selection::changed);
  const auto hold = [&](int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds) {
      QKeyEvent again(QEvent::ShortcutOverride, Qt::Key_N, Qt::NoModifier, "n", true);
      QApplication::sendEvent(child<PairsPanel>().table(), &again);
      QTest::qWait(10);
    }
  };
  int seen = 0;
  QObject::connect(&workbench_.pair_scenes(), &gui::PairScenes::ready, &window_, [&] { ++seen; });
  hold(2000);
  const auto steps = changed.count();
  EXPECT_GE(steps, 3);
  EXPECT_GE(seen, steps - 1) << "every pair on the way is seen";
  QTest::qWait(250);
  const auto after = changed.count();
  QTest::qWait(300);
  EXPECT_EQ(changed.count(), after) << "it does not run on";
}

TEST_F(looking_through, scans_of_pairs_that_come_next_are_ready_before_they_are_asked_for) {
  workbench_.selection().select(PairIndex{10});
  ASSERT_TRUE(shown());
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return workbench_.pair_scenes().find(PairIndex{11}) != nullptr; }, testing::kPatience_ms));
  workbench_.decisions().decide({PairIndex{10}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.pair_scenes().find(PairIndex{11})) << "a decision changes no scan";
  workbench_.pair_scenes().set_budget(0);
  workbench_.selection().select(PairIndex{30});
  ASSERT_TRUE(shown());
  EXPECT_FALSE(workbench_.pair_scenes().find(PairIndex{10})) << "what was seen long ago makes room";
  EXPECT_TRUE(workbench_.pair_scenes().find(PairIndex{30}));
}

TEST_F(looking_through, a_section_shows_how_thick_a_wall_is_before_and_after) {
  auto& panel = child<SectionPanel>();
  auto* dock = window_.findChild<QDockWidget*>("section");
  dock->show();
  dock->raise();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !panel.plot()->cuts().empty(); }, testing::kPatience_ms));
  const std::vector<ShownCut> cuts = panel.plot()->cuts();
  ASSERT_EQ(cuts.size(), 3U);
  for (const ShownCut& shown : cuts) EXPECT_TRUE(shown.cut.measured) << shown.title.toStdString();
  EXPECT_LT(cuts[1].cut.thickness_together_m, cuts[0].cut.thickness_together_m) << "aligned it is thinner than before";
  photograph(window_, "40-section");
  const QString place = texts_of(panel);
  QTest::keyClick(panel.plot(), Qt::Key_Right);
  EXPECT_TRUE(QTest::qWaitFor([&] { return texts_of(panel).contains("chosen place"); }, testing::kPatience_ms))
      << texts_of(panel).toStdString();
  auto& kind = *panel.findChild<QComboBox*>();
  kind.setCurrentIndex(1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return texts_of(panel).contains("place 1"); }, testing::kPatience_ms))
      << texts_of(panel).toStdString();
  EXPECT_NE(place, texts_of(panel));
}

TEST_F(looking_through, all_pairs_have_a_small_picture_and_share_marks_with_the_table) {
  trigger("Ctrl+Shift+A");
  auto& sheet = child<ContactSheet>();
  ASSERT_TRUE(sheet.isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return sheet.missing().empty(); }, testing::kPatience_ms));
  EXPECT_TRUE(sheet.has_thumbnail(PairIndex{0}));
  photograph(window_, "41-all-pairs");
  sheet.list()->setCurrentIndex(sheet.list()->model()->index(6, 0));
  sheet.list()->selectionModel()->select(sheet.list()->model()->index(8, 0),
                                         QItemSelectionModel::Select | QItemSelectionModel::Rows);
  EXPECT_EQ(workbench_.selection().pair(), PairIndex{6});
  EXPECT_EQ(child<PairsPanel>().marked_pairs(), (std::vector<PairIndex>{PairIndex{6}, PairIndex{8}}));
  trigger("R");
  ASSERT_TRUE(settle());
  EXPECT_EQ(pair(6).state, motion::PairState::Rejected);
  EXPECT_EQ(pair(8).state, motion::PairState::Rejected);
  EXPECT_TRUE(sheet.has_thumbnail(PairIndex{6})) << "a decision changes no picture";
  emit sheet.opened(PairIndex{12});
  EXPECT_EQ(workbench_.selection().pair(), PairIndex{12});
  EXPECT_FALSE(sheet.isVisible());
}

TEST_F(looking_through, the_review_has_the_room_of_the_other_panels_and_gives_it_back) {
  if (!has_gl()) GTEST_SKIP() << "needs a display with OpenGL";
  window_.resize(1366, 768);
  QTest::qWait(100);
  const QWidget& canvas = *child<PairView>().canvas();
  const int narrow = canvas.width();
  window_.go_to_step(Step::Review);
  QTest::qWait(300);
  photograph(window_, "43-review");
  const double width = 100.0 * canvas.width() / window_.width(), height = 100.0 * canvas.height() / window_.height();
  std::printf("the picture takes %.0f %% of the width and %.0f %% of the height of 1366x768\n", width, height);
  EXPECT_GT(width, 65.0);
  EXPECT_GE(height, 50.0);
  EXPECT_TRUE(window_.findChild<QDockWidget*>("pairs")->isVisible());
  EXPECT_FALSE(window_.findChild<QDockWidget*>("result")->isVisible());
  window_.go_to_step(Step::Solve);
  QTest::qWait(300);
  EXPECT_TRUE(window_.findChild<QDockWidget*>("result")->isVisible());
  EXPECT_NEAR(canvas.width(), narrow, 30);
}

TEST_F(looking_through, another_language_keeps_the_arrangement_of_the_review) {
  window_.go_to_step(Step::Review);
  action("F11").setChecked(true);
  gui::MainWindow next(workbench_, gui::all_features());
  next.take_over(window_.hand_over());
  next.show();
  EXPECT_TRUE(next.findChild<QDockWidget*>("pairs")->isVisible()) << "the whole screen does not hide it for good";
  EXPECT_FALSE(next.findChild<QDockWidget*>("result")->isVisible());
  next.go_to_step(Step::Solve);
  EXPECT_TRUE(next.findChild<QDockWidget*>("result")->isVisible());
}

TEST_F(looking_through, fills_the_screen_and_keeps_its_keys) {
  auto* pairs = window_.findChild<QDockWidget*>("pairs");
  ASSERT_TRUE(pairs->isVisible());
  action("F11").setChecked(true);
  EXPECT_FALSE(pairs->isVisible());
  EXPECT_EQ(window_.menuBar()->height(), 0);
  EXPECT_TRUE(window_.isFullScreen());
  QTest::qWait(50);
  const auto before = workbench_.selection().pair();
  QTest::keyClick(window_.focusWidget() ? window_.focusWidget() : &window_, Qt::Key_N);
  EXPECT_NE(workbench_.selection().pair(), before) << "N works without the table";
  action("F11").setChecked(false);
  EXPECT_TRUE(pairs->isVisible());
  EXPECT_GT(window_.menuBar()->height(), 0);
}

TEST_F(looking_through, the_view_is_coloured_by_what_was_measured_and_says_its_scale) {
  if (!has_gl()) GTEST_SKIP() << "needs a display with OpenGL";
  auto& view = child<PairView>();
  const auto picture = [&] {
    QTest::qWait(250);  // until all points are drawn
    return view.picture();
  };
  view.look(scene::StandardView::Top);
  EXPECT_TRUE(view.parallel()) << "lengths can be compared from above";
  const QImage plain = picture();
  view.set_coloring(scene::PairColoring::Height);
  const QImage by_height = picture();
  EXPECT_NE(plain, by_height);
  view.show_ground(false);
  EXPECT_NE(picture(), by_height) << "without the ground";
  view.show_ground(true);
  EXPECT_EQ(picture(), by_height) << "and with it again";
  view.set_coloring(scene::PairColoring::SignedDistance);
  const QImage unknown = view.picture();
  const auto& legend = *view.findChild<DistanceLegend*>();
  EXPECT_TRUE(QTest::qWaitFor([&] { return texts_of(legend).contains("median 0."); }, testing::kPatience_ms))
      << texts_of(legend).toStdString();
  EXPECT_NE(picture(), unknown) << "points have colours when their distances are known";
  const auto& bar = *view.findChild<ScaleBar*>();
  const QString scale = bar.text();
  EXPECT_TRUE(scale.endsWith(" m") || scale.endsWith(" cm")) << scale.toStdString();
  view.look(scene::StandardView::Isometric);
  EXPECT_FALSE(view.parallel());
  EXPECT_TRUE(bar.text().contains("in the middle")) << bar.text().toStdString();
  photograph(window_, "42-signed-distance");
}

}  // namespace
}  // namespace remount::widgets
