// The rows of a fleet as text: for a terminal, as CSV for other programs, and as a page for people.
#pragma once

#include <string>
#include <vector>

#include "algorithms/messages/catalogue.h"
#include "model/fleet/fleet_rows.h"

namespace remount::fleet {

/// One line a LiDAR of a job, with lines below it where it has a result, and one where all of them moved together.
std::string fleet_text(const Fleet& fleet, const std::vector<FleetRow>& rows, Language language = Language::English);

/// One header line, then a line a LiDAR of a job (RFC 4180); m and degrees; empty where there is no number. Begins with
/// kFleetCsvMark.
std::string fleet_csv(const Fleet& fleet, const std::vector<FleetRow>& rows);
inline constexpr std::string_view kFleetCsvMark = "vehicle,job,sessions,state,status,";

/// One page that needs no other file; those with an alarm come first, in a list of their own.
std::string fleet_html(const Fleet& fleet, const std::vector<FleetRow>& rows, const std::string& created,
                       Language language = Language::English);

/// "12 jobs: 9 solved, 1 without a usable result, 1 failed, 1 waiting; drift in 2".
Message fleet_counts(const std::vector<FleetRow>& rows);

}  // namespace remount::fleet
