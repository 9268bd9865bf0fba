// What readers of logs and bags choose, leave out or mend as they read.
#include "messages/checks.h"
#include "model/checks/builtin.h"

namespace remount::checks {

DataCheck log_reading_check() {
  return {.kinds = {{"ins-log-chosen", say::ins_log_chosen_meaning, say::ins_log_chosen_remedy},
                    {"gnss-far-away", say::gnss_far_away_meaning, say::gnss_far_away_remedy},
                    {"attitude-chosen", say::attitude_chosen_meaning, say::attitude_chosen_remedy},
                    {"roll-assumed", say::roll_assumed_meaning, say::roll_assumed_remedy},
                    {"ins-status-misnamed", say::ins_status_misnamed_meaning, say::ins_status_misnamed_remedy},
                    {"raw-packets", say::raw_packets_meaning, say::raw_packets_remedy},
                    {"ins-unusable", say::ins_unusable_meaning, say::ins_unusable_remedy},
                    {"bag-copied", say::bag_copied_meaning, say::bag_copied_remedy}}};
}

}  // namespace remount::checks
