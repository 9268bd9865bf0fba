// The program itself while the system calls fail by which it saves, and while a window has the project.
#include <gtest/gtest.h>

#include <csignal>
#include <random>

#include "model/project/holder_lock.h"
#include "model/results/exporters/exporter.h"
#include "tests/app/cli/program_fixture.h"
#include "tests/support/draws.h"
#include "tests/support/fault_law.h"

namespace remount::cli {
namespace {

class cli_save_faults : public ProgramFixture<cli_save_faults> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive("--duration-s 1.5 --beams 12 --azimuth-steps 200");
    folder_ = std::filesystem::canonical(folder_);
    for (const double x_m : {1.0, 2.0}) {
      results::ResultFile file;
      file.ins_axes = drive::InsAxes::ForwardLeftUp;
      file.result.status = calibration::Status::Ok;
      file.result.set_observed(calibration::ParameterSet::all(), {});
      file.result.covariance = Matrix6d::Identity() * 1e-6;
      file.result.mounting.reference_from_sensor = rigid_from_six({x_m, -0.3, 0.8, 0.1, 0.02, -0.02});
      results::save_result(file, path(x_m < 1.5 ? "old.yaml" : "new.yaml"));
    }
  }
  static std::vector<std::string> export_of(const std::string& result) {
    return {REMOUNT_CLI, "export", path(result), "--to", "autoware", "-o", path("out/kit.yaml")};
  }
  /// What the two results are exported as.
  static testing::SavedFile exported_file() {
    std::filesystem::create_directories(folder_ / "out");
    testing::SavedFile file{folder_ / "out" / "kit.yaml", {}, {}, {}};
    std::filesystem::remove(file.path);
    for (const char* result : {"new.yaml", "old.yaml"}) {
      EXPECT_EQ(testing::run_program_traced(folder_ / "out", export_of(result)).exit_code, 0);
      (result == std::string("new.yaml") ? file.new_bytes : file.old_bytes) = testing::bytes_of(file.path);
    }
    EXPECT_NE(file.old_bytes, file.new_bytes);
    return file;
  }
};

TEST_F(cli_save_faults, of_an_export_leave_the_old_or_the_new_file_and_the_exit_code_says_which) {
  if (const std::string why = testing::why_tracing_is_impossible(); !why.empty()) GTEST_SKIP() << why;
  const testing::SavedFile file = exported_file();
  for (const int error : testing::kErrors) {
    const std::size_t calls = testing::for_every_call(
        {0, testing::Fault::Kind::Error, error},
        [&](const testing::Fault& fault) {
          file.put_old();
          return testing::run_program_traced(folder_ / "out", export_of("new.yaml"), fault);
        },
        [&](const testing::TracedRun& run, const testing::Fault& fault) {
          testing::check_saved(file, run, fault);
          EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 2) << testing::told(run, fault);
        });
    EXPECT_GT(calls, 10U);
  }
}

TEST_F(cli_save_faults, an_export_that_is_killed_leaves_the_old_or_the_new_file) {
  ONLY_IN_LONG_TESTS();
  if (const std::string why = testing::why_tracing_is_impossible(); !why.empty()) GTEST_SKIP() << why;
  const int kKills = testing::draws_all() ? 200 : 100;
  const testing::SavedFile file = exported_file();
  const std::vector<std::string> words = export_of("new.yaml");
  file.put_old();
  const std::size_t calls = testing::run_program_traced(folder_ / "out", words).calls.size();
  ASSERT_GT(calls, 0U);
  std::mt19937 dice(20);
  int old_files = 0;
  for (int i = 0; i < kKills && !HasFailure(); ++i) {
    file.put_old();
    const testing::Fault fault{1 + dice() % calls,
                               i % 2 == 0 ? testing::Fault::Kind::KillBefore : testing::Fault::Kind::KillAfter, 0};
    const testing::TracedRun run = testing::run_program_traced(folder_ / "out", words, fault);
    EXPECT_EQ(run.exit_code, 128 + SIGKILL) << testing::told(run, fault);
    old_files += file.is_old() ? 1 : 0;
    EXPECT_TRUE(file.is_old() || file.is_new()) << testing::told(run, fault);
    // What it left beside the file does not stop the next one.
    if (i % 20 == 0) {
      EXPECT_EQ(testing::run_program_traced(folder_ / "out", words).exit_code, 0) << testing::told(run, fault);
    }
  }
  EXPECT_TRUE(old_files > 0 && old_files < kKills) << old_files << " of " << kKills << " were old";
  std::printf("killed %d times at %zu calls: %d old files, the others new\n", kKills, calls, old_files);
}

TEST_F(cli_save_faults, a_project_that_is_open_is_not_saved_over) {
  const std::string project = path("job.remount");
  {
    const auto window = project::HolderLock::take(project::lock_path_of(project));
    ASSERT_TRUE(window.lock) << window.why_none;
    const Outcome refused = run("calibrate " + path("drive") + " --save-project " + project);
    EXPECT_EQ(refused.code, 2) << refused.err;
    for (const std::string& part : {project, std::string("is open in another window"), project::this_holder().user,
                                    "process " + std::to_string(project::this_holder().process)})
      EXPECT_NE(refused.err.find(part), std::string::npos) << part << " is not in: " << refused.err;
    EXPECT_FALSE(std::filesystem::exists(project));
  }
  const Outcome done = run("calibrate " + path("drive") + " --save-project " + project);
  EXPECT_TRUE(std::filesystem::exists(project)) << done.err;
  EXPECT_FALSE(std::filesystem::exists(project::lock_path_of(project)));
}

}  // namespace
}  // namespace remount::cli
