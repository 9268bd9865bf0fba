// What the engineer should know about data and results.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "algorithms/messages/render.h"

namespace remount::drive {

enum class Severity { Note, Warning, Problem };

/// "note", "warning", "problem".
std::string_view to_string(Severity severity);

/// Where something is: a file, a session or a topic by its name, which is the same in every language, or a part of the
/// data in words.
class Place {
 public:
  Place() = default;
  Place(std::string name) : words_(Message::verbatim(std::move(name))) {}  // NOLINT: a name is a place
  Place(Message words) : words_(std::move(words)) {}                       // NOLINT

  const Message& words() const { return words_; }
  /// Null where it is told in words.
  const std::string* name() const {
    const Argument* name = words_.code() == kVerbatim ? words_.argument(kOnlyPlace) : nullptr;
    return name == nullptr ? nullptr : std::get_if<std::string>(&name->value);
  }

  friend bool operator==(const Place& a, const Place& b) = default;

 private:
  Message words_;
};

/// In English, for files and tests.
inline std::string english(const Place& place) { return english(place.words()); }

/// Something the engineer should know about the data: what, where, and what to do about it.
struct Finding {
  Severity severity = Severity::Note;
  std::string code;     ///< stable identifier, "ins-gap"
  Place where;          ///< file, stamp or stream
  Message explanation;  ///< in words, with what to do
};

}  // namespace remount::drive
