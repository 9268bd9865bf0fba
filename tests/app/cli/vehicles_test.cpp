// Recordings with several LiDARs on the command line.
#include <gtest/gtest.h>

#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

class cli_vehicles : public ProgramFixture<cli_vehicles> {
 protected:
  static constexpr const char* kShort = " --duration-s 2 --beams 16 --azimuth-steps 200 ";
  static constexpr const char* kMounts =
      "--mount front=lidar:at128,at:1.2/0/1.6/0/0/-2.5,points:3000,phase:0.03 "
      "--mount rear=at:-1.5/0/0.9/180/0/0,rate:5,ring-elevation-deg:0.1,lidar-range-offset-m:0.02,beams:32 ";

  static void SetUpTestSuite() { make_folder_with_drive(std::string(kShort) + kMounts); }

  static void expect_refused(const std::string& mounts, const std::string& part) {
    const Outcome outcome = run("simulate street " + path("x") + kShort + mounts);
    EXPECT_EQ(outcome.code, 1) << mounts;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << part << " in\n" << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path("x")));
  }
};

void expect_said(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST_F(cli_vehicles, are_simulated_with_the_truth_of_each_lidar) {
  const std::string truth = text_of(path("drive/truth.yaml"));
  expect_said(truth, {"lidars:\n  front:\n    ins_from_lidar:", "\n  rear:\n", "lidar: at128", "scan_phase_s: 0.03",
                      "roll_deg: -2.5", "lidar_range_offset_m: 0.02", "beams: 32", "range_offset_m: 0.02"});
  EXPECT_TRUE(std::filesystem::exists(path("drive/front/scan_stamps.csv")));
  EXPECT_TRUE(std::filesystem::exists(path("drive/rear/scans")));
}

TEST_F(cli_vehicles, inspect_lists_the_lidars_and_looks_at_the_one_that_is_named) {
  const Outcome first = run("inspect " + path("drive")), rear = run("inspect " + path("drive") + " --topic lidar=rear");
  expect_said(first.out,
              {"LiDARs of this recording", "  front: 19 scans (this one)\n", "  rear: 10 scans\n", "not read: rear"});
  expect_said(rear.out, {"  front: 19 scans\n", "  rear: 10 scans (this one)\n"});
  EXPECT_EQ(run("inspect " + path("drive") + " --topic lidar=left").code, 1);
  ASSERT_EQ(run("simulate flat " + path("bag") + kShort + kMounts + "--format mcap").code, 0);
  const Outcome bag = run("inspect " + path("bag"));
  expect_said(bag.out, {"  /lidar_front/points: 19 scans", "  /lidar_rear/points: 10 scans"});
  ASSERT_EQ(run("simulate flat " + path("one") + kShort).code, 0);
  EXPECT_EQ(run("inspect " + path("one")).out.find("LiDARs of this recording"), std::string::npos);
}

TEST_F(cli_vehicles, mounts_that_are_none_are_refused) {
  expect_refused("--mount front", "expected NAME=KEY:VALUE");
  expect_refused("--mount front=beams", "expected NAME=KEY:VALUE");
  expect_refused("--mount front=beams:0", "beams");
  expect_refused("--mount front=beams:many", "expected a number, not 'many'");
  expect_refused("--mount front=beams:16.5", "beams");
  expect_refused("--mount front=beams:16,beams:32", "stands twice");
  expect_refused("--mount front=lidar:radar", "'radar' is not one of");
  expect_refused("--mount front=backwards:yes", "expected true or false");
  expect_refused("--mount front=duration-s:3", "'duration-s' is nothing of a LiDAR");
  expect_refused("--mount front=at:1/2/3", "expected six numbers");
  expect_refused("--mount front=phase:2", "mount front");
  for (const char* name : {"a/b", "all", "none"})
    expect_refused(std::string("--mount ") + name + "=beams:16", "is no name of a LiDAR");
  expect_refused("--mount front= --mount front=", "two LiDARs are called front");
  expect_refused("--mount front= --format kitti-raw", "room for one LiDAR");
}

}  // namespace
}  // namespace remount::cli
