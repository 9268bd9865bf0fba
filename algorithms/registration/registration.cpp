#include "algorithms/registration/registration.h"

#include <cstdio>

namespace remount {
namespace {

std::string percent_below(const char* what, double value, double limit, const char* unit) {
  char text[120];
  std::snprintf(text, sizeof text, "%s %.3g%s, limit %.3g%s", what, value, unit, limit, unit);
  return text;
}

std::string judge(const RegistrationQuality& quality, const RegistrationOptions& options) {
  if (!quality.converged) return "registration did not converge";
  if (quality.overlap < options.min_overlap)
    return percent_below("overlap too small:", quality.overlap, options.min_overlap, "");
  if (quality.rmse_m > options.max_rmse_m)
    return percent_below("residual too large:", quality.rmse_m, options.max_rmse_m, " m");
  return {};
}

}  // namespace

const std::vector<RegistrationMethod>& registration_methods() {
  static const std::vector<RegistrationMethod> methods{
      {"plane-to-plane", align_plane_to_plane},
      {"pcl-icp", align_pcl_icp},
      {"pcl-gicp", align_pcl_gicp},
      {"pcl-ndt", align_pcl_ndt},
  };
  return methods;
}

RegistrationResult align_scans(const PreparedCloud& source, const PreparedCloud& target,
                               const RigidTransform& target_from_source_start, const RegistrationOptions& options,
                               const Progress& progress) {
  constexpr std::size_t kMinPoints = 100;
  if (source.size() < kMinPoints || target.size() < kMinPoints) {
    RegistrationResult result;
    result.quality.attempted = true;
    result.quality.failure = "too few points with a surface: " + std::to_string(std::min(source.size(), target.size()));
    return result;
  }
  const RegistrationMethod& method = registration_methods().at(static_cast<std::size_t>(options.algorithm));
  RegistrationResult result = method.align(source, target, target_from_source_start, options, progress);
  result.quality.attempted = true;
  if (!result.target_from_source.matrix().allFinite()) {
    result.target_from_source = target_from_source_start;
    result.quality.converged = false;
  }
  const AlignmentEquations equations =
      alignment_equations(source, target, result.target_from_source, 0.5 * options.max_correspondence_m);
  result.quality.rmse_m = equations.rmse_m;
  result.quality.overlap = equations.overlap;
  result.quality.information = equations.information;
  result.quality.failure = progress.cancelled() ? "cancelled" : judge(result.quality, options);
  return result;
}

}  // namespace remount
