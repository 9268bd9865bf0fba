// A report of several LiDARs of a vehicle: where they sit against each other, then each as a report of one has it.
#pragma once

#include <string>

#include "model/report/report.h"
#include "model/results/vehicle_file.h"

namespace remount::report {

/// @param of_each what the reports of all LiDARs have in common: when they were made, why there are no pictures
std::string vehicle_report_html(const results::VehicleFile& vehicle, const Report& of_each, const ReportStyle& style);

}  // namespace remount::report
