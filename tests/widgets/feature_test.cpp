// A panel is added to the window by one class and one entry of the list of features.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>

#include "app/gui/features/all_features.h"
#include "app/gui/shell/main_window.h"
#include "tests/widgets/support/sample_world.h"

namespace remount::widgets {
namespace {

/// Counts the sessions that are open: a dock, an action, a help page.
class CountFeature : public gui::Feature {
 public:
  explicit CountFeature(gui::MainWindow& window) : Feature(window), text_(new QLabel) {
    dock_ = window.add_dock({.title = "Count", .name = "count", .content = text_, .help_page = "setup"});
    window.menus().add(gui::MenuPlace::CalibrateResult, "Count &sessions", QKeySequence("Ctrl+Alt+K"),
                       [this] { count(); });
  }
  void show_state() override { ++states_; }
  std::vector<gui::TurnQueue::Piece> show_output_later() override {
    return {[this] { ++outputs_; }};
  }
  void show_palette(const QPalette&) override { ++palettes_; }
  bool may_close(const std::function<void()>&) override { return may_close_; }

  int states_ = 0, outputs_ = 0, palettes_ = 0;
  bool may_close_ = true;
  QLabel* text_;
  QDockWidget* dock_;

 private:
  void count() { text_->setText(QString::number(workbench_.sessions().all().size())); }
};

std::vector<gui::MakeFeature> with_count(std::vector<gui::MakeFeature> features) {
  features.push_back(gui::plug<CountFeature>());
  return features;
}

const QAction* action_of(const QWidget& window, const QString& text) {
  for (const QMenu* menu : window.findChildren<QMenu*>())
    for (const QAction* action : menu->actions())
      if (action->text() == text) return action;
  return nullptr;
}

QMenu* menu_of(const gui::MainWindow& window, const QString& title) {
  for (QMenu* menu : window.findChildren<QMenu*>())
    if (menu->title() == title) return menu;
  return nullptr;
}

class feature_list : public ::testing::TestWithParam<bool> {
 protected:
  gui::Workbench workbench_{testing::sample_engine()};
  gui::MainWindow window_{workbench_, with_count(GetParam() ? gui::all_features() : std::vector<gui::MakeFeature>())};
  CountFeature& count_ = *window_.feature<CountFeature>();
};

TEST_P(feature_list, gives_the_window_its_dock) {
  EXPECT_EQ(window_.findChild<QDockWidget*>("count"), count_.dock_);
  EXPECT_EQ(window_.dockWidgetArea(count_.dock_), Qt::BottomDockWidgetArea);
  const QMenu* view = menu_of(window_, gui::Menus::tr("&View"));
  ASSERT_TRUE(view);
  EXPECT_TRUE(view->actions().contains(count_.dock_->toggleViewAction()));
}

TEST_P(feature_list, gives_the_window_its_action) {
  const QMenu* calibrate = menu_of(window_, gui::Menus::tr("&Calibrate"));
  ASSERT_TRUE(calibrate);
  const QAction* action = action_of(window_, "Count &sessions");
  ASSERT_TRUE(action && calibrate->actions().contains(const_cast<QAction*>(action)));
  const_cast<QAction*>(action)->trigger();
  EXPECT_EQ(count_.text_->text(), "0");
}

TEST_P(feature_list, is_found_by_help) { EXPECT_EQ(window_.help_page_of(count_.text_), "setup"); }

TEST_P(feature_list, is_told_what_changes) {
  EXPECT_EQ(count_.palettes_, 1);
  const int states = count_.states_;
  workbench_.announce();
  window_.show_everything();
  EXPECT_GT(count_.states_, states);
  EXPECT_GT(count_.outputs_, 0);
}

TEST_P(feature_list, may_keep_the_window_open) {
  count_.may_close_ = false;
  EXPECT_FALSE(window_.close());
  count_.may_close_ = true;
  EXPECT_TRUE(window_.close());
}

INSTANTIATE_TEST_SUITE_P(alone_and_with_all, feature_list, ::testing::Bool());

}  // namespace
}  // namespace remount::widgets
