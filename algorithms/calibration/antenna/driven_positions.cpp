#include "algorithms/calibration/antenna/driven_positions.h"

#include <utility>

namespace remount::calibration {

std::vector<DrivenPosition> driven_positions(const motion::WheelImuSignals& sensed,
                                             const std::vector<StampedPosition>& positions, double window_s,
                                             const Progress& progress) {
  std::vector<DrivenPosition> driven;
  double time_s = 0.0;
  for (std::size_t i = 0; i < positions.size() && !progress.cancelled(); ++i) {
    if (positions[i].stamp_ns < sensed.begin_ns() || positions[i].stamp_ns > sensed.end_ns()) continue;
    auto steps = i > 0 ? sensed.steps(positions[i - 1].stamp_ns, positions[i].stamp_ns)
                       : std::optional<std::vector<motion::MotionStep>>();
    DrivenPosition one;
    if (steps) one.steps = *std::move(steps);
    for (const motion::MotionStep& step : one.steps) time_s += step.duration_s;
    one.begins_window = driven.empty() || one.steps.empty() || time_s > window_s;
    if (one.begins_window) time_s = 0.0;
    one.window = driven.empty() ? 0 : driven.back().window + (one.begins_window ? 1 : 0);
    one.time_s = time_s;
    one.position = positions[i];
    driven.push_back(std::move(one));
  }
  return driven;
}

}  // namespace remount::calibration
