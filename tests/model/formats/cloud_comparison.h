// Clouds as they were written and as they are read.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "algorithms/cloud/point_cloud.h"

namespace remount::formats {

/// The points that a reader keeps: finite, not at the origin, within 1e5 m.
inline cloud::PointCloud kept(const cloud::PointCloud& cloud) {
  cloud::PointCloud kept;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& point = cloud.points[i];
    if (!point.allFinite() || point.isZero(0.0F) || point.cwiseAbs().maxCoeff() > 1e5F) {
      ++kept.dropped_points;
      continue;
    }
    kept.points.push_back(point);
    if (!cloud.intensity.empty()) kept.intensity.push_back(cloud.intensity[i]);
    if (!cloud.ring.empty()) kept.ring.push_back(cloud.ring[i]);
    if (!cloud.time_from_stamp_s.empty()) kept.time_from_stamp_s.push_back(cloud.time_from_stamp_s[i]);
  }
  return kept;
}

template <class T>
std::string bits(const std::vector<T>& items) {
  return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T)};
}

/// NaN equals NaN, and zeros of different sign differ.
inline void expect_same(const cloud::PointCloud& read, const cloud::PointCloud& written, const std::string& what) {
  const cloud::PointCloud expected = kept(written);
  ASSERT_EQ(read.size(), expected.size()) << what;
  EXPECT_EQ(read.dropped_points, expected.dropped_points) << what;
  EXPECT_EQ(bits(read.points), bits(expected.points)) << what;
  EXPECT_EQ(bits(read.intensity), bits(expected.intensity)) << what;
  EXPECT_EQ(read.ring, expected.ring) << what;
  EXPECT_EQ(bits(read.time_from_stamp_s), bits(expected.time_from_stamp_s)) << what;
}

}  // namespace remount::formats
