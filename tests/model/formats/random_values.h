// Values for round trips, the same for the same seed: ordinary ones, and those at the edges of their type.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount::formats {

class RandomValues {
 public:
  explicit RandomValues(unsigned seed) : random_(seed) {}

  bool flip() { return random_() % 2 == 0; }
  std::size_t below(std::size_t count) { return random_() % count; }
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  /// One in four is an edge: zeros of both signs, the smallest, the largest.
  float any_float() {
    constexpr float kEdges[] = {0.0F,
                                -0.0F,
                                std::numeric_limits<float>::denorm_min(),
                                std::numeric_limits<float>::min(),
                                -std::numeric_limits<float>::max(),
                                std::numeric_limits<float>::max(),
                                1.0F / 3.0F};
    return below(4) == 0 ? kEdges[below(std::size(kEdges))] : static_cast<float>(between(-100.0, 100.0));
  }

  /// Scripts, quotes, what YAML, XML and CSV take for their own, and nothing at all.
  std::string text() {
    static const std::vector<std::string> kTexts{
        "",       "drive",      "测试 行驶", "Überfahrt №7",     "a \"b\" 'c'", "# no comment",
        "- item", "key: value", "a,b;c",     "<tag> & \\n",      "null",        "~",
        "1e5",    "true",       " spaces ",  "\xF0\x9F\x9A\x97", "[1, 2]",      "{a}",
        "*x &y",  "tab\there"};
    return kTexts[below(kTexts.size())];
  }

  RigidTransform rigid() {
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond q(normal(random_), normal(random_), normal(random_), normal(random_));
    return make_rigid(q.normalized().toRotationMatrix(), {between(-5, 5), between(-5, 5), between(-5, 5)});
  }
  /// Turned by less than a right angle about level axes, so that any convention of angles can say it.
  Eigen::Quaterniond attitude() {
    return Eigen::AngleAxisd(between(-3.14, 3.14), Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(between(-1.2, 1.2), Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(between(-1.2, 1.2), Eigen::Vector3d::UnitX());
  }

  /// With any of the columns; one point in eight is none: at the origin, beyond what any LiDAR sees, or not finite.
  cloud::PointCloud cloud(std::size_t points, bool intensity, bool ring, bool time) {
    cloud::PointCloud cloud;
    for (std::size_t i = 0; i < points; ++i) {
      Eigen::Vector3f point{any_float(), any_float(), any_float()};
      if (below(8) == 0) point = below(2) == 0 ? Eigen::Vector3f(0.0F, -0.0F, 0.0F) : Eigen::Vector3f(1, kNan, 1);
      cloud.points.push_back(point);
      if (intensity) cloud.intensity.push_back(below(8) == 0 ? kNan : any_float());
      if (ring) cloud.ring.push_back(static_cast<std::uint16_t>(below(65536)));
      // From zero to a tenth of a second, as a turn has them: the unit can be told from that.
      if (time) cloud.time_from_stamp_s.push_back(0.1F * static_cast<float>(i) / static_cast<float>(points));
    }
    return cloud;
  }

 private:
  static constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

  std::mt19937 random_;
};

}  // namespace remount::formats
