#include "model/formats/files/cut_line.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace remount::formats {
namespace {

class cut_lines : public ::testing::Test {
 protected:
  /// What is left of `table` and a last line.
  std::string kept(const std::string& table, const std::string& last) {
    findings_.clear();
    return std::string(without_cut_line(table_ = table + last, "ins.csv", findings_));
  }
  void expect_whole(const std::string& table, const std::string& last) {
    EXPECT_EQ(kept(table, last), table + last);
    EXPECT_TRUE(findings_.empty()) << last;
  }
  void expect_cut(const std::string& table, const std::string& last) {
    EXPECT_EQ(kept(table, last), table) << last;
    ASSERT_EQ(findings_.size(), 1U) << last;
    EXPECT_EQ(findings_[0].code + " " + drive::english(findings_[0].where),
              "log-cut ins.csv:" + std::to_string(1 + std::count(table.begin(), table.end(), '\n')));
  }
  std::string table_;
  std::vector<drive::Finding> findings_;
};

TEST_F(cut_lines, a_number_that_lost_what_makes_it_another_is_left_out_and_said) {
  const std::string decimals = "t,x,z\n1000,2.51,250.7\n\n1001,2.52,250.71\n# stop\n1002,2.5,250.7\n1003,2.5,99.75\n";
  for (const char* cut : {"1004,2.53,2", "1004,2.53,250", "1004,2.53,250.", "1004,2.5", "1004,", "1"})
    expect_cut(decimals, cut);
  for (const char* whole : {"1004,2.53,250.7", "1004,2,9.5", "1004,2.53,250.7\n", "1004,2.53,250.7\r\n", "", "\n",
                            "# the end", "1004,2.53,250.71234,7"})
    expect_whole(decimals, whole);
  const std::string stamps =
      "file,stamp_ns\na.pcd,1700000011000000000\nb.pcd,1700000011100000000\n"
      "c.pcd,1700000011200000000\nd.pcd,1700000011300000000\n";
  expect_cut(stamps, "e.pcd,17000000114");
  expect_cut(stamps, "e.pcd,170000001140000000");
  expect_whole(stamps, "e.pcd,1700000011400000000");
  const std::string blanks = "1.0 2 0.12345\n1.1 2 0.12346\n1.2 2 1.12347e-05\n1.3 2 0.12348\n";
  expect_cut(blanks, "1.4 2 0.1");
  expect_cut(blanks, "1.4 2 1.1234e-0");
  expect_whole(blanks, "1.4 2 0.1234");
}

TEST_F(cut_lines, what_does_not_show_that_it_was_cut_is_kept) {
  const std::string words = "t,x,quality\n1000,2.5,good\n1001,2.5,good\n1002,2.5,degraded\n1003,2.5,good\n";
  expect_whole(words, "1004,2.5,good");
  expect_cut(words, "1004,2.5");
  expect_whole("t,x\n1000,2.51\n", "1001,2");
  expect_whole("", "no line end");
  EXPECT_EQ(kept(words, "\x1a"), words) << "the end of a file, to DOS";
  EXPECT_TRUE(findings_.empty());
}

}  // namespace
}  // namespace remount::formats
