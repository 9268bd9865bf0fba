#include "algorithms/calibration/pairwise/sigma_budget.h"

#include <cmath>

#include "algorithms/calibration/observability.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {

NoiseModel with_registration_times(NoiseModel noise, double factor) {
  noise.registration_scale *= factor;
  noise.registration_floor_m *= factor;
  noise.registration_floor_rad *= factor;
  return noise;
}

NoiseModel with_ins_times(NoiseModel noise, double factor) {
  noise.ins_position_sigma_m *= factor;
  noise.ins_attitude_sigma_rad *= factor;
  noise.ins_position_drift *= factor;
  noise.ins_attitude_drift *= factor;
  return noise;
}

Matrix6d contribution_of(NoiseModel (*with_times)(NoiseModel, double), const JointProblem& problem,
                         const PairwiseDetails& details, const Progress& progress) {
  constexpr double kFactor = 1.02;
  constexpr int kSteps = 2;  // of which the last is taken where the errors of the poses are known
  const auto covariance = [&](double factor) {
    return solve_joint(problem, with_times(details.noise, factor), details.joint.ins_from_lidar, kSteps, progress)
        .covariance;
  };
  return (covariance(kFactor) - covariance(1.0 / kFactor)) / (4.0 * std::log(kFactor));
}

}  // namespace

Vector6d SigmaBudget::variances_of(const Matrix6d& covariance) const {
  return parameter_covariance(ins_from_lidar_, covariance).diagonal();
}

void SigmaBudget::reach(const Matrix6d& covariance, const Message& source) {
  const Vector6d now = variances_of(covariance);
  // Where a step that stretches axes makes an angle better known than before, every part of it is so much smaller.
  for (int row = 0; row < 6; ++row)
    if (now[row] < reached_[row])
      for (Part& part : parts_) part.variance[row] *= now[row] / reached_[row];
  parts_.push_back({source, (now - reached_).cwiseMax(0.0)});
  reached_ = now;
}

void SigmaBudget::begin(const Matrix6d& covariance, const std::vector<Source>& sources, const Message& rest) {
  reached_ = variances_of(covariance);
  Vector6d sum = Vector6d::Zero();
  for (const Source& source : sources) {
    parts_.push_back({source.name, variances_of(source.covariance).cwiseMax(0.0)});
    sum += parts_.back().variance;
  }
  for (int row = 0; row < 6; ++row)
    if (sum[row] > reached_[row])  // by what their computation errs
      for (Part& part : parts_) part.variance[row] *= reached_[row] / sum[row];
  parts_.push_back({rest, (reached_ - sum).cwiseMax(0.0)});
}

void SigmaBudget::write(CalibrationResult& result) const {
  constexpr double kLeastShare = 1e-6;  // of the variance of whatever parameter; less is no part of anything
  for (const Part& part : parts_)
    if (part.variance.cwiseQuotient(reached_).maxCoeff() > kLeastShare)
      add_sigma_part(part.source, part.variance, result);
}

void begin_with_sources(const JointProblem& problem, const PairwiseDetails& details, const Matrix6d& covariance,
                        const Progress& progress, SigmaBudget& budget) {
  budget.begin(covariance,
               {{say::sigma_part_registration(), contribution_of(with_registration_times, problem, details, progress)},
                {say::sigma_part_ins(), contribution_of(with_ins_times, problem, details, progress)}},
               say::sigma_part_lasting());
}

}  // namespace remount::calibration
