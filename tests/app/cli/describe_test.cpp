// Writes manifests of tables that nobody declared, and opens them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

namespace fs = std::filesystem;

class describe_verb : public ProgramFixture<describe_verb> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive("--duration-s 8 --beams 8 --azimuth-steps 90 --scan-rate-hz 5");
    fs::create_directories(path("tables"));
    fs::copy(path("drive/scans"), path("tables/scans"), fs::copy_options::recursive);
    fs::copy_file(path("drive/scan_stamps.csv"), path("tables/scan_stamps.csv"));
    fs::copy_file(path("drive/ins.csv"), path("tables/motion.csv"));
  }
};

TEST_F(describe_verb, a_manifest_is_written_that_opens_and_is_not_replaced_unasked) {
  const std::string manifest = path("tables/session.yaml");
  const Outcome printed = run("describe " + path("tables"));
  EXPECT_EQ(printed.code, 0) << printed.err;
  EXPECT_NE(printed.out.find("remount-session/1"), std::string::npos) << printed.out;
  EXPECT_FALSE(fs::exists(manifest)) << "nobody asked for a file";
  const Outcome written = run("describe " + path("tables") + " -o " + manifest);
  EXPECT_EQ(written.code, 0) << written.err;
  const std::string text = text_of(manifest);
  EXPECT_EQ(text, printed.out);
  EXPECT_NE(text.find("# Attitude from yaw_deg, pitch_deg, roll_deg"), std::string::npos) << text;
  EXPECT_EQ(run("inspect " + path("tables")).code, 0) << text;
  const Outcome again = run("describe " + path("tables/scans") + " " + path("tables/motion.csv") + " -o " + manifest);
  EXPECT_EQ(again.code, 1);
  EXPECT_NE(again.err.find("--force"), std::string::npos) << again.err;
  EXPECT_EQ(text_of(manifest), text);
  EXPECT_EQ(run("describe " + path("tables") + " --force -o " + manifest).code, 0);
  EXPECT_EQ(run("--language zh_CN describe " + path("tables") + " --force -o " + manifest).code, 0);
  EXPECT_NE(text_of(manifest).find("姿态，取自"), std::string::npos) << text_of(manifest);
  EXPECT_EQ(run("inspect " + path("tables")).code, 0);
  fs::remove(manifest);
}

TEST_F(describe_verb, what_a_format_is_known_of_is_said_to_be_so) {
  const Outcome known = run("describe " + path("drive") + " -o " + path("never.yaml"));
  EXPECT_EQ(known.code, 0) << known.err;
  EXPECT_NE(known.out.find("has a manifest already, which can be opened"), std::string::npos) << known.out;
  EXPECT_FALSE(fs::exists(path("never.yaml")));
  fs::rename(path("drive/ins.csv"), path("ins.csv"));
  const Outcome broken = run("describe " + path("drive"));
  EXPECT_EQ(broken.code, 3) << "what `inspect` refuses is not said to open";
  EXPECT_NE(broken.out.find("a manifest that cannot be opened"), std::string::npos) << broken.out;
  fs::rename(path("ins.csv"), path("drive/ins.csv"));
}

TEST_F(describe_verb, what_is_missing_is_named_and_ends_with_3) {
  fs::create_directories(path("half"));
  fs::copy_file(path("drive/ins.csv"), path("half/motion.csv"), fs::copy_options::overwrite_existing);
  const Outcome half = run("describe " + path("half"));
  EXPECT_EQ(half.code, 3) << half.out;
  EXPECT_NE(half.out.find("# MISSING: no scans"), std::string::npos) << half.out;
  fs::create_directories(path("nothing"));
  const Outcome nothing = run("describe " + path("nothing"));
  EXPECT_EQ(nothing.code, 3);
  EXPECT_NE(nothing.err.find("no table or log"), std::string::npos) << nothing.err;
  std::ofstream(path("nothing/motion.csv")) << "time,lat,lon,h,roll,pitch,heading\n";
  const Outcome told = run("describe " + path("nothing"));
  EXPECT_EQ(told.code, 3);
  EXPECT_NE(told.err.find("motion.csv: has 0 rows of numbers"), std::string::npos) << told.err;
  EXPECT_EQ(run("describe " + path("not-there")).code, 2);
  EXPECT_EQ(run("describe").code, 1);
}

}  // namespace
}  // namespace remount::cli
