#include "model/formats/poses/motion_pairs_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"

namespace remount::formats {
namespace {

constexpr const char* kHeader =
    "set,i,j,P00,P01,P02,P03,P10,P11,P12,P13,P20,P21,P22,P23,Q00,Q01,Q02,Q03,Q10,Q11,Q12,Q13,Q20,Q21,Q22,Q23\n";
constexpr const char* kIdentity = "1,0,0,0,0,1,0,0,0,0,1,0";

class motion_pairs : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }
  MotionPairs read(const std::string& text) const {
    std::ofstream(path_) << text;
    return read_motion_pairs(path_);
  }
  std::string error_of(const std::string& text) const {
    try {
      read(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("remount_pairs_" + std::to_string(::getpid()) + ".csv");
};

TEST_F(motion_pairs, b_is_i_and_a_is_j) {
  const MotionPairs found = read(std::string("# a comment\n") + kHeader + "one,3,7,0,-1,0,1.5,1,0,0,2,0,0,1,3," +
                                 kIdentity + "\ntwo,3,8," + kIdentity + "," + kIdentity + "\n");
  ASSERT_EQ(found.pairs.size(), 2U);
  EXPECT_EQ(found.sets, (std::vector<std::string>{"one", "two"}));
  const motion::Pair& pair = found.pairs[0];
  EXPECT_EQ(found.keyframes[pair.keyframe_b].scan, index_at<motion::ScanIndex>(3));
  EXPECT_EQ(found.keyframes[pair.keyframe_a].scan, index_at<motion::ScanIndex>(7));
  EXPECT_NEAR(pair.rotation_rad, kPi / 2, 1e-12);
  EXPECT_EQ(pair.ins_b_from_ins_a.translation(), Eigen::Vector3d(1.5, 2, 3));
  EXPECT_EQ(found.keyframes.size(), 4U) << "the same number in another set is another pose";
}

TEST_F(motion_pairs, bad_lines_are_named) {
  const std::string good = std::string("s,0,1,") + kIdentity + "," + kIdentity + "\n";
  EXPECT_EQ(error_of(kHeader + good), "");
  EXPECT_NE(error_of(kHeader + good + "s,1,2,3\n").find(":3: has 4 fields"), std::string::npos)
      << error_of(kHeader + good + "s,1\n");
  EXPECT_NE(error_of(std::string(kHeader) + "s,0,1,2,0,0,0,0,1,0,0,0,0,1,0," + kIdentity + "\n")
                .find(":2: P holds no rotation"),
            std::string::npos);
  EXPECT_NE(error_of(std::string(kHeader) + "s,0,1,nan,0,0,0,0,1,0,0,0,0,1,0," + kIdentity + "\n").find("P00"),
            std::string::npos);
  EXPECT_NE(error_of(std::string(kHeader) + "s,x,1," + kIdentity + "," + kIdentity + "\n").find("'x'"),
            std::string::npos);
  EXPECT_NE(error_of("i,j\n0,1\n").find("P00"), std::string::npos);
  EXPECT_NE(error_of(kHeader).find("no pair"), std::string::npos);
  EXPECT_NE(error_of("").find("empty"), std::string::npos);
}

TEST_F(motion_pairs, published_files_are_read) {
  const std::filesystem::path folder = std::filesystem::path(REMOUNT_SOURCE_DIR) / "../shared/data/pairs";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  EXPECT_EQ(read_motion_pairs(folder / "opencalib_PQ_exact.csv").pairs.size(), 104U);
  EXPECT_EQ(read_motion_pairs(folder / "zxl19_PQ_inspvax_vs_aloam.csv").sets,
            (std::vector<std::string>{"bag1", "bag2", "bag4"}));
  EXPECT_EQ(read_motion_pairs(folder / "kitti_PQ_icp_vs_ins.csv").sets.size(), 4U);
}

}  // namespace
}  // namespace remount::formats
