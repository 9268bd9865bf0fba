// Where positions fall from RTK by their own status.
#pragma once

#include <string>
#include <vector>

#include "model/formats/bags/ros_messages.h"

namespace remount::bags {

/// By what a position was found.
struct CorrectionStatus {
  int level = 0;     ///< 3 RTK fixed, 2 float or converged PPP, 1 a position of less, 0 none
  std::string name;  ///< "INS_RTKFIXED"; of a NavSatFix "STATUS_GBAS_FIX"
};

CorrectionStatus correction_status(const FixMessage& fix);
/// Of INSPVAX, whose position type is a name or the number that stands for it.
CorrectionStatus correction_status(const InspvaxMessage& message);

/// Adds "rtk-lost" where a tenth of the positions or more are RTK or PPP and later ones fall behind these.
void report_lost_corrections(std::vector<CorrectionStatus> positions, const std::string& where,
                             std::vector<drive::Finding>& findings);

}  // namespace remount::bags
