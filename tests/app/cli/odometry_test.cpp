// The verb "odometry" as it is called.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

class cli_odometry : public ProgramFixture<cli_odometry> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive("--duration-s 1.5 --beams 12 --azimuth-steps 200 --ins-from-lidar 1.2,-0.3,0.8,5,1,-1");
  }
};

TEST_F(cli_odometry, writes_a_pose_for_every_scan_and_says_what_it_took_for_granted) {
  const Outcome outcome = run("odometry " + path("drive") + " --nominal 1.2,-0.3,0.8,5,1,-1 -o " + path("poses.txt"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("poses over"), std::string::npos) << outcome.out;
  const std::string text = text_of(path("poses.txt"));
  EXPECT_TRUE(text.starts_with("# t x y z qx qy qz qw")) << text.substr(0, 80);
  EXPECT_GE(std::count(text.begin(), text.end(), '\n'), 15);
  EXPECT_NE((outcome.out + outcome.err).find("fusion.ins_x_m"), std::string::npos) << outcome.out << outcome.err;
}

TEST_F(cli_odometry, without_a_nominal_it_uses_the_scans_alone) {
  const Outcome outcome = run("odometry " + path("drive") + " --nominal none -o " + path("alone.txt"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE((outcome.out + outcome.err).find("the scans alone"), std::string::npos) << outcome.out << outcome.err;
  EXPECT_EQ((outcome.out + outcome.err).find("Record wheel speeds"), std::string::npos) << "there are wheels";
}

TEST_F(cli_odometry, refuses_what_is_no_setting_and_overwrites_no_other_file) {
  EXPECT_EQ(run("odometry " + path("drive") + " -o " + path("x.txt") + " --set fusion.nonsense=1").code, 1);
  std::ofstream(path("mine.txt")) << "my notes\n";
  const Outcome outcome = run("odometry " + path("drive") + " -o " + path("mine.txt"));
  EXPECT_NE(outcome.code, 0);
  EXPECT_EQ(text_of(path("mine.txt")), "my notes\n");
}

}  // namespace
}  // namespace remount::cli
