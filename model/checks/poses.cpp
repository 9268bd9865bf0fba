// What was found out of positions, poses and frames on the earth while a session was opened.
#include "model/checks/builtin.h"

namespace remount {

DataCheck pose_check() {
  return {.kinds = {
              {"utm-true-north", "Without that, yaw of X would be off by the grid's convergence without a sign of it.",
               "Give latitude and longitude where you have them, as a NavSatFix or in a session.yaml."},
              {"utm-grid-north", "Distances of the grid are up to a thousandth too long or too short.",
               "Give latitude and longitude where you have them."},
              {"north-unknown", "Positions and attitudes that count from different norths turn X about the vertical.",
               "Record the fixes of the same drive, too, or give latitude and longitude with attitudes to true north."},
              {"ins-axes-by-travel", "Exports that turn axes, and the obstacle check, go by what looks forward.",
               "Nothing; where a robot moves sideways at will, mind that its axes are called otherwise."},
              {"ins-axes-down", "Exports that turn axes cannot know what the axes of the INS are.",
               "Nothing, where the INS has z down; otherwise check the convention of the attitude (ENU or NED)."},
              {"off-earth", "Glitches of a filter or of its log; what lies between them is used.",
               "Look at the source of the stream where they are many."},
              {"stamps-unit", "Stamps in another unit would be none at all.",
               "Name the unit in the first line, as in \"# timestamp [ns] tx ty tz qx qy qz qw\"."}}};
}

}  // namespace remount
