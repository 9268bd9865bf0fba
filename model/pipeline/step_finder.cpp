#include "model/pipeline/step_finder.h"

#include <algorithm>
#include <cmath>

namespace remount::pipeline {

bool as_long_as(const RigidTransform& lidar_motion, const RigidTransform& ins_motion) {
  constexpr double kLongestArm_m = 5.0, kNoise_m = 0.3, kNoiseShare = 0.1;
  const double travelled_m = ins_motion.translation().norm();
  return std::abs(lidar_motion.translation().norm() - travelled_m) <
         kNoise_m + kNoiseShare * travelled_m + kLongestArm_m * so3_log(ins_motion.linear()).norm();
}

namespace {

bool fits(const registration::RegistrationResult& step, const RigidTransform& ins_step) {
  return step.quality.failure.empty() && as_long_as(step.target_from_source, ins_step);
}

}  // namespace

StepFinder::StepFinder(const registration::RegistrationOptions& options, const Eigen::Vector3d& up_in_lidar,
                       const Progress& progress)
    : options_(options), up_in_lidar_(up_in_lidar), progress_(progress) {}

registration::RegistrationResult StepFinder::find(const registration::PreparedCloud& source,
                                                  const registration::PreparedCloud& target,
                                                  const RigidTransform& ins_step) {
  registration::RegistrationResult step = registration::align_scans(source, target, last_, options_, progress_);
  // Of a shorter way neighbours are matched over all of it, and a direction shows in none.
  const bool far = ins_step.translation().norm() > options_.max_correspondence_m;
  const bool searching = searches_ > 0 && may_search();
  if (far && (searching || !fits(step, ins_step)))
    if (auto longer = may_search() ? search(source, target, ins_step, step.quality.overlap)
                                   : again_as_before(source, target, ins_step))
      step = *std::move(longer);
  last_ = step.quality.failure.empty() ? step.target_from_source : RigidTransform::Identity();
  if (fits(step, ins_step)) fitting_ = last_;
  return step;
}

bool StepFinder::may_search() const {
  constexpr int kSearches = 6;
  // Lengths that never fit are another fault than a wrong start: of clocks, units or the INS.
  constexpr int kMostFruitless = 10;
  return searches_ < kSearches && fruitless_ < kMostFruitless;
}

std::optional<registration::RegistrationResult> StepFinder::search(const registration::PreparedCloud& source,
                                                                   const registration::PreparedCloud& target,
                                                                   const RigidTransform& ins_step, double overlap) {
  // The right step aligns nearly as well as one that is favoured because all places look alike.
  constexpr double kNearlyAsWell = 0.7;
  const Eigen::Vector3d ahead = up_in_lidar_.unitOrthogonal(), aside = up_in_lidar_.cross(ahead);
  std::array<registration::RegistrationResult, kDirections> found;
  bool any = false;
  for (std::size_t k = 0; k < kDirections && !progress_.cancelled(); ++k) {
    const double angle_rad = 2.0 * kPi * static_cast<double>(k) / kDirections;
    RigidTransform start = RigidTransform::Identity();
    start.translation() = ins_step.translation().norm() * (std::cos(angle_rad) * ahead + std::sin(angle_rad) * aside);
    found[k] = registration::align_scans(source, target, start, options_, progress_);
    if (!fits(found[k], ins_step) || found[k].quality.overlap < kNearlyAsWell * overlap) continue;
    scores_[k] += found[k].quality.overlap;
    any = true;
  }
  if (progress_.cancelled()) return std::nullopt;  // not every direction was tried
  fruitless_ = any ? 0 : fruitless_ + 1;
  if (!any) return std::nullopt;
  ++searches_;
  const auto best = static_cast<std::size_t>(std::max_element(scores_.begin(), scores_.end()) - scores_.begin());
  if (!fits(found[best], ins_step)) return std::nullopt;
  return found[best];
}

std::optional<registration::RegistrationResult> StepFinder::again_as_before(const registration::PreparedCloud& source,
                                                                            const registration::PreparedCloud& target,
                                                                            const RigidTransform& ins_step) {
  if (!fitting_) return std::nullopt;
  registration::RegistrationResult again = registration::align_scans(source, target, *fitting_, options_, progress_);
  if (!fits(again, ins_step)) return std::nullopt;
  return again;
}

}  // namespace remount::pipeline
