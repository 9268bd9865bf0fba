// Quantities that messages state: a type each, so that metres never stand where radians are meant.
#pragma once

#include <concepts>
#include <cstdint>

namespace remount {

struct Length {
  double m;
};
struct Angle {
  double rad;
};
struct Duration {
  double s;
};
struct Speed {
  double mps;
};
struct TurnRate {
  double radps;
};
struct Acceleration {
  double mps2;
};
struct Frequency {
  double hz;
};
/// A part of a whole: 0.5 is shown as 50 %.
struct Share {
  double of_one;
};
struct Bytes {
  std::uint64_t bytes;
};
/// Of things that are counted. No floating-point number becomes one by mistake.
struct Count {
  template <std::integral Integer>
  Count(Integer counted) : number(static_cast<std::int64_t>(counted)) {}  // NOLINT: counts are what integers are
  std::int64_t number;
};

}  // namespace remount
