// The checks that are built in, one file each.
#pragma once

#include "model/checks/data_check.h"

namespace remount::checks {

DataCheck ins_solution_check();
DataCheck frozen_part_check();
DataCheck held_part_check();
DataCheck ins_jump_check();
DataCheck rtk_check();
DataCheck drive_variety_check();
DataCheck attitude_data_check();
DataCheck unit_check();
DataCheck clock_check();
DataCheck stamp_check();
DataCheck scan_check();
DataCheck handedness_check();
DataCheck bag_stream_check();
DataCheck capture_check();
DataCheck log_reading_check();
DataCheck pose_check();
DataCheck reading_check();
DataCheck calibration_check();
DataCheck method_run_check();

}  // namespace remount::checks
