#include "model/formats/sessions/motion_logs.h"

#include <gtest/gtest.h>

#include <algorithm>

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

/// Beside a log of NovAtel, opened as a folder.
drive::Session beside_novatel(const TemporaryFolder& folder, const std::string& name, const std::string& bytes) {
  folder.write("span.log", samples::inspvax_log(40));
  folder.write("lidar_poses.txt", samples::poses(" ", 40));
  folder.write(name, bytes);
  return open(folder.path());
}

// What an INS exports on the drive looks the same, and a table may lie there for something else.
TEST(motion_logs, a_table_that_does_not_say_it_was_post_processed_leaves_novatels_log) {
  const std::string explorer = samples::explorer_table(40);
  const auto without = [&](const std::string& word, const std::string& instead) {
    std::string text = explorer;
    return text.replace(text.find(word), word.size(), instead);
  };
  const std::pair<std::string, std::string> tables[] = {
      {"of an INS while it drives", samples::oxts_csv(40)},
      {"of something else", "date,utctime,lat,lon,alt,heading,speed\n2020-09-13,12:26:40,51.5,9.2,310,20,5\n"},
      {"without a column that is needed", without("Heading", "Course2")},
      {"with a unit that nobody knows", without("(deg)", "(gon)")},
      {"without its program", without("Inertial Explorer", "another program")}};
  for (const auto& [what, text] : tables) {
    const TemporaryFolder folder;
    const drive::Session session = beside_novatel(folder, "table.csv", text);
    EXPECT_EQ(session.files.front().filename(), "span.log") << what;
    EXPECT_EQ(session.ins_axes, drive::InsAxes::RightForwardUp) << what;
    EXPECT_EQ(session.ins.size(), 40U) << what;
    const std::string said = words_of_choice(session);
    EXPECT_TRUE(contains(said, "not from table.csv beside it")) << what << ": " << said;
    EXPECT_FALSE(contains(said, "post-processed")) << what << ": " << said;
  }
}

TEST(motion_logs, a_solution_that_changes_the_axes_of_x_is_a_warning) {
  const auto choice_of = [](const drive::Session& session) {
    const auto found = std::ranges::find_if(session.findings, [](const drive::Finding& finding) {
      return finding.code == "ins-log-chosen" && contains(english(finding.explanation), "post-processed");
    });
    return found == session.findings.end() ? drive::Finding{} : *found;
  };
  const TemporaryFolder other, same;
  const drive::Session sbet = beside_novatel(other, "sbet.out", samples::sbet(40)),
                       explorer = beside_novatel(same, "post.txt", samples::explorer_table(40));
  EXPECT_EQ(sbet.ins_axes, drive::InsAxes::ForwardLeftUp);
  EXPECT_EQ(choice_of(sbet).severity, drive::Severity::Warning);
  const std::string said = english(choice_of(sbet).explanation);
  EXPECT_TRUE(contains(said, "axes of this log, x forward, y left, z up; those of NovAtel's logs are x right")) << said;
  EXPECT_EQ(explorer.ins_axes, drive::InsAxes::RightForwardUp);
  EXPECT_EQ(choice_of(explorer).severity, drive::Severity::Note);
  EXPECT_FALSE(contains(english(choice_of(explorer).explanation), "axes"));
}

}  // namespace
}  // namespace remount::formats
