// Symbols out of bytes that were packed by arithmetic coding.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/formats/laz/entropy_models.h"

namespace remount::formats {

/// Symbols in the order in which they were packed, each with the model that it was packed with. Throws Error(Format) at
/// `where` behind the end of the bytes, and where these were not packed so. Bytes and `where` are the caller's.
class EntropyDecoder {
 public:
  EntropyDecoder(std::string_view bytes, const std::string& where);
  unsigned symbol(SymbolModel& model);
  unsigned bit(BitModel& model);
  /// A number of so many bits, 1 to 32, of which nothing is expected.
  std::uint32_t number(unsigned bits);

 private:
  std::uint32_t short_number(unsigned bits);
  std::uint32_t next_byte();
  void take(std::uint32_t from, std::uint32_t length);
  [[noreturn]] void fail() const;

  std::string_view bytes_;
  const std::string& where_;
  std::size_t at_ = 0;
  std::uint32_t value_ = 0;              ///< the packed number, from the begin of the interval on
  std::uint32_t length_ = 0xffff'ffffU;  ///< of the interval that it lies in
};

}  // namespace remount::formats
