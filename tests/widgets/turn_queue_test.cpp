#include "app/gui/basics/turn_queue.h"

#include <gtest/gtest.h>

#include <QTest>
#include <vector>

namespace remount::widgets {
namespace {

TEST(turn_queue, does_one_piece_a_turn_in_order) {
  gui::TurnQueue queue;
  std::vector<int> done;
  queue.start({[&] { done.push_back(1); }, [&] { done.push_back(2); }, [&] { done.push_back(3); }});
  EXPECT_TRUE(done.empty()) << "not in the turn that asks for it";
  for (std::size_t turn = 0; turn < 3; ++turn) {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_LE(done.size(), turn + 1);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return queue.idle(); }));
  EXPECT_EQ(done, (std::vector<int>{1, 2, 3}));
}

TEST(turn_queue, what_is_newer_takes_the_place_of_what_waits) {
  gui::TurnQueue queue;
  std::vector<int> done;
  queue.start({[&] { done.push_back(1); }, [&] { done.push_back(2); }});
  queue.start({[&] { done.push_back(3); }});
  ASSERT_TRUE(QTest::qWaitFor([&] { return queue.idle(); }));
  EXPECT_EQ(done, std::vector<int>{3});
}

TEST(turn_queue, a_piece_may_start_others_and_all_may_be_wanted_at_once) {
  gui::TurnQueue queue;
  std::vector<int> done;
  queue.start({[&] { queue.start({[&] { done.push_back(2); }}); }, [&] { done.push_back(1); }});
  queue.finish();
  EXPECT_EQ(done, std::vector<int>{2});
  EXPECT_TRUE(queue.idle());
}

}  // namespace
}  // namespace remount::widgets
