// A window on the sample world, and what its tests do with it.
#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QGuiApplication>
#include <QLabel>
#include <QTest>

#include "app/gui/features/all_features.h"
#include "app/gui/shell/main_window.h"
#include "tests/support/sanitized.h"
#include "tests/widgets/support/sample_world.h"

namespace remount::testing {

constexpr int kPatience_ms = 60000 * static_cast<int>(kSanitizerSlowdown);

class WindowFixture : public ::testing::Test {
 protected:
  explicit WindowFixture(int stages = 10)
      : workbench_(sample_engine(stages, hold_at_)), window_(workbench_, gui::all_features()) {}
  using MakeEngine = gui::Engine (*)(std::shared_ptr<const std::atomic<int>> hold_at);
  explicit WindowFixture(MakeEngine make_engine)
      : workbench_(make_engine(hold_at_)), window_(workbench_, gui::all_features()) {}

  void show() {
    window_.show();
    window_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_, kPatience_ms));
  }
  bool settle() {
    const bool settled = QTest::qWaitFor(
        [&] {
          return !workbench_.activity().opening() && !workbench_.activity().calibrating() &&
                 !workbench_.activity().solving();
        },
        kPatience_ms);
    window_.show_everything();
    return settled;
  }
  void calibrate_drive() {
    window_.open_paths({"/data/drive1"});
    ASSERT_TRUE(settle());
    workbench_.calibrations().calibrate();
    ASSERT_TRUE(settle());
    ASSERT_TRUE(workbench_.outcome().output());
    steps_of_calibrating_ = workbench_.history().stack().count();
  }
  /// Steps that undo takes back, beside those of calibrate_drive: opening and the calibration itself.
  int edits_since_calibration() { return workbench_.history().stack().count() - steps_of_calibrating_; }
  double x_m() const { return workbench_.outcome().output()->result.mounting.reference_from_sensor.translation().x(); }
  const motion::Pair& pair(std::size_t index) const { return workbench_.outcome().output()->pairs.at(index); }
  void trigger(const QString& key) {
    for (QAction* action : window_.findChildren<QAction*>())
      if (action->shortcut() == QKeySequence(key)) return action->trigger();
    FAIL() << "no action has the key " << key.toStdString();
  }
  template <class Widget>
  Widget& child(const QString& name = {}) {
    return *window_.findChild<Widget*>(name);
  }
  /// Of all visible labels.
  static QString texts_of(const QWidget& widget) {
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>())
      if (label->isVisible()) texts << label->text();
    return texts.join('\n');
  }
  /// Where REMOUNT_SCREENSHOT_DIR is set, a picture of a widget is left there for people to look at.
  void photograph(QWidget& widget, const QString& name) {
    const QString folder = qEnvironmentVariable("REMOUNT_SCREENSHOT_DIR");
    if (folder.isEmpty() || QGuiApplication::platformName() == QLatin1String("offscreen")) return;
    QTest::qWait(300);
    widget.grab().save(QDir(folder).filePath(name + ".png"));
  }

  int steps_of_calibrating_ = 0;
  std::shared_ptr<std::atomic<int>> hold_at_ = std::make_shared<std::atomic<int>>(-1);  ///< of the sample engine
  gui::Workbench workbench_;
  gui::MainWindow window_;
};

}  // namespace remount::testing
