// The window on the model's own engine: a simulated drive is written, opened, calibrated, saved and opened again.
#include <gtest/gtest.h>

#include <QDir>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "algorithms/messages/render.h"
#include "app/gui/features/all_features.h"
#include "app/gui/shell/main_window.h"
#include "model/results/result_words.h"
#include "model/simulator/simulator.h"
#include "widgets/pairs/pair_view.h"
#include "widgets/result/result_panel.h"

namespace remount::widgets {
namespace {

constexpr int kDrivePatience_ms = 200000;

/// Short and coarse, so that it is calibrated in seconds.
simulator::SimulationOptions short_drive() {
  simulator::SimulationOptions options;
  options.duration_s = 6.0;
  options.scan_rate_hz = 5.0;
  options.beams = 32;
  options.azimuth_steps = 500;
  options.scenario = simulator::ScenarioKind::FigureEight;
  return options;
}

class real_drive : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    drive_ = simulator::simulate_drive(short_drive());
    Progress progress;
    simulator::write_drive(drive_, folder_.filePath("drive").toStdString(), "native", 0, progress);
  }
  bool settle(gui::Workbench& workbench) {
    return QTest::qWaitFor(
        [&] {
          return !workbench.activity().opening() && !workbench.activity().calibrating() &&
                 !workbench.activity().solving();
        },
        kDrivePatience_ms);
  }

  QTemporaryDir folder_;
  simulator::SimulatedDrive drive_;
};

TEST_F(real_drive, is_calibrated_reviewed_saved_and_opened_again) {
  const QString project = folder_.filePath("job.remount");
  RigidTransform found = RigidTransform::Identity();
  {
    gui::Workbench workbench(gui::model_engine());
    gui::MainWindow window(workbench, gui::all_features());
    window.show();
    window.open_paths({folder_.filePath("drive")});
    ASSERT_TRUE(settle(workbench));
    ASSERT_EQ(workbench.sessions().all().size(), 1U);
    SixParameters nominal = six_from_rigid(drive_.ins_from_lidar);
    nominal.x_m += 0.1;
    nominal.yaw_rad += 0.02;
    workbench.setup().edit_nominal(rigid_from_six(nominal));
    QSignalSpy loaded(&workbench.pair_scenes(), &gui::PairScenes::ready),
        failed(&workbench.pair_scenes(), &gui::PairScenes::failed);
    QElapsedTimer timer;
    timer.start();
    workbench.calibrations().calibrate();
    ASSERT_TRUE(settle(workbench)) << "not calibrated in " << timer.elapsed() << " ms";
    ASSERT_TRUE(workbench.outcome().output());
    const calibration::CalibrationResult& result = workbench.outcome().output()->result;
    ASSERT_TRUE(results::has_mounting(result)) << english(result.message);
    found = result.mounting.reference_from_sensor;
    EXPECT_LT(rotation_angle_between_rad(found, drive_.ins_from_lidar), degrees_to_radians(0.2))
        << "found in " << timer.elapsed() << " ms";
    ASSERT_TRUE(QTest::qWaitFor([&] { return loaded.count() + failed.count() > 0; }, kDrivePatience_ms));
    EXPECT_EQ(failed.count(), 0) << failed.value(0).value(1).toString().toStdString();
    const QString pictures = qEnvironmentVariable("REMOUNT_SCREENSHOT_DIR");
    if (!pictures.isEmpty() && window.findChild<PairView*>()->has_gl()) {
      QTest::qWait(300);
      window.grab().save(QDir(pictures).filePath("8-real.png"));
    }
    workbench.decisions().decide({motion::PairIndex{0}}, motion::PairState::Rejected);
    ASSERT_TRUE(settle(workbench));
    EXPECT_LT(rotation_angle_between_rad(workbench.outcome().output()->result.mounting.reference_from_sensor,
                                         drive_.ins_from_lidar),
              degrees_to_radians(0.2));
    EXPECT_TRUE(workbench.document().has_unsaved_decisions());
    bool saved = false;
    workbench.document().save(project, [&] { saved = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kDrivePatience_ms));
    found = workbench.outcome().output()->result.mounting.reference_from_sensor;
  }
  gui::Workbench workbench(gui::model_engine());
  gui::MainWindow window(workbench, gui::all_features());
  window.open_paths({project});
  ASSERT_TRUE(settle(workbench));
  ASSERT_TRUE(workbench.outcome().output()) << "the project holds the calibration";
  EXPECT_EQ(workbench.outcome().output()->pairs.at(0).state, motion::PairState::Rejected);
  EXPECT_LT(rotation_angle_between_rad(workbench.outcome().output()->result.mounting.reference_from_sensor, found),
            1e-9);
}

TEST_F(real_drive, a_missing_folder_is_a_message_and_no_more) {
  gui::Workbench workbench(gui::model_engine());
  QSignalSpy messages(&workbench.notices(), &gui::Notices::message);
  workbench.sessions().open({folder_.filePath("nowhere")});
  ASSERT_TRUE(settle(workbench));
  ASSERT_FALSE(messages.isEmpty());
  EXPECT_EQ(messages.last().at(0).value<drive::Severity>(), drive::Severity::Problem);
  EXPECT_TRUE(workbench.sessions().all().empty());
}

}  // namespace
}  // namespace remount::widgets
