#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/messages/render.h"
#include "model/drive/attitude_convention.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/sessions/kitti_raw_reader.h"
#include "model/formats/sessions/native_session_reader.h"
#include "model/formats/sessions/native_session_writer.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

constexpr std::int64_t kStart = 1'600'000'000'123'456'789;

/// Scans that are made when they are asked for.
class MadeScans final : public drive::ScanSource {
 public:
  MadeScans(std::size_t count, bool columns) : count_(count), columns_(columns) {}
  std::size_t size() const override { return count_; }
  std::int64_t stamp_ns(std::size_t scan) const override {
    return kStart + static_cast<std::int64_t>(scan) * 100'000'007;
  }
  std::string name(std::size_t scan) const override { return std::to_string(scan); }
  cloud::PointCloud load(std::size_t scan) const override {
    cloud::PointCloud cloud;
    for (int i = 0; i < 50; ++i) {
      cloud.points.emplace_back(1.25f + 0.1f * static_cast<float>(i), -3.5f, 0.01f * static_cast<float>(scan));
      cloud.intensity.push_back(0.5f * static_cast<float>(i));
      if (!columns_) continue;
      cloud.ring.push_back(static_cast<std::uint16_t>(i % 16));
      cloud.time_from_stamp_s.push_back(0.002f * static_cast<float>(i));
    }
    return cloud;
  }

 private:
  std::size_t count_;
  bool columns_;
};

drive::Session made_session(bool columns) {
  drive::Session session;
  session.name = "a \"drive\": 1";
  session.scans = std::make_shared<MadeScans>(5, columns);
  session.scan_timing = columns ? drive::ScanTiming::PerPoint : drive::ScanTiming::SweepAzimuth;
  session.sweep = {0.0998, 0.3, false, false};
  for (int i = 0; i < 60; ++i) {
    motion::InsSample sample;
    sample.stamp_ns = kStart - 7 + i * 10'000'001;
    sample.latitude_rad = 0.8514 + 1.23456789e-7 * i;
    sample.longitude_rad = -2.1 - 1.1e-8 * i;
    sample.height_m = 250.0 + 0.001 / 3.0 * i;
    sample.enu_from_ins =
        drive::enu_from_ins({0.1 * i, 0.03 * std::sin(i), -0.02 * std::cos(i)}, drive::AttitudeConvention::EnuYaw);
    sample.quality = motion::InsQuality::Good;
    sample.sigma.position_enu_m = {0.01, 0.02, 0.03};
    sample.sigma.attitude_rad = {1e-3, 2e-3, 3e-3};
    session.ins.push_back(sample);
  }
  session.lidar = cloud::LidarKind::SolidState;
  session.ins_position_white_sigma_m = 0.005;
  session.ins_attitude_bias_sigma_rad = 1e-4;
  session.nominal_ins_from_lidar = rigid_from_six({0.9, -0.25, 0.75, 0.03, -0.02, 0.015});
  return session;
}

void expect_same_ins(const drive::Session& read, const drive::Session& written) {
  ASSERT_EQ(read.ins.size(), written.ins.size());
  for (std::size_t i = 0; i < read.ins.size(); ++i) {
    const motion::InsSample &a = read.ins[i], &b = written.ins[i];
    EXPECT_EQ(a.stamp_ns, b.stamp_ns);
    EXPECT_NEAR(radians_to_degrees(a.latitude_rad - b.latitude_rad), 0.0, 1e-12);
    EXPECT_NEAR(radians_to_degrees(a.longitude_rad - b.longitude_rad), 0.0, 1e-12);
    EXPECT_NEAR(a.height_m, b.height_m, 1e-9);
    EXPECT_LT(radians_to_degrees(so3_log((a.enu_from_ins * b.enu_from_ins.inverse()).toRotationMatrix()).norm()),
              1e-12);
  }
}

