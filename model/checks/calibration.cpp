// What a calibration itself suspects, with its result before it.
#include "model/checks/builtin.h"

namespace remount {

DataCheck calibration_check() {
  return {.kinds = {
              {"nominal-far", "Either the LiDAR sits otherwise than assumed, or the nominal is given in other terms.",
               "Look at the vehicle; check axes, signs, order of angles and direction of the nominal."},
              {"map-less-sharp", "The accumulated scans contradict the result, whatever its residuals say.",
               "Look at the pairs that were accepted and at the clock offset; do not use the result before that."},
              {"measured-unused", "The result does not contain the value that was measured by hand.",
               "Give its sigma, or leave it out."},
              {"measured-without-ins", "The result does not contain the value that was measured by hand.",
               "Leave it out, or record an INS with attitude."},
          }};
}

}  // namespace remount
