#include "model/formats/files/file_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "algorithms/core/error.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

TEST(file_lock, one_holds_it_and_the_file_says_who) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "lock";
  EXPECT_EQ(lock_holder(path), "");
  {
    const std::optional<FileLock> mine = FileLock::take(path, "me");
    ASSERT_TRUE(mine);
    EXPECT_FALSE(FileLock::take(path, "another"));
    EXPECT_EQ(lock_holder(path), "me");
    EXPECT_GT(mine->taken_ns(), 1'600'000'000'000'000'000);
  }
  EXPECT_TRUE(FileLock::take(path, "another with a longer name"));
  EXPECT_TRUE(FileLock::take(path, "x"));
  EXPECT_EQ(lock_holder(path), "x") << "nothing is left of the longer name";
}

TEST(file_lock, ends_with_a_process_that_is_killed) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "lock";
  const pid_t child = ::fork();
  if (child == 0) {
    const std::optional<FileLock> held = FileLock::take(path, this_process());
    for (;;) ::pause();
  }
  const std::string name = "process " + std::to_string(child) + " on ";
  for (int i = 0; i < 1000 && lock_holder(path).rfind(name, 0) != 0; ++i) ::usleep(5000);
  EXPECT_EQ(lock_holder(path).rfind(name, 0), 0U) << lock_holder(path);
  EXPECT_FALSE(FileLock::take(path, "me"));
  ::kill(child, SIGKILL);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  EXPECT_TRUE(FileLock::take(path, "me"));
}

TEST(file_lock, refuses_what_is_no_file) {
  const TemporaryFolder folder;
  EXPECT_THROW(FileLock::take(folder.path(), "me"), Error);
  EXPECT_THROW(FileLock::take(folder.path() / "none" / "lock", "me"), Error);
}

}  // namespace
}  // namespace remount::formats
