#include "remount/registration.h"

#include "algorithms/registration/registration.h"
#include "api/bridge.h"
#include "api/own_recording.h"
#include "messages/programs.h"
#include "model/settings/settings.h"

namespace remount::api {

namespace {

/// Throws remount::Error(Format) where nothing of it is a return.
cloud::PointCloud returns_of(const Scan& scan, const std::string& where) {
  cloud::PointCloud cloud = cloud_of(scan, where);
  if (cloud.points.empty() && cloud.dropped_points > 0)
    throw remount::Error(remount::ErrorCode::Format, where, say::api_scan_without_returns(cloud.dropped_points));
  return cloud;
}

}  // namespace

Registration register_scans(const Scan& source, const Scan& target, const Matrix4& target_from_source_start,
                            const Settings& settings, const Progress& progress) {
  return with_progress(progress, [&](remount::Progress& inner) {
    settings::require_valid(settings.inside());
    const registration::RegistrationOptions& options = settings.inside().registration;
    const RigidTransform start = rigid_of_matrix(target_from_source_start, "target_from_source_start");
    const registration::PreparedCloud prepared_source(returns_of(source, "source"), options, {}, inner);
    const registration::PreparedCloud prepared_target(returns_of(target, "target"), options, {}, inner);
    const registration::RegistrationResult found =
        registration::align_scans(prepared_source, prepared_target, start, options, inner);
    const motion::RegistrationQuality& quality = found.quality;
    return Registration{matrix_of(found.target_from_source),
                        quality.converged,
                        quality.iterations,
                        quality.rmse_m,
                        quality.overlap,
                        quality.information,
                        Text(quality.failure),
                        Text(quality.undetermined)};
  });
}

}  // namespace remount::api
