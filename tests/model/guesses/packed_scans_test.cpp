// Scans in compressed LAS, without a manifest.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "model/formats/files/time_stamp.h"
#include "tests/model/formats/laz/laz_bytes.h"
#include "tests/model/guesses/described_drive.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

class packed_scans : public DescribedDrive {
 protected:
  static constexpr std::size_t kEvery = 20;  ///< point of those that the drive has

  /// Standard GPS time, as seconds less 1e9.
  static double las_time_s(std::int64_t stamp_ns, float from_stamp_s) {
    return 1e-9 * static_cast<double>(formats::gps_ns_from_unix_ns(stamp_ns) - 1'000'000'000'000'000'000) +
           static_cast<double>(from_stamp_s);
  }

  /// Scans that are numbered: their points alone tell when they were taken.
  void write_numbered(int format) const {
    fs::create_directories(folder_.path() / "scans");
    for (std::size_t i = 0; i < session_->scans->size(); ++i) {
      const cloud::PointCloud cloud = session_->scans->load(i);
      std::vector<formats::laz::Point> points;
      for (std::size_t k = 0; k < cloud.size(); k += kEvery) {
        formats::laz::Point& point = points.emplace_back();
        for (int axis = 0; axis < 3; ++axis)
          point.xyz[static_cast<std::size_t>(axis)] =
              static_cast<std::int32_t>(std::lround(1e3F * cloud.points[k][axis]));
        point.time = las_time_s(session_->scans->stamp_ns(i), cloud.time_from_stamp_s[k]);
      }
      formats::laz::Options options;
      options.format = format;
      folder_.write("scans/" + std::to_string(i + 1) + ".laz", formats::laz::laz_of(points, options));
    }
  }

  formats::TemporaryFolder folder_;
};

TEST_F(packed_scans, are_described_and_opened) {
  for (const int format : {1, 6}) {
    write_numbered(format);
    folder_.write("motion.txt", table_text(layouts().front(), *samples_));
    const Description found = described({folder_.path()});
    ASSERT_TRUE(found.complete());
    const drive::Session read = opened(found, folder_.path());
    ASSERT_EQ(read.scans->size(), session_->scans->size());
    double worst_m = 0.0, worst_s = 0.0;
    std::size_t points = 0;
    for (std::size_t i = 0; i < read.scans->size(); i += 7) {
      const cloud::PointCloud packed = read.scans->load(i), made = session_->scans->load(i);
      ASSERT_EQ(packed.size(), (made.size() + kEvery - 1) / kEvery);
      const double moved_s = 1e-9 * static_cast<double>(read.scans->stamp_ns(i) - session_->scans->stamp_ns(i));
      for (std::size_t k = 0; k < packed.size(); ++k) {
        worst_m = std::max<double>(worst_m, (packed.points[k] - made.points[k * kEvery]).cwiseAbs().maxCoeff());
        worst_s =
            std::max(worst_s, std::abs(packed.time_from_stamp_s[k] + moved_s - made.time_from_stamp_s[k * kEvery]));
      }
      points += packed.size();
    }
    std::cout << "format " << format << ": " << points << " points, off by " << worst_m << " m and " << worst_s
              << " s\n";
    EXPECT_LT(worst_m, 0.00052);
    EXPECT_LT(worst_s, 2e-6);
    EXPECT_LT(motions_apart(read, *session_), kTextPrecision);
    fs::remove(folder_.path() / "session.yaml");
  }
}

}  // namespace
}  // namespace remount::guesses
