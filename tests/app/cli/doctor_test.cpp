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
  // No version may be missing: CMake gives an empty one where it does not find it. What the machine does not tell may
  // be unknown.
  const std::size_t libraries = told.out.find("built with: ");
  const std::string versions = told.out.substr(libraries, told.out.find('\n', libraries) - libraries) + "\n";
  for (const char* gap : {" ,", " \n", "unknown"}) EXPECT_EQ(versions.find(gap), std::string::npos) << versions;
  expect_contains(run("doctor -j 3").out, "threads: 3;");
}

TEST_F(cli_doctor, speaks_chinese) {
  const Outcome told = run("--language zh_CN doctor");
  EXPECT_EQ(told.code, 0) << told.err;
  for (const char* part : {"编译所用的库：", "处理器：", "配准的内层循环：", "线程：", "内存：", "临时文件："})
    expect_contains(told.out, part);
  EXPECT_EQ(told.out.find("memory:"), std::string::npos) << told.out;
}

TEST_F(cli_doctor, folders_are_told_without_names_of_people_and_vehicles) {
  expect_contains(told_where("-u XDG_CACHE_HOME HOME=/home/somebody-known"),
                  "kept indexes of captures: ~/.cache/remount/captures, free: ");
  const std::string told = told_where(
      "HOME=/home/somebody-known USER=somebody-here LOGNAME=somebody-else SUDO_USER=somebody-first "
      "XDG_CACHE_HOME=/var/somebody-here/somebody-else/somebody-first");
  expect_contains(told, "kept indexes of captures: /var/…/…/…/remount/captures, free: ");
  EXPECT_EQ(told.find("somebody"), std::string::npos) << told;
  expect_contains(told_where("XDG_CACHE_HOME=/data/vehicle-17-alice/cache"),
                  "kept indexes of captures: /data/…, free: ");
}

TEST_F(cli_doctor, the_host_is_not_told) {
  char host[256] = {};
  ASSERT_EQ(::gethostname(host, sizeof(host) - 1), 0);
  const std::string name = host;
  if (name == "remount") GTEST_SKIP() << "this host is called as the program";
  expect_contains(told_where("XDG_CACHE_HOME='/var/" + name + "'"), "/…/remount/captures, free: ");
}

TEST_F(cli_doctor, a_temporary_folder_that_is_none_is_told) {
  expect_contains(told_where("TMPDIR='" + path("nothing-here") + "'"),
                  "temporary files: nowhere, TMPDIR is not a folder\n");
}

TEST_F(cli_doctor, privacy_is_said_as_it_is) {
  const std::string help = run("doctor --help").out;
  for (const char* part : {"/usr", "/opt", "/tmp", "/var", "~", "Look through it"}) expect_contains(help, part);
}

}  // namespace
}  // namespace remount::cli
