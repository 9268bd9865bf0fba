// Scans of which only the points tell when they were taken.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <iostream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "tests/model/guesses/described_drive.h"
#include "tests/support/findings.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDatedScans = 12;

class dated_points : public DescribedDrive {
 protected:
  /// Scans that are numbered, of every fiftieth point in text; dates of points are in microseconds.
  /// @param dates of each scan by its number; others have no column of times
  void write_numbered(const std::vector<bool>& dates) const {
    fs::create_directories(folder_.path() / "scans");
    for (std::size_t i = 0; i < dates.size(); ++i) {
      const cloud::PointCloud cloud = session_->scans->load(i);
      std::string text = dates[i] ? "x y z time_us\n" : "x y z\n";
      for (std::size_t k = 0; k < cloud.size(); k += 50) {
        char line[120];
        const Eigen::Vector3f& p = cloud.points[k];
        std::snprintf(line, sizeof line, "%.3f %.3f %.3f", p.x(), p.y(), p.z());
        text += line + (dates[i] ? " " + std::to_string(time_us(i, cloud.time_from_stamp_s[k])) : "") + "\n";
      }
      folder_.write("scans/" + std::to_string(i + 1) + ".xyz", text);
    }
  }
  static std::int64_t time_us(std::size_t scan, float from_stamp_s) {
    return session_->scans->stamp_ns(scan) / 1000 + std::llround(1e6 * from_stamp_s);
  }
  /// Of the points that were written.
  static std::int64_t first_us(std::size_t scan) {
    const cloud::PointCloud cloud = session_->scans->load(scan);
    std::int64_t first = time_us(scan, cloud.time_from_stamp_s.front());
    for (std::size_t k = 0; k < cloud.size(); k += 50)
      first = std::min(first, time_us(scan, cloud.time_from_stamp_s[k]));
    return first;
  }
  Description described_folder() const {
    folder_.write("motion.txt", table_text(layouts().front(), *samples_));
    return described({folder_.path()});
  }
  /// By the manifest of when all scans had dates.
  drive::Session open_again(std::stop_token stop = {}) const {
    Progress progress(stop);
    return formats::open_session(folder_.path() / "session.yaml", progress);
  }

  formats::TemporaryFolder folder_;
};

TEST_F(dated_points, are_found_by_describe_and_stamp_their_scans) {
  write_numbered(std::vector<bool>(kDatedScans, true));
  const Description found = described_folder();
  ASSERT_TRUE(found.complete()) << (found.missing.empty() ? "" : english(found.missing.front()));
  EXPECT_TRUE(says(find_guess(found.lidars.front().guesses, GuessKind::Stamps)->evidence, "guess-stamps-in-points"));
  const drive::Session session = opened(found, folder_.path());
  ASSERT_EQ(session.scans->size(), kDatedScans);
  EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
  std::int64_t worst_ns = 0;
  for (std::size_t i = 0; i < kDatedScans; ++i) {
    worst_ns = std::max(worst_ns, std::abs(session.scans->stamp_ns(i) - 1000 * first_us(i)));
    const std::vector<float> times_s = session.scans->load(i).time_from_stamp_s;
    ASSERT_FALSE(times_s.empty()) << i;
    EXPECT_GE(*std::ranges::min_element(times_s), -1e-6f) << i;
  }
  std::cout << "stamps at most " << worst_ns << " ns off\n";
  EXPECT_LE(worst_ns, 300) << "a date in microseconds is a double of a quarter of one";
  EXPECT_EQ(testing::said_of(session.findings, "point-clock"), "");
}

TEST_F(dated_points, that_some_scans_lack_leave_these_out) {
  std::vector<bool> dates(kDatedScans, true);
  dates[4] = false;
  write_numbered(dates);
  const drive::Session session = opened(described_folder(), folder_.path());
  EXPECT_EQ(session.scans->size(), kDatedScans - 1);
  const std::string said = testing::said_of(session.findings, "missing-scans");
  EXPECT_NE(said.find("5.xyz"), std::string::npos) << said;
}

TEST_F(dated_points, that_no_scan_has_are_an_error_that_says_what_to_do) {
  write_numbered(std::vector<bool>(kDatedScans, true));
  opened(described_folder(), folder_.path());
  write_numbered(std::vector<bool>(kDatedScans, false));
  try {
    open_again();
    ADD_FAILURE() << "opened";
  } catch (const Error& error) {
    EXPECT_EQ(fs::path(error.where()).filename(), "1.xyz");
    EXPECT_NE(english(error.message()).find("columns are x y z."), std::string::npos) << english(error.message());
  }
  fs::remove(folder_.path() / "session.yaml");
  EXPECT_TRUE(says(described_folder().missing, "guess-needs-stamps"));
}

TEST_F(dated_points, stop_being_read_when_that_is_cancelled) {
  write_numbered(std::vector<bool>(3, true));
  EXPECT_EQ(opened(described_folder(), folder_.path()).scans->size(), 3U);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(open_again(stop.get_token()).scans);
}

}  // namespace
}  // namespace remount::guesses
