// What is believed of a LiDAR's own errors before a drive tells. docs/maths/beams.md (B4)
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "algorithms/cloud/beam_errors.h"
#include "algorithms/core/options.h"
#include "messages/options.h"

namespace remount::cloud {

/// What a session may say of its LiDAR, and what users may say beside that.
enum class LidarKind { Perfect, Spinning, SolidState, Unknown, Auto, Own };
inline constexpr std::array<std::string_view, 4> kDeclaredLidars{"perfect", "spinning", "solid-state", "unknown"};

/// Each beam errs for itself, and all of them together.
struct BeamOptions {
  std::string file;  ///< corrections that are known beforehand; empty: none
  LidarKind lidar = LidarKind::Auto;
  double beam_elevation_deg = 0.05;
  double beam_range_m = 0.02;
  double common_elevation_deg = 0.2;
  double common_range_m = 0.02;
  double range_scale = 0.001;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"file", "", say::option_beams_file, say::option_beams_file_help}, self.file);
    visitor.choice({"lidar", "", say::option_beams_lidar, say::option_beams_lidar_help}, self.lidar,
                   {"perfect", "spinning", "solid-state", "unknown", "auto", "own"});
    visitor({"beam_elevation_deg", "deg", say::option_beams_beam_elevation_deg,
             say::option_beams_beam_elevation_deg_help, 0.0, 5.0},
            self.beam_elevation_deg);
    visitor({"beam_range_m", "m", say::option_beams_beam_range_m, say::option_beams_beam_range_m_help, 0.0, 1.0},
            self.beam_range_m);
    visitor({"common_elevation_deg", "deg", say::option_beams_common_elevation_deg,
             say::option_beams_common_elevation_deg_help, 0.0, 5.0},
            self.common_elevation_deg);
    visitor({"common_range_m", "m", say::option_beams_common_range_m, say::option_beams_common_range_m_help, 0.0, 1.0},
            self.common_range_m);
    visitor({"range_scale", "", say::option_beams_range_scale, say::option_beams_range_scale_help, 0.0, 0.1},
            self.range_scale);
  }
};

/// @param declared what a session says of its LiDAR: taken where the options leave it open
/// @param nodes where its errors are unknowns
BeamPrior believed_of_beams(const BeamOptions& options, LidarKind declared, const BeamNodes& nodes);
/// Where an earlier drive told them. Correlations are not kept in files: what all beams share is known as well as the
/// mean of those that were told, the rest of each sigma is its own.
BeamPrior believed_of_known(const BeamEstimate& known);

}  // namespace remount::cloud
