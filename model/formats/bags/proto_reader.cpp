#include "model/formats/bags/proto_reader.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/records.h"
#include "model/formats/bags/raw_bytes.h"
#include "model/formats/files/number_bytes.h"

namespace remount::bags {

void ProtoReader::fail() const { throw Error(ErrorCode::Format, std::string(where_), say::record_no_field(position_)); }

/// Where a message that may be cut ends within a field, it ends with the one before.
bool ProtoReader::ended() {
  if (end_ == End::Whole) fail();
  position_ = bytes_.size();
  return false;
}

std::optional<std::uint64_t> ProtoReader::varint() {
  constexpr unsigned kBits = 7, kMostShift = 63;
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift <= kMostShift; shift += kBits) {
    if (!more(1)) return std::nullopt;
    const std::uint8_t byte = formats::byte_at(bytes_, position_++);
    if (shift == kMostShift && byte > 1) fail();
    value |= std::uint64_t{byte & 0x7fU} << shift;
    if ((byte & 0x80U) == 0) return value;
  }
  fail();
}

bool ProtoReader::next() {
  constexpr std::uint64_t kMostTag = 0xffffffffU;
  if (!more(1)) return false;
  const std::optional<std::uint64_t> tag = varint();
  if (!tag) return ended();
  field_ = static_cast<std::uint32_t>(*tag >> 3U);
  wire_ = static_cast<Wire>(*tag & 7U);
  if (*tag > kMostTag || field_ == 0) fail();
  if (wire_ == Wire::Whole || wire_ == Wire::Bytes) {
    const std::optional<std::uint64_t> number = varint();
    if (!number) return ended();
    number_ = *number;
    begins_ = position_;
    if (wire_ == Wire::Whole) return true;
    if (number_ > bytes_.size() - position_ && end_ == End::Whole) fail();
    payload_ = bytes_.substr(position_, std::min<std::uint64_t>(number_, bytes_.size() - position_));
    position_ += payload_.size();
    return true;
  }
  if (wire_ != Wire::Bits64 && wire_ != Wire::Bits32) fail();
  const std::size_t size = wire_ == Wire::Bits64 ? 8 : 4;
  if (!more(size)) return ended();
  begins_ = position_;
  payload_ = bytes_.substr(position_, size);
  position_ += size;
  return true;
}

std::optional<std::uint64_t> ProtoReader::whole() const {
  return wire_ == Wire::Whole ? std::optional(number_) : std::nullopt;
}

std::optional<double> ProtoReader::real() const {
  if (wire_ == Wire::Bits64) return formats::little_number<double>(payload_, 0);
  if (wire_ == Wire::Bits32) return formats::little_number<float>(payload_, 0);
  return std::nullopt;
}

std::optional<std::string_view> ProtoReader::bytes() const {
  return wire_ == Wire::Bytes ? std::optional(payload_) : std::nullopt;
}

void ProtoWriter::varint(std::uint64_t value) {
  for (; value >= 0x80U; value >>= 7U) message_ += static_cast<char>((value & 0x7fU) | 0x80U);
  message_ += static_cast<char>(value);
}

ProtoWriter& ProtoWriter::whole(std::uint32_t field, std::uint64_t value) {
  varint(std::uint64_t{field} << 3U);
  varint(value);
  return *this;
}

ProtoWriter& ProtoWriter::real(std::uint32_t field, double value) {
  varint(std::uint64_t{field} << 3U | 1U);
  message_ += raw_bytes(value);
  return *this;
}

ProtoWriter& ProtoWriter::narrow(std::uint32_t field, float value) {
  varint(std::uint64_t{field} << 3U | 5U);
  message_ += raw_bytes(value);
  return *this;
}

ProtoWriter& ProtoWriter::bytes(std::uint32_t field, std::string_view value) {
  varint(std::uint64_t{field} << 3U | 2U);
  varint(value.size());
  message_ += value;
  return *this;
}

}  // namespace remount::bags
