#include "widgets/scene/frame_budget.h"

#include <algorithm>

namespace remount::scene {

void FrameBudget::took(std::size_t points, double seconds) {
  if (points == 0 || !(seconds > 0.0)) return;
  frames_[count_++ % frames_.size()] = {static_cast<double>(points), seconds};
  learn();
  // In small steps: a single slow frame, of a machine that was busy elsewhere, does not empty the view. Of the target
  // at least half is for points, whatever the rest of a frame costs.
  const double wanted = std::max(kTarget_s - fixed_s_, 0.5 * kTarget_s) / seconds_per_point_;
  const double before = static_cast<double>(points_);
  points_ = std::max(kFewest, static_cast<std::size_t>(std::clamp(wanted, 0.5 * before, 2.0 * before)));
}

/// A straight line through the last frames.
void FrameBudget::learn() {
  const std::size_t n = std::min(count_, frames_.size());
  Frame mean;
  for (std::size_t i = 0; i < n; ++i) {
    mean.points += frames_[i].points / static_cast<double>(n);
    mean.seconds += frames_[i].seconds / static_cast<double>(n);
  }
  double spread = 0.0, together = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    spread += (frames_[i].points - mean.points) * (frames_[i].points - mean.points);
    together += (frames_[i].points - mean.points) * (frames_[i].seconds - mean.seconds);
  }
  // Frames that are all alike say nothing of what one without points would cost: what was known of it stays.
  const bool differ = spread > 0.01 * static_cast<double>(n) * mean.points * mean.points;
  if (differ) fixed_s_ = std::clamp(mean.seconds - together / spread * mean.points, 0.0, 0.9 * mean.seconds);
  fixed_s_ = std::min(fixed_s_, 0.9 * mean.seconds);
  seconds_per_point_ = (mean.seconds - fixed_s_) / mean.points;
}

double FrameBudget::seconds_for(std::size_t points) const {
  return fixed_s_ + seconds_per_point_ * static_cast<double>(points);
}

std::size_t FrameBudget::points_within(double seconds) const {
  return std::max(kFewest, static_cast<std::size_t>(std::max(0.0, seconds - fixed_s_) / seconds_per_point_));
}

}  // namespace remount::scene
