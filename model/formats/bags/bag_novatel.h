// The INS of a NovAtel from its messages in a bag.
#pragma once

#include "model/formats/bags/bag_streams.h"

namespace remount::bags {

/// Samples of INSPVAX, INSPVA or the solution of another make, as `kind` says; those of GSOF 49 with the errors of GSOF
/// 50, INSPVA with the errors that INSPVAX and INSSTDEV beside it state (formats::give_errors), of which a finding
/// tells ("ins-log-chosen"). Corrections that were lost are one, too.
std::vector<motion::InsSample> ins_from_inspvax(const BagStreams& streams, MessageKind kind, const std::string& where,
                                                std::vector<drive::Finding>& findings);

}  // namespace remount::bags
