// The fields of a message in the wire format of Protocol Buffers, one after the other, and as they are written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace remount::bags {

/// Walks the fields of a message as they stand in it. What a field is by its number is known to the caller; one whose
/// type is another is as one that nobody knows, which readers pass over. Messages within are bytes, for a walk of their
/// own.
class ProtoReader {
 public:
  enum class End {
    Whole,  ///< a field that reaches beyond the bytes is damage
    Cut,    ///< the bytes are the beginning of the message: such a field is the last
  };

  /// @param where for errors; outlives the reader
  ProtoReader(std::string_view bytes, std::string_view where, End end = End::Whole)
      : bytes_(bytes), where_(where), end_(end) {}

  /// Goes to the next field; false where there is none. Throws Error(Format) for what is none: number 0, a type that is
  /// not known, a number of more than 64 bits, and what reaches beyond the bytes.
  bool next();

  std::uint32_t field() const { return field_; }
  /// A whole number, where the field is one; likewise a number with a fraction (of 32 or 64 bits), and bytes: text, a
  /// message, or what there is of them where they are cut.
  std::optional<std::uint64_t> whole() const;
  std::optional<double> real() const;
  std::optional<std::string_view> bytes() const;

  /// How long bytes are by their own length, and where they begin.
  std::uint64_t length() const { return number_; }
  std::size_t begins() const { return begins_; }

 private:
  enum class Wire : std::uint8_t { Whole = 0, Bits64 = 1, Bytes = 2, Bits32 = 5 };
  bool more(std::size_t count) const { return bytes_.size() - position_ >= count; }
  std::optional<std::uint64_t> varint();
  bool ended();
  [[noreturn]] void fail() const;

  std::string_view bytes_, where_, payload_;
  End end_;
  std::size_t position_ = 0, begins_ = 0;
  std::uint32_t field_ = 0;
  Wire wire_ = Wire::Whole;
  std::uint64_t number_ = 0;
};

/// Writes fields in the order in which they are given.
class ProtoWriter {
 public:
  ProtoWriter& whole(std::uint32_t field, std::uint64_t value);
  ProtoWriter& real(std::uint32_t field, double value);
  ProtoWriter& narrow(std::uint32_t field, float value);
  ProtoWriter& bytes(std::uint32_t field, std::string_view value);
  const std::string& message() const { return message_; }

 private:
  void varint(std::uint64_t value);
  std::string message_;
};

}  // namespace remount::bags
