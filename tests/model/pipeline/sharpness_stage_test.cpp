#include "model/pipeline/sharpness_stage.h"

#include <gtest/gtest.h>

namespace remount::pipeline {
namespace {

std::vector<drive::Finding> said(double result_m, double nominal_m, std::size_t points) {
  std::vector<drive::Finding> findings;
  report_sharpness({{calibration::MountingSource::Result, {0.0, result_m, points}},
                    {calibration::MountingSource::Nominal, {0.0, nominal_m, points}}},
                   findings);
  return findings;
}

TEST(map_check, warns_of_a_map_that_is_blunter_under_the_result) {
  ASSERT_EQ(said(0.03, 0.02, 1000).size(), 1U);
  EXPECT_EQ(said(0.03, 0.02, 1000)[0].code, kMapLessSharp);
  EXPECT_TRUE(said(0.0205, 0.02, 1000).empty());
  EXPECT_TRUE(said(0.02, 0.03, 1000).empty());
}

TEST(map_check, says_nothing_from_a_handful_of_neighbourhoods) {
  EXPECT_EQ(said(0.03, 0.02, 200).size(), 1U);
  EXPECT_TRUE(said(0.03, 0.02, 199).empty());
}

}  // namespace
}  // namespace remount::pipeline
