// What stands where in a message, by the definition of its type.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/bags/message_reader.h"

namespace remount::bags {

struct MessageField {
  enum class Kind : std::uint8_t { Number, Text, WideText, Time, Header, Message };
  enum class Many : std::uint8_t { One, Fixed, Sequence };
  std::string name;
  Kind kind = Kind::Number;
  Many many = Many::One;
  std::uint32_t count = 1;  ///< of Many::Fixed
  std::uint8_t bytes = 0;   ///< of a number
  std::size_t message = 0;  ///< which of MessageLayout::messages it is
  bool is_bytes() const { return kind == Kind::Number && bytes == 1 && many != Many::One; }
};

/// The fields of a message, and of those within it.
struct MessageLayout {
  std::vector<std::vector<MessageField>> messages;  ///< the first is the message itself
};

/// Reads a definition as bags have it: a line a field, then, each behind a line of '=' and "MSG: package/Type", those
/// of the messages in it. std_msgs/Header and the times of ROS need no definition. Nothing for what is none, names a
/// message that is not there, or is larger than any is.
/// @param type of the message, "velodyne_msgs/VelodyneScan"
std::optional<MessageLayout> parse_message_layout(std::string_view definition, std::string_view type);

/// Goes over a field that is of no interest. Throws Error as the reader does.
void skip_field(MessageReader& reader, const MessageLayout& layout, const MessageField& field);

}  // namespace remount::bags
