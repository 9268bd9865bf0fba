// What the messages of a bag do not say: its reader takes note of it as it reads.
#include "messages/checks.h"
#include "model/checks/builtin.h"

namespace remount::checks {

DataCheck bag_stream_check() {
  return {.kinds = {
              {"no-orientation", say::no_orientation_meaning, say::no_orientation_remedy},
              {"rates-denied", say::rates_denied_meaning, say::rates_denied_remedy},
              {"no-rates", say::no_rates_meaning, say::no_rates_remedy},
              {"antenna-position", say::antenna_position_meaning, say::antenna_position_remedy},
              {"no-fix", say::no_fix_meaning, say::no_fix_remedy},
              {"gnss-covariance-unknown", say::gnss_covariance_unknown_meaning, say::gnss_covariance_unknown_remedy}}};
}

}  // namespace remount::checks
