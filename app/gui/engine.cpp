#include "app/gui/engine.h"

#include "model/io/session_reader.h"
#include "model/methods/calibration_method.h"

namespace remount {

Engine model_engine() {
  return {open_session,   calibrate,          solve_again,    load_pair_clouds, solve_at_once,
          load_map_scans, load_keyframe_scan, check_hold_out, check_map};
}

}  // namespace remount
