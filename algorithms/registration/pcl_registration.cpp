// PCL's algorithms behind the same function type. All heavy PCL headers of the product are in this file.
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/ndt.h>

#include "algorithms/registration/registration.h"

namespace remount::registration {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr to_pcl(const PreparedCloud& prepared) {
  auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(prepared.size());
  for (std::size_t i = 0; i < prepared.size(); ++i) {
    const Eigen::Vector3f p = prepared.point(i);
    cloud->push_back({p.x(), p.y(), p.z()});
  }
  return cloud;
}

template <class Algorithm>
RegistrationResult run(Algorithm& algorithm, const PreparedCloud& source, const PreparedCloud& target,
                       const RigidTransform& target_from_source_start) {
  const Cloud::Ptr source_cloud = to_pcl(source), target_cloud = to_pcl(target);
  algorithm.setInputSource(source_cloud);
  algorithm.setInputTarget(target_cloud);
  Cloud aligned;
  algorithm.align(aligned, target_from_source_start.matrix().cast<float>());
  RegistrationResult result;
  const Eigen::Matrix4d matrix = algorithm.getFinalTransformation().template cast<double>();
  result.target_from_source = make_rigid(nearest_rotation(matrix.topLeftCorner<3, 3>()), matrix.topRightCorner<3, 1>());
  result.quality.converged = algorithm.hasConverged();
  return result;
}

}  // namespace

RegistrationResult align_pcl_icp(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start,
                                 const RegistrationOptions& options, const Progress&) {
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setMaxCorrespondenceDistance(options.max_correspondence_m);
  icp.setMaximumIterations(options.max_iterations);
  icp.setTransformationEpsilon(1e-9);
  return run(icp, source, target, start);
}

RegistrationResult align_pcl_gicp(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start,
                                  const RegistrationOptions& options, const Progress&) {
  pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> gicp;
  gicp.setMaxCorrespondenceDistance(options.max_correspondence_m);
  gicp.setMaximumIterations(options.max_iterations);
  return run(gicp, source, target, start);
}

RegistrationResult align_pcl_ndt(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start,
                                 const RegistrationOptions& options, const Progress&) {
  pcl::NormalDistributionsTransform<pcl::PointXYZ, pcl::PointXYZ> ndt;
  ndt.setResolution(static_cast<float>(std::max(1.0, 4.0 * options.voxel_m)));
  ndt.setStepSize(0.1);
  // PCL compares this with the *squared* translation step: 1e-6 stops at a millimetre.
  ndt.setTransformationEpsilon(1e-6);
  ndt.setMaximumIterations(options.max_iterations);
  return run(ndt, source, target, start);
}

}  // namespace remount::registration
