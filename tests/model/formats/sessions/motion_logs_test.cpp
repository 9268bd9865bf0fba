#include "model/formats/sessions/motion_logs.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/formats/sessions/ins_beside.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/sample_files.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

struct MotionLogFile {
  std::string name, bytes;
};

/// One of each kind, in the order in which they are taken; solutions that were post-processed come first.
std::vector<MotionLogFile> logs_of_all_kinds() {
  return {{"post.txt", samples::explorer_table(40)}, {"span.log", samples::inspvax_log(40)},
          {"drive.ncom", samples::ncom(40)},         {"gnss.nmea", samples::nmea(12)},
          {"rover.pos", samples::rtklib(12)},        {"track.gpx", samples::gpx(6)},
          {"ins.txt", samples::poses(" ", 40)}};
}

std::string words_of_choice(const drive::Session& session) {
  std::string words;  // of a log itself, and of those beside it
  for (const drive::Finding& finding : session.findings)
    if (finding.code == "ins-log-chosen")
      words += english(finding.where.words()) + ": " + english(finding.explanation) + "\n";
  return words;
}

// Of two whole solutions nobody knows which is right.
TEST(motion_logs, of_every_two_kinds_the_one_that_is_passed_over_is_named) {
  const std::vector<MotionLogFile> logs = logs_of_all_kinds();
  for (std::size_t better = 0; better < logs.size(); ++better)
    for (std::size_t other = better + 1; other < logs.size(); ++other) {
      const TemporaryFolder folder;
      const auto taken = folder.write(logs[better].name, logs[better].bytes),
                 passed_over = folder.write(logs[other].name, logs[other].bytes);
      const std::string pair = logs[better].name + " and " + logs[other].name;
      drive::Session session;
      if (better == 0 && logs[other].name == "drive.ncom") {
        EXPECT_ERROR(read_ins_beside({taken, passed_over}, folder.path(), session), "holds several INS logs");
        continue;
      }
      ASSERT_TRUE(read_ins_beside({passed_over, taken}, folder.path(), session)) << pair;
      ASSERT_FALSE(session.files.empty()) << pair;
      EXPECT_EQ(session.files.front(), taken) << pair;
      const std::string said = words_of_choice(session);
      EXPECT_TRUE(contains(said, logs[better].name + ": ")) << pair << ": " << said;
      EXPECT_TRUE(contains(said, "not from " + logs[other].name + " beside it")) << pair << ": " << said;
      EXPECT_EQ(contains(said, "was post-processed"), better == 0 && logs[other].name == "span.log") << said;
    }
}

TEST(motion_logs, one_log_alone_passes_over_none) {
  for (const MotionLogFile& log : logs_of_all_kinds()) {
    const TemporaryFolder folder;
    drive::Session session;
    ASSERT_TRUE(read_ins_beside({folder.write(log.name, log.bytes)}, folder.path(), session)) << log.name;
    EXPECT_FALSE(contains(words_of_choice(session), "beside it")) << log.name;
  }
}

// With LiDAR poses other readers open the folder.
TEST(motion_logs, beside_lidar_poses_the_same_are_taken_and_named) {
  std::vector<MotionLogFile> logs = logs_of_all_kinds();
  logs.pop_back();
  for (std::size_t better = 0; better < logs.size(); ++better)
    for (std::size_t other = better + 1; other < logs.size(); ++other) {
      if (better == 0 && logs[other].name == "drive.ncom") continue;
      const TemporaryFolder folder;
      folder.write("lidar_poses.txt", samples::poses(" ", 40));
      const auto taken = folder.write(logs[better].name, logs[better].bytes);
      folder.write(logs[other].name, logs[other].bytes);
      const drive::Session session = open(folder.path());
      const std::string pair = logs[better].name + " and " + logs[other].name, said = words_of_choice(session);
      EXPECT_EQ(session.files.front(), taken) << pair;
      EXPECT_FALSE(session.odometry_from_lidar.empty()) << pair;
      EXPECT_TRUE(contains(said, "not from " + logs[other].name + " beside it")) << pair << ": " << said;
      if (better == 0 && logs[other].name == "span.log") {
        EXPECT_EQ(session.ins.size(), 40U);
        EXPECT_EQ(session.format, "novatel") << "the LiDAR's clock is that of the host";
      }
    }
}

// Which of two that were post-processed is the better one, nobody says: NovAtel's own log stays.
TEST(motion_logs, of_several_that_were_post_processed_none_is_preferred) {
  const TemporaryFolder folder;
  const auto span = folder.write("span.log", samples::inspvax_log(40)),
             one = folder.write("a.txt", samples::explorer_table(40)),
             two = folder.write("b.txt", samples::explorer_table(40));
  drive::Session session;
  ASSERT_TRUE(read_ins_beside({span, one, two}, folder.path(), session));
  EXPECT_EQ(session.files.front(), span);
  EXPECT_TRUE(contains(words_of_choice(session), "not from a.txt, b.txt beside it")) << words_of_choice(session);
  EXPECT_ERROR(read_ins_beside({one, two}, folder.path(), session), "holds several INS logs");
}

}  // namespace
}  // namespace remount::formats
