// What a calibration itself suspects, with its result before it.
#include "model/checks/builtin.h"

namespace remount {

DataCheck calibration_check() {
  return {.kinds = {
              {"nominal-far", "Either the LiDAR sits otherwise than assumed, or the nominal is given in other terms.",
               "Look at the vehicle; check axes, signs, order of angles and direction of the nominal."},
              {"map-less-sharp", "The accumulated scans contradict the result, whatever its residuals say.",
               "Look at the pairs that were accepted and at the clock offset; do not use the result before that."},
              {"ins-position-lag",
               "Unless it is taken out, X is off by the way that is driven in that time, along the direction of travel "
               "mostly: 20 ms at 36 km/h are 0.2 m.",
               "Log position and attitude of one moment, in one message of one device; look which of the two is "
               "filtered, sent later, or stamped when it arrives."},
              {"ins-positions-apart",
               "X is uncertain by the way that is driven in that time, along the direction of travel mostly.",
               "Log position and attitude in one message, or with stamps that agree; or brake and accelerate while "
               "recording, which shows how well they go together."},
              {"measured-unused", "The result does not contain the value that was measured by hand.",
               "Give its sigma, or leave it out."},
              {"measured-without-ins", "The result does not contain the value that was measured by hand.",
               "Leave it out, or record an INS with attitude."},
          }};
}

}  // namespace remount
