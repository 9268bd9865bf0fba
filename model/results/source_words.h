// Sources of candidates, which files and results hold as English words, for people.
#pragma once

#include <string>

#include "algorithms/messages/message.h"

namespace remount {

/// "pair 12", "all pairs: Park-Martin", "nominal" as a message; verbatim where it is none that is known.
Message source_words(const std::string& source);

}  // namespace remount
