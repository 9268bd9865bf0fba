// Runs the program itself in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/exit_code.h"

namespace remount::cli {

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

/// Asks until the answer is yes, for a minute at most.
template <class Question>
bool eventually(Question&& question) {
  for (int i = 0; i < 6000; ++i) {
    if (question()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
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
    return {testing::exit_code_of(status), text_of(path("out.txt")), text_of(path("err.txt"))};
  }

  /// The program without waiting for it, in a process group of its own, as a shell starts it.
  static pid_t start(const std::vector<std::string>& words, const std::string& error_file) {
    std::vector<char*> arguments{const_cast<char*>(REMOUNT_CLI)};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = ::fork();
    if (child != 0) {
      ::setpgid(child, child);
      return child;
    }
    ::setpgid(0, 0);
    if (std::freopen(error_file.c_str(), "w", stderr) == nullptr || std::freopen("/dev/null", "w", stdout) == nullptr)
      ::_exit(99);
    ::execv(REMOUNT_CLI, arguments.data());
    ::_exit(98);
  }

  inline static std::filesystem::path folder_;
};

}  // namespace remount::cli
