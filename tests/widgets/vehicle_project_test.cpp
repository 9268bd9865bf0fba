// A project that holds the LiDARs of a vehicle.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTableView>

#include "app/gui/document/result_files.h"
#include "tests/support/draws.h"
#include "tests/support/sanitized.h"
#include "tests/widgets/support/vehicle_window.h"

namespace remount::widgets {
namespace {

using testing::kFront;
using testing::kRear;
using testing::kVehiclePatience_ms;
using testing::vehicle_window;

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

}  // namespace
}  // namespace remount::widgets
