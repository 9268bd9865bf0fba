// A disk that does not answer does not stall the window.
#include "app/gui/workbench/lock_keeper.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <future>

#include "app/gui/workbench/workbench.h"
#include "tests/widgets/support/sample_world.h"

namespace remount::widgets {
namespace {

constexpr int kLockPatience_ms = 20000;

/// Giving a lock back waits as long as the disk hangs.
struct HangingDisk {
  std::promise<void> answers;
  std::shared_future<void> answered = answers.get_future().share();
  std::atomic<int> asked = 0;
  std::function<void(gui::LockKeeper::LockPtr)> give_back() {
    return [this](gui::LockKeeper::LockPtr) {
      ++asked;
      answered.wait();
    };
  }
};

std::filesystem::path lock_in(const QTemporaryDir& folder) { return folder.filePath("job.lock").toStdString(); }

TEST(lock_keeper, does_not_wait_for_the_disk_and_gives_the_lock_back) {
  const QTemporaryDir folder;
  HangingDisk disk;
  gui::LockKeeper keeper(disk.give_back());
  gui::LockKeeper::LockPtr lock = keeper.keep(project::HolderLock::take(lock_in(folder)).lock);
  ASSERT_TRUE(lock);
  EXPECT_EQ(lock->path(), lock_in(folder));
  gui::LockKeeper::LockPtr other = lock;
  lock.reset();
  EXPECT_EQ(disk.asked, 0) << "somebody has it still";
  other.reset();  // would hang here
  EXPECT_TRUE(project::HolderLock::take(lock_in(folder)).holder) << "it is on its way";
  disk.answers.set_value();
  keeper.await(lock_in(folder));
  EXPECT_EQ(disk.asked, 1);
  EXPECT_TRUE(project::HolderLock::take(lock_in(folder)).lock);
  EXPECT_FALSE(keeper.keep(nullptr));
}

TEST(lock_keeper, gives_back_what_is_left_before_it_goes) {
  const QTemporaryDir folder;
  {
    gui::LockKeeper keeper;
    keeper.keep(project::HolderLock::take(lock_in(folder)).lock).reset();
  }
  EXPECT_TRUE(project::HolderLock::take(lock_in(folder)).lock);
}

class hanging_disk : public ::testing::Test {
 protected:
  void TearDown() override {
    if (!answered_) disk_.answers.set_value();
  }
  bool settle() {
    return QTest::qWaitFor([&] { return !workbench_.activity().opening(); }, kLockPatience_ms);
  }
  bool save(const QString& path) {
    workbench_.document().save(path);
    return QTest::qWaitFor([&] { return workbench_.document().path() == path; }, kLockPatience_ms);
  }
  bool answered_ = false;
  HangingDisk disk_;
  QTemporaryDir folder_;
  gui::Workbench workbench_{testing::sample_engine(), std::make_unique<gui::LockKeeper>(disk_.give_back())};
};

TEST_F(hanging_disk, lets_the_window_go_on_where_another_project_takes_the_place_of_one) {
  workbench_.sessions().open({"/data/drive1"});
  ASSERT_TRUE(settle());
  const QString first = folder_.filePath("first.remount"), second = folder_.filePath("second.remount");
  ASSERT_TRUE(save(first));
  ASSERT_TRUE(save(second)) << "the lock of the first is given back by a thread that hangs";
  EXPECT_TRUE(QTest::qWaitFor([&] { return disk_.asked == 1; }, kLockPatience_ms));
  workbench_.document().open(first);
  QTest::qWait(100);
  EXPECT_TRUE(workbench_.activity().opening()) << "whose lock is on its way is waited for, in the background";
  answered_ = true;
  disk_.answers.set_value();
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench_.document().path(), first) << "and is not taken for one of another window";
}

}  // namespace
}  // namespace remount::widgets
