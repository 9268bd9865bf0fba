// Sentences of NMEA in a bag, as a log of them.
#pragma once

#include <string>

#include "model/drive/session.h"

namespace remount::bags {

/// Makes the sentences of the topic `where` the INS of a session, with the times that stand in them. Where they hold
/// none, a finding says why ("bad-nmea").
void add_nmea_ins(const std::string& sentences, const std::string& where, drive::Session& session);
/// Likewise its fixes. @param told the same sentences are the INS, and what is wrong with them was told
void add_nmea_fixes(const std::string& sentences, const std::string& where, bool told, drive::Session& session);

}  // namespace remount::bags
