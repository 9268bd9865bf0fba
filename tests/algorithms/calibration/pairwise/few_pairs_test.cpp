#include "algorithms/calibration/pairwise/few_pairs.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <utility>
#include <vector>

namespace remount::calibration {
namespace {

// 99.865 % quantiles of Student's t, from tables.
TEST(few_pairs, student_is_as_in_the_tables) {
  for (const auto& [freedom, quantile] : {std::pair{3.0, 9.219}, std::pair{4.0, 6.620}, std::pair{6.0, 4.904},
                                          std::pair{12.0, 3.764}, std::pair{30.0, 3.270}, std::pair{100.0, 3.077}}) {
    std::printf("  %.0f degrees of freedom: %.3f (%.3f)\n", freedom, student_of_three_sigma(freedom), quantile);
    EXPECT_NEAR(student_of_three_sigma(freedom), quantile, 0.025 * quantile);
  }
}

TEST(few_pairs, sigma_widens_the_fewer_they_are_and_the_less_is_believed_and_not_from_forty_on) {
  double before = 100.0;
  for (const int motions : {3, 4, 6, 10, 20, 39}) {
    const double assumed = widening_of_few(motions, 1.5), declared = widening_of_few(motions, 0.3);
    std::printf("  %d motions: %.3f where noise is assumed, %.3f where it is declared\n", motions, assumed, declared);
    EXPECT_LT(assumed, before);
    EXPECT_LE(declared, assumed);
    before = assumed;
  }
  for (const int motions : {40, 41, 200, 10000}) EXPECT_EQ(widening_of_few(motions, 1.5), 1.0);
}

TEST(few_pairs, that_share_keyframes_repeat_each_other) {
  JointProblem problem;
  problem.terms.resize(3);
  for (int i = 0; i < 3; ++i) {
    problem.terms[static_cast<std::size_t>(i)].node_a = index_at<motion::KeyframeIndex>(2 * i);
    problem.terms[static_cast<std::size_t>(i)].node_b = index_at<motion::KeyframeIndex>(2 * i + 1);
  }
  EXPECT_EQ(independent_motions(problem), 3);
  problem.terms.back().weight = 0.0;
  EXPECT_EQ(independent_motions(problem), 2) << "what is left out says nothing";
  problem.terms.assign(10, {});
  for (JointTerm& term : problem.terms) term.node_b = motion::KeyframeIndex{1};
  EXPECT_EQ(independent_motions(problem), 1);
}

TEST(few_pairs, of_keyframes_that_are_linked_are_one_fewer_than_those) {
  for (const int keyframes : {2, 4, 5, 6}) {
    JointProblem chain, complete;
    for (int b = 1; b < keyframes; ++b)
      for (int a = 0; a < b; ++a) {
        JointTerm term;
        term.node_a = index_at<motion::KeyframeIndex>(a);
        term.node_b = index_at<motion::KeyframeIndex>(b);
        complete.terms.push_back(term);
        if (a + 1 == b) chain.terms.push_back(term);
      }
    std::printf("  %d keyframes: %d motions in a chain, %d in %zu pairs of all with all\n", keyframes,
                independent_motions(chain), independent_motions(complete), complete.terms.size());
    EXPECT_EQ(independent_motions(chain), keyframes - 1);
    EXPECT_EQ(independent_motions(complete), keyframes - 1);
    // Another drive's pairs are linked to none of these.
    const std::vector<JointTerm> first = complete.terms;
    for (JointTerm term : first) {
      term.node_a = motion::KeyframeIndex(term.node_a + 100);
      term.node_b = motion::KeyframeIndex(term.node_b + 100);
      complete.terms.push_back(term);
    }
    EXPECT_EQ(independent_motions(complete), 2 * (keyframes - 1));
  }
}

}  // namespace
}  // namespace remount::calibration
