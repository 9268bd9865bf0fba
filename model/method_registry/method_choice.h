// Which calibration method is chosen: what settings hold.
#pragma once

#include <concepts>
#include <string_view>
#include <vector>

#include "model/method_registry/calibration_method.h"

namespace remount::method_registry {

/// A method of the list; the default where nobody chose.
class MethodChoice {
 public:
  constexpr MethodChoice() = default;
  /// Throws Error(Contract) that names the methods where `id` is none of them.
  explicit MethodChoice(std::string_view id);
  /// By the place in method_ids(), as options take choices. One that is none is found by Settings::check.
  explicit constexpr MethodChoice(std::integral auto place) : place_(static_cast<int>(place)) {}
  template <std::integral Place>
  explicit constexpr operator Place() const {
    return static_cast<Place>(place_);
  }

  /// Throws std::out_of_range where the place is none.
  const CalibrationMethod& operator*() const;
  const CalibrationMethod* operator->() const { return &**this; }

  friend bool operator==(const MethodChoice&, const MethodChoice&) = default;

 private:
  int place_ = 0;
};

/// Of the methods in their order.
std::vector<std::string_view> method_ids();

}  // namespace remount::method_registry
