// What could not be used of a recording, and why.
#include "model/checks/builtin.h"

namespace remount {

DataCheck reading_check() {
  return {
      .kinds = {
          {"missing-scans", "Scans that are listed are not there, and take no part.",
           "Copy the recording again, whole."},
          {"scans-without-stamp", "Scans without a time cannot be used.",
           "Copy the file of stamps again, as it was recorded."},
          {"ins-far-away", "Positions far from all others are glitches of the receiver, and left out.",
           "Nothing, where they are few; otherwise the log holds more than one drive."},
          {"bad-scan-names", "Files whose names are no stamps are left out.",
           "Name scans by their time, or give a table of stamps."},
          {"heading-alone", "Roll and pitch are guesses: of the mounting only yaw, and x and y, can be relied on.",
           "Log PASHR as well, or use an INS; or give what you measured, or the height of the INS above ground."},
          {"log-cut", "The recording was stopped, or copied, before it was complete.",
           "Copy the log again, whole. What lies before the cut is used."},
          {"heading-order", "In turns, headings may be those of the next position.",
           "Begin the log with a heading (HDT) and end it with a position, or log PASHR, which has a time."},
          {"attitude-sparse", "Between attitudes that are far apart in time the motion is not known.",
           "Log attitude (PASHR or HDT) at the rate of the positions, at 5 Hz or more."},
          {"bag-cut-end", "Nothing is missing but the index; yet a file that lacks its end was not copied whole.",
           "Copy the bag again, whole; close the recorder before copying. mcap recover writes a new index."},
          {"bag-*", "What lies in the damaged part of the bag takes no part.",
           "Copy the bag again, whole; close the recorder before copying. rosbag reindex (.bag) or mcap recover "
           "(.mcap) restore an index, sqlite3's .recover what is whole of a .db3."},
          {"ins-incomplete", "Messages without a fix or an orientation are no poses of the INS.",
           "Let the INS get its fix and align before you drive; record position and orientation at one rate."},
          {"ins-slow", "Where the vehicle turns, an interpolated motion is not the one that was driven.",
           "Log the INS at 50 Hz or faster, or drive slowly and steadily."},
          {"no-point-times",
           "Scans of a moving sensor are bent by the motion within a sweep, unless somebody has compensated them.",
           "Record points with their times: set the driver to write them (in a field called time, t or timestamp). A "
           "calibration tries sweeps in both directions and takes what the scans prove; without proof the sigmas "
           "include the others, and no clock offset is estimated."},
          {"point-times-misfit",
           "Times that are of another unit, or shares of a turn, bend the scans instead of mending them; they count as "
           "scans whose times are not known.",
           "Have the driver write the times of points in seconds, or name the unit in the column (time_ms, time_us, "
           "time_ns)."},
          {"point-times-backwards", "Taken forwards, such times bend the scans twice.",
           "Have the driver write the times of points from the stamp on."},
          {"sweep-open", "How the scans are bent by motion is a guess.",
           "Record points with their times, or declare in a native session how the sensor turns (timing: sweep)."},
          {"sweep-reversed", "The sensor turns the other way than those that the format was made for.",
           "Nothing, where the LiDAR is another one; otherwise check that axes of the points are right-handed."},
          {"stamps-not-by-number", "Scans and INS samples were taken out or renumbered apart from each other.",
           "Nothing, where the stamps of both are right; otherwise copy the drive again, whole."},
          {"no-stamps", "What the recorder is late by is a clock offset: X is off by it where the vehicle turns.",
           "Have the driver stamp its messages; look at the clock offset of the result."},
          {"height-missing", "A height that falls to zero is taken for motion.",
           "Export the track with its heights, or take out the points that have none."},
          {"nominal-unreadable", "The search begins without the mounting that lies beside the drive.",
           "Mend the file, or give the nominal mounting yourself."},
          {"rotation-not-orthonormal", "Digits were lost, or the numbers are in another order than was taken.",
           "Export the poses again with all digits, and check their layout."},
          {"scan-without-ins", "Scans without a motion of the INS cannot be compared with anything.",
           "Record the INS from before the first scan until after the last, on one clock."},
          {"no-readable-scan", "There is nothing that could be registered.", "Copy the recording again, whole."},
          {"too-few-scans", "A motion lies between two scans.",
           "Record a drive, and see whether the folder holds all of its scans."},
          {"no-motion", "Only motion tells where the LiDAR sits.",
           "Turn fully to each side at least once: in a figure of eight with a vehicle, on the spot with a machine "
           "that slews."},
          {"bad-*", "Lines that are damaged are left out.", "Export the log again where they are many."}}};
}

}  // namespace remount
