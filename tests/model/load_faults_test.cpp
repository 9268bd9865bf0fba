// Data that fail or disappear while they are read: a session is whole, or the error says what could not be read.
#include <unistd.h>

#include <algorithm>
#include <random>

#include "algorithms/messages/render.h"
#include "model/formats/session_readers.h"
#include "model/simulator/simulator.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/fault_law.h"
#include "tests/support/findings.h"

namespace remount::testing {
namespace {

simulator::SimulationOptions tiny_drive() {
  simulator::SimulationOptions options;
  options.duration_s = 0.5;
  options.scan_rate_hz = 10.0;
  options.beams = 4;
  options.azimuth_steps = 40;
  options.clockwise = false;  // as KITTI's turns
  return options;
}

class load_faults : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const std::string why = why_tracing_is_impossible(); !why.empty()) GTEST_SKIP() << why;
    Progress progress;
    simulator::write_drive(simulator::simulate_drive(tiny_drive()), drive_, GetParam(), 1, progress);
    before_ = loaded(drive_);
  }

  struct Loaded {
    drive::Session session;
    std::vector<std::size_t> points;  ///< of each scan
  };
  static Loaded loaded(const std::filesystem::path& path) {
    Progress progress;
    Loaded all{formats::open_session(path, progress), {}};
    for (std::size_t i = 0; all.session.scans && i < all.session.scans->size(); ++i)
      all.points.push_back(all.session.scans->load(i).size());
    return all;
  }
  static std::string contents_of(const Loaded& all) {
    std::string text = std::to_string(all.session.ins.size()) + " of the INS, " +
                       std::to_string(all.session.world_from_ins.size() + all.session.odometry_from_lidar.size()) +
                       " poses, " + std::to_string(all.session.imu.size()) + " of the IMU, scans of";
    for (const std::size_t points : all.points) text += " " + std::to_string(points);
    return text;
  }
  /// What came of loading the drive: nothing where it is whole; the error, or the findings that say what is not; what
  /// is different without a word.
  std::string outcome() const {
    try {
      const Loaded now = loaded(drive_);
      if (contents_of(now) == contents_of(before_)) return "";
      std::string said;
      for (const drive::Finding& finding : now.session.findings)
        if (!was_found(finding.code))
          said += drive::english(finding.where) + ": " + english(finding.explanation) + "\n";
      return said.empty() ? "silently other: " + contents_of(now) : said;
    } catch (const Error& error) {
      return error.what();
    }
  }

  bool was_found(const std::string& code) const { return has_code(before_.session.findings, code); }

  QuickFolder folder_;
  std::filesystem::path drive_ = folder_.path() / "drive";
  Loaded before_;
};

TEST_P(load_faults, no_call_that_fails_makes_a_session_smaller_without_a_word) {
  const auto run_with = [&](const Fault& fault) {
    return run_traced(
        drive_,
        [&] {
          begin_faults();
          return outcome();
        },
        fault);
  };
  constexpr std::array<int, 3> kErrors{EIO, EINTR, EACCES};
  constexpr int kRuns = 120;  // of hundreds of calls: each run makes them all
  const std::size_t calls = run_with({}).calls.size();
  std::mt19937 dice(20);
  int errors = 0;
  for (int i = 0; i < kRuns && !HasFailure(); ++i) {
    // Most calls are those of readers that find out whether a drive is theirs: it is read by the last.
    const std::size_t before = i % 2 == 0 ? 0 : 3 * calls / 4;
    const Fault fault{before + 1 + dice() % (calls - before), Fault::Kind::Error, kErrors[dice() % kErrors.size()]};
    const TracedRun run = run_with(fault);
    EXPECT_NE(run.said.rfind("silently", 0), 0U) << told(run, fault);
    if (run.exit_code == 0) continue;
    ++errors;
    EXPECT_NE(fault.error, EINTR) << "is tried again\n" << told(run, fault);
    EXPECT_NE(run.said.find(drive_.string()), std::string::npos) << told(run, fault);
    // What fails while formats are tried makes none of them fit.
    EXPECT_TRUE(formats::contains(run.said, std::strerror(fault.error)) ||
                formats::contains(run.said, "is no session ") || formats::contains(run.said, "holds no "))
        << told(run, fault);
  }
  std::printf("%d of %d runs with a fault in one of %zu calls were refused\n", errors, kRuns, calls);
  EXPECT_GT(errors, 5) << "of " << kRuns << " runs with a fault in one of " << calls << " calls";
}

