// Limits of control groups, on machines that are made up of files.
#include "app/cli/group_limits.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace remount::cli {
namespace {

namespace fs = std::filesystem;

class group_limits : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "remount_groups_XXXXXX").string();
    root_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  void in_group(const std::string& lines) const { write("proc/self/cgroup", lines); }

  fs::path root_;
};

TEST_F(group_limits, nothing_is_known_where_nothing_is_told) {
  const GroupLimits limits = limits_of_group(root_);
  EXPECT_FALSE(limits.memory_bytes.known);
  EXPECT_FALSE(limits.memory_bytes.most || limits.processors);
}

TEST_F(group_limits, of_version_2_are_the_smallest_on_the_way_up) {
  in_group("0::/user.slice/job.scope\n");
  const std::string mount = "sys/fs/cgroup/";
  write(mount + "user.slice/job.scope/cgroup.controllers", "cpu memory\n");
  write(mount + "user.slice/job.scope/memory.max", "max\n");
  write(mount + "user.slice/job.scope/cpu.max", "300000 100000\n");
  EXPECT_TRUE(limits_of_group(root_).memory_bytes.known);
  EXPECT_FALSE(limits_of_group(root_).memory_bytes.most) << "none is known, and is none";
  write(mount + "user.slice/memory.max", "4000000000\n");
  write(mount + "user.slice/cpu.max", "150000 100000\n");
  write(mount + "memory.max", "8000000000\n");
  EXPECT_EQ(limits_of_group(root_).memory_bytes.most, 4000000000U);
  EXPECT_EQ(limits_of_group(root_).processors, 1.5);
}

TEST_F(group_limits, of_version_2_are_none_in_the_group_that_holds_all) {
  in_group("0::/\n");
  EXPECT_FALSE(limits_of_group(root_).memory_bytes.known) << "not mounted";
  write("sys/fs/cgroup/cgroup.controllers", "cpu memory\n");
  EXPECT_TRUE(limits_of_group(root_).memory_bytes.known);
  EXPECT_FALSE(limits_of_group(root_).memory_bytes.most);
}

TEST_F(group_limits, of_a_group_outside_of_the_namespace_are_unknown) {
  in_group("0::/../elsewhere\n");
  write("sys/fs/cgroup/memory.max", "8000000000\n");
  EXPECT_FALSE(limits_of_group(root_).memory_bytes.known);
}

TEST_F(group_limits, of_version_1_are_those_of_the_controllers) {
  in_group("9:name=systemd:/\n4:hugetlb,memory:/docker/17\n1:cpu,cpuacct:/docker/17\n0::/\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  write("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "-1\n");
  write("sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n");
  EXPECT_TRUE(limits_of_group(root_).memory_bytes.known) << "in a container its group is the mount itself";
  EXPECT_FALSE(limits_of_group(root_).memory_bytes.most);
  EXPECT_FALSE(limits_of_group(root_).processors);
  write("sys/fs/cgroup/memory/docker/17/memory.limit_in_bytes", "2147483648\n");
  write("sys/fs/cgroup/cpu/docker/17/cpu.cfs_quota_us", "50000\n");
  write("sys/fs/cgroup/cpu/docker/17/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(limits_of_group(root_).memory_bytes.most, 2147483648U);
  EXPECT_EQ(limits_of_group(root_).processors, 0.5);
}

}  // namespace
}  // namespace remount::cli
