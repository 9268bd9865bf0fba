// One job of a fleet in this process.
#pragma once

#include "app/cli/console.h"
#include "model/batch/fleet.h"

namespace remount {

/// Calibrates one job where that has not been done yet, and ends as `calibrate` does. Waits where another process is
/// at the same job. Cancelled, it leaves what was there; where it cannot run, it leaves the reason beside the result
/// and throws Error.
int run_job(const Fleet& fleet, const FleetJob& job, Console& console);

}  // namespace remount
