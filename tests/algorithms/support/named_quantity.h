// What methods tell beside the mounting.
#pragma once

#include <string_view>
#include <vector>

#include "algorithms/calibration/method_details.h"

namespace remount {

/// Null where there is none of that name.
inline const NamedQuantity* quantity_of(const std::vector<NamedQuantity>& quantities, std::string_view name) {
  for (const NamedQuantity& quantity : quantities)
    if (quantity.name == name) return &quantity;
  return nullptr;
}

}  // namespace remount
