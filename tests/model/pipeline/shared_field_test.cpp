#include "model/pipeline/shared_field.h"

#include <gtest/gtest.h>

#include "model/pipeline/solve_stage.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"

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

// Where the vehicle hides a part of the turn each ring of a spinning LiDAR still errs for itself.
TEST(shared_field, beams_err_over_what_the_lidar_shows_unless_it_has_rings) {
  const auto nodes_of = [](const char* lidar, cloud::LidarKind kind, const cloud::BeamEstimate& known = {}) {
    PipelineInput input;
    input.settings.beams.lidar = kind;
    const DriveMotion motion = motion_of(lidar);
    return choose_beam_nodes(input, SharedField(motion, {}), known);
  };
  EXPECT_EQ(nodes_of("spinning", cloud::LidarKind::Unknown), cloud::BeamNodes::all_around());
  const cloud::BeamNodes ahead = nodes_of("m1", cloud::LidarKind::SolidState);
  ASSERT_TRUE(ahead.by_azimuth());
  EXPECT_NEAR(radians_to_degrees(ahead.azimuths_rad().front()), -60.0, 1.5);
  EXPECT_NEAR(radians_to_degrees(ahead.azimuths_rad().back()), 60.0, 1.5);
  EXPECT_EQ(nodes_of("m1", cloud::LidarKind::Unknown), ahead);
  EXPECT_EQ(nodes_of("m1", cloud::LidarKind::Spinning), cloud::BeamNodes::all_around());
  cloud::BeamEstimate all_around;
  all_around.nodes = cloud::BeamNodes::all_around();
  EXPECT_EQ(nodes_of("spinning", cloud::LidarKind::Unknown, all_around), all_around.nodes);
  EXPECT_ERROR(nodes_of("m1", cloud::LidarKind::Unknown, all_around), "another field of view");
}

TEST(shared_field, a_session_without_scans_says_nothing_of_the_field) {
  const DriveMotion ahead = motion_of("m1");
  auto poses = std::make_shared<drive::Session>(ahead.session(kOfOne));
  poses->scans = nullptr;
  const DriveMotion both({std::make_shared<const drive::Session>(ahead.session(kOfOne)), poses});
  EXPECT_EQ(SharedField(both, {}).beam_nodes(), SharedField(ahead, {}).beam_nodes());
}

TEST(shared_field, cancelled_takes_all_for_common) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(SharedField(motion_of("mid-70"), Progress(stop.get_token())).any_narrow());
}

}  // namespace
}  // namespace remount::pipeline
