// What readers could not use of a recording that is usable as a whole.
#include "model/checks/builtin.h"

namespace remount {

DataCheck reading_check() {
  return {.kinds = {
              {"missing-scans", "Scans that are listed are not there, and take no part.",
               "Copy the recording again, whole."},
              {"scans-without-stamp", "Scans without a time cannot be used.",
               "Copy the file of stamps again, as it was recorded."},
              {"ins-far-away", "Positions far from all others are glitches of the receiver, and left out.",
               "Nothing, where they are few; otherwise the log holds more than one drive."},
              {"bad-scan-names", "Files whose names are no stamps are left out.",
               "Name scans by their time, or give a table of stamps."},
              {"heading-alone", "Roll and pitch are guesses: of the mounting only yaw, and x and y, can be relied on.",
               "Log PASHR as well, or use an INS."},
              {"heading-order", "In turns, headings may be those of the next position.",
               "Begin the log with a heading (HDT) before its position, or log PASHR, which has a time."},
              {"attitude-sparse", "Between attitudes that are far apart in time the motion is not known.",
               "Log attitude (PASHR or HDT) at the rate of the positions, at 5 Hz or more."},
              {"utm-poses", "Yaw of the result is off by as much as the grid turns against true north there.",
               "Give latitude and longitude where you have them, or turn the poses by the grid convergence."},
              {"bag-*", "What lies in the damaged part of the bag takes no part.",
               "Copy the bag again, whole; close the recorder before copying. rosbag reindex (.bag) or mcap recover "
               "(.mcap) restore an index, sqlite3's .recover what is whole of a .db3."},
              {"bad-*", "Lines that are damaged are left out.", "Export the log again where they are many."}}};
}

}  // namespace remount
