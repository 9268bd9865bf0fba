// In which ways positions and attitudes of poses may belong together, and how likely each is.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/geodesy/geodesy.h"
#include "model/conventions/turned_by_fixes.h"
#include "model/drive/session.h"

namespace remount::conventions {

/// What positions count in: UTM, another grid (a national one), or a metric world of their own.
enum class PoseWorld { Utm, OtherGrid, Own };

struct NorthHypothesis {
  PoseWorld world = PoseWorld::Own;
  double correction_rad = 0.0;                      ///< that brings attitudes to the axes of the positions
  std::optional<double> turned_rad = std::nullopt;  ///< positions against east and north; nothing: by any angle
  double scale = 1.0, scale_sigma = 0.0;            ///< metres of the world in one metre
  bool northern = true;                             ///< of UTM
  double weight = 0.0;
};

/// What is left of the direction of travel when the nearest axis of the INS is taken for forward.
struct HeadingApart {
  double apart_rad = 0.0, sigma_rad = 0.0;
};
std::optional<HeadingApart> heading_apart(const drive::Session& session);

/// Of the angle between the heading of an INS and the direction of travel, per radian: most are set up in line with
/// their vehicle to some tenths of a degree; one in ten is turned by a degree or some.
double setup_density(double angle_rad, double sigma_rad);

/// Positions have the numbers of a grid. UTM's northings count from the equator; national grids count theirs from near
/// their south, and their convergence is not known.
/// @param on_utm by fixes; nothing where there are none
/// @param northern hemisphere, where it is known
std::vector<NorthHypothesis> norths_by_numbers(const drive::Session& session, std::optional<bool> on_utm,
                                               std::optional<bool> northern);

/// Fixes tell where the drive is, and its numbers are not those of UTM there.
/// @param here on UTM's grid
/// @param not_utm the numbers are those of a grid
std::vector<NorthHypothesis> norths_by_fixes(const drive::Session& session, const TurnedByFixes& turned,
                                             const geodesy::GridFix& here, bool not_utm);

/// By what the drive tells; weights then sum to one.
void weigh_norths(const std::optional<TurnedByFixes>& turned, const std::optional<HeadingApart>& heading,
                  std::vector<NorthHypothesis>& norths);

/// The likeliest of the likeliest world.
NorthHypothesis likeliest_north(const std::vector<NorthHypothesis>& norths);

/// Whether the INS would be in line with its vehicle, as most are.
bool fits_travel(const NorthHypothesis& north, const HeadingApart& heading);

/// How far attitudes may be from where they are taken to be, one sigma. What the data cannot tell from it lies within
/// three sigma: where an INS that is itself turned by about the convergence looks like another north, both do.
double north_doubt_rad(const std::vector<NorthHypothesis>& norths, const NorthHypothesis& taken);

}  // namespace remount::conventions
