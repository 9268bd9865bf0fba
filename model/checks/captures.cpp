// What packets of a capture do not say or lack, and recordings that give nothing: readers take note of it as they read.
#include "messages/checks.h"
#include "model/checks/builtin.h"

namespace remount::checks {

DataCheck capture_check() {
  return {.kinds = {{"capture-clock", say::capture_clock_meaning, say::capture_clock_remedy},
                    {"capture-tai", say::capture_tai_meaning, say::capture_tai_remedy},
                    {"capture-angles", say::capture_angles_meaning, say::capture_angles_remedy},
                    {"capture-missing", say::capture_missing_meaning, say::capture_missing_remedy},
                    {"capture-index", say::capture_index_meaning, say::capture_index_remedy},
                    {"capture-repeated", say::capture_repeated_meaning, say::capture_repeated_remedy},
                    {"capture-foreign", say::capture_foreign_meaning, say::capture_foreign_remedy},
                    {"capture-other-sensors", say::capture_other_sensors_meaning, say::capture_other_sensors_remedy},
                    {"capture-refused", say::capture_refused_meaning, say::capture_refused_remedy},
                    {"recording-unused", say::recording_unused_meaning, say::recording_unused_remedy},
                    {"capture-truncated", say::capture_truncated_meaning, say::capture_truncated_remedy},
                    {"capture-position", say::capture_position_meaning, say::capture_position_remedy},
                    {"capture-*", say::capture_any_meaning, say::capture_any_remedy}}};
}

}  // namespace remount::checks
