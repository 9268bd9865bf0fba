// Messages as words.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/catalogue.h"
#include "algorithms/messages/message.h"

namespace remount {

/// The words of a message, UTF-8. Units, plurals and what joins lists are those of the language. A code that is not in
/// the catalogue is shown with its arguments: better than nothing.
std::string render(const Message& message, Language language);

/// Takes the words of a message and its numbers apart, in the order in which they are shown.
class RenderedMessage {
 public:
  virtual ~RenderedMessage() = default;
  virtual void words(std::string_view said) = 0;
  virtual void number(std::string_view digits) = 0;  ///< without its unit
};
void render(const Message& message, Language language, RenderedMessage& out);

/// In English, which the command line, files and tests speak where nothing else is set.
std::string english(const Message& message);

std::vector<std::string> english(const std::vector<Message>& messages);

/// In English, for tests and logs.
std::ostream& operator<<(std::ostream& stream, const Message& message);

/// @return English where the tag ("en", "zh_CN", "zh") is of no language of the catalogue
Language language_of(std::string_view tag);

}  // namespace remount
