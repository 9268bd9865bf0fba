// What a calibration itself suspects, with its result before it.
#include "messages/checks.h"
#include "model/checks/builtin.h"

namespace remount::checks {

DataCheck calibration_check() {
  return {
      .kinds = {
          {"scans-gathered", say::scans_gathered_meaning, say::scans_gathered_remedy},
          {"pairs-chosen", say::pairs_chosen_meaning, say::pairs_chosen_remedy},
          {"nominal-far", say::nominal_far_meaning, say::nominal_far_remedy},
          {"lidar-left-out", say::lidar_left_out_meaning, say::lidar_left_out_remedy},
          {"lidars-not-joined", say::lidars_not_joined_meaning, say::lidars_not_joined_remedy},
          {"lidar-not-seen-by-others", say::lidar_not_seen_meaning, say::lidar_not_seen_remedy},
          {"vehicle-drives-contradict", say::vehicle_drives_contradict_meaning, say::vehicle_drives_contradict_remedy},
          {"lidars-contradict", say::lidars_contradict_meaning, say::lidars_contradict_remedy},
          {"motions-differ", say::motions_differ_meaning, say::motions_differ_remedy},
          {"map-less-sharp", say::map_less_sharp_meaning, say::map_less_sharp_remedy},
          {"beam-errors", say::beam_errors_meaning, say::beam_errors_remedy},
          {"ins-position-lag", say::ins_position_lag_meaning, say::ins_position_lag_remedy},
          {"ins-positions-apart", say::ins_positions_apart_meaning, say::ins_positions_apart_remedy},
          {"measured-unused", say::measured_unused_meaning, say::measured_unused_remedy},
          {"measured-without-ins", say::measured_unused_meaning, say::measured_without_ins_remedy},
      }};
}

}  // namespace remount::checks
