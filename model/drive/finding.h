// What the engineer should know about data and results.
#pragma once

#include <string>
#include <string_view>

#include "algorithms/messages/message.h"

namespace remount {

enum class Severity { Note, Warning, Problem };

/// "note", "warning", "problem".
std::string_view to_string(Severity severity);

/// Something the engineer should know about the data: what, where, and what to do about it.
struct Finding {
  Severity severity = Severity::Note;
  std::string code;     ///< stable identifier, "ins-gap"
  std::string where;    ///< file, stamp or stream
  Message explanation;  ///< in words, with what to do
};

}  // namespace remount
