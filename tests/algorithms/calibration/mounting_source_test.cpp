#include "algorithms/calibration/mounting_source.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"

namespace remount::calibration {
namespace {

TEST(mounting_source, comes_back_from_what_files_have_and_is_told_in_both_languages) {
  for (const char* text : {"nominal", "result", "refined", "joint clouds", "pair 12", "pairs 3 + 17",
                           "all pairs: Park-Martin", "all pairs: dual quaternion", "all pairs: joint quadratic",
                           "all pairs: certified optimum", "all pairs: best found in range"}) {
    const MountingSource source = mounting_source_from_string(text);
    EXPECT_NE(source.kind, MountingSource::Unknown) << text;
    EXPECT_EQ(to_string(source), text);
    EXPECT_NE(render(in_words(source), Language::Chinese), text);
  }
  EXPECT_EQ(mounting_source_from_string("pairs 3 + 17"),
            MountingSource::pairs(motion::PairIndex{3}, motion::PairIndex{17}));
}

TEST(mounting_source, what_is_not_known_stays_as_it_is) {
  for (const char* text : {"", "pair", "pair 12 of 13", "pair 012", "pair 99999999999", "of a later version"}) {
    const MountingSource source = mounting_source_from_string(text);
    EXPECT_EQ(source.kind, MountingSource::Unknown) << text;
    EXPECT_EQ(to_string(source), text);
    EXPECT_EQ(render(in_words(source), Language::Chinese), text);
  }
}

}  // namespace
}  // namespace remount::calibration
