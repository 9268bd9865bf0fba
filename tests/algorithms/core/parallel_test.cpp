#include "algorithms/core/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "algorithms/core/progress.h"
#include "messages/stages.h"

namespace remount {
namespace {

TEST(parallel, each_index_is_visited_once_for_any_number_of_threads) {
  for (const int threads : {0, 1, 2, 7, 64})
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{1000}}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, threads, [&](std::size_t i) { ++visits[i]; });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads << " threads";
    }
}

TEST(parallel, an_exception_reaches_the_caller_and_ends_the_loop) {
  constexpr int kCount = 100'000'000;  // far more than are visited while an exception is thrown
  for (const int threads : {1, 2, 8}) {
    std::atomic<int> after{0};
    EXPECT_THROW(parallel_for(kCount, threads,
                              [&](std::size_t i) {
                                if (i == 3) throw std::runtime_error("broken");
                                if (i > 3) ++after;
                              }),
                 std::runtime_error);
    EXPECT_LT(after.load(), kCount - 4) << "no further indices are handed out";
  }
}

TEST(parallel, zero_asks_for_one_worker_per_core) {
  EXPECT_GE(worker_count(0), 1);
  EXPECT_EQ(worker_count(3), 3);
}

TEST(progress, reports_from_several_workers_arrive_one_at_a_time) {
  int inside = 0, reports = 0;
  bool overlapped = false;
  Progress progress({}, [&](const ProgressUpdate& update) {
    overlapped = overlapped || ++inside > 1;
    ++reports;
    EXPECT_EQ(update.stage, say::stage_solving);
    EXPECT_EQ(update.total, 200U);
    --inside;
  });
  parallel_for(200, 4, [&](std::size_t i) { progress.report(say::stage_solving, i, 200); });
  EXPECT_EQ(reports, 200);
  EXPECT_FALSE(overlapped);
  EXPECT_FALSE(progress.cancelled());
}

TEST(progress, cancellation_comes_through_the_stop_token) {
  std::stop_source source;
  const Progress progress(source.get_token());
  EXPECT_FALSE(progress.cancelled());
  source.request_stop();
  EXPECT_TRUE(progress.cancelled());
}

}  // namespace
}  // namespace remount
