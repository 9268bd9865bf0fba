#include <gtest/gtest.h>

#include <limits>

#include "tests/widgets/support/sample_world.h"
#include "widgets/scene/framing.h"
#include "widgets/scene/pair_scene.h"

namespace remount::widgets {
namespace {

TEST(framing, one_bad_coordinate_does_not_move_the_camera) {
  cloud::PointCloud cloud = testing::street_cloud(rigid_from_six(testing::kTruth), 1);
  const scene::Framing before = scene::robust_framing(cloud.points, RigidTransform::Identity());
  cloud.points.emplace_back(1e9F, 0.0F, 0.0F);
  cloud.points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F);
  const scene::Framing after = scene::robust_framing(cloud.points, RigidTransform::Identity());
  EXPECT_NEAR(after.radius_m, before.radius_m, 0.05 * before.radius_m);
  EXPECT_LT((after.centre_m - before.centre_m).norm(), 0.05 * before.radius_m);
}

TEST(framing, an_empty_cloud_has_a_view_all_the_same) {
  EXPECT_GT(scene::robust_framing({}, RigidTransform::Identity()).radius_m, 0.0);
}

TEST(pair_transforms, agree_under_the_true_mounting_and_differ_under_a_wrong_one) {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  pipeline::PipelineOutput output = testing::sample_output(input, 20);
  output.result.mounting.reference_from_sensor = rigid_from_six(testing::kTruth);
  const scene::PairTransforms transforms = scene::pair_transforms(output, motion::PairIndex{6});
  const auto apart = [](const RigidTransform& first, const RigidTransform& second) {
    return difference(first, second).norm();
  };
  EXPECT_LT(apart(transforms.current_lidar_b_from_lidar_a, transforms.registered_lidar_b_from_lidar_a), 1e-9);
  EXPECT_GT(apart(transforms.before_lidar_b_from_lidar_a, transforms.registered_lidar_b_from_lidar_a), 1e-3);
  output.pairs[6].registration.attempted = false;
  EXPECT_LT(apart(scene::pair_transforms(output, motion::PairIndex{6}).registered_lidar_b_from_lidar_a,
                  transforms.before_lidar_b_from_lidar_a),
            1e-12)
      << "without an alignment the prediction is shown";
}

TEST(pair_transforms, name_no_result_where_nothing_of_it_is_observed) {
  pipeline::PipelineInput input;
  input.sessions = {std::make_shared<const drive::Session>(testing::sample_session("drive1"))};
  pipeline::PipelineOutput output = testing::sample_output(input, 20);
  EXPECT_TRUE(scene::pair_transforms(output, motion::PairIndex{6}).current_known);
  output.result.status = calibration::Status::Inconsistent;
  EXPECT_TRUE(scene::pair_transforms(output, motion::PairIndex{6}).current_known) << "one looks at what contradicts";
  output.result.status = calibration::Status::TooFewPairs;
  EXPECT_FALSE(scene::pair_transforms(output, motion::PairIndex{6}).current_known);
  output.result.status = calibration::Status::Degenerate;
  output.result.set_observed({}, Message::verbatim("not shown by this drive"));
  EXPECT_FALSE(scene::pair_transforms(output, motion::PairIndex{6}).current_known);
  const RigidTransform candidate = rigid_from_six(testing::kTruth);
  EXPECT_TRUE(scene::pair_transforms(output, motion::PairIndex{6}, &candidate).current_known)
      << "a candidate is one whatever the result";
}

}  // namespace
}  // namespace remount::widgets
