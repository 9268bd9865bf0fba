// Runs the program itself in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace remount {

struct Outcome {
  int code = -1;
  std::string out, err;
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Each Suite has a folder, which goes when its tests are done.
template <class Suite>
class ProgramFixture : public ::testing::Test {
 protected:
  /// Simulates a street into "drive".
  static void make_folder_with_drive(const std::string& arguments) {
    std::string pattern = (std::filesystem::temp_directory_path() / "remount_cli_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    const Outcome made = run("simulate street " + path("drive") + " " + arguments);
    ASSERT_EQ(made.code, 0) << made.err;
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }

  static std::string path(const std::string& name) { return (folder_ / name).string(); }

  static Outcome run(const std::string& arguments) {
    const std::string command = std::string("'") + REMOUNT_CLI + "' " + arguments + " > '" + path("out.txt") +
                                "' 2> '" + path("err.txt") + "' < /dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(path("out.txt")),
            text_of(path("err.txt"))};
  }

  inline static std::filesystem::path folder_;
};

}  // namespace remount
