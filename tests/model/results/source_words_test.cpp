#include "model/results/source_words.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"

namespace remount {
namespace {

TEST(source_words, are_those_of_files_in_english_and_told_in_chinese) {
  for (const char* source : {"nominal", "result", "refined", "joint clouds", "pair 12", "pairs 3 + 17",
                             "all pairs: Park-Martin", "all pairs: dual quaternion", "all pairs: joint quadratic",
                             "all pairs: certified optimum", "all pairs: best found in range"}) {
    EXPECT_EQ(english(source_words(source)), source);
    EXPECT_NE(render(source_words(source), Language::Chinese), source);
  }
}

TEST(source_words, what_is_not_known_stays_as_it_is) {
  for (const char* source : {"", "pair", "pair 12 of 13", "of a later version"})
    EXPECT_EQ(render(source_words(source), Language::Chinese), source);
}

}  // namespace
}  // namespace remount
