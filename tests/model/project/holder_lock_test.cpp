#include "model/project/holder_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <functional>

#include "model/formats/files/input_file.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::project {
namespace {

/// What a process on another computer, or an earlier one on this, wrote.
std::string record(const LockHolder& holder) {
  return "format: remount-lock/1\nuser: " + holder.user + "\nhost: " + holder.host +
         "\nprocess: " + std::to_string(holder.process) + "\nsince_s: " + std::to_string(holder.since_s) +
         "\nmachine: \"" + holder.machine + "\"\nboot: \"" + holder.boot + "\"\n";
}

LockHolder somebody_else() { return {"bob", "ws7", "another-machine", "its-boot", 4711, 1795377600}; }

void set_age(const std::filesystem::path& path, std::int64_t age_s) {
  const timespec then{std::time(nullptr) - age_s, 0};
  const timespec times[2] = {then, then};
  ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
}

class holder_lock : public ::testing::Test {
 protected:
  formats::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / ".job.remount.lock";
};

TEST_F(holder_lock, says_who_holds_it_and_goes_when_it_is_given_back) {
  {
    const auto mine = HolderLock::take(path_);
    ASSERT_TRUE(mine.lock) << mine.why_none;
    EXPECT_FALSE(mine.lock->beat());
    const auto second = HolderLock::take(path_);
    EXPECT_FALSE(second.lock);
    ASSERT_TRUE(second.holder);
    EXPECT_EQ(second.holder->process, ::getpid());
    EXPECT_EQ(second.holder->host, this_holder().host);
    EXPECT_EQ(second.holder->user, this_holder().user);
    EXPECT_FALSE(second.on_another_computer);
    EXPECT_LE(std::abs(second.holder->since_s - std::time(nullptr)), 60);
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_TRUE(HolderLock::take(path_).lock);
}

TEST_F(holder_lock, ends_with_a_process_that_is_killed) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto held = HolderLock::take(path_);
    [[maybe_unused]] const auto said = ::write(ready[1], held.lock ? "y" : "n", 1);
    for (;;) ::pause();
  }
  char answer = '?';
  ASSERT_EQ(::read(ready[0], &answer, 1), 1);
  ASSERT_EQ(answer, 'y');
  const auto refused = HolderLock::take(path_);
  ASSERT_TRUE(refused.holder);
  EXPECT_EQ(refused.holder->process, child);
  ::kill(child, SIGKILL);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  EXPECT_TRUE(std::filesystem::exists(path_)) << "the killed one leaves its file";
  EXPECT_TRUE(HolderLock::take(path_).lock) << "but not its lock";
}

TEST_F(holder_lock, of_an_earlier_start_of_the_computer_holds_nothing) {
  LockHolder before = this_holder();
  before.boot = "earlier";
  folder_.write(path_.filename(), record(before));
  EXPECT_TRUE(HolderLock::take(path_).lock);
}

TEST_F(holder_lock, of_another_computer_holds_as_long_as_it_shows_signs_of_life) {
  folder_.write(path_.filename(), record(somebody_else()));
  const auto fresh = HolderLock::take(path_);
  ASSERT_TRUE(fresh.holder);
  EXPECT_EQ(*fresh.holder, somebody_else());
  EXPECT_TRUE(fresh.on_another_computer);
  EXPECT_EQ(english(holder_words(*fresh.holder)), "bob on ws7 (process 4711), since 2026-11-22 20:00 UTC");
  for (const std::int64_t age_s : {HolderLock::kStale_s + 60, -(HolderLock::kStale_s + 60)}) {
    folder_.write(path_.filename(), record(somebody_else()));
    set_age(path_, age_s);
    EXPECT_TRUE(HolderLock::take(path_).lock) << age_s << " s old; a clock that was set back is no sign of life";
  }
  folder_.write(path_.filename(), record(somebody_else()));
  set_age(path_, HolderLock::kStale_s - 60);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(HolderLock::take(path_).holder);
  set_age(path_, HolderLock::kStale_s + 1);
  EXPECT_TRUE(HolderLock::take(path_).lock) << "asking is no sign of life";
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "nothing is left";
}

TEST_F(holder_lock, that_is_taken_by_force_is_lost_by_its_holder_who_learns_of_it) {
  const auto first = HolderLock::take(path_);
  ASSERT_TRUE(first.lock);
  auto second = HolderLock::take(path_, true);
  ASSERT_TRUE(second.lock);
  ASSERT_TRUE(first.lock->beat());
  EXPECT_FALSE(second.lock->beat());
  EXPECT_TRUE(HolderLock::take(path_).holder);
  second.lock.reset();
  EXPECT_FALSE(std::filesystem::exists(path_));
  // The record of another computer, which writes into the same file where there is no lock of the kernel's.
  folder_.write(path_.filename(), record(somebody_else()));
  const auto learned = first.lock->beat();
  ASSERT_TRUE(learned);
  EXPECT_EQ(learned->user, "bob");
}

TEST_F(holder_lock, that_was_lost_leaves_the_file_of_its_new_holder) {
  auto first = HolderLock::take(path_);
  const auto second = HolderLock::take(path_, true);
  first.lock.reset();
  EXPECT_TRUE(std::filesystem::exists(path_));
  EXPECT_TRUE(HolderLock::take(path_).holder);
}

TEST_F(holder_lock, whose_file_says_nothing_or_nonsense_blocks_nobody) {
  for (const char* text : {"", "format: [", "format: remount-lock/1\n", "4711\nremount\nws7\n", "format: other/1\n"}) {
    folder_.write(path_.filename(), text);
    EXPECT_TRUE(HolderLock::take(path_).lock) << text;
  }
}

TEST_F(holder_lock, that_cannot_be_made_says_why) {
  for (const std::filesystem::path& path :
       {folder_.path() / "none" / "lock", folder_.path(), folder_.path() / std::string(300, 'x')}) {
    const auto none = HolderLock::take(path);
    EXPECT_FALSE(none.lock || none.holder) << path;
    EXPECT_FALSE(none.why_none.empty()) << path;
  }
}

TEST_F(holder_lock, of_another_user_is_respected_while_it_is_held_and_replaced_afterwards) {
  if (::getuid() != 0) GTEST_SKIP() << "needs two users";
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0777));
  auto mine = HolderLock::take(path_);
  ASSERT_TRUE(mine.lock);
  ASSERT_EQ(::chmod(path_.c_str(), 0644), 0);
  const auto as_nobody = [&](const std::function<bool()>& question) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(::setuid(65534) == 0 && question() ? 0 : 1);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  };
  EXPECT_TRUE(as_nobody([&] {
    const auto attempt = HolderLock::take(path_);
    return attempt.holder && attempt.holder->process == ::getppid();
  }));
  mine.lock.reset();
  folder_.write(path_.filename(), record(this_holder()));  // as a killed one leaves it
  ASSERT_EQ(::chmod(path_.c_str(), 0644), 0);
  EXPECT_TRUE(as_nobody([&] { return HolderLock::take(path_).lock != nullptr; }));
}

}  // namespace
}  // namespace remount::project
