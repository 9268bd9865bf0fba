#include "algorithms/geometry/lasting_errors.h"

#include <algorithm>
#include <cmath>

namespace remount {

double lasting_factor(const std::vector<double>& residuals, double taken) {
  const auto count = static_cast<double>(residuals.size());
  std::vector<double> linked(residuals.size() / 4, 0.0);  // by lag
  for (std::size_t lag = 0; lag < linked.size(); ++lag)
    for (std::size_t i = lag; i < residuals.size(); ++i) linked[lag] += residuals[i] * residuals[i - lag] / count;
  if (linked.size() < 2 || linked[1] <= 2.0 / std::sqrt(count) * linked[0]) return 1.0;
  double total = linked[0];
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    const double removed = std::min(linked[0], taken * total / count);
    const double power = linked[0] + removed;
    total = power;
    for (std::size_t lag = 1; lag < linked.size(); ++lag) {
      const double value = linked[lag] + removed * (1.0 - static_cast<double>(lag) / count);
      if (value < 0.05 * power) break;
      total += 2.0 * value;
    }
  }
  return std::max(1.0, total / linked[0] * (count - taken) / count);
}

}  // namespace remount
