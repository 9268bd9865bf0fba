#include "model/formats/bags/correction_status.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "tests/model/formats/bags/bag_maker.h"

namespace remount::bags {
namespace {

std::string said_of(const drive::Session& session, const std::string& topic) {
  for (const drive::Finding& finding : session.findings)
    if (finding.code == "rtk-lost" && drive::english(finding.where).ends_with(topic)) {
      std::printf("%s: %s\n", topic.c_str(), english(finding.explanation).c_str());
      return english(finding.explanation);
    }
  return "";
}

/// A drive whose fixes, without covariance, have `status` from the 20th to the 30th of 100, and 2 otherwise.
drive::Session drive_with(const fs::path& path, bool orientation, int usual, int status) {
  BagMaker bag(path);
  bag.add_scans("/points", 45, 30);
  if (!orientation) bag.add_odometry("/ins/odometry", 100);
  for (int i = 0; i < 100; ++i) {
    bag.add_fix("/fix", i, i >= 20 && i < 30 ? status : usual, false);
    if (orientation)
      bag.add(kStart_ns + i * kStep_ns / 2 + 10'000'000, "/imu", "sensor_msgs/Imu",
              attitude_message(BagMaker::on_circle(i), 0.001, "ins", kRos1));
  }
  bag.finish();
  return formats::open(path);
}

TEST(correction_status, a_status_that_falls_is_named_without_a_covariance) {
  const formats::TemporaryFolder folder;
  const std::string expected =
      "The status of the position falls from STATUS_GBAS_FIX to STATUS_FIX in 1 stretch, 10 % of the drive: "
      "corrections (RTK) were lost.";
  EXPECT_EQ(said_of(drive_with(folder.path() / "gnss.bag", false, 2, 0), "/fix"), expected);
  const drive::Session session = drive_with(folder.path() / "ins.bag", true, 2, 0);
  EXPECT_EQ(said_of(session, "/fix"), expected);
  EXPECT_EQ(session.ins.size(), 100U);
  EXPECT_EQ(std::count_if(session.findings.begin(), session.findings.end(),
                          [](const drive::Finding& finding) { return finding.code == "rtk-lost"; }),
            1)
      << "fixes that serve twice are named once";
}

TEST(correction_status, what_was_never_rtk_is_not_lost) {
  const formats::TemporaryFolder folder;
  EXPECT_EQ(said_of(drive_with(folder.path() / "single.bag", false, 0, 0), "/fix"), "");
  EXPECT_EQ(said_of(drive_with(folder.path() / "sbas.bag", false, 1, 0), "/fix"), "");
  EXPECT_EQ(said_of(drive_with(folder.path() / "fixed.bag", false, 2, 2), "/fix"), "");
}

TEST(correction_status, a_position_type_of_inspvax_that_falls_is_named) {
  const formats::TemporaryFolder folder;
  for (const std::uint32_t type : {56U, 55U, 53U}) {
    const fs::path path = folder.path() / (std::to_string(type) + ".bag");
    BagMaker bag(path);
    bag.add_scans("/points", 45, 30);
    bag.add_inspvax("/inspvax", 80, 1);
    bag.add_inspvax("/inspvax", 20, 1, type, 80);
    bag.finish();
    const std::string expected = type == 56U   ? ""
                                 : type == 55U ? "falls from INS_RTKFIXED to INS_RTKFLOAT in 1 stretch, 20 %"
                                               : "falls from INS_RTKFIXED to INS_PSRSP in 1 stretch, 20 %";
    const std::string said = said_of(formats::open(path), "/inspvax");
    EXPECT_EQ(said.empty(), expected.empty()) << said;
    EXPECT_TRUE(formats::contains(said, expected)) << said;
  }
}

TEST(correction_status, what_comes_before_rtk_and_what_has_no_position_is_no_loss) {
  std::vector<CorrectionStatus> positions(20, {1, "SINGLE"});
  positions.insert(positions.end(), 80, {3, "INS_RTKFIXED"});
  std::vector<drive::Finding> findings;
  report_lost_corrections(positions, "/inspvax", findings);
  positions.insert(positions.begin() + 50, 10, {0, "NONE"});
  report_lost_corrections(positions, "/inspvax", findings);
  EXPECT_TRUE(findings.empty()) << english(findings.front().explanation);
  positions.insert(positions.begin() + 70, 5, {2, "INS_RTKFLOAT"});
  report_lost_corrections(positions, "/inspvax", findings);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_TRUE(
      formats::contains(english(findings.front().explanation), "from INS_RTKFIXED to INS_RTKFLOAT in 1 stretch"))
      << english(findings.front().explanation);
}

TEST(correction_status, of_inspvax_is_read_by_number_and_by_name) {
  InspvaxMessage message;
  for (const char* type : {"56", "INS_RTKFIXED"}) {
    message.position_type = type;
    EXPECT_EQ(correction_status(message).level, 3) << type;
    EXPECT_EQ(correction_status(message).name, "INS_RTKFIXED") << type;
  }
  message.position_type = "1234";
  EXPECT_EQ(correction_status(message).level, 1);
  EXPECT_EQ(correction_status(message).name, "1234");
}

}  // namespace
}  // namespace remount::bags
