#include "model/formats/laz/entropy_decoder.h"

#include "algorithms/core/error.h"
#include "messages/laz.h"

namespace remount::formats {
namespace {

/// An interval that is shorter is lengthened by a byte.
constexpr std::uint32_t kShortestInterval = 1U << 24;

/// Writers leave off zeros at the end that do not matter, as far as one looks ahead.
constexpr std::size_t kLookAhead = 4;

}  // namespace

EntropyDecoder::EntropyDecoder(std::string_view bytes, const std::string& where) : bytes_(bytes), where_(where) {
  for (int i = 0; i < 4; ++i) value_ = value_ << 8 | next_byte();
}

unsigned EntropyDecoder::symbol(SymbolModel& model) {
  const std::uint32_t whole = length_, unit = length_ >> kSymbolShift;
  const unsigned symbol = model.symbol_of(value_ / unit);
  const std::uint32_t from = unit * model.below(symbol);
  take(from, (symbol + 1 < model.symbols() ? unit * model.below(symbol + 1) : whole) - from);
  model.came(symbol);
  return symbol;
}

unsigned EntropyDecoder::bit(BitModel& model) {
  const std::uint32_t zeros = model.share_of_zero() * (length_ >> kBitShift);
  const unsigned bit = value_ >= zeros ? 1 : 0;
  take(bit == 0 ? 0 : zeros, bit == 0 ? zeros : length_ - zeros);
  model.came(bit);
  return bit;
}

std::uint32_t EntropyDecoder::number(unsigned bits) {
  constexpr unsigned kMostAtOnce = 19, kHalf = 16;
  if (bits <= kMostAtOnce) return short_number(bits);
  const std::uint32_t low = short_number(kHalf);
  return short_number(bits - kHalf) << kHalf | low;
}

std::uint32_t EntropyDecoder::short_number(unsigned bits) {
  const std::uint32_t unit = length_ >> bits, number = value_ / unit;
  if (number >> bits != 0) fail();
  take(number * unit, unit);
  return number;
}

/// Goes on with the part of the interval that begins at `from`.
void EntropyDecoder::take(std::uint32_t from, std::uint32_t length) {
  value_ -= from;
  length_ = length;
  if (length_ == 0) fail();
  for (; length_ < kShortestInterval; length_ <<= 8) value_ = value_ << 8 | next_byte();
}

std::uint32_t EntropyDecoder::next_byte() {
  const std::size_t at = at_++;
  if (at < bytes_.size()) return static_cast<unsigned char>(bytes_[at]);
  if (at >= bytes_.size() + kLookAhead) fail();
  return 0;
}

void EntropyDecoder::fail() const { throw Error(ErrorCode::Format, where_, say::laz_damaged()); }

}  // namespace remount::formats
