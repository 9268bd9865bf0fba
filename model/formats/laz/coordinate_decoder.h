// Coordinates of compressed points, which both kinds of chunks have alike.
#pragma once

#include <array>
#include <cstdint>

#include "model/formats/laz/integer_decoder.h"
#include "model/formats/laz/running_median.h"

namespace remount::formats {

/// x and y by what they differ from the point before by, expected as the median of points of its kind; z as the last
/// one of its level. How many bits x and y took tells what to expect of what follows.
class CoordinateDecoder {
 public:
  /// @param first the point that stands at the begin of the chunk @param height what z is expected to be on all levels
  CoordinateDecoder(const std::array<std::int32_t, 3>& first, std::int32_t height);
  /// @param kind of up to 16, by number and count of returns @param only whether the pulse had one return
  void next_xy(EntropyDecoder& decoder, unsigned kind, bool only);
  /// To follow next_xy. @param level of 8: how many returns lie behind
  void next_z(EntropyDecoder& decoder, unsigned level, bool only);
  const std::array<std::int32_t, 3>& xyz() const { return xyz_; }

 private:
  void step(EntropyDecoder& decoder, std::size_t axis, unsigned kind, unsigned context);

  std::array<std::int32_t, 3> xyz_;
  std::array<IntegerDecoder, 3> numbers_{IntegerDecoder(32, 2), IntegerDecoder(32, 22), IntegerDecoder(32, 20)};
  std::array<std::array<RunningMedian, 16>, 2> steps_;
  std::array<std::int32_t, 8> heights_;
};

}  // namespace remount::formats
