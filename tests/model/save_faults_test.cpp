// Every system call of every kind of saving fails once, and processes are killed while they save.
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <climits>
#include <random>

#include "algorithms/core/error.h"
#include "model/formats/files/append_file.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/output_file.h"
#include "model/project/project.h"
#include "model/report/report.h"
#include "model/results/exporters/exporter.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/fault_law.h"

namespace remount::testing {
namespace {

constexpr int kKills = 200;  // of each kind of file

results::ResultFile sample_result(bool newer) {
  results::ResultFile file;
  file.ins_axes = drive::InsAxes::ForwardLeftUp;
  file.result.status = calibration::Status::Ok;
  file.result.set_observed(calibration::ParameterSet::all(), {});
  file.result.covariance = Matrix6d::Identity() * 1e-6;
  file.result.mounting.reference_from_sensor = rigid_from_six({newer ? 2.0 : 1.0, -0.3, 0.8, 0.1, 0.02, -0.02});
  return file;
}

project::Project sample_project(bool newer) {
  project::Project project;
  project.sessions = {"/data/drive1", "/data/drive2"};
  project.nominal_ins_from_lidar = rigid_from_six({newer ? 2.0 : 1.0, 0, 1, 0.1, 0, 0});
  pipeline::PipelineOutput output;
  output.result = sample_result(newer).result;
  for (int i = 0; i < (newer ? 300 : 200); ++i)
    output.keyframes.push_back({motion::SessionIndex{0}, index_at<motion::ScanIndex>(i), 100LL * i, 0.1 * i});
  project.output = output;
  project.basis = {2, project.settings, project.nominal_ins_from_lidar};
  return project;
}

struct Kind {
  const char* name;
  const char* file;
  void (*save)(const std::filesystem::path& path, bool newer);
};

void save_export(const std::filesystem::path& path, bool newer) {
  const results::Exporter& format = results::exporter("autoware");
  results::check_replaces_export(path, format);
  formats::save_atomically(path, format.write(sample_result(newer), {}));
}

void save_report(const std::filesystem::path& path, bool newer) {
  report::Report report;
  report.file = sample_result(newer);
  formats::save_atomically(path, report::report_html(report));
}

void record(const std::filesystem::path& path, bool newer) {
  formats::AppendFile file(path);
  for (int i = 0; i < 4; ++i) file.append(std::string(5000, newer ? 'n' : 'o'));
  file.overwrite(100, newer ? "new" : "old");
  file.finish();
}

const Kind kKinds[] = {
    {"project", "job.remount",
     [](const auto& path, bool newer) { project::save_project(sample_project(newer), path); }},
    {"result", "result.yaml", [](const auto& path, bool newer) { results::save_result(sample_result(newer), path); }},
    {"json", "result.json", [](const auto& path, bool newer) { results::save_result(sample_result(newer), path); }},
    {"export", "sensor_kit_calibration.yaml", save_export},
    {"report", "report.html", save_report},
    {"scan", "scan.bin",
     [](const auto& path, bool newer) { formats::write_file(path, std::string(40000, newer ? 'n' : 'o')); }},
    {"recording", "drive.mcap", record},
};

class save_faults : public ::testing::TestWithParam<Kind> {
 protected:
  void SetUp() override {
    if (const std::string why = why_tracing_is_impossible(); !why.empty()) GTEST_SKIP() << why;
    GetParam().save(file_.path, true);
    file_.new_bytes = bytes_of(file_.path);
    std::filesystem::remove(file_.path);
    GetParam().save(file_.path, false);
    file_.old_bytes = bytes_of(file_.path);
    ASSERT_NE(file_.old_bytes, file_.new_bytes);
    ASSERT_FALSE(file_.old_bytes.empty());
  }

  std::string save() const {
    return formats::error_of([&] { GetParam().save(file_.path, true); });
  }
  TracedRun saved_with(const Fault& fault) const {
    file_.put_old();
    return run_traced(
        folder_.path(),
        [&] {
          begin_faults();
          return save();
        },
        fault);
  }
  /// What a killed process leaves beside the file must not stop the next save.
  void expect_whole_and_savable(const std::string& what) const {
    EXPECT_TRUE(file_.is_old() || file_.is_new()) << what << ": " << bytes_of(file_.path).size() << " bytes";
    EXPECT_EQ(save(), "") << what;
    EXPECT_TRUE(file_.is_new()) << what;
  }

