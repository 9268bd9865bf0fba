#include "model/formats/laz/entropy_models.h"

#include <algorithm>
#include <bit>

namespace remount::formats {
namespace {

constexpr unsigned kShareBits = 31;

/// A quarter longer each time, up to a limit: what was learned holds ever longer.
std::uint32_t longer_cycle(std::uint32_t cycle, std::uint32_t longest) { return std::min((5 * cycle) >> 2, longest); }

}  // namespace

SymbolModel::SymbolModel(unsigned symbols) : below_(symbols), counts_(symbols, 1), cycle_(symbols) {
  const auto place_bits = static_cast<unsigned>(std::bit_width(symbols / 4));
  place_shift_ = kSymbolShift - place_bits;
  places_.resize((std::size_t{1} << place_bits) + 1);
  update();
  cycle_ = until_update_ = (symbols + 6) >> 1;
}

void SymbolModel::update() {
  total_ += cycle_;
  if (total_ > 1U << kSymbolShift) {
    total_ = 0;
    for (std::uint32_t& count : counts_) total_ += count = (count + 1) >> 1;
  }
  const std::uint32_t scale = (1U << kShareBits) / total_;
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    below_[i] = (scale * sum) >> (kShareBits - kSymbolShift);
    sum += counts_[i];
  }
  mark_places();
  cycle_ = until_update_ = longer_cycle(cycle_, (symbols() + 6) << 3);
}

void SymbolModel::mark_places() {
  std::uint16_t symbol = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    while (symbol + 1U < symbols() && below_[symbol + 1U] <= i << place_shift_) ++symbol;
    places_[i] = symbol;
  }
}

unsigned SymbolModel::symbol_of(std::uint32_t share) const {
  share = std::min(share, (1U << kSymbolShift) - 1);
  const std::size_t from = share >> place_shift_;
  unsigned low = places_[from], beyond = places_[from + 1] + 1U;
  while (beyond - low > 1) {
    const unsigned middle = (low + beyond) / 2;
    (below_[middle] > share ? beyond : low) = middle;
  }
  return low;
}

void BitModel::update() {
  total_ += cycle_;
  if (total_ > 1U << kBitShift) {
    total_ = (total_ + 1) >> 1;
    zeros_ = (zeros_ + 1) >> 1;
    if (zeros_ == total_) ++total_;
  }
  share_of_zero_ = (zeros_ * ((1U << kShareBits) / total_)) >> (kShareBits - kBitShift);
  cycle_ = until_update_ = longer_cycle(cycle_, 64);
}

}  // namespace remount::formats
