#include <gtest/gtest.h>

#include "model/formats/documents/parse_document.h"
#include "model/results/result_file.h"
#include "tests/support/full_records.h"
#include "tests/support/members.h"

namespace remount::results {
namespace {

using Names = std::set<std::string>;

ResultFile read_again(const ResultFile& file, bool json) {
  const formats::DocumentNode document = result_document(file);
  const formats::DocumentNode node = json ? formats::parse_json(formats::to_json(document), "r")
                                          : formats::parse_yaml(formats::to_yaml(document), "r");
  return result_from_document(formats::DocumentView(node, "r"));
}

TEST(result_document, the_full_result_leaves_no_member_as_it_is_from_the_first) {
  EXPECT_EQ(testing::members_not_set(testing::full_result_file()), Names());
}

TEST(result_document, every_member_of_a_result_is_kept) {
  const ResultFile file = testing::full_result_file();
  const Names not_in_files{"result.noise.ins_position_sigma_m",   "result.noise.ins_attitude_sigma_rad",
                           "result.noise.registration_scale",     "result.noise.registration_floor_m",
                           "result.noise.registration_floor_rad", "result.noise.ins_position_drift",
                           "result.noise.ins_attitude_drift"};
  for (const bool json : {false, true})
    EXPECT_EQ(testing::members_that_differ(file, read_again(file, json)), not_in_files);
}

TEST(result_document, a_result_without_anything_comes_back) {
  ResultFile file;
  file.version = "0.0.1-before";
  EXPECT_EQ(testing::members_that_differ(file, read_again(file, false)), Names());
}

}  // namespace
}  // namespace remount::results
