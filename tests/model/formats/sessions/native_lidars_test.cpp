#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/growing_session.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/overview/session_report.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

const std::string kScansOfFront =
    "scans: {directory: front/scans, type: kitti-bin, stamps: from-names, timing: instant}";
const std::string kScansOfRear = "scans: {directory: rear, type: kitti-bin, stamps: rear.csv, timing: instant}";

/// A vehicle of two LiDARs that saw the same two seconds, of which one stamped three scans and the other two.
class native_lidars : public ::testing::Test {
 protected:
  native_lidars() {
    folder_.write("ins.txt", "1600000000 0 0 0 0 0 0 1\n1600000001 1 0 0 0 0 0 1\n1600000002 3 0 0 0 0 0 1\n");
    for (const char* name : {"1600000000.1", "1600000000.6", "1600000001.1"})
      folder_.write(std::string("front/scans/") + name + ".bin", std::string(32, '\x3f'));
    folder_.write("rear/a.bin", std::string(48, '\x3f'));
    folder_.write("rear/b.bin", std::string(64, '\x3f'));
    folder_.write("rear.csv", "file,stamp_ns\na.bin,1600000000250000000\nb.bin,1600000000750000000\n");
    folder_.write("roof.txt", "1600000000 0 0 0 0 0 0 1\n1600000001 1 0 0 0 0 0 1\n");
  }
  /// @param lidars what stands below the key, an entry a line
  void declare(const std::vector<std::string>& lidars, const std::string& more = "") {
    std::string text =
        "format: remount-session/1\nname: van\nins_poses: {file: ins.txt, format: tum}\n" + more + "lidars:\n";
    for (const std::string& lidar : lidars) text += "  " + lidar + "\n";
    folder_.write("session.yaml", text);
  }
  void declare_van() {
    declare({"front: {" + kScansOfFront +
                 ", lidar: solid-state, nominal: {x_m: 2, y_m: 0, z_m: 1, yaw_deg: 0, "
                 "pitch_deg: 0, roll_deg: 0}}",
             "rear-left_2: {" + kScansOfRear + ", lidar: spinning}",
             "roof: {lidar_poses: {file: roof.txt, format: tum}}"});
  }
  drive::Session open_lidar(const drive::TopicChoice& choice) {
    Progress progress;
    return open_session(folder_.path(), choice, progress, checks::LookAt::Streams);
  }
  std::string refusal(const drive::TopicChoice& choice = {}) {
    return error_of([&] { open_lidar(choice); });
  }
  TemporaryFolder folder_;
};

TEST_F(native_lidars, each_is_a_session_with_the_same_ins) {
  declare_van();
  Progress progress;
  const std::vector<drive::LidarOffer> offers = offer_lidars(folder_.path(), progress);
  ASSERT_EQ(offers.size(), 3u);
  EXPECT_EQ(offers[0].scans, 3u);
  EXPECT_EQ(offers[1].scans, 2u);
  EXPECT_FALSE(offers[2].scans);
  std::vector<std::string> names;
  for (const drive::LidarOffer& offer : offers) {
    const drive::Session session = open_lidar(offer.choice);
    names.push_back(offer.name);
    EXPECT_EQ(session.lidar_name, offer.name);
    EXPECT_EQ(session.topic_choice, offer.choice);
    EXPECT_EQ(drive::choice_in_use(session.topics), offer.choice);
    EXPECT_EQ(session.world_from_ins.size(), 3u);
    EXPECT_FALSE(find(session, "lidar-chosen"));
    EXPECT_EQ(session.scans ? std::optional(session.scans->size()) : std::nullopt, offer.scans);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"front", "rear-left_2", "roof"}));
  const drive::Session front = open_lidar(offers[0].choice), rear = open_lidar(offers[1].choice);
  EXPECT_EQ(front.lidar, cloud::LidarKind::SolidState);
  EXPECT_EQ(rear.lidar, cloud::LidarKind::Spinning);
  ASSERT_TRUE(front.nominal_ins_from_lidar);
  EXPECT_EQ(front.nominal_ins_from_lidar->translation(), Eigen::Vector3d(2.0, 0.0, 1.0));
  EXPECT_FALSE(rear.nominal_ins_from_lidar);
  EXPECT_EQ(rear.scans->stamp_ns(1), 1'600'000'000'750'000'000);
  EXPECT_EQ(rear.scans->load(1).size(), 4u);
  EXPECT_EQ(open_lidar(offers[2].choice).odometry_from_lidar.size(), 2u);
}

