// Line and plane features of a scan of a spinning LiDAR, told apart by the curvature along each beam.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/odometry/fusion/fusion_options.h"

namespace remount::odometry {

/// In the frame of the cloud, m; thinned to one a voxel.
struct ScanFeatures {
  std::vector<Eigen::Vector3f> lines;
  std::vector<Eigen::Vector3f> planes;
};

/// Points of each beam in the order in which it met them: by `ring` where the scan has it, otherwise by the jumps of
/// the azimuth in a scan that is stored beam by beam, otherwise by elevation in steps of half a degree.
std::vector<std::vector<Eigen::Vector3f>> points_by_beam(const cloud::PointCloud& cloud_in_lidar);

/// How far the point at `index` lies off the chord of its neighbours, five to either side (index in [5, size - 6]):
/// the distance of their mean from the point, square to the chord, m. What lies along the chord is only the spacing of
/// the points, which is uneven where a beam meets a plane at a slant. (After Zhang and Singh 2014, LOAM, eq. 1, which
/// divides by the range.)
float off_chord_m(const std::vector<Eigen::Vector3f>& beam, std::size_t index);

/// Features of a scan whose motion was compensated. Plane features lie where a beam runs straight; line features at
/// corners between two straight stretches, at edges in front of something farther, and on thin objects such as poles.
/// Not at edges behind which the background is hidden, at gaps, or where the beam grazes the surface: those move with
/// the sensor.
ScanFeatures extract_features(const cloud::PointCloud& cloud_in_lidar, const FusionOptions& options);

}  // namespace remount::odometry
