#include "model/formats/bags/message_layout.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "model/formats/bags/bag_file.h"
#include "model/formats/files/input_file.h"

namespace remount::bags {
namespace {

/// No message has more, each counted wherever it stands: a hostile definition says "twice the other" again and again.
constexpr std::size_t kMostFields = 10'000;
constexpr int kDeepest = 16;

constexpr std::pair<std::string_view, std::uint8_t> kNumbers[] = {
    {"bool", 1},  {"byte", 1},   {"char", 1},  {"int8", 1},   {"uint8", 1},   {"int16", 2},  {"uint16", 2},
    {"int32", 4}, {"uint32", 4}, {"int64", 8}, {"uint64", 8}, {"float32", 4}, {"float64", 8}};

/// The lines of each message by its type; the first part is the message itself.
std::map<std::string, std::string_view> parts_of(std::string_view definition, std::string_view type) {
  std::map<std::string, std::string_view> parts;
  std::string name = short_type(type);
  while (true) {
    const std::size_t end = definition.find("\n===");
    parts.emplace(name, definition.substr(0, end));
    if (end == std::string_view::npos) return parts;
    const std::size_t mark = definition.find("\nMSG: ", end + 1);
    if (mark == std::string_view::npos) return parts;
    const std::size_t begin = mark + 6, line_end = std::min(definition.find('\n', begin), definition.size());
    name = short_type(formats::trim(definition.substr(begin, line_end - begin)));
    definition.remove_prefix(std::min(line_end, definition.size()));
  }
}

/// A line as the type and the name of a field; empty for what is none: nothing, a remark, a constant.
std::pair<std::string_view, std::string_view> field_of(std::string_view line) {
  line = formats::trim(line.substr(0, line.find('#')));
  const std::size_t type_end = line.find_first_of(" \t");
  if (type_end == std::string_view::npos) return {};
  const std::string_view rest = formats::trim(line.substr(type_end));
  const std::string_view name = rest.substr(0, rest.find_first_of(" \t="));  // a default value stands behind the name
  const std::string_view behind = formats::trim(rest.substr(name.size()));
  if (behind.starts_with('=')) return {};
  return {line.substr(0, type_end), name};
}

class LayoutParser {
 public:
  explicit LayoutParser(std::map<std::string, std::string_view> parts) : parts_(std::move(parts)) {}

  /// False where something is not understood.
  bool parse(const std::string& type, int depth) {
    const auto part = parts_.find(type);
    if (part == parts_.end() || depth > kDeepest) return false;
    const std::size_t place = layout_.messages.size();
    layout_.messages.emplace_back();
    std::string_view lines = part->second;
    while (!lines.empty()) {
      const std::size_t end = std::min(lines.find('\n'), lines.size());
      const auto [written, name] = field_of(lines.substr(0, end));
      lines.remove_prefix(std::min(end + 1, lines.size()));
      if (written.empty()) continue;
      MessageField field;
      field.name = name;
      if (++fields_ > kMostFields || !read_type(written, type, depth, field)) return false;
      layout_.messages[place].push_back(std::move(field));
    }
    return true;
  }
  MessageLayout take() { return std::move(layout_); }

 private:
  /// "uint8[1206]", "pkg/Type[]", "string<=20", "float32[<=3]".
  bool read_type(std::string_view written, const std::string& within, int depth, MessageField& field) {
    if (const std::size_t bracket = written.find('['); bracket != std::string_view::npos) {
      if (!written.ends_with(']')) return false;
      const std::string_view count = written.substr(bracket + 1, written.size() - bracket - 2);
      field.many = count.empty() || count.starts_with("<=") ? MessageField::Many::Sequence : MessageField::Many::Fixed;
      if (field.many == MessageField::Many::Fixed && !read_count(count, field.count)) return false;
      written = written.substr(0, bracket);
    }
    written = written.substr(0, written.find("<="));
    for (const auto& [name, bytes] : kNumbers)
      if (written == name) {
        field.bytes = bytes;
        return true;
      }
    if (written == "string" || written == "wstring") {
      field.kind = written == "string" ? MessageField::Kind::Text : MessageField::Kind::WideText;
      return true;
    }
    return read_message(short_type(written), within, depth, field);
  }

  bool read_message(const std::string& written, const std::string& within, int depth, MessageField& field) {
    constexpr std::string_view kTimes[] = {"time", "duration", "builtin_interfaces/Time",
                                           "builtin_interfaces/Duration"};
    if (std::ranges::find(kTimes, written) != std::end(kTimes)) {
      field.kind = MessageField::Kind::Time;
      return true;
    }
    if (written == "Header" || written == "std_msgs/Header" || written == "roslib/Header") {
      field.kind = MessageField::Kind::Header;
      return true;
    }
    // An array of a fixed number of messages may be without end and take no byte.
    if (field.many == MessageField::Many::Fixed) return false;
    field.kind = MessageField::Kind::Message;
    field.message = layout_.messages.size();
    const bool full = written.find('/') != std::string::npos;
    return parse(full ? written : within.substr(0, within.find('/') + 1) + written, depth + 1);
  }

  static bool read_count(std::string_view text, std::uint32_t& count) {
    constexpr std::uint32_t kMost = 1U << 24U;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    return error == std::errc() && end == text.data() + text.size() && count <= kMost;
  }

  std::map<std::string, std::string_view> parts_;
  MessageLayout layout_;
  std::size_t fields_ = 0;
};

void skip_one(MessageReader& reader, const MessageLayout& layout, const MessageField& field) {
  switch (field.kind) {
    case MessageField::Kind::Number:
      reader.align(field.bytes);
      reader.skip(field.bytes);
      return;
    case MessageField::Kind::Text:
      reader.string();
      return;
    case MessageField::Kind::WideText:
      reader.skip(2 * reader.sequence(2));
      return;
    case MessageField::Kind::Time:
      reader.time_ns();
      return;
    case MessageField::Kind::Header:
      read_header(reader);
      return;
    case MessageField::Kind::Message:
      for (const MessageField& inner : layout.messages[field.message]) skip_field(reader, layout, inner);
      return;
  }
}

}  // namespace

std::optional<MessageLayout> parse_message_layout(std::string_view definition, std::string_view type) {
  LayoutParser parser(parts_of(definition, type));
  if (!parser.parse(short_type(type), 0)) return std::nullopt;
  return parser.take();
}

void skip_field(MessageReader& reader, const MessageLayout& layout, const MessageField& field) {
  const std::size_t count = field.many == MessageField::Many::One     ? 1
                            : field.many == MessageField::Many::Fixed ? field.count
                                                                      : reader.sequence(1);
  if (field.kind == MessageField::Kind::Number) {
    if (count > 0) reader.align(field.bytes);
    reader.skip(count * field.bytes);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = reader.left();
    skip_one(reader, layout, field);
    if (reader.left() == before) return;  // so do the others: a message without fields
  }
}

}  // namespace remount::bags