TEST_F(native_lidars, without_a_choice_the_first_is_read_and_the_others_are_named) {
  declare_van();
  const drive::Session session = open_lidar({});
  EXPECT_EQ(session.lidar_name, "front");
  const drive::Finding* finding = find(session, "lidar-chosen");
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, drive::Severity::Note);
  EXPECT_TRUE(contains(english(finding->explanation), "rear-left_2, roof")) << english(finding->explanation);
  ASSERT_EQ(session.topics.size(), 3u);
  EXPECT_EQ(session.topics[1].count, 2u);
  EXPECT_EQ(drive::choice_in_use(session.topics), (drive::TopicChoice{{"lidar", "front"}}));
  Progress progress;
  const std::string text = overview::describe(session, overview::report_session(session, progress));
  for (const char* line : {"front (scans): 3, used as lidar\n", "roof (lidar_poses): not used; could be lidar\n"})
    EXPECT_TRUE(contains(text, line)) << line << " in\n" << text;
  declare({"only: {" + kScansOfFront + "}"});
  const drive::Session alone = open_lidar({});
  EXPECT_EQ(alone.lidar_name, "only");
  EXPECT_FALSE(find(alone, "lidar-chosen"));
  EXPECT_TRUE(alone.topics.empty());
}

TEST_F(native_lidars, are_topics_to_choose_from_where_there_are_several) {
  declare_van();
  Progress progress;
  const auto offer = offer_topics(folder_.path(), progress);
  ASSERT_TRUE(offer);
  ASSERT_EQ(offer->topics.size(), 3u);
  EXPECT_FALSE(drive::is_ambiguous(offer->topics)) << "each is a LiDAR";
  EXPECT_EQ(offer->open({{"lidar", "roof"}}, progress).lidar_name, "roof");
  declare({"only: {" + kScansOfFront + "}"});
  EXPECT_FALSE(offer_topics(folder_.path(), progress));
}

TEST_F(native_lidars, one_that_has_no_name_stays_without) {
  folder_.write("session.yaml", "format: remount-session/1\nname: car\nins_poses: {file: ins.txt, format: tum}\n" +
                                    kScansOfFront + "\n");
  Progress progress;
  const std::vector<drive::LidarOffer> offers = offer_lidars(folder_.path(), progress);
  ASSERT_EQ(offers.size(), 1u);
  EXPECT_EQ(offers[0].name, "");
  EXPECT_TRUE(offers[0].choice.empty());
  EXPECT_EQ(offers[0].scans, 3u);
  EXPECT_EQ(open_lidar(offers[0].choice).lidar_name, "");
  EXPECT_TRUE(contains(refusal({{"lidar", "front"}}), "no topics to choose"));
}

TEST_F(native_lidars, can_be_left_out) {
  declare_van();
  const drive::Session session = open_lidar({{"lidar", "none"}});
  EXPECT_FALSE(session.scans);
  EXPECT_EQ(session.world_from_ins.size(), 3u);
  EXPECT_EQ(session.lidar_name, "");
}

TEST_F(native_lidars, what_is_wrong_is_named_with_its_line) {
  const auto expect_refused = [&](const std::vector<std::string>& lidars, const std::string& part,
                                  const std::string& more = "") {
    declare(lidars, more);
    EXPECT_TRUE(contains(refusal(), part)) << "message: '" << refusal() << "', expected: '" << part << "'";
  };
  const std::string front = "front: {" + kScansOfFront + "}";
  expect_refused({front, "front: {" + kScansOfRear + "}"}, "front");
  expect_refused({front, "a/b: {" + kScansOfRear + "}"}, "session.yaml:6");
  expect_refused({front, "a/b: {" + kScansOfRear + "}"}, "'a/b' is no name of a LiDAR");
  expect_refused({std::string(65, 'a') + ": {" + kScansOfFront + "}"}, "is no name of a LiDAR");
  expect_refused({"'': {" + kScansOfFront + "}"}, "is no name of a LiDAR");
  expect_refused({"front: {lidar: spinning}"}, "expected either 'scans' or 'lidar_poses'");
  expect_refused({"front: {" + kScansOfFront + ", lidar_poses: {file: roof.txt, format: tum}}"},
                 "expected either 'scans' or 'lidar_poses'");
  expect_refused({"front: {" + kScansOfFront + ", ins_noise: {position_sigma_m: 1}}"}, "ins_noise");
  expect_refused({"front: {" + kScansOfFront + ", nominal: {x_m: 1}}"}, "session.yaml:5");
  expect_refused({"front: 3"}, "session.yaml:5");
  expect_refused({front}, "'lidar' stands within lidars", "lidar: spinning\n");
  expect_refused({front}, "'scans' stands within lidars", kScansOfRear + "\n");
  expect_refused({front}, "only where lidar_poses are given", "clocks: unsynchronised\n");
  expect_refused({"[]"}, "session.yaml");
  std::vector<std::string> many;
  for (int i = 0; i < 65; ++i) many.push_back("l" + std::to_string(i) + ": {" + kScansOfFront + "}");
  expect_refused(many, "one to 64");
  many.pop_back();
  declare(many);
  EXPECT_EQ(refusal(), "");
  declare_van();
  EXPECT_TRUE(contains(refusal({{"lidar", "left"}}), "front, rear-left_2, roof")) << refusal({{"lidar", "left"}});
  EXPECT_TRUE(contains(refusal({{"ins", "/imu"}}), "no topics to choose"));
}

