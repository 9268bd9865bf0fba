#include "algorithms/registration/registration.h"

#include <algorithm>

#include "algorithms/core/index.h"
#include "algorithms/registration/search_around.h"
#include "messages/pairs.h"

namespace remount::registration {
namespace {

// No LiDAR sees so far, and coordinates in single precision would not tell its points apart.
constexpr double kFarthestStart_m = 1e4;

Message judge(const motion::RegistrationQuality& quality, const RegistrationOptions& options) {
  if (!quality.converged) return say::registration_not_converged();
  if (quality.overlap < options.min_overlap)
    return say::registration_small_overlap(quality.overlap, options.min_overlap);
  if (quality.rmse_m > options.max_rmse_m)
    return say::registration_large_residual({quality.rmse_m}, {options.max_rmse_m});
  if (quality.information.isZero(0.0)) return say::registration_determines_nothing();
  return {};
}

// Aligns with the chosen algorithm and judges the outcome.
JudgedAlignment align_from(const PreparedCloud& source, const PreparedCloud& target, const RigidTransform& start,
                           const RegistrationOptions& options, const Progress& progress) {
  const RegistrationMethod& method = registration_methods().at(index_of(options.algorithm));
  JudgedAlignment out{method.align(source, target, start, options, progress), 0.0};
  RegistrationResult& result = out.result;
  result.quality.attempted = true;
  if (!result.target_from_source.matrix().allFinite()) {
    result.target_from_source = start;
    result.quality.converged = false;
  }
  const AlignmentEquations equations = alignment_equations(
      source, target, result.target_from_source, 0.5 * options.max_correspondence_m, progress, options.beam_nodes);
  out.agreement = equations.agreement;
  result.quality.rmse_m = equations.rmse_m;
  result.quality.overlap = equations.overlap;
  result.quality.information = equations.information;
  result.quality.beam_response = equations.beam_response;
  result.quality.undetermined = equations.undetermined.words();
  result.quality.failure = progress.cancelled() ? say::registration_cancelled() : judge(result.quality, options);
  return out;
}

}  // namespace

const std::vector<RegistrationMethod>& registration_methods() {
  static const std::vector<RegistrationMethod> methods{
      {"plane-to-plane", align_plane_to_plane},
#ifndef REMOUNT_ONLY_READERS  // which align with the first alone, for a check
      {"pcl-icp", align_pcl_icp},
      {"pcl-gicp", align_pcl_gicp},
      {"pcl-ndt", align_pcl_ndt},
#endif
  };
  return methods;
}

RegistrationResult align_scans(const PreparedCloud& source, const PreparedCloud& target,
                               const RigidTransform& target_from_source_start, const RegistrationOptions& options,
                               const Progress& progress) {
  constexpr std::size_t kMinPoints = 100;
  if (progress.cancelled()) {
    RegistrationResult result;  // scans whose preparation was cancelled are empty: no verdict on them
    result.quality.attempted = true;
    result.quality.failure = say::registration_cancelled();
    return result;
  }
  if (source.size() < kMinPoints || target.size() < kMinPoints) {
    RegistrationResult result;
    result.quality.attempted = true;
    result.quality.failure = say::registration_few_points(std::min(source.size(), target.size()));
    return result;
  }
  if (!(target_from_source_start.translation().norm() < kFarthestStart_m)) {  // also where it is not a number
    RegistrationResult result;
    result.quality.attempted = true;
    result.quality.failure = say::registration_too_far();
    return result;
  }
  JudgedAlignment alignment = align_from(source, target, target_from_source_start, options, progress);
  if (!options.search_when_doubtful || progress.cancelled()) return alignment.result;
  AroundSearch around;
  around.target_from_source = alignment.result.target_from_source;
  if (is_doubtful(alignment, target_from_source_start, options))
    around = search_around(source, target, target_from_source_start, alignment, options, progress);
  // The way from far away may take more iterations than are allowed from near.
  const bool on_its_way =
      !alignment.result.quality.converged && moved_far(target_from_source_start, alignment.result.target_from_source);
  if ((around.better || on_its_way) && !progress.cancelled()) {
    RegistrationOptions patient = options;
    patient.max_iterations = 3 * options.max_iterations;
    alignment = align_from(source, target, around.target_from_source, patient, progress);
  }
  if (progress.cancelled())
    alignment.result.quality.failure = say::registration_cancelled();
  else if (alignment.result.quality.failure.empty())
    alignment.result.quality.failure = around.ambiguity;
  return alignment.result;
}

}  // namespace remount::registration
