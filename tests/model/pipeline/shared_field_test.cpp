#include "model/pipeline/shared_field.h"

#include <gtest/gtest.h>

#include "model/simulator/simulator.h"

namespace remount::pipeline {
namespace {

constexpr motion::SessionIndex kOfOne;

DriveMotion motion_of(const char* lidar) {
  simulator::SimulationOptions options;
  options.lidar.model = simulator::lidar_named(lidar);
  options.lidar.points_per_scan = 5000;
  options.duration_s = 5.0;
  return DriveMotion({std::make_shared<const drive::Session>(simulator::simulate_drive(options).session)});
}

RigidTransform turned(double yaw_deg, double ahead_m = 0.0) {
  return rigid_from_six({ahead_m, 0.0, 0.0, degrees_to_radians(yaw_deg), 0.0, 0.0});
}

TEST(shared_field, of_a_lidar_that_looks_all_around_all_is_common) {
  for (const char* lidar : {"spinning", "mid-360"}) {
    const SharedField field(motion_of(lidar), {});
    EXPECT_FALSE(field.any_narrow()) << lidar;
    EXPECT_EQ(field.share(kOfOne, turned(90.0)), 1.0) << "exactly, for limits are multiplied by it";
  }
}

TEST(shared_field, of_a_lidar_that_looks_ahead_a_turn_leaves_less_the_narrower_its_field_is) {
  const SharedField rosette(motion_of("mid-70"), {}), narrow(motion_of("mid-40"), {}), raster(motion_of("m1"), {});
  for (const SharedField* field : {&rosette, &narrow, &raster}) {
    EXPECT_TRUE(field->any_narrow());
    EXPECT_GT(field->share(kOfOne, RigidTransform::Identity()), 0.99);
    EXPECT_LT(field->share(kOfOne, turned(130.0)), 0.01);
    double before = 1.0;
    for (const double yaw_deg : {10.0, 20.0, 30.0}) {
      const double share = field->share(kOfOne, turned(yaw_deg));
      EXPECT_LT(share, before);
      before = share;
    }
  }
  std::printf("  turned by 30 deg: mid-70 %.2f, mid-40 %.2f, m1 %.2f\n", rosette.share(kOfOne, turned(30.0)),
              narrow.share(kOfOne, turned(30.0)), raster.share(kOfOne, turned(30.0)));
  EXPECT_LT(narrow.share(kOfOne, turned(30.0)), rosette.share(kOfOne, turned(30.0)));
  EXPECT_LT(rosette.share(kOfOne, turned(30.0)), raster.share(kOfOne, turned(30.0)));
}

TEST(shared_field, what_is_passed_is_no_longer_seen) {
  const SharedField field(motion_of("mid-70"), {});
  const double near = field.share(kOfOne, turned(0.0, -2.0)), far = field.share(kOfOne, turned(0.0, -15.0));
  std::printf("  2 m on %.2f, 15 m on %.2f\n", near, far);
  EXPECT_GT(near, far);
  EXPECT_LT(far, 0.9);
}

TEST(shared_field, cancelled_takes_all_for_common) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(SharedField(motion_of("mid-70"), Progress(stop.get_token())).any_narrow());
}

}  // namespace
}  // namespace remount::pipeline
