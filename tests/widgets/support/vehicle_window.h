// A window with a vehicle of two LiDARs, on the model's own engine.
#pragma once

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/features/all_features.h"
#include "app/gui/shell/main_window.h"
#include "model/simulator/simulator.h"
#include "widgets/vehicle/lidars_panel.h"

namespace remount::testing {

using widgets::LidarsPanel;
using widgets::LidarTableModel;

inline constexpr int kVehiclePatience_ms = 200000;

inline simulator::LidarMount mount(std::string name, double phase_s, const SixParameters& ins_from_lidar) {
  simulator::LidarMount out;
  out.name = std::move(name);
  out.options.beams = 24;
  out.options.azimuth_steps = 200;
  out.options.scan_rate_hz = 5.0;
  out.options.scan_phase_s = phase_s;
  out.options.ins_from_lidar = rigid_from_six(ins_from_lidar);
  return out;
}

class vehicle_window : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<QTemporaryDir>();
    ASSERT_TRUE(folder_->isValid());
    simulator::SimulationOptions options;
    options.scenario = simulator::ScenarioKind::FigureEight;
    options.duration_s = 6.0;
    const simulator::SimulatedVehicle vehicle =
        simulator::simulate_vehicle(options, {mount("front", 0.0, {1.9, 0.1, 0.8, 0.02, 0.03, -0.01}),
                                              mount("rear", 0.04, {-1.2, -0.2, 1.1, 2.9, -0.02, 0.02})});
    truth_.clear();
    for (const simulator::SimulatedDrive& lidar : vehicle.lidars) truth_.push_back(lidar.ins_from_lidar);
    Progress progress;
    simulator::write_vehicle(vehicle, folder_->filePath("drive").toStdString(), "native", 0, progress);
    options.duration_s = 2.0;
    options.seed = 2;
    simulator::write_vehicle(
        simulator::simulate_vehicle(options, {mount("front", 0.0, {1.9, 0.1, 0.8, 0.02, 0.03, -0.01}),
                                              mount("side", 0.02, {0.5, 0.9, 1.4, 1.5, 0.0, 0.0})}),
        folder_->filePath("second").toStdString(), "native", 0, progress);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  void SetUp() override {
    window_.show();
    window_.open_paths({folder_->filePath("drive")});
    ASSERT_TRUE(settle());
    ASSERT_TRUE(QTest::qWaitFor([&] { return workbench_.vehicle().lidars().size() == 2; }, kVehiclePatience_ms));
    // It is not asked how well they are calibrated.
    workbench_.setup().edit_option("pairing", "max_partners", 3);
    workbench_.setup().edit_option("run", "map_check", false);
  }
  bool settle() {
    const gui::Activity& activity = workbench_.activity();
    const auto idle = [&] { return !activity.opening() && !activity.calibrating() && !activity.solving(); };
    const bool settled = QTest::qWaitFor(idle, kVehiclePatience_ms);
    window_.show_everything();
    return settled;
  }
  void press(const QString& text) {
    for (auto* button : panel().findChildren<QPushButton*>())
      if (button->text() == text) {
        ASSERT_TRUE(button->isEnabled()) << text.toStdString();
        return button->click();
      }
    FAIL() << "no button " << text.toStdString();
  }
  void calibrate_together() {
    press("Calibrate ticked");
    ASSERT_TRUE(settle());
    ASSERT_TRUE(vehicle().common());
  }
  /// Opened in a window of its own, which does not take the project from this one.
  void save_and_open(const QString& path, gui::Workbench& later) {
    QSignalSpy saved(&workbench_.document(), &gui::ProjectDocument::saved);
    workbench_.document().save(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved.count() > 0; }, kVehiclePatience_ms));
    gui::ProjectToOpen request;
    request.path = path;
    request.access = gui::ProjectToOpen::Access::Copy;
    later.document().open(request);
    const std::size_t sessions = workbench_.sessions().all().size();
    const auto opened = [&] { return later.sessions().all().size() == sessions && !later.activity().opening(); };
    ASSERT_TRUE(QTest::qWaitFor(opened, kVehiclePatience_ms));
  }
  gui::Vehicle& vehicle() { return workbench_.vehicle(); }
  LidarsPanel& panel() { return *window_.findChild<LidarsPanel*>(); }
  QString cell(int row, LidarTableModel::Column column) {
    return panel().model()->index(row, column).data().toString();
  }
  const RigidTransform& found() { return workbench_.outcome().output()->result.mounting.reference_from_sensor; }

  static inline std::unique_ptr<QTemporaryDir> folder_;
  static inline std::vector<RigidTransform> truth_;
  gui::Workbench workbench_{gui::model_engine()};
  gui::MainWindow window_{workbench_, gui::all_features()};
};

inline const motion::LidarIndex kFront{0}, kRear{1};

}  // namespace remount::testing
