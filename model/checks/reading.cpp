// What could not be used of a recording, and why.
#include "messages/checks.h"
#include "model/checks/builtin.h"

namespace remount::checks {

DataCheck reading_check() {
  return {.kinds = {
              {"lidar-chosen", say::lidar_chosen_meaning, say::lidar_chosen_remedy},
              {"tables-chosen", say::tables_chosen_meaning, say::tables_chosen_remedy},
              {"missing-scans", say::missing_scans_meaning, say::missing_scans_remedy},
              {"scans-without-stamp", say::bad_stamps_meaning, say::bad_stamps_remedy},
              {"ins-far-away", say::ins_far_away_meaning, say::gnss_far_away_remedy},
              {"bad-scan-names", say::bad_scan_names_meaning, say::bad_scan_names_remedy},
              {"heading-alone", say::heading_alone_meaning, say::heading_alone_remedy},
              {"log-cut", say::log_cut_meaning, say::log_cut_remedy},
              {"heading-order", say::heading_order_meaning, say::heading_order_remedy},
              {"attitude-sparse", say::attitude_sparse_meaning, say::attitude_sparse_remedy},
              {"bag-cut-end", say::bag_cut_end_meaning, say::bag_cut_end_remedy},
              {"bag-*", say::bag_any_meaning, say::bag_any_remedy},
              {"record-*", say::record_any_meaning, say::record_any_remedy},
              {"scans-compensated", say::scans_compensated_meaning, say::scans_compensated_remedy},
              {"ins-incomplete", say::ins_incomplete_meaning, say::ins_incomplete_remedy},
              {"ins-slow", say::ins_slow_meaning, say::ins_slow_remedy},
              {"no-point-times", say::no_point_times_meaning, say::no_point_times_remedy},
              {"point-times-misfit", say::point_times_misfit_meaning, say::point_times_misfit_remedy},
              {"point-times-backwards", say::point_times_backwards_meaning, say::point_times_backwards_remedy},
              {"sweep-open", say::sweep_open_meaning, say::sweep_open_remedy},
              {"sweep-reversed", say::sweep_reversed_meaning, say::sweep_reversed_remedy},
              {"stamps-not-by-number", say::stamps_not_by_number_meaning, say::stamps_not_by_number_remedy},
              {"no-stamps", say::no_stamps_meaning, say::no_stamps_remedy},
              {"height-missing", say::height_missing_meaning, say::height_missing_remedy},
              {"nominal-unreadable", say::nominal_unreadable_meaning, say::nominal_unreadable_remedy},
              {"rotation-not-orthonormal", say::rotation_not_orthonormal_meaning, say::rotation_not_orthonormal_remedy},
              {"scan-without-ins", say::scan_without_ins_meaning, say::scan_without_ins_remedy},
              {"no-readable-scan", say::no_readable_scan_meaning, say::missing_scans_remedy},
              {"too-few-scans", say::too_few_scans_meaning, say::too_few_scans_remedy},
              {"no-motion", say::no_motion_meaning, say::little_turning_remedy},
              {"bad-*", say::bad_any_meaning, say::bad_any_remedy}}};
}

}  // namespace remount::checks
