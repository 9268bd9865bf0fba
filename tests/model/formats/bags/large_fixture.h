// Bags that are larger than memory, written with holes where the points of scans would be.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <iostream>

#include "tests/model/formats/bags/bag_maker.h"
#include "tests/support/peak_memory.h"
#include "tests/support/sanitized.h"

namespace remount::bags {

inline constexpr MessageEncoding kCdr = MessageEncoding::Cdr;

/// A file that is written from its beginning to its end, with holes.
class SparseFile {
 public:
  explicit SparseFile(const fs::path& path) : file_(std::fopen(path.c_str(), "wb")) {}
  ~SparseFile() { std::fclose(file_); }
  SparseFile(const SparseFile&) = delete;
  SparseFile& operator=(const SparseFile&) = delete;

  std::uint64_t at() const { return at_; }
  void put(const std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), file_);
    at_ += bytes.size();
  }
  void skip(std::uint64_t bytes) {
    std::fseek(file_, static_cast<long>(bytes), SEEK_CUR);
    at_ += bytes;
  }
  /// Over what stands there already.
  void put_at(long offset, const std::string& bytes) {
    std::fseek(file_, offset, SEEK_SET);
    std::fwrite(bytes.data(), 1, bytes.size(), file_);
  }

 private:
  std::FILE* file_;
  std::uint64_t at_ = 0;
};

/// What every large bag holds: topics by their index, and so many samples of the INS with each scan.
inline constexpr const char* kLargeTopics[] = {"/points", "/ins/imu", "/ins/fix"};
inline constexpr const char* kLargeTypes[] = {"sensor_msgs/PointCloud2", "sensor_msgs/Imu", "sensor_msgs/NavSatFix"};
inline constexpr int kInsPerScan = 2;

struct LargeInsMessages {
  std::int64_t stamp_ns = 0;
  std::string imu, fix;
};
inline LargeInsMessages large_ins_messages(int sample_index, MessageEncoding encoding) {
  const motion::InsSample sample = BagMaker::on_circle(sample_index);
  const motion::GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, 100.0,
                            Eigen::Matrix3d::Identity()};
  return {sample.stamp_ns, attitude_message(sample, 0.001, "ins", encoding), fix_message(fix, 2, "ins", encoding)};
}

/// The i-th scan: one real point, then zeros, which are no returns, and the last byte.
struct LargeScan {
  std::int64_t stamp_ns = 0;
  std::string begin;        ///< with the real point
  std::uint64_t zeros = 0;  ///< bytes after it
  std::string end{'\1'};    ///< it is dense
  std::uint64_t bytes() const { return begin.size() + zeros + end.size(); }
};
inline LargeScan large_scan(int i, std::uint64_t scan_bytes, MessageEncoding encoding) {
  const auto points = static_cast<std::uint32_t>(scan_bytes / 16);
  LargeScan scan;
  scan.stamp_ns = kStart_ns + i * kStep_ns;
  MessageWriter writer(encoding);
  writer.header(scan.stamp_ns, "lidar").number<std::uint32_t>(1).number(points).number<std::uint32_t>(3);
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    writer.string(std::string(1, static_cast<char>('x' + axis)))
        .number(axis * 4)
        .number<std::uint8_t>(7)
        .number<std::uint32_t>(1);
  writer.number<std::uint8_t>(0).number<std::uint32_t>(16).number(points * 16).number(points * 16);
  const std::string first_point = raw(1.0f) + raw(2.0f) + raw(static_cast<float>(i));
  scan.begin = writer.bytes() + first_point;
  scan.zeros = std::uint64_t{points} * 16 - first_point.size();
  return scan;
}

/// Opens a bag of so many such scans, and reads some of them: in seconds, with memory for one scan at a time.
inline void expect_opens_in_seconds(const fs::path& path, int scans, std::uint64_t scan_bytes) {
  const auto count = static_cast<std::size_t>(scans);
  const double bytes = static_cast<double>(fs::file_size(path));
  ASSERT_GT(bytes, static_cast<double>(scan_bytes) * static_cast<double>(scans));
  const double before_mb = testing::peak_mb();
  const auto started = std::chrono::steady_clock::now();
  const drive::Session session = formats::open(path);
  const double opened_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  const double opened_mb = testing::peak_mb() - before_mb;
  for (const char* damage : {"bag-unindexed", "bag-damaged", "bag-cut-end"})
    EXPECT_FALSE(formats::find(session, damage));
  ASSERT_TRUE(session.scans);
  EXPECT_EQ(session.scans->size(), count);
  EXPECT_EQ(session.ins.size(), kInsPerScan * count);
  for (const std::size_t scan : {std::size_t{0}, count * 617 / 1000, count - 1}) {
    const cloud::PointCloud cloud = session.scans->load(scan);
    ASSERT_EQ(cloud.size(), 1u);
    EXPECT_EQ(cloud.points[0], Eigen::Vector3f(1.0f, 2.0f, static_cast<float>(scan)));
    EXPECT_EQ(cloud.dropped_points, scan_bytes / 16 - 1);
  }
  std::cout << bytes * 1e-9 << " GB: opened in " << opened_s << " s, memory grew by " << opened_mb
            << " MB, with scans by " << testing::peak_mb() - before_mb << " MB\n";
  EXPECT_LT(opened_s, 5.0 * testing::kSanitizerSlowdown);
  EXPECT_LT(testing::peak_mb() - before_mb, 100.0 + testing::kSanitizerKeeps_mb);
}

}  // namespace remount::bags
