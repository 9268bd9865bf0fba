#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/checks/builtin.h"
#include "tests/model/checks/check_fixture.h"

namespace remount::checks {
namespace {

/// Scans of so many points, of which so many were none; -1 points: cannot be read.
class CountedScans final : public drive::ScanSource {
 public:
  explicit CountedScans(std::vector<std::pair<int, int>> counts) : counts_(std::move(counts)) {}
  std::size_t size() const override { return counts_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return static_cast<std::int64_t>(scan) * 100'000'000; }
  std::string name(std::size_t scan) const override { return "scan " + std::to_string(scan); }
  cloud::PointCloud load(std::size_t scan) const override {
    const auto [points, dropped] = counts_.at(scan);
    if (points < 0) throw Error(ErrorCode::Format, name(scan), Message::verbatim("is cut off"));
    cloud::PointCloud cloud;
    cloud.points.resize(static_cast<std::size_t>(points), {1, 2, 3});
    cloud.dropped_points = static_cast<std::size_t>(dropped);
    return cloud;
  }

 private:
  std::vector<std::pair<int, int>> counts_;
};

std::vector<drive::Finding> found(std::vector<std::pair<int, int>> counts) {
  drive::Session session;
  session.scans = std::make_shared<CountedScans>(std::move(counts));
  return found_by(scan_check(), session);
}

TEST(scan_check, whole_scans_pass) {
  EXPECT_TRUE(found({{20000, 0}, {19000, 0}, {21000, 0}}).empty());
  EXPECT_TRUE(found({{20000, 0}}).empty());
  EXPECT_TRUE(found_by(scan_check(), good_drive()).empty()) << "no scans";
}

TEST(scan_check, few_points_are_named) {
  const std::vector<drive::Finding> few = found({{400, 0}, {410, 0}, {390, 0}});
  ASSERT_TRUE(testing::has_code(few, "scan-few-points"));
  const std::vector<drive::Finding> torn = found({{20000, 0}, {20000, 0}, {20000, 0}, {1500, 0}, {20000, 0}});
  ASSERT_TRUE(testing::has_code(torn, "scan-few-points")) << "a tenth of the others";
  EXPECT_EQ(drive::english(torn[0].where), "scan 3");
  EXPECT_EQ(english(torn[0].explanation), "The scan has 1500 points only; the usual one has 20000.");
  const std::vector<drive::Finding> empty = found({{0, 0}, {0, 0}, {0, 0}});
  ASSERT_TRUE(testing::has_code(empty, "scan-few-points"));
  EXPECT_EQ(empty[0].severity, drive::Severity::Problem) << "nothing can be calibrated from such a drive";
}

TEST(scan_check, points_that_are_none_are_counted_and_many_of_them_warned_of) {
  const std::vector<drive::Finding> usual = found({{15000, 5000}, {15000, 5000}, {15000, 5000}});
  ASSERT_EQ(usual.size(), 1U);
  EXPECT_EQ(usual[0].code, "scan-nan");
  EXPECT_EQ(usual[0].severity, drive::Severity::Note);
  EXPECT_NE(english(usual[0].explanation).find("25.0 %"), std::string::npos) << english(usual[0].explanation);
  EXPECT_EQ(found({{3000, 17000}, {3000, 17000}}).at(0).severity, drive::Severity::Warning);
}

TEST(scan_check, scans_that_cannot_be_read_are_named) {
  const std::vector<drive::Finding> findings = found({{20000, 0}, {20000, 0}, {-1, 0}});
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "bad-scan");
  EXPECT_EQ(drive::english(findings[0].where), "scan 2");
}

}  // namespace
}  // namespace remount::checks
