// Slabs through the two scans of a pair, where a wall, the ground or a pole shows how well they lie on each other.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/geometry/rigid_transform.h"

namespace remount::quality {

enum class SectionKind { Wall, Ground, Pole };

/// A box in the lidar frame of scan b. Of a surface its first direction lies within it, the second is its normal; of a
/// pole both are level.
struct Section {
  SectionKind kind = SectionKind::Wall;
  Eigen::Vector3d centre_in_lidar_b = Eigen::Vector3d::Zero();  ///< m
  Eigen::Matrix3d lidar_b_from_section = Eigen::Matrix3d::Identity();
  Eigen::Vector3d half_size_m = Eigen::Vector3d::Ones();  ///< along the section's directions

  Eigen::Vector3d along() const { return lidar_b_from_section.col(0); }
  Eigen::Vector3d normal() const { return lidar_b_from_section.col(1); }
  /// The same slab at another place, m along its directions.
  Section moved(const Eigen::Vector3d& by_m) const;
};

/// Scan a as it is brought to scan b, and scan b; points that are not finite are ignored.
struct SectionScans {
  const std::vector<Eigen::Vector3f>& points_in_lidar_a;
  const std::vector<Eigen::Vector3f>& points_in_lidar_b;
  RigidTransform lidar_b_from_lidar_a = RigidTransform::Identity();
};

/// Places where both scans have such a surface, the best first: flat, seen by many points of either, at least 3 m
/// apart. Empty where there is none, or cancelled.
/// @param up_in_lidar_b away from the ground, unit length
/// @param most how many at most
std::vector<Section> find_sections(const SectionScans& scans, SectionKind kind, const Eigen::Vector3d& up_in_lidar_b,
                                   std::size_t most, const Progress& progress = {});

/// A section of this kind through a point that somebody chose: turned to the surface of scan b there, or as it is where
/// there is none.
Section section_at(const SectionScans& scans, SectionKind kind, const Eigen::Vector3d& point_in_lidar_b,
                   const Eigen::Vector3d& up_in_lidar_b);

/// What a slab holds: points along and across the surface, m from the centre, and how thick the surface is.
struct SectionCut {
  std::vector<Eigen::Vector2f> scan_a_m, scan_b_m;
  /// Standard deviations across the surface, m, of the points within kSurface_m of it, robust; 0 where fewer than
  /// kFewest.
  double thickness_a_m = 0.0, thickness_b_m = 0.0, thickness_together_m = 0.0;
  /// Scan a before (positive) or behind scan b across the surface, medians, m; of a pole the distance of its axes.
  double offset_m = 0.0;
  bool measured = false;  ///< false: too few points of one of the scans to say numbers

  static constexpr double kSurface_m = 0.25;
  static constexpr std::size_t kFewest = 12;
};
SectionCut cut_section(const SectionScans& scans, const Section& section);

}  // namespace remount::quality
