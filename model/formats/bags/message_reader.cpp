#include "model/formats/bags/message_reader.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "algorithms/core/error.h"
#include "messages/bags.h"

namespace remount::bags {

static_assert(std::endian::native == std::endian::little, "messages are taken to need no swapping");

MessageReader::MessageReader(std::string_view bytes, MessageEncoding encoding, std::string where)
    : bytes_(bytes), encoding_(encoding), where_(std::move(where)) {
  if (encoding == MessageEncoding::Other) throw Error(ErrorCode::Unsupported, where_, say::bag_message_encoding());
  if (encoding != MessageEncoding::Cdr) return;
  // Two bytes that name the representation, two of options (OMG DDSI-RTPS, "encapsulation").
  const std::string_view header = view(kCdrHeader);
  if (header[0] != 0 || (header[1] != 0 && header[1] != 1))
    throw Error(ErrorCode::Unsupported, where_,
                say::bag_message_representation(static_cast<unsigned char>(header[0]) * 256 +
                                                static_cast<unsigned char>(header[1])));
  swap_ = header[1] == 0;
  bytes_.remove_prefix(kCdrHeader);
  position_ = 0;
}

std::string_view MessageReader::view(std::size_t count) {
  if (count > left())
    throw Error(ErrorCode::Format, where_, say::bag_message_too_short(Bytes{bytes_.size()}, count, position_));
  const std::string_view found = bytes_.substr(position_, count);
  position_ += count;
  return found;
}

void MessageReader::take(char* to, std::size_t count) {
  std::memcpy(to, view(count).data(), count);
  if (swap_) std::reverse(to, to + count);
}

void MessageReader::align(std::size_t bytes) {
  if (encoding_ != MessageEncoding::Cdr) return;
  const std::size_t over = position_ % bytes;
  if (over > 0) view(std::min(bytes - over, left()));
}

std::string_view MessageReader::string() {
  const std::size_t length = number<std::uint32_t>();
  std::string_view text = view(length);
  // CDR counts the zero at the end.
  if (encoding_ == MessageEncoding::Cdr && text.ends_with('\0')) text.remove_suffix(1);
  return text;
}

std::string_view MessageReader::byte_sequence() { return view(number<std::uint32_t>()); }

std::size_t MessageReader::sequence(std::size_t least_item_bytes) {
  const std::size_t count = number<std::uint32_t>();
  if (count > left() / least_item_bytes)
    throw Error(ErrorCode::Format, where_, say::bag_sequence_too_long(count, Bytes{left()}));
  return count;
}

std::int64_t MessageReader::time_ns() {
  // ROS 1 counts seconds without a sign, ROS 2 with one; both mean the years to 2038.
  const std::int64_t seconds =
      encoding_ == MessageEncoding::Ros1 ? std::int64_t{number<std::uint32_t>()} : number<std::int32_t>();
  return seconds * 1'000'000'000 + number<std::uint32_t>();
}

MessageHeader read_header(MessageReader& reader) {
  if (reader.encoding() == MessageEncoding::Ros1) reader.number<std::uint32_t>();  // seq
  MessageHeader header;
  header.stamp_ns = reader.time_ns();
  std::string_view frame = reader.string();
  while (frame.starts_with('/')) frame.remove_prefix(1);
  header.frame = frame;
  return header;
}

}  // namespace remount::bags
