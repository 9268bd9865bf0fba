#include "algorithms/calibration/bootstrap.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <map>
#include <random>

namespace remount {

Matrix6d bootstrap_covariance(const std::vector<PairInfluence>& pairs, const Matrix6d& prior, int samples, int seed,
                              const Progress& progress) {
  std::map<int, PairInfluence> blocks;
  for (const PairInfluence& pair : pairs) {
    blocks[pair.block].hessian += pair.hessian;
    blocks[pair.block].side += pair.side;
  }
  std::vector<PairInfluence> list;
  for (const auto& [index, block] : blocks) list.push_back(block);
  if (list.size() < 4 || samples < 2) return Matrix6d::Zero();
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<Vector6d> steps;
  for (int sample = 0; sample < samples && !progress.cancelled(); ++sample) {
    Matrix6d hessian = prior;
    Vector6d side = Vector6d::Zero();
    for (std::size_t i = 0; i < list.size(); ++i) {
      // Modulo, not a distribution: the standard fixes the generator's numbers but not a distribution's.
      const PairInfluence& block = list[random() % list.size()];
      hessian += block.hessian;
      side += block.side;
    }
    steps.push_back(hessian.ldlt().solve(side));
  }
  Vector6d mean = Vector6d::Zero();
  for (const Vector6d& step : steps) mean += step / static_cast<double>(steps.size());
  Matrix6d covariance = Matrix6d::Zero();
  for (const Vector6d& step : steps) covariance += (step - mean) * (step - mean).transpose();
  // Resampling n blocks underestimates by (n - 1) / n.
  const double small_sample = static_cast<double>(list.size()) / static_cast<double>(list.size() - 1);
  return covariance * small_sample / static_cast<double>(std::max<std::size_t>(1, steps.size() - 1));
}

}  // namespace remount
