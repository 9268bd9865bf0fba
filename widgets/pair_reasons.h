// Why a pair was rejected: the choices, and words for what files hold.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "algorithms/messages/message.h"

namespace remount {

/// Reasons that are one key away, as files hold them.
const std::vector<const char*>& quick_reasons();
/// In the user's language where the words are the program's own; the user's as they are.
QString reason_words(const std::string& reason);
QString reason_words(const Message& reason);

}  // namespace remount
