#include "algorithms/core/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "algorithms/core/progress.h"

namespace remount {
namespace {

TEST(Parallel, EachIndexIsVisitedOnceForAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 7, 64})
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{1000}}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, threads, [&](std::size_t i) { ++visits[i]; });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads << " threads";
    }
}

TEST(Parallel, AnExceptionReachesTheCallerAndEndsTheLoop) {
  for (const int threads : {1, 2, 8}) {
    std::atomic<int> after{0};
    EXPECT_THROW(parallel_for(100'000, threads,
                              [&](std::size_t i) {
                                if (i == 3) throw std::runtime_error("broken");
                                if (i > 3) ++after;
                              }),
                 std::runtime_error);
    EXPECT_LT(after.load(), 100'000 - 4) << "no further indices are handed out";
  }
}

TEST(Parallel, ZeroAsksForOneWorkerPerCore) {
  EXPECT_GE(worker_count(0), 1);
  EXPECT_EQ(worker_count(3), 3);
}

TEST(Progress, ReportsFromSeveralWorkersArriveOneAtATime) {
  int inside = 0, reports = 0;
  bool overlapped = false;
  Progress progress({}, [&](const ProgressUpdate& update) {
    overlapped = overlapped || ++inside > 1;
    ++reports;
    EXPECT_EQ(update.stage, "testing");
    EXPECT_EQ(update.total, 200U);
    --inside;
  });
  parallel_for(200, 4, [&](std::size_t i) { progress.report("testing", i, 200); });
  EXPECT_EQ(reports, 200);
  EXPECT_FALSE(overlapped);
  EXPECT_FALSE(progress.cancelled());
}

TEST(Progress, CancellationComesThroughTheStopToken) {
  std::stop_source source;
  const Progress progress(source.get_token());
  EXPECT_FALSE(progress.cancelled());
  source.request_stop();
  EXPECT_TRUE(progress.cancelled());
}

}  // namespace
}  // namespace remount
