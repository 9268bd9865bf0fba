#include "algorithms/core/index.h"

#include <gtest/gtest.h>

#include <optional>
#include <type_traits>
#include <vector>

#include "algorithms/motion/pair.h"

namespace remount {

using motion::KeyframeIndex;
using motion::PairIndex;

namespace {

template <class A, class B>
concept Comparable = requires(A a, B b) {
  a == b;
};
template <class A, class B>
concept Ordered = requires(A a, B b) {
  a < b;
};
template <class A, class B>
concept Assignable = requires(A a, B b) {
  a = b;
};

// A list is asked by a place as it is.
static_assert(std::is_convertible_v<KeyframeIndex, std::size_t>);
// It is made of a number only where that is written...
static_assert(!std::is_convertible_v<std::size_t, KeyframeIndex> && !std::is_convertible_v<int, KeyframeIndex>);
static_assert(std::is_constructible_v<KeyframeIndex, std::size_t>);
static_assert(!Assignable<KeyframeIndex&, int> && !Assignable<KeyframeIndex&, std::size_t>);
// ... and never becomes one in another list.
static_assert(!std::is_convertible_v<KeyframeIndex, motion::SessionIndex> &&
              !std::is_convertible_v<PairIndex, KeyframeIndex>);
static_assert(!std::is_constructible_v<KeyframeIndex, motion::SessionIndex>);
static_assert(!Assignable<motion::SessionIndex&, motion::ScanIndex> &&
              !Assignable<std::optional<PairIndex>&, KeyframeIndex>);
static_assert(Comparable<PairIndex, PairIndex> && Ordered<PairIndex, PairIndex>);
static_assert(!Comparable<PairIndex, KeyframeIndex> && !Ordered<motion::SessionIndex, motion::ScanIndex>);
// How far apart places are may be negative, which a place is not.
template <class A, class B>
concept Subtracted = requires(A a, B b) {
  a - b;
};
static_assert(!Subtracted<KeyframeIndex, KeyframeIndex> && !Subtracted<KeyframeIndex, PairIndex>);
// The first place is no "none".
static_assert(!std::is_constructible_v<bool, motion::SessionIndex>);
static_assert(sizeof(KeyframeIndex) == sizeof(std::size_t) && std::is_trivially_copyable_v<KeyframeIndex>);

TEST(index, asks_a_list_and_walks_through_it) {
  const std::vector<double> values{2.0, 3.0, 5.0};
  double sum = 0.0;
  for (PairIndex pair; pair < values.size(); ++pair) sum += values[pair];
  EXPECT_EQ(sum, 10.0);
  EXPECT_EQ(values.at(index_at<PairIndex>(2)), 5.0);
  EXPECT_EQ(PairIndex(), index_at<PairIndex>(0));
  EXPECT_LT(index_at<PairIndex>(1), index_at<PairIndex>(2));
  auto pair = index_at<PairIndex>(1);
  EXPECT_EQ(pair++, index_at<PairIndex>(1));
  EXPECT_EQ(pair, index_at<PairIndex>(2));
}

TEST(index, of_an_enumeration_counts_its_values_and_of_a_grid_its_cells_row_by_row) {
  static_assert(index_of(motion::PairState::Proposed) == 0 && index_of(motion::PairState::Rejected) == 2);
  std::size_t next = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) EXPECT_EQ(cell_at(row, column, 4), next++);
  EXPECT_EQ(cell_count(3, 4), next) << "the size of all";
}

TEST(index, is_the_same_number_in_files_and_matrices) {
  EXPECT_EQ(signed_of(index_at<motion::SessionIndex>(7)), 7);
  EXPECT_EQ(index_at<motion::SessionIndex>(7), index_at<motion::SessionIndex>(7));
  EXPECT_EQ(signed_of(index_at<motion::ScanIndex>(2)) - signed_of(index_at<motion::ScanIndex>(5)), -3);
}

}  // namespace
}  // namespace remount
