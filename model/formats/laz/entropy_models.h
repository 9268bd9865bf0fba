// What is expected of coming symbols, learned from those that came. The counts and when they are taken over are part of
// the format: LASzip's use of A. Said, "Introduction to Arithmetic Coding" (HPL-2004-76).
#pragma once

#include <cstdint>
#include <vector>

namespace remount::formats {

/// Bits of an interval that probabilities of symbols and of single bits are multiplied without.
inline constexpr unsigned kSymbolShift = 15, kBitShift = 13;

/// Of symbols from 0 to one less than `symbols`, which is at least 2. Shares are of 1 << kSymbolShift.
class SymbolModel {
 public:
  explicit SymbolModel(unsigned symbols);
  unsigned symbols() const { return static_cast<unsigned>(counts_.size()); }
  /// Share of all symbols below this one.
  std::uint32_t below(unsigned symbol) const { return below_[symbol]; }
  /// The symbol that has this share of all: that of the last one is without end.
  unsigned symbol_of(std::uint32_t share) const;
  /// To be told of each symbol, once.
  void came(unsigned symbol) {
    ++counts_[symbol];
    if (--until_update_ == 0) update();
  }

 private:
  void update();
  void mark_places();

  std::vector<std::uint32_t> below_, counts_;
  std::vector<std::uint16_t> places_;  ///< symbols of shares in even distances: to search between two of them is enough
  unsigned place_shift_ = 0;
  std::uint32_t total_ = 0, cycle_, until_update_ = 0;
};

/// Of one bit; its share is of 1 << kBitShift.
class BitModel {
 public:
  std::uint32_t share_of_zero() const { return share_of_zero_; }
  void came(unsigned bit) {
    zeros_ += bit == 0 ? 1 : 0;
    if (--until_update_ == 0) update();
  }

 private:
  void update();

  std::uint32_t zeros_ = 1, total_ = 2, share_of_zero_ = 1U << (kBitShift - 1), cycle_ = 4, until_update_ = 4;
};

}  // namespace remount::formats
