// Recordings whose folder disappears while the window works with them: a disk that is taken out.
#include <gtest/gtest.h>

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/features/all_features.h"
#include "app/gui/shell/main_window.h"
#include "model/simulator/simulator.h"

namespace remount::widgets {
namespace {

constexpr int kLoadingPatience_ms = 100000;

class vanished_data : public ::testing::Test {
 protected:
  vanished_data() : workbench_(gui::model_engine()), window_(workbench_, gui::all_features()) {
    QObject::connect(
        &workbench_.notices(), &gui::Notices::message,
        [this](drive::Severity, const QString& where, const QString& what) { said_ << where + ": " + what; });
  }
  void SetUp() override {
    simulator::SimulationOptions options;
    options.duration_s = 4.0;
    options.scan_rate_hz = 5.0;
    options.beams = 16;
    options.azimuth_steps = 300;
    options.scenario = simulator::ScenarioKind::FigureEight;
    Progress progress;
    simulator::write_drive(simulator::simulate_drive(options), drive_.toStdString(), "native", 0, progress);
    window_.open_paths({drive_});
    ASSERT_TRUE(settle());
    ASSERT_EQ(workbench_.sessions().all().size(), 1U);
    said_.clear();
  }
  bool settle() {
    return QTest::qWaitFor(
        [&] {
          return !workbench_.activity().opening() && !workbench_.activity().calibrating() &&
                 !workbench_.activity().solving();
        },
        kLoadingPatience_ms);
  }
  void take_the_disk_out() { ASSERT_TRUE(QDir().rename(drive_, folder_.filePath("elsewhere"))); }
  bool was_said(const QString& part) const { return said_.join('\n').contains(part); }

  QTemporaryDir folder_;
  QString drive_ = folder_.filePath("drive");
  gui::Workbench workbench_;
  gui::MainWindow window_;
  QStringList said_;
};

TEST_F(vanished_data, before_they_are_needed_are_named_and_the_window_keeps_what_it_has) {
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  const gui::OutputPtr before = workbench_.outcome().output();
  ASSERT_TRUE(before);
  ASSERT_GT(before->pairs.size(), 1U);
  take_the_disk_out();
  QSignalSpy failed(&workbench_.pair_scenes(), &gui::PairScenes::failed),
      loaded(&workbench_.pair_scenes(), &gui::PairScenes::ready);
  QTest::qWait(100);  // what was being read before
  failed.clear();
  workbench_.selection().select(motion::PairIndex(before->pairs.size() - 1));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, kLoadingPatience_ms));
  EXPECT_TRUE(failed.last().at(1).toString().contains("drive/")) << failed.last().at(1).toString().toStdString();
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle()) << "it hangs";
  EXPECT_TRUE(was_said(drive_)) << said_.join('\n').toStdString();
  EXPECT_EQ(workbench_.outcome().output(), before);
  EXPECT_EQ(workbench_.sessions().all().size(), 1U);
}

TEST_F(vanished_data, while_they_are_read_are_named) {
  QSignalSpy progressed(&workbench_.activity(), &gui::Activity::progressed);
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(progressed.wait(kLoadingPatience_ms));
  take_the_disk_out();
  ASSERT_TRUE(settle()) << "it hangs";
  EXPECT_TRUE(was_said(drive_)) << said_.join('\n').toStdString();
  EXPECT_FALSE(workbench_.outcome().output()) << "half of the scans are no calibration";
  EXPECT_EQ(workbench_.sessions().all().size(), 1U);
  ASSERT_TRUE(QDir().rename(folder_.filePath("elsewhere"), drive_)) << "the disk is back";
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.outcome().output()) << said_.join('\n').toStdString();
}

}  // namespace
}  // namespace remount::widgets
