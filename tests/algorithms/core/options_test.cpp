#include "algorithms/core/options.h"

#include <gtest/gtest.h>

#include <limits>

#include "algorithms/calibration/search_range.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "algorithms/motion/keyframes.h"
#include "algorithms/motion/pairing.h"
#include "algorithms/registration/registration_options.h"

namespace remount {
namespace {

TEST(options, defaults_are_valid) {
  EXPECT_TRUE(option_problems(calibration::SolveOptions{}).empty());
  EXPECT_TRUE(option_problems(calibration::SearchRange{}).empty());
  EXPECT_TRUE(option_problems(registration::RegistrationOptions{}).empty());
  EXPECT_TRUE(option_problems(motion::KeyframeOptions{}).empty());
  EXPECT_TRUE(option_problems(motion::PairingOptions{}).empty());
}

TEST(options, every_problem_is_named_not_only_the_first) {
  registration::RegistrationOptions options;
  options.voxel_m = -1.0;
  options.max_iterations = 0;
  options.min_overlap = std::numeric_limits<double>::quiet_NaN();
  options.algorithm = static_cast<registration::RegistrationAlgorithm>(9);
  const std::vector<std::string> problems = english(option_problems(options));
  ASSERT_EQ(problems.size(), 4U);
  std::string all;
  for (const std::string& problem : problems) all += problem + "\n";
  for (const char* name : {"voxel_m", "max_iterations", "min_overlap", "algorithm"})
    EXPECT_NE(all.find(name), std::string::npos) << all;
}

TEST(error, tells_where_before_what_and_keeps_both) {
  const Error error(ErrorCode::Format, "scan.pcd:7", Message::verbatim("expected a number"));
  EXPECT_STREQ(error.what(), "scan.pcd:7: expected a number");
  EXPECT_EQ(error.where(), "scan.pcd:7");
  EXPECT_EQ(english(error.what_happened()), "expected a number");
  EXPECT_EQ(error.code(), ErrorCode::Format);
  EXPECT_STREQ(Error(ErrorCode::Io, "", Message::verbatim("disk full")).what(), "disk full");
}

}  // namespace
}  // namespace remount
