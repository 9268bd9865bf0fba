#include "algorithms/geometry/lasting_errors.h"

#include <algorithm>
#include <cmath>

namespace remount {

double lasting_factor(const std::vector<double>& residuals, double taken) {
  const auto count = static_cast<double>(residuals.size());
  const std::size_t lags = residuals.size() / 4;
  std::vector<double> linked;  // by lag, as far as is asked for: all of them would take the square of the count
  const auto linked_at = [&](std::size_t lag) {
    while (linked.size() <= lag) {
      const std::size_t next = linked.size();
      double sum = 0.0;
      for (std::size_t i = next; i < residuals.size(); ++i) sum += residuals[i] * residuals[i - next] / count;
      linked.push_back(sum);
    }
    return linked[lag];
  };
  if (lags < 2 || linked_at(1) <= 2.0 / std::sqrt(count) * linked_at(0)) return 1.0;
  double total = linked_at(0);
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    const double removed = std::min(linked_at(0), taken * total / count);
    const double power = linked_at(0) + removed;
    total = power;
    for (std::size_t lag = 1; lag < lags; ++lag) {
      const double value = linked_at(lag) + removed * (1.0 - static_cast<double>(lag) / count);
      if (value < 0.05 * power) break;
      total += 2.0 * value;
    }
  }
  return std::max(1.0, total / linked_at(0) * (count - taken) / count);
}

Eigen::VectorXd lasting_widening(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& scores, int fewest_blocks) {
  // How far each row moves each unknown.
  const Eigen::MatrixXd moves = scores * covariance;
  const Eigen::VectorXd narrow = moves.colwise().squaredNorm().transpose();
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(covariance.rows());
  for (Eigen::Index length = 2; moves.rows() / length >= fewest_blocks; length *= 2) {
    const Eigen::Index blocks = moves.rows() / length;
    Eigen::VectorXd wide = Eigen::VectorXd::Zero(covariance.rows());
    for (Eigen::Index b = 0; b < blocks; ++b)
      wide += moves.middleRows(b * length, length).colwise().sum().cwiseAbs2().transpose();
    wide *= static_cast<double>(moves.rows()) / static_cast<double>(blocks * length);
    // The ratio of two variances from so many blocks scatters by itself: only what exceeds chance counts.
    const double chance = 1.0 + 1.7 * std::sqrt(2.0 / static_cast<double>(blocks));
    // An unknown is fitted to what lasts, the more so the longer it does.
    const double fitted = static_cast<double>(blocks) / (static_cast<double>(blocks) - 2.0);
    for (Eigen::Index k = 0; k < factor.size(); ++k)
      if (narrow[k] > 0.0 && wide[k] > chance * narrow[k])
        factor[k] = std::max(factor[k], std::sqrt(fitted * wide[k] / narrow[k]));
  }
  return factor;
}

}  // namespace remount
