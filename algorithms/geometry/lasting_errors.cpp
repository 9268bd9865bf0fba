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

}  // namespace remount
