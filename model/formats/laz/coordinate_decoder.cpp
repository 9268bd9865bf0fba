#include "model/formats/laz/coordinate_decoder.h"

#include <algorithm>

namespace remount::formats {
namespace {

/// Two lengths share a context, and what is longer than the last one has has that one.
unsigned context_of(unsigned bits, unsigned last, bool only) { return std::min(bits & ~1U, last) + (only ? 1 : 0); }

}  // namespace

CoordinateDecoder::CoordinateDecoder(const std::array<std::int32_t, 3>& first, std::int32_t height) : xyz_(first) {
  heights_.fill(height);
}

void CoordinateDecoder::next_xy(EntropyDecoder& decoder, unsigned kind, bool only) {
  step(decoder, 0, kind, only ? 1 : 0);
  step(decoder, 1, kind, context_of(numbers_[0].last_bits(), 20, only));
}

void CoordinateDecoder::step(EntropyDecoder& decoder, std::size_t axis, unsigned kind, unsigned context) {
  RunningMedian& median = steps_[axis][kind];
  const std::int32_t step = numbers_[axis].next(decoder, median.value(), context);
  median.add(step);
  xyz_[axis] = static_cast<std::int32_t>(static_cast<std::uint32_t>(xyz_[axis]) + static_cast<std::uint32_t>(step));
}

void CoordinateDecoder::next_z(EntropyDecoder& decoder, unsigned level, bool only) {
  const unsigned bits = (numbers_[0].last_bits() + numbers_[1].last_bits()) / 2;
  xyz_[2] = heights_[level] = numbers_[2].next(decoder, heights_[level], context_of(bits, 18, only));
}

}  // namespace remount::formats
