// The middle of values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace remount {

/// Of at least one value; of an even number, the upper of the two in the middle.
template <class Value>
Value median_of(std::vector<Value> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace remount
