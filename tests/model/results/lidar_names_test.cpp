#include "model/results/lidar_names.h"

#include <gtest/gtest.h>

namespace remount::results {
namespace {

using LidarNames = std::vector<std::string>;

const LidarNames kTopics{"/lidar_front/points", "/lidar_rear/points", "/roof/points"};

TEST(lidar_names, a_part_of_a_topic_means_the_lidar_that_alone_has_it) {
  EXPECT_EQ(lidar_meant_by("/lidar_rear/points", kTopics), "/lidar_rear/points");
  EXPECT_EQ(lidar_meant_by("lidar_rear", kTopics), "/lidar_rear/points");
  EXPECT_EQ(lidar_meant_by("rear", kTopics), "/lidar_rear/points");
  EXPECT_EQ(lidar_meant_by("roof_base_link", kTopics), "/roof/points");
  EXPECT_EQ(lidar_meant_by("points", kTopics), "") << "all have it";
  EXPECT_EQ(lidar_meant_by("ear", kTopics), "");
  EXPECT_EQ(lidar_meant_by("", kTopics), "");
  EXPECT_EQ(lidar_meant_by("rear", {"rear", "/lidar_rear/points"}), "rear") << "what is called exactly so comes first";
}

TEST(lidar_names, of_two_recordings_say_which_lidars_are_the_same) {
  using Same = std::map<std::string, std::string>;
  const LidarNames names{"front", "rear", "left"};
  EXPECT_EQ(same_lidars(names, kTopics), (Same{{"/lidar_front/points", "front"}, {"/lidar_rear/points", "rear"}}));
  EXPECT_EQ(same_lidars(kTopics, names), (Same{{"front", "/lidar_front/points"}, {"rear", "/lidar_rear/points"}}));
  EXPECT_EQ(same_lidars(names, names), Same());
  EXPECT_EQ(same_lidars({"front"}, {"/a/front/points", "/b/front/points"}), Same()) << "not clear which";
  EXPECT_EQ(same_lidars({"front", "lidar_front"}, {"/lidar_front/points"}), Same()) << "not clear which";
}

}  // namespace
}  // namespace remount::results
