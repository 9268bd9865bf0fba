#include "model/drive/topic_offer.h"

#include <gtest/gtest.h>

#include "model/formats/session_readers.h"
#include "tests/model/formats/bags/bag_maker.h"

namespace remount::drive {
namespace {

class topic_offer : public ::testing::Test {
 protected:
  std::filesystem::path path() const { return folder_.path() / "drive.bag"; }
  TopicOffer offered() const {
    Progress progress;
    std::optional<TopicOffer> offer = formats::offer_topics(path(), progress);
    if (!offer) throw Error(ErrorCode::Contract, path().string(), Message::verbatim("offers nothing"));
    return *offer;
  }
  static const OfferedTopic& find(const TopicOffer& offer, const std::string& name) {
    for (const OfferedTopic& offered : offer.topics)
      if (offered.topic.name == name) return offered;
    throw Error(ErrorCode::Contract, name, Message::verbatim("is not listed"));
  }
  static std::string why(const TopicOffer& offer, const std::string& name, std::string_view role) {
    const TopicUse* use = find(offer, name).use(role);
    return use ? english(use->why) : "it cannot be that";
  }
  static TopicChoice suggested(const TopicOffer& offer) {
    std::vector<SessionTopic> topics;
    for (const OfferedTopic& one : offer.topics) topics.push_back(one.topic);
    return choice_in_use(topics);
  }
  formats::TemporaryFolder folder_;
};

TEST_F(topic_offer, one_topic_a_role_leaves_nothing_to_ask) {
  bags::BagMaker bag(path());
  bag.add_ins("/ins", 41);
  bag.add_scans("/points", 20, 30);
  bag.add_odometry("/lidar/odometry", 41);  // by its name not of an INS
  bag.add(bags::kStart_ns, "/chatter", "std_msgs/String", "x");
  bag.finish();
  const TopicOffer offer = offered();
  EXPECT_FALSE(is_ambiguous(offer.topics));
  EXPECT_EQ(
      suggested(offer),
      (TopicChoice{{"lidar", "/points"}, {"ins", "/ins/imu"}, {"ins-position", "/ins/fix"}, {"gnss", "/ins/fix"}}));
  Progress progress;
  EXPECT_EQ(offer.open({}, progress).scans->size(), 20U);
}

TEST_F(topic_offer, says_of_every_topic_what_it_can_be_and_why_or_why_not) {
  bags::BagMaker bag(path());
  bag.add_ins("/ins", 41);
  bag.add_odometry("/ins/odometry", 41);
  bag.add_odometry("/lidar/odometry", 41);
  bag.add_scans("/front", 20, 30);
  bag.add_scans("/top", 20, 50, false);
  bag.add_scans("/map", 2, 5000, false);
  bag.add_static_transform("base", "lidar", 1.0);
  bag.add(bags::kStart_ns, "/tf", "tf2_msgs/TFMessage", "x");
  bag.add(bags::kStart_ns, "/camera", "sensor_msgs/Image", "x");
  bag.finish();
  const TopicOffer offer = offered();
  EXPECT_TRUE(is_ambiguous(offer.topics));
  EXPECT_EQ(why(offer, "/front", "lidar"), "scans of 30 points that have times");
  EXPECT_EQ(why(offer, "/top", "lidar"), "scans of 50 points without times");
  EXPECT_EQ(why(offer, "/map", "lidar"), "rare, as maps are: 5000 points");
  EXPECT_EQ(why(offer, "/ins/odometry", "ins"), "poses; the name speaks of an INS");
  EXPECT_EQ(why(offer, "/ins/imu", "ins"), "an orientation, to which fixes give the position");
  EXPECT_TRUE(find(offer, "/ins/imu").use("ins")->needs_position);
  EXPECT_EQ(why(offer, "/lidar/odometry", "ins"), "its name speaks of another sensor than an INS");
  EXPECT_FALSE(find(offer, "/lidar/odometry").use("ins")->unasked);
  EXPECT_TRUE(find(offer, "/tf_static").use(kNominalRole));
  EXPECT_EQ(english(find(offer, "/tf").unusable), "transforms that change with time are not read");
  EXPECT_EQ(english(find(offer, "/camera").unusable), "messages of this type are not read");
  for (const OfferedTopic& topic : offer.topics) {
    EXPECT_NE(topic.uses.empty(), topic.unusable.empty()) << topic.topic.name << " is one of the two";
    EXPECT_EQ(topic.uses.size(), topic.topic.can_be.size()) << topic.topic.name;
  }
  const TopicChoice suggestion = suggested(offer);
  EXPECT_EQ(suggestion.at("lidar"), "/front") << "its points have times";
  EXPECT_EQ(suggestion.at("ins"), "/ins/odometry");
  EXPECT_FALSE(suggestion.contains("ins-position")) << "the odometry has a position of its own";
  // The bag that was listed is the one that is read, with whatever was chosen; more than once.
  Progress progress;
  const Session session = offer.open({{"lidar", "/top"}, {"ins", "/ins/imu"}}, progress);
  EXPECT_EQ(session.scans->load(0).size(), 50U);
  EXPECT_EQ(session.topic_choice, (TopicChoice{{"lidar", "/top"}, {"ins", "/ins/imu"}}));
  EXPECT_EQ(session.ins.size(), 41U);
  EXPECT_EQ(offer.open(suggestion, progress).scans->load(0).size(), 30U);
  EXPECT_ERROR(offer.open({{"lidar", "/lidar/odometry"}, {"ins", "/lidar/odometry"}}, progress),
               "was chosen for lidar and for ins");
}

TEST_F(topic_offer, a_lidar_that_only_poses_could_be_is_asked_for) {
  bags::BagMaker bag(path());
  bag.add_odometry("/ins/odometry", 41);
  bag.add_odometry("/lidar/odometry", 41);
  bag.finish();
  const TopicOffer offer = offered();
  EXPECT_TRUE(is_ambiguous(offer.topics));
  EXPECT_EQ(suggested(offer), (TopicChoice{{"lidar", "none"}, {"ins", "/ins/odometry"}}));
}

TEST_F(topic_offer, only_bags_have_topics) {
  Progress progress;
  const std::filesystem::path log = folder_.write("other/a.log", formats::inspvaxa(2183, 100.0, 90.0));
  EXPECT_FALSE(formats::offer_topics(log, progress));
  EXPECT_ERROR(formats::offer_topics(folder_.path() / "none", progress), "does not exist");
  std::filesystem::remove(path());
  folder_.write("broken.bag", "#ROSBAG V2.0\n");
  EXPECT_ERROR(formats::offer_topics(folder_.path() / "broken.bag", progress), "broken.bag");
}

}  // namespace
}  // namespace remount::drive
