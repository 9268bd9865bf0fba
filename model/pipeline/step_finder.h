// Registration of neighbouring scans while the mounting is not known.
#pragma once

#include <array>
#include <optional>

#include "algorithms/registration/registration.h"

namespace remount::pipeline {

/// Whether a motion of the LiDAR is as long as that of the INS, whatever X is: they differ by the turn times the lever
/// arm.
bool as_long_as(const RigidTransform& lidar_motion, const RigidTransform& ins_motion);

/// Aligns the scans of a session one after the other, each from the step before it. A vehicle at speed travels farther
/// between two scans than neighbours are matched over, and a street looks alike a few metres on: where a step is not as
/// long as the INS says, steps of that length along the ground are tried in all directions.
class StepFinder {
 public:
  /// @param up_in_lidar away from the ground, unit length @param progress outlives this
  StepFinder(const registration::RegistrationOptions& options, const Eigen::Vector3d& up_in_lidar,
             const Progress& progress);

  /// The step that was found. Where none has the length of the INS's it is the one from the step before, right or
  /// wrong; where there is none at all, its quality says why.
  /// @param target the scan before `source`
  /// @param ins_step target_from_source of the INS
  registration::RegistrationResult find(const registration::PreparedCloud& source,
                                        const registration::PreparedCloud& target, const RigidTransform& ins_step);

 private:
  static constexpr std::size_t kDirections = 12;

  bool may_search() const;
  // Tries steps in all directions. A single pair of scans may fit backwards or across as well: the direction counts
  // that did best over all searches so far.
  std::optional<registration::RegistrationResult> search(const registration::PreparedCloud& source,
                                                         const registration::PreparedCloud& target,
                                                         const RigidTransform& ins_step, double overlap);
  std::optional<registration::RegistrationResult> again_as_before(const registration::PreparedCloud& source,
                                                                  const registration::PreparedCloud& target,
                                                                  const RigidTransform& ins_step);

  registration::RegistrationOptions options_;
  Eigen::Vector3d up_in_lidar_;
  const Progress& progress_;
  RigidTransform last_ = RigidTransform::Identity();
  std::optional<RigidTransform> fitting_;     // the last one of the right length
  std::array<double, kDirections> scores_{};  // overlap where the length was right, summed over the searches
  int searches_ = 0, fruitless_ = 0;
};

}  // namespace remount::pipeline
