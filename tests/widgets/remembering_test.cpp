// What the user set is there again at the next start.
#include <gtest/gtest.h>

#include <QAction>
#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "app/gui/features/all_features.h"
#include "app/gui/features/help_feature.h"
#include "app/gui/features/pairs_feature.h"
#include "app/gui/shell/main_window.h"
#include "tests/widgets/support/sample_world.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/shell/keys_dialog.h"

namespace remount::widgets {
namespace {

/// Settings as the application keeps them, in a folder of the test's own.
class remembering : public ::testing::Test {
 protected:
  void SetUp() override {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
    QCoreApplication::setOrganizationName("remount-test");
  }
  void TearDown() override { QCoreApplication::setOrganizationName({}); }

  QTemporaryDir folder_;
};

TEST_F(remembering, keys_and_the_scale_of_distances) {
  {
    gui::Workbench workbench(testing::sample_engine());
    gui::MainWindow window(workbench, gui::all_features());
    EXPECT_NE(window.findChild<PairView*>()->scale_m(), 0.35);
    window.findChild<PairView*>()->set_scale(0.35);
    for (QAction* action : window.findChildren<QAction*>())
      if (action->text() == gui::HelpFeature::tr("&Keys")) action->trigger();
    auto* dialog = window.findChild<KeysDialog*>();
    ASSERT_TRUE(dialog);
    dialog->set_key("view-top", QKeySequence("T"));
    dialog->set_key("accept", QKeySequence("Y"));
    dialog->accept();
  }
  gui::Workbench workbench(testing::sample_engine());
  gui::MainWindow next(workbench, gui::all_features());
  EXPECT_DOUBLE_EQ(next.findChild<PairView*>()->scale_m(), 0.35);
  QStringList with_keys;
  for (const QAction* action : next.findChildren<QAction*>())
    if (action->shortcut() == QKeySequence("T") || action->shortcut() == QKeySequence("Y")) with_keys << action->text();
  EXPECT_EQ(with_keys, (QStringList{gui::PairsFeature::tr("&Accept pair"), gui::MainWindow::tr("&Top")}));
}

}  // namespace
}  // namespace remount::widgets
