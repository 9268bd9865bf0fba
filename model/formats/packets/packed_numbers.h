// Numbers that differ little from one to the next, in few bytes.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "algorithms/core/error.h"

namespace remount::formats {

/// Seven bits a byte, the lowest first.
class NumberPacker {
 public:
  void number(std::uint64_t value) {
    for (; value >= 0x80U; value >>= 7U) bytes_.push_back(static_cast<char>(value | 0x80U));
    bytes_.push_back(static_cast<char>(value));
  }
  /// A difference, which is small forwards and backwards.
  void step(std::uint64_t from, std::uint64_t to) {
    const std::uint64_t step = to - from;
    number(step << 1U ^ (step >> 63U != 0 ? ~std::uint64_t{0} : 0U));
  }
  void text(std::string_view text) {
    number(text.size());
    bytes_ += text;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Throws Error(Format) made by `broken` where the bytes end early or hold no such number.
class NumberUnpacker {
 public:
  NumberUnpacker(std::string_view bytes, std::string where, Message (*broken)())
      : bytes_(bytes), where_(std::move(where)), broken_(broken) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && at_ < bytes_.size(); shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_[at_++]);
      if (shift == 63 && byte > 1) break;
      value |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80U) return value;
    }
    fail();
  }
  /// At most that large.
  std::uint64_t number(std::uint64_t most) {
    const std::uint64_t value = number();
    if (value > most) fail();
    return value;
  }
  template <class T>
  T number_of() {
    return static_cast<T>(number(std::numeric_limits<T>::max()));
  }
  std::uint64_t step(std::uint64_t from) {
    const std::uint64_t packed = number();
    return from + (packed >> 1U ^ (packed & 1U ? ~std::uint64_t{0} : 0U));
  }
  /// How many things follow that take so many bytes each, at least: no more than there are bytes.
  std::size_t count(std::size_t least_bytes) { return number((bytes_.size() - at_) / least_bytes); }
  std::string text() {
    const std::size_t size = count(1);
    at_ += size;
    return std::string(bytes_.substr(at_ - size, size));
  }
  bool at_end() const { return at_ == bytes_.size(); }
  [[noreturn]] void fail() const { throw Error(ErrorCode::Format, where_, broken_()); }

 private:
  std::string_view bytes_;
  std::string where_;
  Message (*broken_)();
  std::size_t at_ = 0;
};

}  // namespace remount::formats
