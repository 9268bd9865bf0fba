// How fast a vehicle would be, for whoever doubts a table.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace remount::guesses {

/// Where the horizontal place is another than in the row before, from the first such row on. Logs repeat a fix in every
/// row until there is another: from row to row those would stand still and jump in turns. None of no place or no time.
std::vector<std::size_t> distinct_fixes(const std::vector<Eigen::Vector3d>& places_m,
                                        const std::vector<double>& times_s);

/// Horizontal speed over half a second, or between fixes that are further apart; less where all of it takes only
/// seconds. But for one in a hundred; 0 where there are none.
/// @param fixes the places that count, as above
double fastest_speed_mps(const std::vector<Eigen::Vector3d>& places_m, const std::vector<double>& times_s,
                         const std::vector<std::size_t>& fixes);

}  // namespace remount::guesses
