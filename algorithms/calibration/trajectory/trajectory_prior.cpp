// What is expected before any data.
#include <Eigen/Cholesky>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/trajectory/trajectory_answer.h"

namespace remount::calibration {
namespace {

// What was measured by hand draws the prior towards itself, linear about x.
void add_measured(const Measured& measured, const RigidTransform& x, TrajectoryPrior& prior) {
  Matrix6d information = prior.information.topLeftCorner<6, 6>();
  Vector6d pull = Vector6d::Zero();
  const Vector6d away = difference(prior.ins_from_lidar, x);
  for (const MeasuredRow& known : measured.rows(x)) {
    const double weight = 1.0 / (known.sigma * known.sigma);
    information += weight * known.row * known.row.transpose();
    pull += weight * (known.residual + known.row.dot(away)) * known.row;
  }
  prior.ins_from_lidar = perturb(prior.ins_from_lidar, symmetric_solution(information, pull));
  prior.information.topLeftCorner<6, 6>() = information;
}

}  // namespace

TrajectoryPrior weak_trajectory_prior(const TrajectoryProblem& problem, const TrajectoryOptions& options,
                                      const RigidTransform& start_ins_from_lidar) {
  TrajectoryPrior prior;
  // A start knows nothing of a translation that the drive does not show; LiDAR and INS are on one vehicle.
  prior.ins_from_lidar =
      problem.nominal_ins_from_lidar.value_or(make_rigid(start_ins_from_lidar.linear(), Eigen::Vector3d::Zero()));
  prior.information.topLeftCorner<6, 6>() = weak_prior(problem.nominal_ins_from_lidar.has_value());
  prior.information.bottomRightCorner<3, 3>() =
      Eigen::Matrix3d::Identity() / (options.antenna_reach_m * options.antenna_reach_m);
  add_measured(problem.measured, start_ins_from_lidar, prior);
  return prior;
}

}  // namespace remount::calibration
