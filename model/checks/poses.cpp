// What was found out of positions, poses and frames on the earth while a session was opened.
#include "messages/checks.h"
#include "model/checks/builtin.h"

namespace remount::checks {

DataCheck pose_check() {
  return {.kinds = {{"utm-true-north", say::utm_true_north_meaning, say::utm_true_north_remedy},
                    {"utm-grid-north", say::utm_grid_north_meaning, say::utm_grid_north_remedy},
                    {"north-unknown", say::north_unknown_meaning, say::north_unknown_remedy},
                    {"ins-axes-by-travel", say::ins_axes_by_travel_meaning, say::ins_axes_by_travel_remedy},
                    {"ins-axes-down", say::ins_axes_down_meaning, say::ins_axes_down_remedy},
                    {"off-earth", say::off_earth_meaning, say::off_earth_remedy},
                    {"poses-without-time", say::poses_left_without_meaning, say::poses_left_without_remedy},
                    {"missing-poses", say::poses_missing_meaning, say::poses_missing_remedy},
                    {"poses-in-plane", say::poses_in_plane_meaning, say::poses_in_plane_remedy},
                    {"no-nominal", say::no_nominal_meaning, say::no_nominal_remedy},
                    {"poses-by-mounting", say::poses_by_mounting_meaning, say::poses_by_mounting_remedy},
                    {"stamps-unit", say::stamps_unit_meaning, say::stamps_unit_remedy}}};
}

}  // namespace remount::checks
