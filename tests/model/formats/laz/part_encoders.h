// Coordinates and times of points, packed as LASzip does.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "model/formats/laz/running_median.h"
#include "tests/model/formats/laz/entropy_encoder.h"

namespace remount::formats::laz {

inline std::int32_t wrapped_difference(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

class CoordinateEncoder {
 public:
  CoordinateEncoder(std::array<std::int32_t, 3> first, std::int32_t height) : last_(first) { heights_.fill(height); }

  void put_xy(EntropyEncoder& encoder, const std::array<std::int32_t, 3>& xyz, unsigned kind, bool only) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const unsigned bits = x_.last_bits();
      const unsigned context = axis == 0 ? 0 : bits < 20 ? bits & ~1U : 20;
      const std::int32_t step = wrapped_difference(xyz[axis], last_[axis]);
      (axis == 0 ? x_ : y_).put(encoder, steps_[axis][kind].value(), step, context + (only ? 1 : 0));
      steps_[axis][kind].add(step);
    }
    last_ = xyz;
  }

  void put_z(EntropyEncoder& encoder, std::int32_t z, unsigned level, bool only) {
    const unsigned bits = (x_.last_bits() + y_.last_bits()) / 2;
    z_.put(encoder, heights_[level], z, (bits < 18 ? bits & ~1U : 18) + (only ? 1 : 0));
    heights_[level] = z;
  }

 private:
  std::array<std::int32_t, 3> last_;
  IntegerEncoder x_{32, 2}, y_{32, 22}, z_{32, 20};
  std::array<std::array<RunningMedian, 16>, 2> steps_;
  std::array<std::int32_t, 8> heights_{};
};

/// @param skipped 0 where points may keep their time, 1 in layers, where they then have no code
class TimeEncoder {
 public:
  TimeEncoder(unsigned skipped, double first) : skipped_(skipped), standing_(6 - skipped), multiples_(516 - skipped) {
    sequences_[0].time = std::bit_cast<std::int64_t>(first);
  }

  void put(EntropyEncoder& encoder, double value) {
    const auto time = std::bit_cast<std::int64_t>(value);
    Sequence& sequence = sequences_[current_];
    if (!fits(time - sequence.time)) return put_elsewhere(encoder, time);
    const auto step = static_cast<std::int32_t>(time - sequence.time);
    if (sequence.step == 0)
      put_first_step(encoder, step);
    else if (step == 0 && skipped_ == 0)
      encoder.symbol(multiples_, 511);
    else
      put_multiple(encoder, step);
    sequence.time = time;
  }

 private:
  struct Sequence {
    std::int64_t time = 0;
    std::int32_t step = 0;
    int unusual = 0;
  };

  static bool fits(std::int64_t step) { return std::abs(step) < std::numeric_limits<std::int32_t>::max(); }

  void put_first_step(EntropyEncoder& encoder, std::int32_t step) {
    if (step == 0 && skipped_ == 0) return encoder.symbol(standing_, 0);
    encoder.symbol(standing_, 1 - skipped_);
    steps_.put(encoder, 0, step, 0);
    sequences_[current_].step = step;
    sequences_[current_].unusual = 0;
  }

  void put_multiple(EntropyEncoder& encoder, std::int32_t step) {
    Sequence& sequence = sequences_[current_];
    const double ratio = std::round(static_cast<double>(step) / sequence.step);
    const int multiple = static_cast<int>(std::clamp(ratio, -10.0, 500.0));
    encoder.symbol(multiples_, static_cast<unsigned>(multiple >= 0 ? multiple : 500 - multiple));
    const unsigned context = multiple == 1     ? 1
                             : multiple == 0   ? 7
                             : multiple == 500 ? 4
                             : multiple == -10 ? 6
                             : multiple < 0    ? 5
                             : multiple < 10   ? 2
                                               : 3;
    const auto expected = static_cast<std::uint32_t>(multiple) * static_cast<std::uint32_t>(sequence.step);
    steps_.put(encoder, static_cast<std::int32_t>(expected), step, context);
    if (multiple == 1) sequence.unusual = 0;
    if ((context != 7 && context != 4 && context != 6) || ++sequence.unusual <= 3) return;
    sequence.step = step;
    sequence.unusual = 0;
  }

  void put_elsewhere(EntropyEncoder& encoder, std::int64_t time) {
    Sequence& sequence = sequences_[current_];
    const auto code = [&](unsigned of_standing, unsigned of_multiples) {
      if (sequence.step == 0) return encoder.symbol(standing_, of_standing - skipped_);
      encoder.symbol(multiples_, of_multiples - skipped_);
    };
    for (unsigned i = 1; i < 4; ++i) {
      if (!fits(time - sequences_[(current_ + i) % 4].time)) continue;
      code(2 + i, 512 + i);
      current_ = (current_ + i) % 4;
      return put(encoder, std::bit_cast<double>(time));
    }
    code(2, 512);
    newest_ = (newest_ + 1) % 4;
    const auto bits = static_cast<std::uint64_t>(time);
    steps_.put(encoder, static_cast<std::int32_t>(sequence.time >> 32), static_cast<std::int32_t>(bits >> 32), 8);
    encoder.number(32, static_cast<std::uint32_t>(bits));
    sequences_[newest_] = {time};
    current_ = newest_;
  }

  unsigned skipped_;
  SymbolModel standing_, multiples_;
  IntegerEncoder steps_{32, 9};
  std::array<Sequence, 4> sequences_;
  unsigned current_ = 0, newest_ = 0;
};

}  // namespace remount::formats::laz
