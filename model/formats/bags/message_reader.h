// The bytes of one message, field by field, in either of ROS's two serialisations.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "model/formats/bags/bag_file.h"

namespace remount::bags {

/// Reads the fields of a message in the order of its definition. Throws Error at `where`: Format where the message is
/// shorter than its fields, Unsupported for a serialisation that is neither ROS 1's nor plain CDR (version 1).
class MessageReader {
 public:
  MessageReader(std::string_view bytes, MessageEncoding encoding, std::string where);

  /// Scalars: aligned to their own size in CDR, packed in ROS 1.
  template <class T>
  T number() {
    align(sizeof(T));
    T value{};
    take(reinterpret_cast<char*>(&value), sizeof(T));
    return value;
  }
  template <std::size_t N>
  std::array<double, N> doubles() {
    std::array<double, N> values{};
    for (double& value : values) value = number<double>();
    return values;
  }

  std::string_view string();
  /// The bytes of a sequence of 8-bit numbers.
  std::string_view byte_sequence();
  /// The length of any other sequence. Refused where its items, of `least_item_bytes` or more, cannot be there.
  std::size_t sequence(std::size_t least_item_bytes);

  /// secs and nsecs. @return Unix time in nanoseconds
  std::int64_t time_ns();

  void skip(std::size_t bytes) { view(bytes); }
  /// In CDR, moves to a multiple of `bytes`.
  void align(std::size_t bytes);

  MessageEncoding encoding() const { return encoding_; }
  bool big_endian() const { return swap_; }
  const std::string& where() const { return where_; }
  std::size_t left() const { return bytes_.size() - position_; }
  /// How many bytes of the message have been read, with the header of CDR.
  std::size_t position() const { return (encoding_ == MessageEncoding::Cdr ? kCdrHeader : 0) + position_; }
  /// The next bytes as they are.
  std::string_view bytes(std::size_t count) { return view(count); }

 private:
  static constexpr std::size_t kCdrHeader = 4;
  std::string_view view(std::size_t count);
  void take(char* to, std::size_t count);

  std::string_view bytes_;  // without the header of CDR, from whose end on fields are aligned
  std::size_t position_ = 0;
  MessageEncoding encoding_;
  bool swap_ = false;
  std::string where_;
};

/// std_msgs/Header.
struct MessageHeader {
  std::int64_t stamp_ns = 0;
  std::string frame;  ///< without the leading '/' of early ROS
};
MessageHeader read_header(MessageReader& reader);

}  // namespace remount::bags
