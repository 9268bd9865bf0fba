// What a report of a fault is told of the machine, and that it does not tell whose it is.
#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "remount_version.h"
#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

class cli_doctor : public ProgramFixture<cli_doctor> {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (std::filesystem::temp_directory_path() / "remount_cli_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  /// With these variables in its environment.
  static std::string told_where(const std::string& variables) {
    const std::string command =
        "env " + variables + " '" + std::string(REMOUNT_CLI) + "' doctor > '" + path("out.txt") + "'";
    EXPECT_EQ(testing::exit_code_of(std::system(command.c_str())), 0);
    return text_of(path("out.txt"));
  }
  static void expect_contains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  }
};

TEST_F(cli_doctor, tells_versions_machine_and_limits) {
  const Outcome told = run("doctor");
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(told.out.find("Remount " + std::string(kVersion) + " ("), 0U) << told.out;
  for (const char* part : {"built with: Eigen 3", "PCL 1.", "yaml-cpp 0.", "GeographicLib ", "system: ", "Linux ",
                           "processor: ", "loops of registration: for ", "threads: ", "memory: ", "open files: ",
                           "locale: ", "kept indexes of captures: ", "temporary files: ", "sample drive: "})
    expect_contains(told.out, part);
  // No version may be missing: CMake gives an empty one where it does not find it.
  for (const char* gap : {" ,", " \n", "unknown"}) EXPECT_EQ(told.out.find(gap), std::string::npos) << told.out;
  expect_contains(run("doctor -j 3").out, "threads: 3;");
}

TEST_F(cli_doctor, speaks_chinese) {
  const Outcome told = run("--language zh_CN doctor");
  EXPECT_EQ(told.code, 0) << told.err;
  for (const char* part : {"编译所用的库：", "处理器：", "配准的内层循环：", "线程：", "内存：", "临时文件："})
    expect_contains(told.out, part);
  EXPECT_EQ(told.out.find("memory:"), std::string::npos) << told.out;
}

TEST_F(cli_doctor, folders_are_told_without_names_of_people) {
  const std::string told = told_where(
      "-u XDG_CACHE_HOME HOME=/home/somebody-known USER=somebody-else TMPDIR=/home/third-person/scratch/somebody-else");
  expect_contains(told, "kept indexes of captures: ~/.cache/remount/captures, free: ");
  for (const char* name : {"somebody", "third-person"}) EXPECT_EQ(told.find(name), std::string::npos) << told;
  char host[256] = {};
  ASSERT_EQ(::gethostname(host, sizeof(host) - 1), 0);
  EXPECT_EQ(told.find("/" + std::string(host) + "/"), std::string::npos) << told;
}

TEST_F(cli_doctor, a_folder_whose_name_begins_as_home_is_not_in_it) {
  expect_contains(told_where("HOME=/srv/kept XDG_CACHE_HOME=/srv/kept-elsewhere"),
                  "kept indexes of captures: /srv/kept-elsewhere/remount/captures, free: ");
}

}  // namespace
}  // namespace remount::cli
