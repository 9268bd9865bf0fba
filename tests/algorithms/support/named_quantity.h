// What methods tell beside the mounting.
#pragma once

#include <string_view>
#include <vector>

#include "algorithms/calibration/method_details.h"

namespace remount {

/// Null where there is none of that id.
inline const NamedQuantity* quantity_of(const std::vector<NamedQuantity>& quantities, std::string_view id) {
  for (const NamedQuantity& quantity : quantities)
    if (quantity.id == id) return &quantity;
  return nullptr;
}

}  // namespace remount
