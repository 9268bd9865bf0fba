#include "algorithms/calibration/method_details.h"

namespace remount::calibration {

namespace {

void keep_every(std::vector<double>& values, std::size_t most) {
  if (values.size() <= most) return;
  std::vector<double> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(values[i * (values.size() - 1) / (most - 1)]);
  values = std::move(kept);
}

}  // namespace

void thin(std::vector<Plot>& plots, std::size_t most) {
  if (most < 2) return;
  for (Plot& plot : plots)
    for (Curve& curve : plot.curves)
      for (std::vector<double>* values : {&curve.x, &curve.y, &curve.sigma, &curve.z}) keep_every(*values, most);
}

}  // namespace remount::calibration
