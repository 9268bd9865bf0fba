// One job of a fleet in this process.
#pragma once

#include "app/cli/console.h"
#include "model/fleet/fleet.h"
#include "model/results/vehicle_file.h"

namespace remount::cli {

/// Calibrates one job where that has not been done yet, and ends as `calibrate` does. Waits where another process is
/// at the same job. Cancelled, it leaves what was there; where it cannot run, it leaves the reason beside the result
/// and throws Error.
int run_job(const fleet::Fleet& fleet, const fleet::FleetJob& job, Console& console);

/// Why a job's result is not what the job would make now; empty where it is. Sessions are opened only where something
/// has been written since.
Message why_out_of_date(const fleet::Fleet& fleet, const fleet::FleetJob& job, const results::VehicleFile& stored,
                        Console& console);

}  // namespace remount::cli
