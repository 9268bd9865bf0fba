#include "model/results/vehicle_file.h"

#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "model/formats/documents/parse_document.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/full_records.h"
#include "tests/support/members.h"

namespace remount::results {
namespace {

using Names = std::set<std::string>;

VehicleFile vehicle_read_again(const VehicleFile& file, bool json) {
  const formats::DocumentNode document = vehicle_document(file);
  const formats::DocumentNode node = json ? formats::parse_json(formats::to_json(document), "v")
                                          : formats::parse_yaml(formats::to_yaml(document), "v");
  return vehicle_from_document(formats::DocumentView(node, "v"));
}

std::string error_with(const std::string& what, const std::string& instead) {
  std::string text = formats::to_yaml(vehicle_document(testing::full_vehicle_file()));
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what << " in\n" << text.substr(0, 3000);
  text.replace(at, what.size(), instead);
  try {
    const formats::DocumentNode node = formats::parse_yaml(text, "v");
    (void)vehicle_from_document(formats::DocumentView(node, "v"));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Format);
    return error.what();
  }
  return {};
}

TEST(vehicle_file, the_full_vehicle_leaves_no_member_as_it_is_from_the_first) {
  EXPECT_EQ(testing::members_not_set(testing::full_vehicle_file()), Names());
}

TEST(vehicle_file, every_member_of_a_vehicle_is_kept) {
  const VehicleFile file = testing::full_vehicle_file();
  for (const bool json : {false, true}) {
    Names lost = testing::members_that_differ(file, vehicle_read_again(file, json));
    std::erase_if(lost, [](const std::string& name) { return name.find(".noise.") != std::string::npos; });
    EXPECT_EQ(lost, Names()) << (json ? "json" : "yaml");
  }
}

TEST(vehicle_file, is_saved_and_loaded_in_both_notations) {
  const formats::TemporaryFolder folder;
  const VehicleFile file = testing::full_vehicle_file();
  for (const char* name : {"v.yaml", "v.json"}) {
    const std::filesystem::path path = folder.path() / name;
    save_vehicle(file, path);
    EXPECT_TRUE(is_vehicle_file(path));
    EXPECT_EQ(lidar_names(load_vehicle(path)), lidar_names(file));
  }
  const VehicleFile yaml = load_vehicle(folder.path() / "v.yaml");
  EXPECT_EQ(lidar_of(yaml, "rear", "v").file.method, "trajectory");
  EXPECT_EQ(lidar_of(yaml, "rear_link", "v").name, "rear") << "as it is meant";
  EXPECT_EQ(find_lidar(yaml, "left"), nullptr);
  EXPECT_THROW((void)lidar_of(yaml, "left", "v"), Error);
}

TEST(vehicle_file, damaged_files_are_refused_with_the_place) {
  EXPECT_NE(error_with("remount-vehicle/1", "remount-vehicle/9").find("remount-vehicle/9"), std::string::npos);
  EXPECT_NE(error_with("lidar_a: front", "lidar_a: left").find("name LiDARs that the file holds"), std::string::npos);
  EXPECT_NE(error_with("name: front", "name: rear").find("a name of its own"), std::string::npos);
  EXPECT_NE(error_with("  - name: front", "  - nome: front").find("name"), std::string::npos);
  EXPECT_NE(error_with("remount-result/2", "remount-result/7").find("remount-result/7"), std::string::npos);
  EXPECT_NE(error_with("height_m: 0.125", "height_m: high").find("height_m"), std::string::npos);
  EXPECT_NE(error_with("most_sigmas: 1.5", "most_sigma: 1.5").find("most_sigmas"), std::string::npos);
}

TEST(vehicle_file, what_names_a_lidar_goes_with_it) {
  VehicleFile file = testing::full_vehicle_file();
  keep_lidars(file, [](const LidarResult&) { return true; });
  EXPECT_EQ(testing::members_that_differ(file, testing::full_vehicle_file()), Names());
  keep_lidars(file, [](const LidarResult& lidar) { return lidar.name == "front"; });
  EXPECT_TRUE(file.relatives.empty());
  EXPECT_TRUE(file.agreements.empty());
  EXPECT_EQ(file.groups, (std::vector<std::vector<std::string>>{{"front"}}));
  EXPECT_EQ(lidar_names(vehicle_read_again(file, false)), (std::vector<std::string>{"front"}));
}

TEST(vehicle_file, is_no_result_of_one_lidar_and_is_not_replaced_by_one) {
  const formats::TemporaryFolder folder;
  const std::filesystem::path several = folder.path() / "several.yaml", one = folder.path() / "one.yaml";
  save_vehicle(testing::full_vehicle_file(), several);
  save_result(testing::full_result_file(), one);
  try {
    (void)load_result(several);
    FAIL() << "a vehicle passed as the result of one LiDAR";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("several LiDARs"), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)load_vehicle(one), Error);
  EXPECT_FALSE(is_vehicle_file(one));
  EXPECT_FALSE(is_vehicle_file(folder.path() / "none.yaml"));
  EXPECT_THROW(check_replaces_result(several), Error);
  EXPECT_THROW(check_replaces_vehicle(one), Error);
  EXPECT_NO_THROW(check_replaces_result(one));
  EXPECT_NO_THROW(check_replaces_vehicle(several));
}

TEST(vehicle_file, of_one_lidar_is_that_of_a_vehicle_with_one_that_has_no_name) {
  const formats::TemporaryFolder folder;
  const std::filesystem::path several = folder.path() / "several.yaml", one = folder.path() / "one.json";
  save_vehicle(testing::full_vehicle_file(), several);
  save_result(testing::full_result_file(), one);
  EXPECT_EQ(lidar_names(load_any_result(several)), lidar_names(testing::full_vehicle_file()));
  const VehicleFile vehicle = load_any_result(one);
  EXPECT_EQ(lidar_names(vehicle), std::vector<std::string>{""});
  EXPECT_EQ(vehicle.version, testing::full_result_file().version);
  EXPECT_EQ(vehicle.lidars.front().file.pairs.size(), testing::full_result_file().pairs.size());
  EXPECT_THROW((void)load_any_result(folder.path() / "none.yaml"), Error);
}

TEST(vehicle_file, says_why_a_lidar_took_no_part) {
  VehicleFile vehicle = testing::full_vehicle_file();
  const auto explain = [](std::string_view code, const drive::Place& where, const char* words) {
    return drive::Finding{drive::Severity::Warning, std::string(code), where, Message::verbatim(words)};
  };
  LidarResult& lidar = vehicle.lidars.front();
  lidar.joined = false;
  vehicle.findings = {explain("lidars-contradict", lidar.name, "something else"),
                      explain(kLidarLeftOut, std::string("another"), "of another"),
                      explain(kLidarLeftOut, lidar.name, "it moved"),
                      explain(kLidarsNotJoined, Message::verbatim("all"), "none was solved")};
  EXPECT_EQ(english(why_not_joined(vehicle, lidar)), "it moved");
  vehicle.findings.erase(vehicle.findings.begin() + 2);
  EXPECT_EQ(english(why_not_joined(vehicle, lidar)), "none was solved");
  lidar.joined = true;
  EXPECT_TRUE(why_not_joined(vehicle, lidar).empty());
}

}  // namespace
}  // namespace remount::results