  QuickFolder folder_;
  SavedFile file_{folder_.path() / GetParam().file, {}, {}, "drive.mcap.active"};
};

TEST_P(save_faults, any_system_call_may_fail) {
  std::size_t calls = 0;
  for (const int error : kErrors)
    calls = for_every_call(
        {0, Fault::Kind::Error, error}, [&](const Fault& fault) { return saved_with(fault); },
        [&](const TracedRun& run, const Fault& fault) { check_saved(file_, run, fault); });
  EXPECT_GE(calls, 5U) << "opening, writing, closing, renaming at the least";
  RecordProperty("calls", static_cast<int>(calls));
}

TEST_P(save_faults, any_write_may_take_a_part_only) {
  for_every_call(
      {0, Fault::Kind::Partly, 0}, [&](const Fault& fault) { return saved_with(fault); },
      [&](const TracedRun& run, const Fault& fault) { check_saved(file_, run, fault); });
}

TEST_P(save_faults, a_process_killed_at_any_system_call_leaves_the_old_or_the_new_file) {
  const std::size_t calls = saved_with({}).calls.size();
  ASSERT_GT(calls, 0U);
  std::mt19937 dice(20);
  int old_files = 0;
  for (int i = 0; i < kKills / 2 && !HasFailure(); ++i) {
    const Fault fault{1 + dice() % calls, dice() % 2 == 0 ? Fault::Kind::KillBefore : Fault::Kind::KillAfter, 0};
    const TracedRun run = saved_with(fault);
    EXPECT_EQ(run.exit_code, 128 + SIGKILL);
    old_files += file_.is_old() ? 1 : 0;
    expect_whole_and_savable(told(run, fault));
  }
  EXPECT_TRUE(old_files > 0 && old_files < kKills / 2) << old_files << " of " << kKills / 2 << " were old";
}

TEST_P(save_faults, a_process_killed_at_any_moment_leaves_the_old_or_the_new_file) {
  const auto save = [&](int run) { GetParam().save(file_.path, run % 2 == 0); };
  const auto longest_life_us = static_cast<unsigned>(life_of_two_runs_us(save, 3000));
  std::mt19937 dice(20);
  int saves = 0;
  for (int i = 0; i < kKills / 2 && !HasFailure(); ++i) {
    file_.put_old();
    saves += run_and_kill(save, static_cast<int>(dice() % longest_life_us));
    expect_whole_and_savable("killed after " + std::to_string(saves) + " saves in all");
  }
  EXPECT_GT(saves, 0) << "no process came as far as to save anything";
}

TEST_P(save_faults, a_folder_that_forbids_it_keeps_its_file_and_is_named) {
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0555));
  const TracedRun run = run_traced(folder_.path(), [&] {
    if (::getuid() == 0 && ::setuid(65534) != 0) return std::string("cannot become somebody else");
    return save();
  });
  std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
  EXPECT_TRUE(formats::contains(run.said, file_.path.string()) && formats::contains(run.said, "Permission denied"))
      << run.said;
  EXPECT_TRUE(file_.is_old());
}

TEST_P(save_faults, a_read_only_file_system_keeps_its_file_and_is_named) {
  const TracedRun run = run_traced(folder_.path(), [&] {
    const char* folder = folder_.path().c_str();
    if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount(folder, folder, nullptr, MS_BIND, nullptr) != 0 ||
        ::mount("none", folder, nullptr, MS_REMOUNT | MS_BIND | MS_RDONLY, nullptr) != 0)
      return std::string("no mounts");
    return save();
  });
  if (run.said == "no mounts") GTEST_SKIP() << "only root can mount a folder read-only";
  EXPECT_TRUE(formats::contains(run.said, file_.path.string()) && formats::contains(run.said, "Read-only file system"))
      << run.said;
  EXPECT_TRUE(file_.is_old());
}

TEST_P(save_faults, names_of_any_language_and_length_are_saved) {
  const std::string end = file_.path.extension().string();
  if (GetParam().save == record) GTEST_SKIP() << "the program names its recordings itself";
  std::string chinese;
  while (chinese.size() + 3 + end.size() <= NAME_MAX) chinese += "\u6807";
  std::filesystem::path deep = folder_.path();
  while (deep.string().size() + 200 < PATH_MAX - 20) deep /= std::string(100, 'd');
  deep /= std::string(PATH_MAX - 1 - deep.string().size() - 3 - end.size(), 'e');
  const std::vector<std::filesystem::path> paths = {
      folder_.path() / ("\u6807\u5b9a \u2013 gr\u00f6\u00dfer \U0001F697" + end),
      folder_.path() / (std::string(NAME_MAX - end.size(), 'x') + end),
      folder_.path() / (chinese + end),
      deep / ("r" + end),
  };
  EXPECT_EQ(paths[1].filename().string().size(), std::size_t{NAME_MAX});
  EXPECT_EQ(paths[3].string().size(), std::size_t{PATH_MAX - 1}) << "with its end, as long as the system takes";
  for (const std::filesystem::path& path : paths) {
    std::filesystem::create_directories(path.parent_path());
    for (const bool newer : {false, true}) {
      EXPECT_EQ(formats::error_of([&] { GetParam().save(path, newer); }), "") << path;
      // Where the sessions lie is written relative to the project; what follows is the same anywhere.
      const std::string &bytes = newer ? file_.new_bytes : file_.old_bytes, saved = bytes_of(path);
      EXPECT_TRUE(path.parent_path() == folder_.path() ? saved == bytes
                                                       : saved.ends_with(bytes.substr(bytes.size() / 2)))
          << path << " holds " << saved.size() << " bytes";
    }
    std::filesystem::remove(path);
    const std::filesystem::path first =
        *std::next(deep.begin(), std::distance(folder_.path().begin(), folder_.path().end()));
    std::set<std::string> left = names_in(folder_.path());
    left.erase(first.string());
    EXPECT_EQ(left, std::set<std::string>{GetParam().file}) << path;
  }
  const std::string error =
      formats::error_of([&] { GetParam().save(folder_.path() / (std::string(256, 'x') + end), true); });
  EXPECT_TRUE(formats::contains(error, "File name too long") && formats::contains(error, "xxx" + end)) << error;
}

INSTANTIATE_TEST_SUITE_P(of, save_faults, ::testing::ValuesIn(kKinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace remount::testing