TEST_F(native_lidars, what_is_wrong_with_one_does_not_keep_the_others) {
  declare({"front: {" + kScansOfFront + "}",
           "gone: {scans: {directory: gone, type: pcd, stamps: from-names, timing: instant}}"});
  Progress progress;
  const std::vector<drive::LidarOffer> offers = offer_lidars(folder_.path(), progress);
  ASSERT_EQ(offers.size(), 2u);
  EXPECT_FALSE(offers[1].scans);
  EXPECT_EQ(refusal(offers[0].choice), "");
  EXPECT_TRUE(contains(refusal(offers[1].choice), "there is no folder"));
}

TEST_F(native_lidars, come_back_as_they_were_written) {
  declare_van();
  drive::Session front = open_lidar({{"lidar", "front"}}), roof = open_lidar({{"lidar", "roof"}});
  roof.lidar_name = "-2";  // would be an item of a list
  roof.nominal_ins_from_lidar = rigid_from_six({0.5, 0.0, 1.6, 0.2, 0.0, 0.0});
  const std::filesystem::path copy = folder_.path() / "copy";
  Progress progress;
  write_native_session({&front, &roof}, copy, 1, progress);
  const std::vector<drive::LidarOffer> offers = offer_lidars(copy, progress);
  ASSERT_EQ(offers.size(), 2u);
  const drive::Session first = open_session(copy, offers[0].choice, progress, checks::LookAt::Streams),
                       second = open_session(copy, offers[1].choice, progress, checks::LookAt::Streams);
  EXPECT_EQ(first.lidar_name, "front");
  EXPECT_EQ(first.lidar, cloud::LidarKind::SolidState);
  EXPECT_EQ(first.scans->stamp_ns(2), front.scans->stamp_ns(2));
  EXPECT_EQ(first.scans->load(2).points, front.scans->load(2).points);
  EXPECT_FALSE(second.scans);
  EXPECT_EQ(second.lidar_name, "-2");
  EXPECT_EQ(second.odometry_from_lidar.size(), roof.odometry_from_lidar.size());
  ASSERT_TRUE(second.nominal_ins_from_lidar);
  EXPECT_TRUE(second.nominal_ins_from_lidar->isApprox(*roof.nominal_ins_from_lidar, 1e-12));
  EXPECT_EQ(second.world_from_ins.size(), 3u);
}

TEST_F(native_lidars, are_not_written_without_names_of_their_own) {
  declare_van();
  drive::Session front = open_lidar({{"lidar", "front"}}), rear = open_lidar({{"lidar", "rear-left_2"}});
  const std::filesystem::path copy = folder_.path() / "copy";
  const auto refused = [&](const std::vector<const drive::Session*>& lidars) {
    Progress progress;
    return error_of([&] { write_native_session(lidars, copy, 1, progress); });
  };
  EXPECT_TRUE(contains(refused({&front, &front}), "two LiDARs are called front"));
  EXPECT_TRUE(contains(refused({}), "one to 64"));
  rear.lidar_name = "";
  EXPECT_TRUE(contains(refused({&front, &rear}), "is no name of a LiDAR"));
  rear.lidar_name = "/lidar_rear/points";
  EXPECT_TRUE(contains(refused({&front, &rear}), "is no name of a LiDAR"));
  rear.lidar_name = "rear";
  rear.scans = nullptr;
  EXPECT_NE(refused({&front, &rear}), "");
  EXPECT_FALSE(std::filesystem::exists(copy));
}

TEST_F(native_lidars, a_session_that_grows_is_opened_as_a_whole) {
  declare_van();
  GrowingSession first(folder_.path(), {}), rear(folder_.path(), {{"lidar", "rear-left_2"}});
  ASSERT_TRUE(first.look());
  EXPECT_EQ(first.look()->scans->size(), 3u);
  ASSERT_TRUE(rear.look());
  EXPECT_EQ(rear.look()->scans->size(), 2u);
}

}  // namespace
}  // namespace remount::formats