TEST(native_session, reads_back_what_was_written) {
  const TemporaryFolder folder;
  const drive::Session written = made_session(true);
  Progress progress;
  write_native_session(written, folder.path() / "drive", 2, progress);
  const NativeSessionReader reader;
  EXPECT_EQ(reader.probe(folder.path() / "drive"), 100);
  const drive::Session read = reader.open(folder.path() / "drive", progress);
  EXPECT_EQ(read.name, written.name);
  EXPECT_TRUE(read.findings.empty()) << english(read.findings[0].explanation);
  expect_same_ins(read, written);
  EXPECT_EQ(read.ins[3].quality, motion::InsQuality::Good);
  EXPECT_LT((read.ins[3].sigma.position_enu_m - written.ins[3].sigma.position_enu_m).norm(), 1e-15);
  EXPECT_LT((read.ins[3].sigma.attitude_rad - written.ins[3].sigma.attitude_rad).norm(), 1e-15);
  EXPECT_EQ(read.lidar, cloud::LidarKind::SolidState);
  EXPECT_DOUBLE_EQ(read.ins_position_white_sigma_m, 0.005);
  EXPECT_TRUE(std::isnan(read.ins_attitude_white_sigma_rad));
  EXPECT_NEAR(read.ins_attitude_bias_sigma_rad, 1e-4, 1e-16);
  ASSERT_TRUE(read.nominal_ins_from_lidar);
  EXPECT_LT(difference(*read.nominal_ins_from_lidar, *written.nominal_ins_from_lidar).norm(), 1e-14);
  EXPECT_EQ(read.scan_timing, drive::ScanTiming::PerPoint);
  ASSERT_EQ(read.scans->size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(read.scans->stamp_ns(i), written.scans->stamp_ns(i));
    const cloud::PointCloud a = read.scans->load(i), b = written.scans->load(i);
    EXPECT_TRUE(std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end()));
    EXPECT_EQ(a.time_from_stamp_s, b.time_from_stamp_s);
    EXPECT_EQ(a.ring, b.ring);
    EXPECT_EQ(a.intensity, b.intensity);
  }
}

TEST(native_session, keeps_the_sweep_and_novatel_axes) {
  const TemporaryFolder folder;
  drive::Session written = made_session(false);
  written.ins_axes = drive::InsAxes::RightForwardUp;
  Progress progress;
  write_native_session(written, folder.path() / "drive", 1, progress);
  const drive::Session read = NativeSessionReader().open(folder.path() / "drive" / "session.yaml", progress);
  EXPECT_EQ(read.scan_timing, drive::ScanTiming::SweepAzimuth);
  EXPECT_DOUBLE_EQ(read.sweep.period_s, 0.0998);
  EXPECT_NEAR(read.sweep.stamp_azimuth_rad, 0.3, 1e-15);
  EXPECT_FALSE(read.sweep.clockwise);
  EXPECT_FALSE(read.sweep.certain);
  EXPECT_EQ(read.ins_axes, written.ins_axes);
  expect_same_ins(read, written);
  EXPECT_LT((read.ins[3].sigma.attitude_rad - written.ins[3].sigma.attitude_rad).norm(), 1e-15);
}

TEST(native_session, writes_the_same_bytes_with_any_number_of_threads) {
  const TemporaryFolder folder;
  const drive::Session session = made_session(true);
  Progress progress;
  write_native_session(session, folder.path() / "one", 1, progress);
  write_native_session(session, folder.path() / "four", 4, progress);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "one")) {
    if (!entry.is_regular_file()) continue;
    const auto read = [](const std::filesystem::path& path) {
      std::ifstream stream(path, std::ios::binary);
      return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    const auto other = folder.path() / "four" / std::filesystem::relative(entry.path(), folder.path() / "one");
    EXPECT_EQ(read(entry.path()), read(other)) << other;
  }
}

TEST(kitti_raw, reads_back_what_was_written_as_extract_and_as_sync) {
  const TemporaryFolder folder;
  drive::Session written = made_session(false);
  Progress progress;
  const KittiRawReader reader;
  write_kitti_raw_session(written, folder.path() / "own-stamps", 2, progress);
  const drive::Session extract = reader.open(folder.path() / "own-stamps", progress);
  EXPECT_TRUE(extract.name.ends_with("_extract"));
  expect_same_ins(extract, written);
  EXPECT_DOUBLE_EQ(extract.ins[0].sigma.position_enu_m.x(), 0.03);
  EXPECT_TRUE(extract.sweep.certain);
  EXPECT_FALSE(extract.sweep.clockwise);
  ASSERT_EQ(extract.scans->size(), 5u);
  EXPECT_EQ(extract.scans->stamp_ns(4), written.scans->stamp_ns(4));
  EXPECT_EQ(extract.scans->load(4).points, written.scans->load(4).points);

  written.ins.resize(5);
  for (std::size_t i = 0; i < 5; ++i) written.ins[i].stamp_ns = written.scans->stamp_ns(i);
  write_kitti_raw_session(written, folder.path() / "same-stamps", 2, progress);
  const drive::Session sync = reader.open(folder.path() / "same-stamps", progress);
  EXPECT_TRUE(sync.name.ends_with("_sync"));
  EXPECT_FALSE(sync.sweep.certain);
  expect_same_ins(sync, written);
}

}  // namespace
}  // namespace remount::formats
