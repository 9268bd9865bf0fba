// Sentences about logs and files that are no session: what readers of NMEA, NovAtel's logs and bags say.
#pragma once

#include <vector>

namespace remount {

const std::vector<const char*>& log_phrases();

}  // namespace remount
