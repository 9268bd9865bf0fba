#include "model/formats/laz/integer_decoder.h"

#include <algorithm>

namespace remount::formats {

IntegerDecoder::IntegerDecoder(unsigned bits, unsigned contexts)
    : bits_(bits), lengths_(contexts, SymbolModel(bits + 1)), differences_(bits + 1) {}

std::int32_t IntegerDecoder::next(EntropyDecoder& decoder, std::int32_t expected, unsigned context) {
  last_bits_ = decoder.symbol(lengths_[context]);
  const std::uint32_t sum = static_cast<std::uint32_t>(expected) + difference(decoder);
  return static_cast<std::int32_t>(bits_ < 32 ? sum & ((1U << bits_) - 1) : sum);
}

/// Of k bits: -(2^k - 1) to -2^(k-1), and 2^(k-1) + 1 to 2^k; of none 0 or 1. Negative ones modulo 2^32.
std::uint32_t IntegerDecoder::difference(EntropyDecoder& decoder) {
  constexpr unsigned kModelled = 8, kWholeRange = 32;
  const unsigned bits = last_bits_;
  if (bits == 0) return decoder.bit(one_bit_);
  if (bits == kWholeRange) return 1U << 31;
  std::optional<SymbolModel>& upper = differences_[bits];
  if (!upper) upper.emplace(1U << std::min(bits, kModelled));
  std::uint32_t place = decoder.symbol(*upper);
  if (bits > kModelled) place = place << (bits - kModelled) | decoder.number(bits - kModelled);
  return place >= 1U << (bits - 1) ? place + 1 : place - ((1U << bits) - 1);
}

}  // namespace remount::formats
