#include "model/formats/documents/message_document.h"

#include <array>
#include <limits>

#include "algorithms/core/index.h"
#include "algorithms/messages/render.h"
#include "messages/decisions.h"
#include "messages/files.h"
#include "messages/results.h"

namespace remount::formats {
namespace {

// Of a message, and of arguments by their kinds.
constexpr std::string_view kCodeKey = "code", kArgumentsKey = "arguments", kTextKey = "text", kTextsKey = "texts",
                           kCountKey = "count", kMessageKey = "message", kMessagesKey = "messages";
constexpr std::array<std::string_view, 10> kQuantityKeys{
    "number",          "length_m",          "angle_rad",    "time_s", "speed_mps",
    "turn_rate_radps", "acceleration_mps2", "frequency_hz", "share",  "bytes"};  // in the order of Dimension
constexpr int kDeepest = 12;  // messages in messages; a file that has more was not written by this program
constexpr std::int64_t kLargestCount = std::numeric_limits<std::int64_t>::max();

struct ValueDocument {
  DocumentNode operator()(const Quantity& quantity) const {
    return of(kQuantityKeys[index_of(quantity.dimension)], DocumentNode::number(quantity.value));
  }
  DocumentNode operator()(std::int64_t count) const { return of(kCountKey, DocumentNode::integer(count)); }
  DocumentNode operator()(const std::string& words) const { return of(kTextKey, DocumentNode::string(words)); }
  DocumentNode operator()(const std::vector<std::string>& names) const {
    DocumentNode list = DocumentNode::sequence();
    for (const std::string& name : names) list.add(DocumentNode::string(name));
    return of(kTextsKey, std::move(list));
  }
  DocumentNode operator()(const Message& message) const { return of(kMessageKey, message_document(message)); }
  DocumentNode operator()(const std::vector<Message>& messages) const {
    return of(kMessagesKey, messages_document(messages));
  }

  static DocumentNode of(std::string_view kind, DocumentNode value) {
    DocumentNode node = DocumentNode::map();
    node.on_one_line = value.kind != DocumentNode::Kind::Map && value.kind != DocumentNode::Kind::Sequence;
    node.add(std::string(kind), std::move(value));
    return node;
  }
};

/// Files of former versions hold words alone. What the program acts on, or shows in a list of its own, is known by
/// them.
Message former_message(const std::string& words) {
  struct Former {
    std::string_view words;
    Message (*message)();
  };
  constexpr Former kFormer[] = {
      {"Preliminary: the calibration was cancelled before its end, and its sigmas do not hold.",
       say::result_preliminary},
      {"accepted by the user", say::accepted_by_the_user},
      {"rejected by the user", say::rejected_by_the_user},
      {"moving objects", say::reason_moving_objects},
      {"aligned wrongly", say::reason_aligned_wrongly},
      {"too little in common", say::reason_too_little_in_common},
      {"INS doubtful here", say::reason_ins_doubtful},
      {"view blocked or dirty", say::reason_view_blocked}};
  for (const Former& former : kFormer)
    if (former.words == words) return former.message();
  return Message::verbatim(words);
}

Message message_at(const DocumentView& view, int depth);

std::vector<Message> messages_at(const DocumentView& list, int depth) {
  std::vector<Message> messages;
  for (const DocumentView& item : list.items()) messages.push_back(message_at(item, depth));
  return messages;
}

Argument::Value value_at(const DocumentView& view, int depth) {
  const auto entries = view.entries();
  if (entries.size() != 1) view.fail(say::message_expected_one_kind());
  const auto& [kind, value] = entries.front();
  if (kind == kCountKey) return value.integer(-kLargestCount, kLargestCount);
  if (kind == kTextKey) return value.string();
  if (kind == kMessageKey) return message_at(value, depth + 1);
  if (kind == kMessagesKey) return messages_at(value, depth + 1);
  if (kind == kTextsKey) {
    std::vector<std::string> names;
    for (const DocumentView& item : value.items()) names.push_back(item.string());
    return names;
  }
  for (std::size_t i = 0; i < kQuantityKeys.size(); ++i)
    if (kind == kQuantityKeys[i]) return Quantity{static_cast<Dimension>(i), value.number_or_nan()};
  return value.node().text;  // of a later version
}

Message message_at(const DocumentView& view, int depth) {
  if (!view.is_map()) return former_message(view.string());
  if (depth > kDeepest) view.fail(say::message_too_deep());
  if (!view.has(kCodeKey)) return Message::verbatim(view.at(kTextKey).string());
  std::vector<Argument> arguments;
  if (const auto list = view.find(kArgumentsKey))
    for (const auto& [name, value] : list->entries()) arguments.push_back({name, value_at(value, depth)});
  return {view.at(kCodeKey).string(), std::move(arguments)};
}

}  // namespace

DocumentNode message_document(const Message& message) {
  if (message.empty()) return DocumentNode::string("");
  DocumentNode node = DocumentNode::map();
  if (message.code() != kVerbatim) {
    node.add(std::string(kCodeKey), DocumentNode::string(message.code()));
    if (!message.arguments().empty()) {
      DocumentNode& arguments = node.add(std::string(kArgumentsKey), DocumentNode::map());
      for (const Argument& argument : message.arguments())
        arguments.add(argument.name, std::visit(ValueDocument{}, argument.value));
    }
  }
  node.add(std::string(kTextKey), DocumentNode::string(english(message)));
  return node;
}

DocumentNode messages_document(const std::vector<Message>& messages) {
  DocumentNode list = DocumentNode::sequence();
  for (const Message& message : messages) list.add(message_document(message));
  return list;
}

Message message_from_document(const DocumentView& view) { return message_at(view, 0); }

std::vector<Message> messages_from_document(const DocumentView& list) { return messages_at(list, 0); }

}  // namespace remount::formats
