#include "widgets/scene/frame_budget.h"

#include <algorithm>
#include <cmath>

namespace remount {

void FrameBudget::took(std::size_t points, double seconds) {
  if (points < kFewest / 2 || !(seconds > 0.0)) return;  // the frame's fixed cost says nothing about points
  const double now = seconds / static_cast<double>(points);
  seconds_per_point_ += 0.5 * (now - seconds_per_point_);
  // In small steps: a single slow frame, of a machine that was busy elsewhere, does not empty the view.
  const double wanted = kTarget_s / seconds_per_point_;
  const double before = static_cast<double>(points_);
  points_ = std::max(kFewest, static_cast<std::size_t>(std::clamp(wanted, 0.5 * before, 2.0 * before)));
}

double FrameBudget::seconds_for(std::size_t points) const { return seconds_per_point_ * static_cast<double>(points); }

}  // namespace remount
