// What the messages of a bag do not say: its reader takes note of it as it reads.
#include "model/checks/builtin.h"

namespace remount {

DataCheck bag_stream_check() {
  return {
      .kinds = {
          {"no-orientation", "Where the INS has no orientation there is no motion to be compared with.",
           "Nothing, where they are at the beginning: the INS was aligning; otherwise see what the driver reports."},
          {"rates-denied", "The rates are used, though the driver says that there are none.",
           "Compare them with the turns of the drive; where they mean nothing leave them out: --topic imu=none."},
          {"no-rates", "Methods that need turn rates have none there.",
           "See whether the driver of the IMU stalled, or say with --topic which topic is the IMU."},
          {"antenna-position",
           "X is of the antenna then, turned as the IMU is: off by the lever arm between the two, and no sigma says "
           "so.",
           "Take the positions of the INS itself (--topic ins-position=TOPIC), or let the driver subtract the lever "
           "arm."},
          {"no-fix", "The receiver has no position there.", "Record under open sky; wait for a fix before you drive."},
          {"gnss-covariance-unknown", "Good fixes count as little as bad ones.",
           "Have the driver state the covariance of its fixes."}}};
}

}  // namespace remount
