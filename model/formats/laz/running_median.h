// The median of what came lately, as LASzip keeps it.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace remount::formats {

/// Of five numbers, zeros at first. A new one takes the place of the largest or of the smallest, in turn as numbers lie
/// above or below the median.
class RunningMedian {
 public:
  std::int32_t value() const { return sorted_[2]; }

  void add(std::int32_t number) {
    const std::int32_t median = value();
    std::size_t at = drops_largest_ ? 4 : 0;
    if (drops_largest_ ? number >= median : number <= median) drops_largest_ = !drops_largest_;
    sorted_[at] = number;
    for (; at > 0 && sorted_[at - 1] > sorted_[at]; --at) std::swap(sorted_[at - 1], sorted_[at]);
    for (; at < 4 && sorted_[at] > sorted_[at + 1]; ++at) std::swap(sorted_[at], sorted_[at + 1]);
  }

 private:
  std::array<std::int32_t, 5> sorted_{};
  bool drops_largest_ = true;
};

}  // namespace remount::formats
