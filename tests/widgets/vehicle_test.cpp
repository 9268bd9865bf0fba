// A vehicle with two LiDARs in the window, on the model's own engine.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/document/result_files.h"
#include "app/gui/document/vehicle_report.h"
#include "app/gui/features/all_features.h"
#include "app/gui/features/vehicle_export_dialog.h"
#include "app/gui/shell/main_window.h"
#include "model/simulator/simulator.h"
#include "tests/support/draws.h"
#include "tests/support/sanitized.h"
#include "widgets/basics/gl_support.h"
#include "widgets/map/map_view.h"
#include "widgets/result/export_dialog.h"
#include "widgets/vehicle/lidars_panel.h"

namespace remount::widgets {
namespace {

constexpr int kVehiclePatience_ms = 200000;

simulator::LidarMount mount(std::string name, double phase_s, const SixParameters& ins_from_lidar) {
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

const motion::LidarIndex kFront{0}, kRear{1};

TEST_F(vehicle_window, calibrates_lidars_together_and_shows_one_after_the_other) {
  EXPECT_EQ(vehicle().shown(), kFront);
  EXPECT_EQ(cell(0, LidarTableModel::State), "not calibrated");
  calibrate_together();
  ASSERT_EQ(vehicle().common()->file.lidars.size(), 2u);
  EXPECT_TRUE(vehicle().up_to_date());
  EXPECT_LT(difference(found(), truth_[0]).head<2>().norm(), 0.02);
  EXPECT_EQ(cell(0, LidarTableModel::State), "Solved, with the others");
  EXPECT_EQ(cell(0, LidarTableModel::Name), "▶ front");
  EXPECT_TRUE(cell(1, LidarTableModel::X).startsWith("-1.")) << cell(1, LidarTableModel::X).toStdString();
  vehicle().show(kRear);
  ASSERT_TRUE(settle());
  EXPECT_EQ(vehicle().shown(), kRear);
  EXPECT_LT(difference(found(), truth_[1]).head<2>().norm(), 0.02);
  EXPECT_EQ(cell(1, LidarTableModel::Name), "▶ rear");
  EXPECT_TRUE(vehicle().up_to_date());
  workbench_.history().stack().undo();
  EXPECT_EQ(vehicle().shown(), kFront);
  workbench_.history().stack().undo();
  EXPECT_FALSE(vehicle().common());
  EXPECT_FALSE(workbench_.outcome().output());
  workbench_.history().stack().redo();
  ASSERT_TRUE(vehicle().common());
  EXPECT_LT(difference(found(), truth_[0]).head<2>().norm(), 0.02);
}

TEST_F(vehicle_window, decisions_on_one_lidar_are_taken_into_the_common_solution) {
  calibrate_together();
  workbench_.setup().edit_nominal(RigidTransform::Identity());
  EXPECT_FALSE(vehicle().up_to_date()) << "it starts from another nominal mounting";
  workbench_.history().stack().undo();
  EXPECT_TRUE(vehicle().up_to_date());
  const RigidTransform rear_before = vehicle().output_of(kRear)->result.mounting.reference_from_sensor;
  const auto& pairs = workbench_.outcome().output()->pairs;
  std::vector<motion::PairIndex> rejected;
  for (motion::PairIndex p; p < pairs.size() && rejected.size() < 5; ++p)
    if (pairs[p].state == motion::PairState::Accepted) rejected.push_back(p);
  workbench_.decisions().decide(rejected, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(vehicle().up_to_date());
  EXPECT_EQ(cell(0, LidarTableModel::State), "▲ changed since: Solved");
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(vehicle().up_to_date()) << "the decision is taken back";
  workbench_.history().stack().redo();
  ASSERT_TRUE(settle());
  press("Solve together again");
  ASSERT_TRUE(settle());
  EXPECT_TRUE(vehicle().up_to_date());
  const auto& anew = workbench_.outcome().output()->pairs;
  for (const motion::PairIndex pair : rejected) {
    EXPECT_EQ(anew.at(pair).state, motion::PairState::Rejected);
    EXPECT_EQ(anew.at(pair).decided_by, motion::DecidedBy::User);
  }
  const RigidTransform rear_after = vehicle().output_of(kRear)->result.mounting.reference_from_sensor;
  const double moved = difference(rear_before, rear_after).norm();
  EXPECT_GT(moved, 0.0) << "what the one says, the other hears";
  EXPECT_LT(moved, 0.01);
}

TEST_F(vehicle_window, tells_relative_mountings_pairs_across_and_the_map_of_all) {
  calibrate_together();
  auto* reference = panel().findChild<QComboBox*>("reference");
  ASSERT_EQ(reference->count(), 3) << "INS, front, rear";
  reference->setCurrentIndex(1);
  EXPECT_EQ(cell(0, LidarTableModel::X), "–") << "it is the one";
  EXPECT_TRUE(cell(1, LidarTableModel::X).contains("±")) << cell(1, LidarTableModel::X).toStdString();
  const double x_m = (truth_[0].inverse() * truth_[1]).translation().x();
  EXPECT_NEAR(cell(1, LidarTableModel::X).section('\n', 0, 0).toDouble(), x_m, 0.02);
  EXPECT_GT(panel().cross_table()->model()->rowCount(), 10);
  if (!missing_gl_reason().isEmpty()) GTEST_SKIP() << "no OpenGL: the map is not looked at";
  panel().cross_table()->selectRow(0);
  auto* map = window_.findChild<MapView*>("vehicle-map");
  window_.show_view(*map);
  EXPECT_TRUE(QTest::qWaitFor([&] { return map->scene().points_shown() > 1000; }, kVehiclePatience_ms));
}

TEST_F(vehicle_window, a_project_holds_all_lidars) {
  calibrate_together();
  workbench_.decisions().decide({motion::PairIndex{3}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  vehicle().show(kRear);
  ASSERT_TRUE(settle());
  vehicle().tick(kFront, false);
  const QString path = folder_->filePath("job.remount");
  const RigidTransform rear = found();
  gui::Workbench later{gui::model_engine()};
  ASSERT_NO_FATAL_FAILURE(save_and_open(path, later));
  ASSERT_EQ(later.vehicle().lidars().size(), 2u);
  EXPECT_EQ(later.vehicle().shown(), kRear) << "in the order of before";
  EXPECT_FALSE(later.vehicle().lidars()[0].ticked);
  EXPECT_LT(difference(later.outcome().output()->result.mounting.reference_from_sensor, rear).norm(), 1e-9);
  ASSERT_TRUE(later.vehicle().common());
  EXPECT_TRUE(later.vehicle().is_as_solved(kRear));
  EXPECT_FALSE(later.vehicle().is_as_solved(kFront)) << "a pair was rejected";
  ASSERT_TRUE(later.vehicle().output_of(kFront));
  later.vehicle().show(kFront);
  ASSERT_TRUE(QTest::qWaitFor([&] { return later.vehicle().shown() == kFront; }, kVehiclePatience_ms));
  EXPECT_EQ(later.outcome().output()->pairs.at(3).state, motion::PairState::Rejected);
  EXPECT_EQ(later.decisions().count(), 1);
  later.history().stack().undo();
  EXPECT_EQ(later.vehicle().shown(), kRear);
}

TEST_F(vehicle_window, exports_all_lidars) {
  calibrate_together();
  gui::export_vehicle_from(workbench_, vehicle().common()->file, window_);
  auto* dialog = window_.findChild<ExportDialog*>();
  ASSERT_TRUE(dialog);
  dialog->choose("urdf");
  EXPECT_TRUE(dialog->current_text().contains("front") && dialog->current_text().contains("rear"))
      << dialog->current_text().toStdString();
  dialog->choose("apollo");
  EXPECT_TRUE(dialog->current_text().contains("===== ")) << dialog->current_text().toStdString();
  const QString folder = folder_->filePath("exported");
  ASSERT_TRUE(QDir().mkpath(folder));
  emit dialog->save_requested("apollo", folder, {});
  EXPECT_EQ(QDir(folder).entryList(QDir::Files).size(), 2) << QDir(folder).entryList().join(' ').toStdString();
  dialog->reject();
}

TEST_F(vehicle_window, lidars_of_other_recordings_keep_what_they_have) {
  ONLY_IN_LONG_TESTS();
  calibrate_together();
  vehicle().show(kRear);
  ASSERT_TRUE(settle());
  const RigidTransform rear = found();
  window_.open_paths({folder_->filePath("second")});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(QTest::qWaitFor([&] { return vehicle().lidars().size() == 3; }, kVehiclePatience_ms));
  EXPECT_FALSE(vehicle().shown()) << "sessions of rear and of front are open";
  EXPECT_TRUE(vehicle().common());
  vehicle().show(kFront);
  ASSERT_TRUE(settle());
  ASSERT_EQ(vehicle().shown(), kFront);
  EXPECT_EQ(workbench_.sessions().all().size(), 2u);
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_LT(difference(found(), truth_[0]).head<2>().norm(), 0.02);
  vehicle().show(kRear);
  ASSERT_TRUE(settle());
  ASSERT_EQ(vehicle().shown(), kRear);
  EXPECT_EQ(workbench_.sessions().all().size(), 1u) << "the second drive has none";
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_LT(difference(found(), rear).norm(), 1e-12);
  EXPECT_EQ(vehicle().others_to_save().size(), 2u);
  vehicle().tick(motion::LidarIndex{2}, false);
  workbench_.announce();  // as another window does
  EXPECT_EQ(vehicle().lidars().size(), 3u);
  while (workbench_.history().can_undo()) workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(workbench_.sessions().empty());
  while (workbench_.history().stack().canRedo()) workbench_.history().stack().redo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(vehicle().shown(), kRear);
  ASSERT_TRUE(workbench_.outcome().output());
  EXPECT_LT(difference(found(), rear).norm(), 1e-12);
}

TEST_F(vehicle_window, what_is_undone_while_it_runs_stays_undone) {
  calibrate_together();
  workbench_.decisions().decide({motion::PairIndex{2}}, motion::PairState::Rejected);
  ASSERT_TRUE(settle());
  vehicle().calibrate();
  ASSERT_TRUE(workbench_.activity().calibrating());
  workbench_.history().stack().undo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.outcome().output()->pairs.at(2).decided_by, motion::DecidedBy::Program);
  EXPECT_TRUE(workbench_.decisions().empty());
  EXPECT_TRUE(workbench_.outcome().whole()) << "solved with the decisions of now";
}

TEST_F(vehicle_window, a_method_that_finds_no_lidar_in_the_ins_frame_shows_no_numbers) {
  ONLY_IN_LONG_TESTS();
  calibrate_together();
  workbench_.setup().edit_option("run", "method", static_cast<int>(method_registry::MethodChoice("vehicle-frame")));
  workbench_.calibrations().calibrate();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(vehicle().up_to_date());
  EXPECT_EQ(cell(0, LidarTableModel::X), "–");
  EXPECT_TRUE(cell(1, LidarTableModel::X).contains("±")) << "the other has what it had";
  vehicle().calibrate();
  EXPECT_FALSE(workbench_.activity().calibrating()) << "pairwise is needed";
}

TEST_F(vehicle_window, a_file_with_several_mountings_gives_each_lidar_its_nominal) {
  const auto urdf = [](const char* one, const char* other) {
    const QString path = folder_->filePath("kit.urdf");
    const QString text = QString::fromUtf8(R"(<robot name="van"><link name="ins"/><link name="%1"/><link name="%2"/>
<joint name="a" type="fixed"><parent link="ins"/><child link="%1"/><origin xyz="1.8 0 0.8" rpy="0 0 0"/></joint>
<joint name="b" type="fixed"><parent link="ins"/><child link="%2"/><origin xyz="-1.2 0 1.1" rpy="0 0 2.9"/></joint>
</robot>)");
    gui::save_text(path, text.arg(one, other));
    return path;
  };
  QStringList doubts;
  const auto only_rear = gui::nominals_from_file(urdf("side_link", "rear_link"), workbench_, doubts);
  EXPECT_TRUE(only_rear.size() == 1 && only_rear.contains("rear")) << "front is shown, and has none in the file";
  EXPECT_TRUE(doubts.join(' ').contains("side_link") && doubts.join(' ').contains("front")) << doubts.size();
  EXPECT_THROW((void)gui::nominals_from_file(urdf("side_link", "left_link"), workbench_, doubts), Error);
  const auto nominals = gui::nominals_from_file(urdf("front_link", "rear_link"), workbench_, doubts);
  ASSERT_EQ(nominals.size(), 2u) << doubts.join(' ').toStdString();
  vehicle().edit_nominals(nominals);
  ASSERT_TRUE(workbench_.setup().nominal_ins_from_lidar());
  EXPECT_NEAR(workbench_.setup().nominal_ins_from_lidar()->translation().x(), 1.8, 1e-9);
  EXPECT_NEAR(vehicle().lidars()[1].nominal_ins_from_lidar->translation().x(), -1.2, 1e-9);
  workbench_.history().stack().undo();
  EXPECT_FALSE(vehicle().lidars()[1].nominal_ins_from_lidar);
  workbench_.history().stack().redo();
  vehicle().show(kRear);
  ASSERT_TRUE(settle());
  EXPECT_NEAR(workbench_.setup().nominal_ins_from_lidar()->translation().x(), -1.2, 1e-9)
      << "not what its drive declares";
}

TEST_F(vehicle_window, a_report_has_all_lidars) {
  calibrate_together();
  const QString path = folder_->filePath("vehicle.html");
  gui::make_vehicle_report(workbench_, path);
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }, kVehiclePatience_ms));
  QFile page(path);
  ASSERT_TRUE(page.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(page.readAll());
  EXPECT_TRUE(text.contains("front") && text.contains("rear") && text.contains("±")) << text.size() << " letters";
}

/// Names, ticks, recordings and results.
void expect_same_lidars(const gui::Vehicle& before, const gui::Vehicle& later) {
  ASSERT_EQ(later.lidars().size(), before.lidars().size());
  for (motion::LidarIndex l; l < before.lidars().size(); ++l) {
    const gui::VehicleLidar &was = before.lidars()[l], &is = later.lidars()[l];
    EXPECT_EQ(is.name(), was.name());
    EXPECT_EQ(is.ticked, was.ticked) << was.name();
    EXPECT_EQ(is.recorded.recordings.size(), was.recorded.recordings.size()) << was.name();
    const auto result_before = before.output_of(l), result_later = later.output_of(l);
    ASSERT_EQ(result_later != nullptr, result_before != nullptr) << was.name();
    std::printf("  %s: %zu recordings%s\n", is.name().c_str(), is.recorded.recordings.size(),
                result_later ? ", calibrated" : "");
    if (!result_before) continue;
    const double apart = difference(result_before->result.mounting.reference_from_sensor,
                                    result_later->result.mounting.reference_from_sensor)
                             .norm();
    EXPECT_LT(apart, 1e-9) << was.name();
  }
}

TEST_F(vehicle_window, a_project_of_mixed_sessions_loses_no_lidar) {
  ONLY_IN_LONG_TESTS();
  calibrate_together();
  vehicle().show(kRear);
  ASSERT_TRUE(settle());
  window_.open_paths({folder_->filePath("second")});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(QTest::qWaitFor([&] { return vehicle().lidars().size() == 3; }, kVehiclePatience_ms));
  ASSERT_FALSE(vehicle().shown());
  const std::vector<gui::SavedLidar> saved = vehicle().others_to_save();
  ASSERT_EQ(saved.size(), 3u);
  EXPECT_TRUE(saved[0].output) << "front";
  EXPECT_TRUE(saved[1].output) << "rear, which was worked on";
  vehicle().tick(kRear, false);

  gui::Workbench later{gui::model_engine()};
  ASSERT_NO_FATAL_FAILURE(save_and_open(folder_->filePath("mixed.remount"), later));
  EXPECT_FALSE(later.vehicle().shown());
  expect_same_lidars(vehicle(), later.vehicle());
  EXPECT_TRUE(later.vehicle().output_of(kFront) && later.vehicle().output_of(kRear));
}

TEST_F(vehicle_window, one_ticked_lidar_is_no_vehicle) {
  vehicle().tick(kRear, false);
  vehicle().calibrate();
  EXPECT_FALSE(workbench_.activity().calibrating());
  vehicle().tick(kRear, true);
  vehicle().calibrate();
  EXPECT_TRUE(workbench_.activity().calibrating());
  workbench_.cancel();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(vehicle().common()) << "cancelled";
  EXPECT_EQ(vehicle().shown(), kFront);
}

}  // namespace
}  // namespace remount::widgets
