// Why a pair was rejected: the choices, and words for it.
#pragma once

#include <QString>
#include <vector>

#include "algorithms/messages/message.h"

namespace remount::widgets {

/// Reasons that are one key away.
const std::vector<Message (*)()>& quick_reasons();

/// What stands where the user gave no reason: who decided.
bool tells_who_only(const Message& reason);

/// In the language of the window; what a user typed as it is.
QString reason_words(const Message& reason);

}  // namespace remount::widgets
