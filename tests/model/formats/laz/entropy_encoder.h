// Packs symbols and integers as LASzip does, for the decoders to unpack.
#pragma once

#include <bit>
#include <string>
#include <vector>

#include "model/formats/laz/entropy_models.h"

namespace remount::formats::laz {

class EntropyEncoder {
 public:
  void symbol(SymbolModel& model, unsigned symbol) {
    const std::uint32_t unit = length_ >> kSymbolShift, from = unit * model.below(symbol);
    const std::uint32_t to = symbol + 1 < model.symbols() ? unit * model.below(symbol + 1) : length_;
    narrow(from, to - from);
    model.came(symbol);
  }

  void bit(BitModel& model, unsigned bit) {
    const std::uint32_t zeros = model.share_of_zero() * (length_ >> kBitShift);
    narrow(bit == 0 ? 0 : zeros, bit == 0 ? zeros : length_ - zeros);
    model.came(bit);
  }

  void number(unsigned bits, std::uint32_t number) {
    if (bits > 19) {
      this->number(16, number & 0xffffU);
      number >>= 16, bits -= 16;
    }
    const std::uint32_t unit = length_ >> bits;
    narrow(number * unit, unit);
  }

  /// The bytes, with as many zeros behind them as a decoder looks ahead.
  std::string finish() {
    constexpr std::uint32_t kShortest = 1U << 24;
    const bool one_byte = length_ > 2 * kShortest;
    narrow(one_byte ? kShortest : kShortest >> 1, one_byte ? kShortest >> 1 : kShortest >> 9);
    return bytes_ + std::string(one_byte ? 3 : 2, '\0');
  }

 private:
  void narrow(std::uint32_t from, std::uint32_t length) {
    const std::uint32_t before = base_;
    base_ += from;
    if (base_ < before) carry();
    for (length_ = length; length_ < 1U << 24; length_ <<= 8, base_ <<= 8) bytes_ += static_cast<char>(base_ >> 24);
  }

  void carry() {
    std::size_t at = bytes_.size() - 1;
    for (; bytes_[at] == '\xff'; --at) bytes_[at] = '\0';
    ++bytes_[at];
  }

  std::string bytes_;
  std::uint32_t base_ = 0, length_ = 0xffff'ffffU;
};

class IntegerEncoder {
 public:
  explicit IntegerEncoder(unsigned bits, unsigned contexts = 1)
      : bits_(bits), lengths_(contexts, SymbolModel(bits + 1)) {
    for (unsigned k = 1; k <= bits; ++k) differences_.emplace_back(1U << std::min(k, 8U));
  }

  void put(EntropyEncoder& encoder, std::int32_t expected, std::int32_t value, unsigned context = 0) {
    auto difference =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(value) - static_cast<std::uint32_t>(expected));
    if (bits_ == 16) difference = static_cast<std::int16_t>(difference);
    const auto size = static_cast<std::uint32_t>(difference <= 0 ? -static_cast<std::int64_t>(difference)
                                                                 : static_cast<std::int64_t>(difference) - 1);
    last_bits_ = static_cast<unsigned>(std::bit_width(size));
    encoder.symbol(lengths_[context], last_bits_);
    if (last_bits_ == 0) return encoder.bit(one_bit_, static_cast<unsigned>(difference));
    if (last_bits_ == 32) return;
    const auto place = static_cast<std::uint32_t>(difference < 0 ? difference + ((std::int64_t{1} << last_bits_) - 1)
                                                                 : std::int64_t{difference} - 1);
    const unsigned lower = last_bits_ > 8 ? last_bits_ - 8 : 0;
    encoder.symbol(differences_[last_bits_ - 1], place >> lower);
    if (lower > 0) encoder.number(lower, place & ((1U << lower) - 1));
  }

  unsigned last_bits() const { return last_bits_; }

 private:
  unsigned bits_, last_bits_ = 0;
  std::vector<SymbolModel> lengths_;
  BitModel one_bit_;
  std::vector<SymbolModel> differences_;
};

}  // namespace remount::formats::laz