TEST(load_access, what_cannot_be_read_does_not_pass_for_what_is_not_known) {
  if (const std::string why = why_tracing_is_impossible(); !why.empty()) GTEST_SKIP() << why;
  const formats::TemporaryFolder folder;
  const std::filesystem::path file = folder.write("drive.mcap", "whatever");
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  std::filesystem::permissions(file, std::filesystem::perms(0));
  const TracedRun run = run_traced(folder.path(), [&] {
    if (::getuid() == 0 && ::setuid(65534) != 0) return std::string("cannot become somebody else");
    return formats::error_of([&] {
      Progress progress;
      (void)formats::open_session(folder.path(), progress);
    });
  });
  EXPECT_TRUE(formats::contains(run.said, file.string()) && formats::contains(run.said, "Permission denied"))
      << run.said;
}

TEST(load_access, a_folder_that_is_somebody_elses_does_not_keep_from_what_lies_beside_it) {
  if (const std::string why = why_tracing_is_impossible(); !why.empty()) GTEST_SKIP() << why;
  const formats::TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  Progress progress;
  const simulator::SimulatedDrive drive = simulator::simulate_drive(tiny_drive());
  for (const char* format : {"native", "mcap"})
    simulator::write_drive(drive, folder.path() / format, format, 1, progress);
  const std::vector<std::filesystem::path> closed{folder.path() / "lost+found", folder.path() / "mcap" / "lost+found"};
  for (const std::filesystem::path& path : closed) {
    std::filesystem::create_directory(path);
    std::filesystem::permissions(path, std::filesystem::perms(0));
  }
  const TracedRun run = run_traced(folder.path(), [&] {
    if (::getuid() == 0 && ::setuid(65534) != 0) return std::string("cannot become somebody else");
    const std::string bag = formats::error_of([&] { (void)formats::open_session(folder.path() / "mcap", progress); });
    const std::string all = formats::error_of([&] { (void)formats::open_session(folder.path(), progress); });
    return bag + " | " + all;
  });
  for (const std::filesystem::path& path : closed)
    std::filesystem::permissions(path, std::filesystem::perms(0755));  // to be removed
  EXPECT_EQ(run.said.rfind(" | ", 0), 0U) << "the bag is opened: " << run.said;
  for (const char* format : {"native", "mcap"})
    EXPECT_TRUE(formats::contains(run.said, (folder.path() / format).string())) << run.said;
  EXPECT_FALSE(formats::contains(run.said, "lost+found")) << run.said;
}

TEST_P(load_faults, a_folder_that_disappears_is_named) {
  const Loaded before = loaded(drive_);
  std::filesystem::rename(drive_, folder_.path() / "away");
  EXPECT_ERROR(loaded(drive_), drive_.string());
  if (!before.session.scans) return;
  for (std::size_t i = 0; i < before.session.scans->size(); ++i) {
    const std::string error = formats::error_of([&] { (void)before.session.scans->load(i); });
    // A bag is open: its bytes are there until it is closed. Files of their own are opened when they are needed.
    EXPECT_TRUE(error.empty() ? before.session.scans->load(i).size() == before.points[i]
                              : formats::contains(error, "drive"))
        << error;
  }
}

INSTANTIATE_TEST_SUITE_P(of, load_faults, ::testing::Values("native", "kitti-raw", "mcap", "rosbag1", "poses"),
                         [](const auto& format) {
                           std::string name = format.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace remount::testing
