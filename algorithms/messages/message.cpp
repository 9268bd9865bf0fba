#include "algorithms/messages/message.h"

#include <algorithm>
#include <utility>

#include "algorithms/messages/catalogue.h"

namespace remount {

Message::Message() = default;
Message::Message(const Message& other) = default;
Message::Message(Message&& other) noexcept = default;
Message& Message::operator=(const Message& other) = default;
Message& Message::operator=(Message&& other) noexcept = default;
Message::~Message() = default;

Message::Message(std::string_view code, std::vector<Argument> arguments)
    : code_(code), arguments_(std::move(arguments)) {}

Message Message::verbatim(std::string words) {
  if (words.empty()) return {};
  return {kVerbatim, {{std::string(kOnlyPlace), std::move(words)}}};
}

Message Message::sequence(std::vector<Message> messages) {
  std::erase_if(messages, [](const Message& message) { return message.empty(); });
  if (messages.empty()) return {};
  if (messages.size() == 1) return std::move(messages.front());
  return {kSequence, {{std::string(kOnlyPlace), std::move(messages)}}};
}

const Argument* Message::argument(std::string_view name) const {
  const auto found = std::find_if(arguments_.begin(), arguments_.end(),
                                  [name](const Argument& argument) { return argument.name == name; });
  return found == arguments_.end() ? nullptr : &*found;
}

bool operator==(const Message& a, const Message& b) { return a.code_ == b.code_ && a.arguments_ == b.arguments_; }

}  // namespace remount
