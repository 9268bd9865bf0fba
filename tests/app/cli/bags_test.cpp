// Bags on the command line: from a simulated drive to its mounting.
#include <gtest/gtest.h>

#include "algorithms/geometry/rotation.h"
#include "model/fleet/fleet.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/project/project.h"
#include "tests/app/cli/program_fixture.h"
#include "tests/support/draws.h"

namespace remount::cli {
namespace {

class cli_bags : public ProgramFixture<cli_bags> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive("--format mcap --duration-s 8 --beams 16 --azimuth-steps 360 --seed 7");
  }
};

TEST_F(cli_bags, are_listed_topic_by_topic) {
  const Outcome listed = run("inspect " + path("drive") + " -q");
  EXPECT_EQ(listed.code, 0) << listed.err;
  const Outcome spoken = run("inspect " + path("drive"));
  for (const char* line : {"/lidar/points (sensor_msgs/PointCloud2): ", "used as lidar", "used as ins\n",
                           "used as ins-position", "/imu/data (sensor_msgs/Imu): ", "used as imu", "used as gnss"})
    EXPECT_NE(spoken.out.find(line), std::string::npos) << line << " in\n" << spoken.out;
}

TEST_F(cli_bags, are_calibrated_to_the_truth) {
  const std::string result = path("result.yaml"), project = path("job.remount");
  const Outcome done = run("calibrate " + path("drive") + " --topic ins=/ins/imu --no-hashes -q -o " + result +
                           " --save-project " + project);
  ASSERT_EQ(done.code, 0) << done.err;
  const results::ResultFile file = results::load_result(result);
  const formats::DocumentNode truth_document = formats::read_document(path("drive/truth.yaml"));
  const RigidTransform truth =
      formats::transform_from_document(formats::DocumentView(truth_document, "truth.yaml").at("ins_from_lidar"));
  const RigidTransform error = truth.inverse() * file.result.mounting.reference_from_sensor;
  const double apart_m = error.translation().norm(), apart_deg = radians_to_degrees(so3_log(error.linear()).norm());
  std::cout << "from a bag: " << apart_m << " m and " << apart_deg << " deg from the truth\n";
  EXPECT_LT(apart_m, 0.15);
  EXPECT_LT(apart_deg, 0.5);
  EXPECT_EQ(project::load_project(project).topics_of(0), (drive::TopicChoice{{"ins", "/ins/imu"}}));
  ASSERT_EQ(file.topics.size(), 1U) << "the result says of which topics it is, suggested ones as well";
  EXPECT_EQ(file.topics[0].topics, (drive::TopicChoice{{"lidar", "/lidar/points"},
                                                       {"ins", "/ins/imu"},
                                                       {"ins-position", "/ins/fix"},
                                                       {"imu", "/imu/data"},
                                                       {"gnss", "/gnss/fix"}}));
}

TEST_F(cli_bags, a_fleet_chooses_their_topics_and_notices_when_it_chooses_others) {
  ONLY_IN_LONG_TESTS();
  const auto fleet = [](const std::string& vehicle) {
    std::ofstream(path("bags.yaml")) << "format: remount-fleet/1\nsettings: {run: {map_check: false}}\n"
                                     << "topics: {ins: /ins/imu, ins-position: /ins/fix}\nvehicles:\n"
                                     << "  - {name: v, " << vehicle << "sessions: [drive]}\n";
    return fleet::load_fleet(path("bags.yaml"));
  };
  const std::string job = "batch " + path("bags.yaml") + " --job 1", table = "batch " + path("bags.yaml") + " --table";
  const auto says = [](const Outcome& outcome, int code, const std::string& words) {
    EXPECT_EQ(outcome.code, code) << outcome.out << outcome.err;
    EXPECT_NE((outcome.out + outcome.err).find(words), std::string::npos) << words << " in\n"
                                                                          << outcome.out << outcome.err;
  };
  const fleet::Fleet all = fleet("");
  says(run(job), 0, "there is no result yet");
  EXPECT_EQ(results::load_result(all.jobs[0].result).topics.at(0).topics.at("gnss"), "/gnss/fix") << "suggested";
  says(run(job), 0, "done already");
  says(run(table), 0, "1 solved");
  fleet("topics: {gnss: /ins/fix}, ");
  says(run(table), 3, "out of date, topics: gnss is /ins/fix, it was /gnss/fix");
  says(run(job), 0, "gnss is /ins/fix, it was /gnss/fix");
  says(run(table), 0, "1 solved");
  fleet("");
  says(run(table), 3, "gnss is /gnss/fix, it was /ins/fix");
  says(run(job), 0, "gnss is /gnss/fix, it was /ins/fix");
  fleet("topics: {lidar: /rear/points}, ");
  says(run(job), 1, "is no topic of this bag");
}

TEST_F(cli_bags, a_result_that_knows_no_topics_is_done_where_nobody_asks_for_any) {
  std::ofstream(path("plain.yaml")) << "format: remount-fleet/1\nsettings: {run: {map_check: false}}\n"
                                    << "vehicles: [{name: v, sessions: [drive]}]\n";
  const std::string job = "batch " + path("plain.yaml") + " --job 1";
  ASSERT_EQ(run(job).code, 0);
  const std::filesystem::path result = fleet::load_fleet(path("plain.yaml")).jobs[0].result;
  results::ResultFile former = results::load_result(result);
  EXPECT_TRUE(former.topics.at(0).asked.empty());
  former.topics.clear();
  results::save_result(former, result);
  const Outcome again = run(job);
  EXPECT_NE(again.out.find("done already"), std::string::npos) << again.out << again.err;
}

TEST_F(cli_bags, that_do_not_have_a_topic_say_which_they_have) {
  const Outcome wrong = run("inspect " + path("drive") + " --topic lidar=/velodyne_points");
  EXPECT_EQ(wrong.code, 1) << "a wrong option, as calibrate says";
  EXPECT_NE(wrong.err.find("/lidar/points"), std::string::npos) << wrong.err;
  const Outcome other = run("inspect " + path("drive") + " --topic lidar=/ins/imu");
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.err.find("cannot serve as lidar; what it can be: ins, imu"), std::string::npos) << other.err;
  EXPECT_EQ(run("inspect " + path("drive") + " --topic camera=/x").code, 1);
  EXPECT_EQ(run("calibrate " + path("drive") + " --topic lidar=/velodyne_points").code, 1);
}

}  // namespace
}  // namespace remount::cli
