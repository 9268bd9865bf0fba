#include "model/report/vehicle_comparison.h"

#include <gtest/gtest.h>

#include <utility>

#include "algorithms/messages/render.h"
#include "tests/support/built_vehicle.h"

namespace remount::report {
namespace {

using testing::as_built, testing::Mountings, testing::vehicle_with;

std::string words_of(const ComparedVehicles& compared) {
  std::string text;
  for (const Message& words : compared.words) text += english(words) + "\n";
  return text;
}

TEST(vehicle_comparison, the_same_vehicle_agrees) {
  const NamedVehicle vehicle = vehicle_with("monday", as_built());
  const ComparedVehicles compared = compare_vehicles(vehicle, vehicle_with("friday", as_built()));
  EXPECT_TRUE(compared.agree());
  EXPECT_EQ(compared.lidars.size(), 3U);
  EXPECT_TRUE(compared.moved.empty());
  EXPECT_TRUE(compared.words.empty()) << words_of(compared);
}

TEST(vehicle_comparison, the_lidar_that_moved_is_named) {
  Mountings later = as_built();
  later["rear"] = later["rear"] * rigid_from_six({0.03, 0, 0, 0.01, 0, 0});
  const ComparedVehicles compared = compare_vehicles(vehicle_with("a", as_built()), vehicle_with("b", later));
  EXPECT_FALSE(compared.agree());
  EXPECT_FALSE(compared.ins_moved);
  EXPECT_EQ(compared.moved, (std::vector<std::string>{"rear"}));
  EXPECT_NE(words_of(compared).find("rear. The other LiDARs sit as before"), std::string::npos) << words_of(compared);
  NamedVehicle without_roof = vehicle_with("b", later);
  for (results::LidarResult& lidar : without_roof.file.lidars)
    if (lidar.name == "roof") lidar.file.result.status = calibration::Status::TooFewPairs;
  const std::string words = words_of(compare_vehicles(vehicle_with("a", as_built()), without_roof));
  EXPECT_NE(words.find("rear. Not all other LiDARs could be compared"), std::string::npos) << words;
}

TEST(vehicle_comparison, what_all_lidars_have_in_common_is_the_ins) {
  const RigidTransform moved_from_ins = rigid_from_six({0.03, -0.02, 0.02, 0.01, 0.005, 0});
  Mountings later = as_built();
  for (auto& [name, ins_from_lidar] : later) ins_from_lidar = moved_from_ins * ins_from_lidar;
  const ComparedVehicles compared = compare_vehicles(vehicle_with("a", as_built()), vehicle_with("b", later));
  EXPECT_FALSE(compared.agree());
  EXPECT_TRUE(compared.ins_moved);
  EXPECT_TRUE(compared.moved.empty());
  EXPECT_NE(words_of(compared).find("it was the INS"), std::string::npos) << words_of(compared);
  for (const ComparedLidar& lidar : compared.lidars) {
    EXPECT_TRUE(compared.moved_with_ins(lidar)) << lidar.name;
    const std::string words = english(lidar.results.words);
    EXPECT_EQ(words.find("the LiDAR was moved"), std::string::npos) << words;
    EXPECT_EQ(words.find("a " + lidar.name + " and b " + lidar.name + ": "), 0U) << words;
  }
  NamedVehicle in_another_order = vehicle_with("b", later);
  for (results::RelativeRecord& two : in_another_order.file.relatives) {
    std::swap(two.lidar_a, two.lidar_b);
    two.lidar_a_from_lidar_b = two.lidar_a_from_lidar_b.inverse();
  }
  EXPECT_TRUE(compare_vehicles(vehicle_with("a", as_built()), in_another_order).ins_moved);
  later["roof"] = later["roof"] * rigid_from_six({0, 0, 0, 0.02, 0, 0});
  const ComparedVehicles both = compare_vehicles(vehicle_with("a", as_built()), vehicle_with("b", later));
  EXPECT_TRUE(both.ins_moved);
  EXPECT_EQ(both.moved, (std::vector<std::string>{"roof"}));
  for (const ComparedLidar& lidar : both.lidars) EXPECT_EQ(both.moved_with_ins(lidar), lidar.name != "roof");
}

TEST(vehicle_comparison, lidars_that_are_called_after_topics_are_found) {
  const auto in_bag = [](const Mountings& mountings) {
    NamedVehicle vehicle = vehicle_with("bag", mountings);
    for (results::LidarResult& lidar : vehicle.file.lidars) lidar.name = "/lidar_" + lidar.name + "/points";
    for (results::RelativeRecord& two : vehicle.file.relatives)
      two.lidar_a = "/lidar_" + two.lidar_a + "/points", two.lidar_b = "/lidar_" + two.lidar_b + "/points";
    return vehicle;
  };
  const RigidTransform moved_from_ins = rigid_from_six({0.03, -0.02, 0.02, 0.01, 0.005, 0});
  Mountings later = as_built();
  for (auto& [name, ins_from_lidar] : later) ins_from_lidar = moved_from_ins * ins_from_lidar;
  for (const bool bag_first : {false, true}) {
    const NamedVehicle native = vehicle_with("native", as_built()), bag = in_bag(later);
    const ComparedVehicles compared = bag_first ? compare_vehicles(bag, native) : compare_vehicles(native, bag);
    EXPECT_EQ(compared.lidars.size(), 3U);
    EXPECT_TRUE(compared.only_first.empty() && compared.only_second.empty());
    EXPECT_TRUE(compared.ins_moved) << words_of(compared);
    ASSERT_EQ(compared.notes.size(), 3U);
    std::printf("  %s\n", english(compared.notes.front()).c_str());
    EXPECT_EQ(compared.lidars.front().name, bag_first ? "/lidar_front/points" : "front");
    EXPECT_EQ(compared.lidars.front().other_name, bag_first ? "front" : "/lidar_front/points");
  }
  NamedVehicle others = in_bag(later);
  for (results::LidarResult& lidar : others.file.lidars) lidar.name = "unknown_" + std::to_string(lidar.name.size());
  others.file.relatives.clear();
  const std::string words = words_of(compare_vehicles(vehicle_with("native", as_built()), others));
  EXPECT_NE(words.find("one by one as yaml"), std::string::npos) << words;
}

TEST(vehicle_comparison, lidars_that_all_moved_on_their_own_are_not_the_ins) {
  Mountings later = as_built();
  for (auto& [name, ins_from_lidar] : later) ins_from_lidar = ins_from_lidar * rigid_from_six({0.05, 0, 0, 0, 0, 0});
  const ComparedVehicles compared = compare_vehicles(vehicle_with("a", as_built()), vehicle_with("b", later));
  EXPECT_FALSE(compared.ins_moved);
  EXPECT_EQ(compared.moved.size(), 3U);
  // Where it is not known how they sat against each other, nothing says that they moved alike.
  NamedVehicle bare = vehicle_with("a", as_built());
  bare.file.relatives.clear();
  for (auto& [name, ins_from_lidar] : later) ins_from_lidar = rigid_from_six({0.03, 0, 0, 0, 0, 0}) * as_built()[name];
  EXPECT_FALSE(compare_vehicles(bare, vehicle_with("b", later)).ins_moved);
}

TEST(vehicle_comparison, lidars_that_only_one_has_are_told_and_those_without_a_result_do_not_agree) {
  Mountings fewer = as_built();
  fewer.erase("roof");
  const ComparedVehicles compared = compare_vehicles(vehicle_with("a", as_built()), vehicle_with("b", fewer));
  EXPECT_TRUE(compared.agree());
  EXPECT_EQ(compared.only_first, (std::vector<std::string>{"roof"}));
  EXPECT_NE(words_of(compared).find("Only a has: roof"), std::string::npos) << words_of(compared);
  NamedVehicle none = vehicle_with("b", fewer);
  none.file.lidars[0].file.result.status = calibration::Status::TooFewPairs;
  EXPECT_FALSE(compare_vehicles(vehicle_with("a", fewer), none).agree());
  EXPECT_FALSE(compare_vehicles(vehicle_with("a", {}), none).agree());
}

}  // namespace
}  // namespace remount::report
