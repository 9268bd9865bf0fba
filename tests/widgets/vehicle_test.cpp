// A vehicle with two LiDARs in the window, on the model's own engine.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTableView>

#include "app/gui/document/result_files.h"
#include "app/gui/document/vehicle_report.h"
#include "app/gui/features/vehicle_export_dialog.h"
#include "tests/support/draws.h"
#include "tests/support/sanitized.h"
#include "tests/widgets/support/vehicle_window.h"
#include "widgets/basics/gl_support.h"
#include "widgets/map/map_view.h"
#include "widgets/result/export_dialog.h"

namespace remount::widgets {
namespace {

using testing::kFront;
using testing::kRear;
using testing::kVehiclePatience_ms;
using testing::vehicle_window;

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
