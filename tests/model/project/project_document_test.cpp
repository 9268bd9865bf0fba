#include <gtest/gtest.h>

#include "model/project/project.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/full_records.h"
#include "tests/support/members.h"

namespace remount::project {
namespace {

using Names = std::set<std::string>;

TEST(project_document, the_full_project_leaves_no_member_as_it_is_from_the_first) {
  const Names of_other_use{"output.evidence.session_sweeps.certain", "output.evidence.session_sweeps.direction_known",
                           "output.evidence.session_sweeps.by_times"};
  Names all = of_other_use;
  for (const std::string& name : of_other_use) all.insert("other_lidars.job." + name);
  for (const char* none : {"other_lidars.job.other_lidars", "other_lidars.job.together", "other_lidars.job.notes"})
    all.insert(none);
  EXPECT_EQ(testing::members_not_set(testing::full_project("/data")), all)
      << "of sweeps that a reader suspects and of trials, and what only a calibration hands on";
}

TEST(project_document, every_member_of_a_project_is_kept) {
  const formats::TemporaryFolder folder;
  const Project project = testing::full_project(folder.path());
  save_project(project, folder.path() / "full.remount");
  Names lost = testing::members_that_differ(project, load_project(folder.path() / "full.remount"));
  std::erase_if(lost, [](const std::string& name) { return name.find("result.noise.") != std::string::npos; });
  EXPECT_EQ(lost, Names()) << "all but the noise, which no file has";
}

TEST(project_document, an_empty_project_comes_back) {
  const formats::TemporaryFolder folder;
  save_project(Project(), folder.path() / "empty.remount");
  EXPECT_EQ(testing::members_that_differ(Project(), load_project(folder.path() / "empty.remount")), Names());
}

}  // namespace
}  // namespace remount::project
