// What readers of logs and bags choose, leave out or mend as they read.
#include "model/checks/builtin.h"

namespace remount {

DataCheck log_reading_check() {
  return {
      .kinds = {
          {"gnss-far-away", "Fixes far from all others are glitches of the receiver, and left out.",
           "Nothing, where they are few; otherwise the log holds more than one drive."},
          {"attitude-chosen",
           "Of several sentences with an attitude one kind serves: mixed, they would be of different sensors.",
           "Nothing, where it is the right one; otherwise log that one alone."},
          {"roll-assumed", "Roll is a guess: of the mounting only yaw, and x and y, can be relied on.",
           "Use an INS that measures roll; or give what you measured, or the height of the INS above ground."},
          {"ins-status-misnamed", "Were the names taken by their words, the INS would seem to be invalid throughout.",
           "Update the driver before you record again; this recording is read as it was meant."},
          {"raw-packets", "Packets have no points that could be registered.",
           "Play the bag with the sensor's driver running, and record the points that it publishes."},
          {"ins-unusable", "Nothing of the topic that would be the INS can be used.",
           "See what the driver of the INS reports, or choose another topic as the INS."},
          {"bag-copied", "What was recorded last lies in the database's log.",
           "Nothing, where there is room for the copy; closing the recorder properly saves it."}}};
}

}  // namespace remount
